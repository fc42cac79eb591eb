//! The bug zoo: famous mistakes, planted one by one in the course's own functions, and the test that
//! notices each.
//!
//! A test that has never failed has shown nothing yet. Elsewhere in the workspace tests are held
//! against a copy of an estimator with a mistake; here the mistake is in the chapter itself. Each
//! *mutant* is one small change of one source file, and names the one test that has to fail.
//!
//! ```text
//! cargo run --release -p stability --bin zoo              all of them: half an hour of two cores
//! cargo run --release -p stability --bin zoo -- --only roulette
//! cargo run --release -p stability --bin zoo -- --write   and the table of the book
//! ```
//!
//! The changes are made in a copy of the workspace below the target folder, never in the workspace
//! itself, so an interrupted run leaves nothing behind. `tests/zoo.rs` checks in a second that every
//! mutant can still be planted and that its test still exists.
//!
//! | file | |
//! |---|---|
//! | [`mutant`] | what a mutant is |
//! | [`scratch`] | the copy of the workspace |
//! | [`check`] | builds and runs one test of the copy |
//! | [`hunt`] | plants one mutant after the other |
//! | the others | the mutants of one chapter each |

pub mod check;
pub mod hunt;
pub mod mutant;
pub mod scratch;

mod blinn_phong;
mod bv_tree;
mod light_sampling;
mod mirror_refraction;
mod path_tracing;
mod ray_casting;
mod rendering_equation;
mod workbench;

pub use mutant::{Mutant, Target, Test};

/// Every mutant, chapter by chapter.
#[must_use]
pub fn mutants() -> Vec<Mutant> {
    [
        workbench::MUTANTS,
        ray_casting::MUTANTS,
        blinn_phong::MUTANTS,
        mirror_refraction::MUTANTS,
        bv_tree::MUTANTS,
        rendering_equation::MUTANTS,
        path_tracing::MUTANTS,
        light_sampling::MUTANTS,
    ]
    .concat()
}
