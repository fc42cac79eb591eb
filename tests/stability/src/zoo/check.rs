//! Builds and runs one test of a copy of the workspace.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::zoo::mutant::Test;
use crate::zoo::scratch::Scratch;

/// What a test said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It ran and passed.
    Passed,
    /// It failed.
    Failed,
    /// Nothing was run: there is no such test.
    NothingRun,
    /// It did not end in time.
    Endless,
    /// It could not be compiled; what the compiler said.
    NotCompiled(String),
}

/// A test that runs longer than this is stopped. None of them takes half a minute.
const PATIENCE: Duration = Duration::from_secs(600);

/// Builds `test` in the copy and runs it.
///
/// # Errors
///
/// Cargo cannot be started, or says something unexpected.
pub fn run(scratch: &Scratch, test: &Test) -> io::Result<Verdict> {
    let program = match build(scratch, test)? {
        Ok(program) => program,
        Err(message) => return Ok(Verdict::NotCompiled(message)),
    };
    let folder = test.folder(&scratch.root);
    let folder = folder.ok_or_else(|| io::Error::other(format!("no package {}", test.package)))?;
    let said = scratch.target.join("zoo-said.txt");
    let mut child = Command::new(program)
        .arg(test.name)
        .current_dir(&folder)
        .env("CARGO_MANIFEST_DIR", &folder)
        .env("INSTA_UPDATE", "no")
        .stdin(Stdio::null())
        .stdout(File::create(&said)?)
        .stderr(Stdio::null())
        .spawn()?;
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            return Ok(Verdict::Endless);
        }
        sleep(Duration::from_millis(20));
    };
    Ok(match (status.success(), fs::read_to_string(&said)?.contains("... ok\n")) {
        (false, _) => Verdict::Failed,
        (true, true) => Verdict::Passed,
        (true, false) => Verdict::NothingRun,
    })
}

/// Builds the program of `test`: its path, or the compiler's message.
fn build(scratch: &Scratch, test: &Test) -> io::Result<Result<PathBuf, String>> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let output = Command::new(cargo)
        .arg("test")
        .args(test.program())
        .args(["--no-run", "--color", "never", "--target-dir"])
        .arg(&scratch.target)
        .current_dir(&scratch.root)
        .stdin(Stdio::null())
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Ok(Err(said.into_owned()));
    }
    // "Executable unittests src/lib.rs (/…/target/debug/deps/ray_casting-0123456789abcdef)"
    let line = said.lines().rfind(|line| line.trim_start().starts_with("Executable"));
    let path = line.and_then(|line| line.rsplit_once('(')?.1.strip_suffix(')'));
    let path = path.ok_or_else(|| io::Error::other(format!("cargo names no program:\n{said}")))?;
    Ok(Ok(scratch.root.join(path)))
}
