//! Chapter 5: integrals over the hemisphere by chance, and how fast their errors fall.
//!
//! `cargo run --release -p rendering-equation --bin estimate -- lobe-100`

use std::io::{Write, stdout};
use std::process::ExitCode;

use clap::Parser;
use rendering_equation::convergence::Command;

fn main() -> ExitCode {
    let text = Command::parse().run();
    // A reader who has gone away needs the rest no more.
    ExitCode::from(u8::from(stdout().write_all(text.as_bytes()).is_err()))
}
