//! Chapter 5: what light does at a surface, as an integral, and how to estimate integrals by chance.
//!
//! Brings BRDFs that can be evaluated and sampled ([`Brdf`]: [`Lambert`], [`Lobe`]), densities over
//! [`directions`] and over surfaces ([`measures`]), Monte Carlo integration ([`monte_carlo`]), and
//! the tracer that follows N directions from every hit ([`DistributedTracer`]), compiled for what a
//! [`Survey`] of the scene finds. A second program, `estimate`, shows how fast Monte Carlo
//! integration converges ([`convergence`]). Relies on chapter 1 for rays, on chapter 4 for the tree,
//! on chapter 3 for mirrors and glass, and on chapter 2 for textures.

pub mod convergence;
pub mod directions;
pub mod measures;
pub mod monte_carlo;

mod brdf;
mod frame;
mod lambert;
mod lobe;
mod material;
mod radiance;
mod scattered;
mod search;
mod stage;
mod survey;

pub use brdf::Brdf;
pub use directions::Density;
pub use frame::Frame;
pub use lambert::Lambert;
pub use lobe::Lobe;
pub use material::{Material, Materials};
pub use radiance::{Branching, DistributedTracer, remarks, simplifications};
pub use scattered::Scattered;
pub use search::{Job, Renderer, draw};
pub use stage::{Extra, STAGE};
pub use survey::{Anything, Code, Has, MatteOnly, Opaque, Survey};
