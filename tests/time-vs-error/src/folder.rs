//! Files that appear when they are whole, or not at all.

use std::fs;
use std::path::Path;

use crate::error::{Error, Result};

/// Writes `text` to `path` by way of a file beside it.
///
/// # Errors
/// If it cannot be written.
pub fn write(path: &Path, contents: impl AsRef<[u8]>) -> Result<()> {
    let failed = |error| Error::file(path, error);
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.part", std::process::id()));
    let beside = Path::new(&beside);
    fs::write(beside, contents).and_then(|()| fs::rename(beside, path)).map_err(failed)
}
