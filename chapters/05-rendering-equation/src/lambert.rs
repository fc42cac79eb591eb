//! The matte surface: as bright from every side.

use std::f32::consts::FRAC_1_PI;

use glam::Vec3;
use ray_casting::Rgb;

use crate::directions::{cosine_hemisphere, cosine_hemisphere_pdf};
use crate::frame::Frame;

// ANCHOR: lambert
/// Lambert's BRDF: f = albedo / π.
///
/// ```text
/// ∫ f cos θᵢ dωᵢ = albedo,   because ∫ cos θ dω = π over the hemisphere
/// ```
///
/// The π that equation 1 of chapter 2 leaves out (errata 8) is this one.
#[derive(Clone, Copy, Debug)]
pub struct Lambert {
    /// The share of the arriving light that is reflected, 0 to 1: the k_d of the scene file.
    pub albedo: Rgb,
}

impl Lambert {
    /// f, in 1/sr, the same for all pairs of directions above the surface.
    #[inline]
    #[must_use]
    pub fn eval(&self) -> Rgb {
        self.albedo * FRAC_1_PI
    }

    /// Draws a direction in proportion to cos θ, which is f cos θ up to a factor. Density:
    /// [`Lambert::pdf`].
    #[inline]
    #[must_use]
    pub fn sample(&self, normal: Vec3, u: [f32; 2]) -> Vec3 {
        Frame::around(normal).to_world(cosine_hemisphere(u))
    }

    /// Density of [`Lambert::sample`] with respect to solid angle, in 1/sr.
    #[inline]
    #[must_use]
    pub fn pdf(&self, normal: Vec3, wi: Vec3) -> f32 {
        cosine_hemisphere_pdf(normal.dot(wi))
    }
}
// ANCHOR_END: lambert
