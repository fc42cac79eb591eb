//! A working folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

use crate::stages::binary;

/// A temporary folder in which stages are run.
#[derive(Debug)]
pub struct Folder(TempDir);

impl Folder {
    /// A folder with these files: names and contents.
    ///
    /// # Panics
    /// If they cannot be written.
    #[must_use]
    pub fn with(files: &[(&str, &str)]) -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        for (name, text) in files {
            folder.write(name, text.as_bytes());
        }
        folder
    }

    /// Writes a file.
    ///
    /// # Panics
    /// If it cannot be written.
    pub fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.path(name), bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
    }

    /// The path of a file in the folder.
    #[must_use]
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// The names of the files, sorted.
    ///
    /// # Panics
    /// If the folder cannot be read.
    #[must_use]
    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("the folder is read");
        let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
        let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
        names.sort();
        names
    }

    /// A stage with these arguments, separated by spaces, ready to be run here.
    #[must_use]
    pub fn command(&self, stage: &str, arguments: &str) -> Command {
        let mut command = Command::new(binary(stage));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        command
    }

    /// Runs a stage, which must end with `status`; returns what it printed.
    ///
    /// # Panics
    /// If it ends with another status, or speaks of a panic.
    #[expect(
        clippy::must_use_candidate,
        reason = "the files that it writes may be all that matters"
    )]
    pub fn run(&self, stage: &str, arguments: &str, status: i32) -> Output {
        let output = self.command(stage, arguments).output().expect("the stage starts");
        let message = message(&output);
        let ended = output.status.code();
        assert_eq!(ended, Some(status), "`{stage} {arguments}` said: {message}");
        assert!(!message.contains("panicked"), "`{stage} {arguments}` said: {message}");
        output
    }

    /// Likewise, and returns what stands on standard error.
    ///
    /// # Panics
    /// As [`run`](Self::run).
    #[must_use]
    pub fn complaint(&self, stage: &str, arguments: &str, status: i32) -> String {
        message(&self.run(stage, arguments, status))
    }
}

impl AsRef<Path> for Folder {
    fn as_ref(&self) -> &Path {
        self.0.path()
    }
}

/// What stands on standard error.
fn message(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
