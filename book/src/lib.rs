//! The machine behind the book: it turns the pages into HTML, and makes every figure in them.
//!
//! | module | what it does |
//! |---|---|
//! | [`pages`] | builds the mdBook: checks, preprocessors, HTML |
//! | [`formulas`] | `$…$` and `$$…$$` become MathML |
//! | [`citations`] | `[Whitted80]` becomes a link to the references |
//! | [`includes`] | every `{{#include …}}` finds its file and its anchor |
//! | [`html`], [`links`] | every link of the built pages leads somewhere, and nothing is fetched
//! from outside | | [`figures`] | the table of figures: make them, or check that they have not
//! drifted | | [`measurements`] | the tables of run times, refreshed by hand |
//! | [`warnings`], [`folder`] | what mdBook logs; files and folders |
//! | [`picture`], [`plot`], [`axis`], [`diagram`], [`table`], [`numbers`] | what a figure can be |

pub mod axis;
pub mod citations;
pub mod course;
pub mod diagram;
pub mod figures;
pub mod folder;
pub mod formulas;
pub mod html;
pub mod includes;
pub mod links;
pub mod measurements;
pub mod numbers;
pub mod pages;
pub mod picture;
pub mod plot;
pub mod table;
pub mod warnings;

/// Any failure of the builder; its text is a sentence for the author of a page.
pub use mdbook_preprocessor::errors::{Error, Result};
