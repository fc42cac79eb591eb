//! The pages: from the folder `book` to the folder `target/book`.

use std::env;
use std::io;
use std::path::{Path, PathBuf};

use mdbook_driver::MDBook;
use mdbook_preprocessor::{Preprocessor, parse_input};

use crate::citations::Citations;
use crate::formulas::Formulas;
use crate::{Error, Result, includes, links, warnings};

/// Builds the book at `root`, and checks it; returns the page to open.
///
/// The two preprocessors, which `book.toml` names as commands for the `mdbook` tool, run in this
/// process instead: they take the place of the commands in the order that `book.toml` asks for.
///
/// # Errors
///
/// Whatever [`check`] finds, a formula or a citation that cannot be set, and any warning of mdBook.
pub fn build(root: &Path) -> Result<PathBuf> {
    // mdBook would warn about some broken includes too, but say less.
    let mut book = MDBook::load(root)?;
    includes::check(&book.source_dir())?;
    book.with_preprocessor(Formulas).with_preprocessor(Citations);

    let (built, warnings) = warnings::collect(|| book.build());
    built?;
    if !warnings.is_empty() {
        return Err(Error::msg(format!("mdBook warns:\n  {}", warnings.join("\n  "))));
    }
    let site = site(&book);
    links::check(&site)?;
    Ok(site.join("index.html"))
}

/// Checks the includes of the pages, and the links of the book as it was built last.
///
/// # Errors
///
/// Includes that show nothing ([`includes::check`]), addresses that lead nowhere
/// ([`links::check`]), or a book that has not been built.
pub fn check(root: &Path) -> Result<String> {
    let book = MDBook::load(root)?;
    includes::check(&book.source_dir())?;
    let site = site(&book);
    if !site.is_dir() {
        return Err(Error::msg("build the book first: cargo run -p book"));
    }
    let followed = links::check(&site)?;
    Ok(format!("{followed} addresses lead somewhere"))
}

/// Answers the `mdbook` tool, which sends the book on standard input and wants it back.
///
/// # Errors
///
/// What the preprocessor finds, or input from a version of mdBook that writes the book differently.
pub fn answer(preprocessor: &impl Preprocessor) -> Result<()> {
    let (mut context, book) = parse_input(io::stdin())
        .map_err(|error| error.context("the book needs mdbook 0.5: `cargo run -p book` has it"))?;
    // mdBook starts its commands in the book's folder, and may name that folder relative to its
    // own.
    context.root = env::current_dir()?;
    let processed = preprocessor.run(&context, book)?;
    serde_json::to_writer(io::stdout(), &processed)?;
    Ok(())
}

fn site(book: &MDBook) -> PathBuf {
    let site = book.build_dir_for("html");
    // `book/../target/book` reads better without the detour.
    site.canonicalize().unwrap_or(site)
}
