//! One way on for a path.

use glam::Vec3;
use ray_casting::Rgb;

/// A direction drawn at a surface, with what it is worth.
#[derive(Clone, Copy, Debug)]
pub struct Scattered {
    /// ωᵢ: unit vector, from the surface toward where the light comes from.
    pub wi: Vec3,
    /// f(ωₒ, ωᵢ) |cos θᵢ| / p(ωᵢ): the factor by which the path's throughput changes.
    pub weight: Rgb,
    /// p(ωᵢ), the density with which the direction was drawn, per steradian.
    pub pdf_solid_angle: f32,
}
