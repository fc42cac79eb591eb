//! Chapter 2: how bright is the surface that a ray meets?
//!
//! Brings the reflection model of Blinn and Phong, shadow rays and textures. Relies on chapter 1.

pub mod reflection;

mod material;
mod picture;
mod radiance;
mod stage;

pub use material::Material;
pub use picture::Picture;
pub use radiance::{Shader, Terms};
pub use stage::{Extra, STAGE};
