//! Run time against error.
//!
//! `cargo run --release -p time-vs-error -- --quick`

use std::process::ExitCode;

use clap::Parser;
use time_vs_error::options::Options;

fn main() -> ExitCode {
    match time_vs_error::measure(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
