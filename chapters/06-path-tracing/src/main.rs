//! Chapter 6: follow one random path per sample.
//!
//! `cargo run --release -p path-tracing -- cornell-box --samples 64`

use std::process::ExitCode;

use path_tracing::STAGE;
use rendering_equation::draw;

fn main() -> ExitCode {
    workbench::main(&STAGE, draw::<path_tracing::Extra>)
}
