//! Chapter 3: what mirrors and glass show, by a function that calls itself.
//!
//! Brings the recursion ([`RayTracer`]), the laws of reflection and refraction ([`fresnel`]), and
//! the book-keeping of what a ray is inside of ([`Media`]). Relies on chapter 1 for rays and on
//! chapter 2 for the light on diffuse surfaces.

pub mod fresnel;

mod boundaries;
mod contacts;
mod limits;
mod material;
mod media;
mod radiance;
mod smooth;
mod stage;

pub use boundaries::{Boundaries, Crossing};
pub use contacts::Contacts;
pub use limits::{Cutoff, Limits};
pub use material::Surface;
pub use media::Media;
pub use radiance::{RayTracer, simplifications};
pub use smooth::{mirror_direction, split};
pub use stage::STAGE;
