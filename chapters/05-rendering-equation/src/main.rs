//! Chapter 5: solve the rendering equation by following N random directions from every hit.
//!
//! `cargo run --release -p rendering-equation -- cornell-box --branching 4 --depth 3`

use std::process::ExitCode;

use rendering_equation::{STAGE, draw};

fn main() -> ExitCode {
    workbench::main(&STAGE, draw::<rendering_equation::Extra>)
}
