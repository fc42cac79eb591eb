//! Chapter 7: ask the lamps instead of waiting to meet them.
//!
//! Brings [`Lights`] that can be sampled ([`FlatLamp`], [`SphereLamp`], point lights and the sky),
//! the choice among them ([`Choice`]), and the path tracer that weighs both ways to find a lamp
//! against each other ([`LightTracer`], [`Heuristic`]). Relies on chapter 6 for the path and its
//! ending, and on what chapter 6 relies on.

mod between;
mod choice;
mod discrete;
mod flat_lamp;
mod heuristic;
mod light;
mod lights;
mod nearby;
mod radiance;
mod sphere_lamp;
mod spherical_triangle;
mod stage;

pub use between::between;
pub use choice::Choice;
pub use discrete::Discrete;
pub use flat_lamp::{FlatLamp, Measure};
pub use heuristic::{Estimator, Heuristic};
pub use light::{Light, LightSample};
pub use lights::Lights;
pub use nearby::Nearby;
pub use radiance::{LightTracer, Settings};
pub use sphere_lamp::SphereLamp;
pub use spherical_triangle::SphericalTriangle;
pub use stage::{Extra, STAGE};
