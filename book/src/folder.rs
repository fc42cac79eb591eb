//! Folders, with errors that name them.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::{Error, Result};

/// All files in a folder and in the folders inside it, in alphabetical order.
///
/// # Errors
///
/// The folder, or one inside it, cannot be read.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let path = entry.map_err(at(folder))?.path();
        if path.is_dir() {
            found.extend(files(&path)?);
        } else {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// The text of a file.
///
/// # Errors
///
/// The file cannot be read, or is not UTF-8.
pub fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).map_err(at(file))
}

/// Writes a file, and the folder that it stands in if need be.
///
/// # Errors
///
/// The file or the folder cannot be written.
pub fn write(file: &Path, bytes: impl AsRef<[u8]>) -> Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(at(folder))?;
    }
    fs::write(file, bytes).map_err(at(file))
}

/// Adds the path to an error that does not tell it.
fn at(path: &Path) -> impl FnOnce(io::Error) -> Error + '_ {
    move |error| Error::new(error).context(path.display().to_string())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{files, read, write};

    #[test]
    fn files_are_found_in_folders_inside_folders() {
        let root = tempfile::tempdir().expect("a temporary folder");
        for name in ["b.md", "a/c/d.md", "a/b.md"] {
            write(&root.path().join(name), name).expect("the folder can be written");
        }
        let found = files(root.path()).expect("the folder can be read");
        let names: Vec<_> = found.iter().map(|f| read(f).expect("the file is there")).collect();
        assert_eq!(names, ["a/b.md", "a/c/d.md", "b.md"], "in alphabetical order");
    }

    #[test]
    fn an_error_names_the_path() {
        let error = read(Path::new("no/such/file")).expect_err("there is none");
        assert!(format!("{error:#}").contains("no/such/file"), "{error:#}");
    }
}
