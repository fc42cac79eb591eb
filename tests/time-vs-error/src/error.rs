//! What can go wrong: files, programs, and options.

use std::fmt;
use std::path::Path;

/// A failure; its text is a sentence for whoever started the measurement.
#[derive(Debug)]
pub struct Error(String);

/// What most functions of this package return.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error that says `sentence`.
    #[must_use]
    pub fn new(sentence: impl Into<String>) -> Self {
        Self(sentence.into())
    }

    /// The error of a file.
    #[must_use]
    pub fn file(path: &Path, reason: impl fmt::Display) -> Self {
        Self(format!("`{}`: {reason}", path.display()))
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

impl From<workbench::Error> for Error {
    fn from(error: workbench::Error) -> Self {
        Self(error.to_string())
    }
}
