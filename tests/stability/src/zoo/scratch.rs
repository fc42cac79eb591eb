//! A copy of the workspace in which files may be changed.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A copy of the sources, and the target folder of its builds.
#[derive(Clone, Debug)]
pub struct Scratch {
    /// The copy's root.
    pub root: PathBuf,
    /// Where it is built; kept from run to run, so that little has to be compiled.
    pub target: PathBuf,
}

impl Scratch {
    /// Copies into `folder` what git knows of the workspace, and new files that it does not ignore.
    ///
    /// Files that have not changed are left alone, so that cargo need not compile them again; a mutant
    /// that an interrupted run has left there is replaced.
    ///
    /// # Errors
    ///
    /// A file cannot be read or written, or there is no git.
    pub fn copy(workspace: &Path, folder: &Path) -> io::Result<Self> {
        let scratch = Self { root: folder.join("workspace"), target: folder.join("target") };
        fs::create_dir_all(&scratch.root)?;
        let files = tracked(workspace)?;
        for file in &files {
            let bytes = fs::read(workspace.join(file))?;
            write_if_different(&scratch.root.join(file), &bytes)?;
        }
        let mut copied = Vec::new();
        list(&scratch.root, &mut copied)?;
        for path in copied {
            let known = path.strip_prefix(&scratch.root).is_ok_and(|file| files.contains(file));
            if !known {
                fs::remove_file(path)?;
            }
        }
        Ok(scratch)
    }

    /// The text of a file of the copy.
    ///
    /// # Errors
    ///
    /// It cannot be read.
    pub fn read(&self, file: &str) -> io::Result<String> {
        fs::read_to_string(self.root.join(file))
    }

    /// Writes a file of the copy.
    ///
    /// # Errors
    ///
    /// It cannot be written.
    pub fn write(&self, file: &str, text: &str) -> io::Result<()> {
        write_if_different(&self.root.join(file), text.as_bytes())
    }
}

/// The files of the workspace that exist, without what is ignored.
fn tracked(workspace: &Path) -> io::Result<BTreeSet<PathBuf>> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    let output = git.current_dir(workspace).output()?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let names = String::from_utf8_lossy(&output.stdout).into_owned();
    let files = names.split('\0').filter(|name| !name.is_empty()).map(PathBuf::from);
    Ok(files.filter(|file| workspace.join(file).is_file()).collect())
}

/// Every file below `folder`.
fn list(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

fn write_if_different(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, bytes)
}
