//! Every stage, through its own binary.

mod agreement;
mod bad_input;
mod closed_forms;
mod command_line;
#[cfg(unix)]
mod interrupt;
mod output;
mod scenes;
mod skips;
mod sound;
mod stated_error;
mod unneeded;
