//! Why a run ended without a picture.

use std::path::PathBuf;
use std::process::ExitCode;
use std::{fmt, io};

use crate::SceneError;

/// Why a run ended without a picture. Its text is one sentence with a remedy.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The command line is at fault; exit status 2.
    CommandLine(String),
    /// The scene, or a file it names, is at fault.
    Scene(SceneError),
    /// A file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// A picture could not be read.
    Picture {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The picture needs more memory than there is.
    Memory(String),
    /// The threads could not be started.
    Threads(String),
}

impl Error {
    /// 2 when the command line is at fault, otherwise 1.
    #[must_use]
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::CommandLine(_) => ExitCode::from(2),
            _ => ExitCode::from(1),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CommandLine(sentence) | Self::Memory(sentence) => f.write_str(sentence),
            Self::Scene(error) => error.fmt(f),
            Self::Write { path, source } => {
                write!(f, "`{}`: could not be written: {source}", path.display())
            }
            Self::Picture { path, reason } => write!(f, "`{}`: {reason}", path.display()),
            Self::Threads(reason) => {
                write!(f, "the threads could not be started: {reason}; try `--threads 1`")
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Scene(error) => Some(error),
            Self::Write { source, .. } => Some(source),
            _ => None,
        }
    }
}

impl From<SceneError> for Error {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}
