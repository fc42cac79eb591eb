//! The stages' binaries.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// The packages of all stages so far, in the order of the chapters.
pub const STAGES: [&str; 8] = [
    "workbench",
    "ray-casting",
    "blinn-phong",
    "mirror-refraction",
    "bv-tree",
    "rendering-equation",
    "path-tracing",
    "light-sampling",
];

/// Those that estimate an integral, and know how far off they are.
pub const ESTIMATING: [&str; 3] = ["rendering-equation", "path-tracing", "light-sampling"];

/// The binary of a stage, built first if it is not up to date.
///
/// Cargo builds a test's own package and its libraries, but not the binaries of others. So they are
/// built here, once a test run, with the profile and into the folder of the running test.
///
/// What is built is chosen as `cargo test` chooses: the members that a plain command means, and a
/// test among them, so that what only tests ask of the libraries below is asked here, too. After
/// `cargo test` everything is there already; with other wishes, all stages would be compiled twice.
///
/// # Panics
/// If the stages cannot be built.
#[must_use]
pub fn binary(stage: &str) -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(build);
    folder.join(stage).with_extension(env::consts::EXE_EXTENSION)
}

/// Builds the stages, and returns the folder in which they lie.
fn build() -> PathBuf {
    // The test is target/PROFILE/deps/TEST.
    let test = env::current_exe().expect("the test knows its own path");
    let folder = test.ancestors().nth(2).expect("the test lies in a target folder");
    let target = folder.parent().expect("a profile's folder lies in a target folder");
    let profile = match folder.file_name().and_then(|name| name.to_str()) {
        Some("debug") | None => "dev",
        Some(name) => name,
    };
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(workspace).args(["build", "--quiet", "--bins", "--test", "stages"]);
    cargo.args(["--profile", profile, "--target-dir"]).arg(target);
    let output = cargo.output().expect("cargo starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "the stages cannot be built: {said}");
    folder.to_owned()
}
