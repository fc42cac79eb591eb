//! The binaries of the stages, as a user has them: run in a folder of their own.
//!
//! The tests lie in `tests/stages/`. They see what a user sees: exit status, messages, files.

mod folder;
mod stages;

pub use folder::Folder;
pub use stages::{ESTIMATING, STAGES, binary};
