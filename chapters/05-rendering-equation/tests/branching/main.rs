//! Distributed ray tracing against closed forms.

mod as_printed;
mod counts;
mod glass;
mod mistakes;
mod rooms;
mod scenes;
mod sky;
