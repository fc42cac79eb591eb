//! Files that appear when they are complete, or not at all.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, PoisonError};

use crate::Error;

/// The temporary files that are being written, for [`remove_unfinished`].
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// What the encoders of pictures need.
pub(crate) trait WriteSeek: Write + Seek {}
impl<T: Write + Seek> WriteSeek for T {}

/// Lets `write` fill a temporary file beside `path`, and gives it that name when it is complete.
///
/// On an error the temporary file is removed, and a file that was there before stays as it was. A
/// device or a pipe is written to directly: renaming would replace it.
pub(crate) fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn WriteSeek) -> io::Result<()>,
) -> Result<(), Error> {
    let failed = |source| Error::Write { path: path.to_owned(), source };
    if is_device(path) {
        let file = OpenOptions::new().write(true).open(path).map_err(failed)?;
        return fill(file, write).map_err(failed);
    }
    // Through a symbolic link to the file that is meant.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let temporary = Temporary::create(&target).map_err(failed)?;
    let file = temporary.open().map_err(failed)?;
    fill(file, write).and_then(|()| temporary.rename_to(&target)).map_err(failed)
}

/// Whether a file can be written to `path`, found out before an hour of rendering.
pub(crate) fn check_writable(path: &Path) -> Result<(), Error> {
    let failed = |source| Error::Write { path: path.to_owned(), source };
    if path.is_dir() {
        return Err(failed(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder")));
    }
    let folder = folder_of(path);
    if !folder.is_dir() {
        let reason = format!("the folder `{}` does not exist; create it first", folder.display());
        return Err(failed(io::Error::new(io::ErrorKind::NotFound, reason)));
    }
    if !is_device(path) {
        Temporary::create(path).map_err(failed)?;
    }
    Ok(())
}

/// Removes what an interrupted run leaves behind.
pub(crate) fn remove_unfinished() {
    for path in UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
        // It may just have been renamed or removed by its owner.
        let _ = fs::remove_file(path);
    }
}

fn fill(file: File, write: impl FnOnce(&mut dyn WriteSeek) -> io::Result<()>) -> io::Result<()> {
    let mut buffered = BufWriter::new(file);
    write(&mut buffered)?;
    let file = buffered.into_inner().map_err(io::IntoInnerError::into_error)?;
    // Some file systems find out only now that the disk is full; devices cannot be synchronised.
    if file.metadata()?.is_file() { file.sync_all() } else { Ok(()) }
}

fn is_device(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A temporary file, removed when dropped unless it was renamed.
struct Temporary(PathBuf);

impl Temporary {
    /// An empty file beside `target`, hidden, and named after this process.
    fn create(target: &Path) -> io::Result<Self> {
        let name = target.file_name().ok_or(io::Error::other("it has no file name"))?;
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}.part", process::id()));
        let temporary = Self(folder_of(target).join(hidden));
        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).push(temporary.0.clone());
        File::create(&temporary.0)?;
        Ok(temporary)
    }

    fn open(&self) -> io::Result<File> {
        OpenOptions::new().write(true).truncate(true).open(&self.0)
    }

    fn rename_to(self, target: &Path) -> io::Result<()> {
        fs::rename(&self.0, target)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // After renaming, there is nothing left to remove.
        let _ = fs::remove_file(&self.0);
        let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
        unfinished.retain(|path| path != &self.0);
    }
}
