//! Chapter 7: follow random paths, and sample the lights at every hit.
//!
//! `cargo run --release -p light-sampling -- cornell-box --samples 64`

use std::process::ExitCode;

use light_sampling::STAGE;
use rendering_equation::draw;

fn main() -> ExitCode {
    workbench::main(&STAGE, draw::<light_sampling::Extra>)
}
