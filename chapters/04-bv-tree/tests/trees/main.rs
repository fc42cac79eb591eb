//! What trees look like, and what they save.

mod counts;
mod own;
mod shapes;
mod threads;
mod tools;
