//! The long tier: every case with as many random inputs as one has time for.
//!
//! `cargo run --release -p stability -- --rays 1e9`

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use stability::report::{Options, report};

/// Tries every case of the stress catalogue with many random inputs.
#[derive(Parser)]
#[command(name = "stability", about)]
struct Arguments {
    /// Inputs of each case, such as 1e6; of one that costs k plain rays, a k-th of them
    #[arg(long, value_name = "N", default_value = "1e6", value_parser = whole)]
    rays: u64,
    /// Only these: ids, components, or parts of facts
    #[arg(long, value_name = "TEXT,…", value_delimiter = ',')]
    only: Vec<String>,
    /// Another seed is another set of inputs
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,
    /// Also writes the table as Markdown
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

fn main() -> ExitCode {
    let Arguments { rays, only, seed, write } = Arguments::parse();
    match report(&Options { rays, only, seed, write }) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// A whole number, also written as 1e9.
fn whole(text: &str) -> Result<u64, String> {
    let number: f64 = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
    let is_whole = (1.0..=1e15).contains(&number) && number.fract() == 0.0;
    if is_whole {
        Ok(number as u64)
    } else {
        Err(format!("{text} is not from 1 to 1e15, or not whole"))
    }
}
