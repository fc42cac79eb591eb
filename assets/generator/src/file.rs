//! Files that are written whole or not at all.

use std::error::Error;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Why a file could not be written.
#[derive(Debug)]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: io::Error,
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` cannot be written: {}", self.path.display(), self.source)
    }
}

impl Error for FileError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&self.source)
    }
}

/// Lets `write` fill a file beside `path`, then moves it to `path`.
///
/// A crash or a full disk leaves the old file, or none; never half a file. What is not an ordinary
/// file, say `/dev/stdout`, cannot be replaced and is written to directly.
///
/// # Errors
/// What the file system or `write` says, with the name of the file.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), FileError> {
    let special = fs::metadata(path).is_ok_and(|m| !m.is_file() && !m.is_dir());
    let done = if special { fill(path, write) } else { fill_and_move(path, write) };
    done.map_err(|source| FileError { path: path.to_owned(), source })
}

fn fill_and_move(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> io::Result<()> {
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "this is no file name"))?;
    let process = std::process::id(); // two generators may write beside each other
    let partial = path.with_file_name(format!(".{}.{process}.partial", name.to_string_lossy()));
    let done = fill(&partial, write).and_then(|()| fs::rename(&partial, path));
    if done.is_err() {
        // The first error is the one worth telling; that there was nothing to remove is not.
        let _ = fs::remove_file(&partial);
    }
    done
}

fn fill(path: &Path, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 20, File::create(path)?);
    write(&mut out)?;
    out.flush()
}
