//! Why a scene could not be loaded.

use std::path::{Path, PathBuf};
use std::{fmt, io};

/// Why a scene could not be loaded. Its text names file, line, key and remedy.
#[derive(Debug)]
#[non_exhaustive]
pub enum SceneError {
    /// A file could not be opened or read.
    Read {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// A file was read, and what it says cannot be rendered.
    Content {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1, when the fault has a place.
        line: Option<usize>,
        /// What is wrong and what would be right, as a sentence without a full stop.
        reason: String,
    },
}

impl SceneError {
    /// A fault of the file as a whole.
    pub(crate) fn file(path: &Path, reason: impl Into<String>) -> Self {
        Self::Content { path: path.to_owned(), line: None, reason: reason.into() }
    }

    /// A fault of one line, counted from 1.
    pub(crate) fn line(path: &Path, line: usize, reason: impl Into<String>) -> Self {
        Self::Content { path: path.to_owned(), line: Some(line), reason: reason.into() }
    }

    /// A fault that the operating system reports.
    pub(crate) fn read(path: &Path, source: io::Error) -> Self {
        Self::Read { path: path.to_owned(), source }
    }

    /// The file at fault.
    #[must_use]
    pub fn path(&self) -> &Path {
        match self {
            Self::Read { path, .. } | Self::Content { path, .. } => path,
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { path, source } => {
                write!(f, "`{}`: could not be read: {source}", path.display())
            }
            Self::Content { path, line: None, reason } => {
                write!(f, "`{}`: {reason}", path.display())
            }
            Self::Content { path, line: Some(line), reason } => {
                write!(f, "`{}`, line {line}: {reason}", path.display())
            }
        }
    }
}

impl std::error::Error for SceneError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read { source, .. } => Some(source),
            Self::Content { .. } => None,
        }
    }
}
