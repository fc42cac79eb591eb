//! Builds the book, and makes the figures in it.
//!
//! `cargo run -p book`

use std::path::Path;
use std::process::ExitCode;

use book::citations::Citations;
use book::formulas::Formulas;
use book::{Result, course, figures, measurements, pages};
use clap::{Parser, Subcommand};

/// Build the book into target/book, and check every include, link and picture of it
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    task: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Check the pages that stand in target/book, without building them
    Check,
    /// Make every picture, plot and table again
    Figures {
        /// Write nothing; fail, and name every figure that a fresh run makes differently
        #[arg(long)]
        check: bool,
        /// Only the figures whose file name contains NAME
        #[arg(long, value_name = "NAME", default_value = "")]
        only: String,
    },
    /// Take the run times again (minutes; only in release, on an idle machine)
    Measurements {
        /// Only the tables whose file name contains NAME
        #[arg(long, value_name = "NAME", default_value = "")]
        only: String,
    },
    /// Draw the same scene by every stage, with the same time for each (only in release)
    Course,
    /// mdBook preprocessor: formulas to MathML (called by `mdbook build book`)
    Formulas {
        #[command(subcommand)]
        question: Option<Question>,
    },
    /// mdBook preprocessor: keys like [Whitted80] to links (called by `mdbook build book`)
    Citations {
        #[command(subcommand)]
        question: Option<Question>,
    },
}

/// What mdBook asks a preprocessor before it sends the book.
#[derive(Subcommand)]
enum Question {
    /// Whether pages for this renderer should be processed
    Supports {
        /// The renderer's name
        renderer: String,
    },
}

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    match run(root, Arguments::parse().task) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(root: &Path, task: Option<Task>) -> Result<ExitCode> {
    match task {
        None => eprintln!("The book is in {}", pages::build(root)?.display()),
        Some(Task::Check) => eprintln!("{}", pages::check(root)?),
        Some(Task::Figures { check: true, only }) => eprintln!("{}", figures::check(root, &only)?),
        Some(Task::Figures { check: false, only }) => figures::make(root, &only)?,
        Some(Task::Measurements { only }) => measurements::take(root, &only)?,
        Some(Task::Course) => course::make(root)?,
        Some(Task::Formulas { question }) => return preprocess(&Formulas, question),
        Some(Task::Citations { question }) => return preprocess(&Citations, question),
    }
    Ok(ExitCode::SUCCESS)
}

fn preprocess(
    preprocessor: &impl mdbook_preprocessor::Preprocessor,
    question: Option<Question>,
) -> Result<ExitCode> {
    match question {
        Some(Question::Supports { renderer }) if preprocessor.supports_renderer(&renderer)? => {
            Ok(ExitCode::SUCCESS)
        }
        Some(Question::Supports { .. }) => Ok(ExitCode::FAILURE),
        None => pages::answer(preprocessor).map(|()| ExitCode::SUCCESS),
    }
}
