//! What a mutant is.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

/// A mistake: one small change of one source file, and the test that has to notice it.
#[derive(Clone, Copy, Debug)]
pub struct Mutant {
    /// The mistake, as a sentence: "the cosine is forgotten".
    pub name: &'static str,
    /// What a reader learns from it.
    pub lesson: &'static str,
    /// The file, seen from the workspace's root.
    pub file: &'static str,
    /// The text to be replaced; it occurs once in the file.
    pub old: &'static str,
    /// What stands there instead.
    pub new: &'static str,
    /// The test that fails then.
    pub test: Test,
}

/// One test of a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Test {
    /// The package, as `cargo test -p` takes it.
    pub package: &'static str,
    /// Which of the package's test programs has it.
    pub target: Target,
    /// The function's name, which is the filter at the same time.
    pub name: &'static str,
}

/// A test program of a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The tests beside the code.
    Lib,
    /// A file or a folder of `tests/`.
    Tests(&'static str),
}

impl Test {
    /// A test beside the code of `package`.
    #[must_use]
    pub const fn lib(package: &'static str, name: &'static str) -> Self {
        Self { package, target: Target::Lib, name }
    }

    /// A test of `tests/PROGRAM.rs` or of `tests/PROGRAM/`.
    #[must_use]
    pub const fn of(package: &'static str, program: &'static str, name: &'static str) -> Self {
        Self { package, target: Target::Tests(program), name }
    }

    /// The folder of the package, seen from anywhere; `None` if `workspace` has no such package.
    #[must_use]
    pub fn folder(&self, workspace: &Path) -> Option<PathBuf> {
        let named = format!("name = \"{}\"", self.package);
        let groups = ["chapters", "tests"].map(|group| fs::read_dir(workspace.join(group)));
        let folders = groups.into_iter().flatten().flatten().flatten().map(|entry| entry.path());
        folders.into_iter().find(|folder| {
            let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
            manifest.lines().any(|line| line == named)
        })
    }

    /// The arguments of `cargo test` that choose its program.
    #[must_use]
    pub fn program(&self) -> Vec<&'static str> {
        match self.target {
            Target::Lib => vec!["-p", self.package, "--lib"],
            Target::Tests(name) => vec!["-p", self.package, "--test", name],
        }
    }
}

impl fmt::Display for Test {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { package, name, .. } = self;
        match self.target {
            Target::Lib => write!(f, "{package}: {name}"),
            Target::Tests(program) => write!(f, "{package}, {program}: {name}"),
        }
    }
}

impl Mutant {
    /// The text of the file with the mistake in it, or why it cannot be planted.
    ///
    /// # Errors
    ///
    /// The old text does not occur once, or is the new one.
    pub fn plant(&self, text: &str) -> Result<String, String> {
        let count = text.matches(self.old).count();
        if count != 1 {
            return Err(format!("{}: `{}` occurs {count} times", self.file, self.old));
        }
        if self.old == self.new {
            return Err(format!("{}: `{}` is replaced by itself", self.file, self.old));
        }
        Ok(text.replacen(self.old, self.new, 1))
    }
}
