//! Makes meshes, scenes and textures.
//!
//! `cargo run --release -p generator -- blob --triangles 1000000 -o blob.obj`

use clap::Parser;
use generator::Options;
use std::process::ExitCode;

fn main() -> ExitCode {
    match generator::run(&Options::parse()) {
        Ok(sentence) => {
            eprintln!("{sentence}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
