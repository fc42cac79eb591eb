//! Chapter 6: follow one random path per sample.
//!
//! Brings the path as a loop ([`PathTracer`]) and the two ways to end it: a limit, which loses
//! light, and Russian [`Roulette`], which does not. Relies on chapter 5 for what a surface does, on
//! chapter 4 for the tree, and on chapters 1 and 3 for rays, mirrors and glass.

mod radiance;
mod roulette;
mod stage;

pub use radiance::PathTracer;
pub use roulette::{Ending, Roulette};
pub use stage::{Ends, Extra, STAGE};
