//! Chapter 7: ask the lamps instead of waiting to meet them.
//!
//! Brings [`Lights`] that can be sampled ([`TriangleLamp`], [`SphereLamp`], point lights and the
//! sky), the choice among them ([`Choice`]), and the path tracer that weighs both ways to find a lamp
//! against each other ([`LightTracer`], [`Heuristic`]). Relies on chapter 6 for the path and its
//! ending, and on what chapter 6 relies on.

mod choice;
mod heuristic;
mod light;
mod lights;
mod radiance;
mod sphere_lamp;
mod stage;
mod triangle_lamp;

pub use choice::Choice;
pub use heuristic::{Estimator, Heuristic};
pub use light::{Light, LightSample};
pub use lights::Lights;
pub use radiance::{LightTracer, Settings};
pub use sphere_lamp::SphereLamp;
pub use stage::{Extra, STAGE};
pub use triangle_lamp::TriangleLamp;
