//! Chapter 4: the recursion of chapter 3 over a tree of bounding volumes.
//!
//! `cargo run --release -p bv-tree -- teapot --volume obb --stats -`

mod draw;

use std::process::ExitCode;

use draw::{Extra, draw};
use workbench::{Run, Stage, Unwatched};

const STAGE: Stage = Stage {
    name: "bv-tree",
    about: "Traces mirrors and glass recursively, over a tree of bounding volumes",
    scene: "whitted-teapot",
    samples: 16,
    depth: Some(8),
    estimates: false,
};

fn main() -> ExitCode {
    workbench::main(&STAGE, |run: &Run<Extra>| match run.recorder() {
        Some(recorder) => draw(run, recorder),
        None => draw(run, &Unwatched),
    })
}
