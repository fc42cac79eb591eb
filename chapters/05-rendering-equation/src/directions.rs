//! Random directions with a known density.
//!
//! Each sampler maps two uniform numbers to a direction, and stands beside its density with respect
//! to solid angle. Hemispheres are those around +z; [`Frame`](crate::Frame) turns them.

use std::f32::consts::{FRAC_1_PI, PI, TAU};

use clap::ValueEnum;
use glam::Vec3;
use ray_casting::math;

/// How the directions at a matte surface are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Density {
    /// Every direction above the surface is as likely as any other.
    Uniform,
    /// In proportion to what counts: cos θ, and the highlight where there is one.
    #[default]
    Cosine,
}

// ANCHOR: cosine
/// Maps `u` ∈ [0,1)² to a direction around +z with density cos θ / π.
///
/// ```text
/// r = √u₀,  φ = 2π u₁,  ω = (r cos φ, r sin φ, √(1 − u₀))
/// ```
///
/// A uniform point of the unit disk is lifted onto the hemisphere. Seen from above, a patch dω
/// covers cos θ dω of the disk, hence the cosine. Malley's method, \[PBR4] §A.5. Since u₀ is at most
/// 1 − 2⁻²⁴, cos θ is at least 2⁻¹²: no direction lies in the plane. Density:
/// [`cosine_hemisphere_pdf`].
#[inline]
#[must_use]
pub fn cosine_hemisphere(u: [f32; 2]) -> Vec3 {
    let (sin_phi, cos_phi) = math::sin_cos(TAU * u[1]);
    let r = u[0].sqrt();
    Vec3::new(r * cos_phi, r * sin_phi, (1.0 - u[0]).sqrt())
}

/// Density of [`cosine_hemisphere`] with respect to solid angle, in 1/sr: p(ω) = cos θ / π above the
/// plane, 0 below.
#[inline]
#[must_use]
pub fn cosine_hemisphere_pdf(cos_theta: f32) -> f32 {
    cos_theta.max(0.0) * FRAC_1_PI
}
// ANCHOR_END: cosine

// ANCHOR: uniform
/// Maps `u` ∈ [0,1)² to a direction around +z, all equally likely.
///
/// ```text
/// cos θ = 1 − u₀,  φ = 2π u₁
/// ```
///
/// Between two heights, the area of a sphere is proportional to their difference (Archimedes), so
/// the height cos θ of a uniform direction is itself uniform. Density: [`uniform_hemisphere_pdf`].
#[inline]
#[must_use]
pub fn uniform_hemisphere(u: [f32; 2]) -> Vec3 {
    // 1 − cos²θ = u₀ (2 − u₀), without the cancellation near the pole.
    let r = (u[0] * (2.0 - u[0])).sqrt();
    let (sin_phi, cos_phi) = math::sin_cos(TAU * u[1]);
    Vec3::new(r * cos_phi, r * sin_phi, 1.0 - u[0])
}

/// Density of [`uniform_hemisphere`] with respect to solid angle, in 1/sr: 1 / 2π above the plane, 0
/// below.
#[inline]
#[must_use]
pub fn uniform_hemisphere_pdf(cos_theta: f32) -> f32 {
    if cos_theta > 0.0 { 0.5 * FRAC_1_PI } else { 0.0 }
}
// ANCHOR_END: uniform

/// Maps `u` ∈ [0,1)² to a direction, all equally likely: cos θ = 1 − 2u₀. Density: [`UNIFORM_SPHERE_PDF`].
#[inline]
#[must_use]
pub fn uniform_sphere(u: [f32; 2]) -> Vec3 {
    let r = 2.0 * (u[0] * (1.0 - u[0])).sqrt();
    let (sin_phi, cos_phi) = math::sin_cos(TAU * u[1]);
    Vec3::new(r * cos_phi, r * sin_phi, 1.0 - 2.0 * u[0])
}

/// Density of [`uniform_sphere`] with respect to solid angle, in 1/sr: 1 / 4π.
pub const UNIFORM_SPHERE_PDF: f32 = 0.25 / PI;
