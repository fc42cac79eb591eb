//! The densities that the study compares, one of them poor.

use std::f64::consts::{FRAC_1_PI, TAU};

use clap::ValueEnum;
use glam::Vec3;
use ray_casting::math;
use workbench::Sampler;

use crate::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
};

/// How directions of the hemisphere around +z are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Sampling {
    /// p = 1/2π
    Uniform,
    /// p = cos θ/π
    Cosine,
    /// p = 4 cos⁷ θ/π: hardly ever looks at the horizon
    Peaked,
}

impl Sampling {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 3] = [Self::Uniform, Self::Cosine, Self::Peaked];

    /// Draws a direction with the density [`Sampling::pdf_solid_angle`].
    ///
    /// The peaked density is drawn by cos θ = u^(1/8). A `u` of 24 bits would never come nearer to
    /// the horizon than cos θ = 2⁻³, and miss a share of the integral: it gets 48.
    #[must_use]
    pub fn sample(self, sampler: &mut Sampler) -> Vec3 {
        match self {
            Self::Uniform => uniform_hemisphere(sampler.next_2d()),
            Self::Cosine => cosine_hemisphere(sampler.next_2d()),
            Self::Peaked => {
                let [coarse, fine] = sampler.next_2d().map(f64::from);
                let step = 1.0 / 16_777_216.0;
                let u = coarse + step * (fine + 0.5 * step);
                let cos = u.sqrt().sqrt().sqrt();
                let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
                let (sin_phi, cos_phi) = math::sin_cos_f64(TAU * f64::from(sampler.next_1d()));
                Vec3::new((sin * cos_phi) as f32, (sin * sin_phi) as f32, cos as f32)
            }
        }
    }

    /// p(ω) in 1/sr.
    #[must_use]
    pub fn pdf_solid_angle(self, wi: Vec3) -> f64 {
        match self {
            Self::Uniform => f64::from(uniform_hemisphere_pdf(wi.z)),
            Self::Cosine => f64::from(cosine_hemisphere_pdf(wi.z)),
            Self::Peaked => {
                let cos = f64::from(wi.z.max(0.0));
                let cos2 = cos * cos;
                4.0 * FRAC_1_PI * (cos2 * cos2 * cos2 * cos)
            }
        }
    }

    /// m, where p falls as cosᵐ θ toward the horizon.
    #[must_use]
    pub const fn power_at_horizon(self) -> i32 {
        match self {
            Self::Uniform => 0,
            Self::Cosine => 1,
            Self::Peaked => 7,
        }
    }

    /// As in the table's heading.
    pub(super) const fn heading(self) -> &'static str {
        match self {
            Self::Uniform => "uniform density, p = 1/2π",
            Self::Cosine => "cosine density, p = cos θ/π",
            Self::Peaked => "peaked density, p = 4 cos⁷ θ/π",
        }
    }

    /// The mark of its curve.
    pub(super) const fn mark(self) -> char {
        match self {
            Self::Uniform => 'u',
            Self::Cosine => 'c',
            Self::Peaked => 'p',
        }
    }
}
