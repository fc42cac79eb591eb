//! The Blinn-Phong highlight, normalised.

use std::f32::consts::{PI, TAU};

use glam::Vec3;
use ray_casting::{Rgb, math};

use crate::frame::Frame;

// ANCHOR: lobe
/// The Blinn-Phong lobe as a BRDF.
///
/// ```text
/// f(ωₒ, ωᵢ) = k_s C(p) (n·h)ᵖ,   h = (ωₒ + ωᵢ) / |ωₒ + ωᵢ|
/// C(p) = (p + 2)(p + 4) / (8π (2^(−p/2) + p))
/// ```
///
/// C makes C ∫ (n·h)ᵖ cos θᵢ dωᵢ one for a viewer straight above; seen from anywhere else it is
/// less, so k_s is the largest share of the light that is reflected, and with k_d + k_s ≤ 1 no
/// surface gives more than it gets. Swapping ωₒ and ωᵢ changes nothing:
/// the lobe is reciprocal. Its source is \[Blinn77]; (p + 8)/(8π), which is common, is C for large p.
#[derive(Clone, Copy, Debug)]
pub struct Lobe {
    /// k_s: reflectance at normal incidence, 0 to 1.
    pub ks: Rgb,
    /// p: the larger, the narrower; at least 0.
    pub exponent: f32,
    /// C(p), in 1/sr.
    normalisation: f32,
}
// ANCHOR_END: lobe

impl Lobe {
    /// A lobe of this reflectance and exponent.
    #[must_use]
    pub fn new(ks: Rgb, exponent: f32) -> Self {
        let p = f64::from(exponent);
        let c = (p + 2.0) * (p + 4.0) / (8.0 * f64::from(PI) * (math::exp2_f64(-0.5 * p) + p));
        Self { ks, exponent, normalisation: c as f32 }
    }

    /// f, in 1/sr, for two directions above the surface.
    #[inline]
    #[must_use]
    pub fn eval(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Rgb {
        self.ks * (self.normalisation * self.power(normal, wo, wi))
    }

    // ANCHOR: sample
    /// Draws a normal **h** with density (p + 1)/2π (n·h)ᵖ and mirrors `wo` in it.
    ///
    /// ```text
    /// cos α = (1 − u₀)^(1/(p+1)),   φ = 2π u₁,   ωᵢ = 2 (ωₒ·h) h − ωₒ
    /// ```
    ///
    /// The result may lie below the surface. Density: [`Lobe::pdf`].
    #[inline]
    #[must_use]
    pub fn sample(&self, normal: Vec3, wo: Vec3, u: [f32; 2]) -> Vec3 {
        let cos = math::power_f64(1.0 - f64::from(u[0]), 1.0 / (f64::from(self.exponent) + 1.0));
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt() as f32;
        let (sin_phi, cos_phi) = math::sin_cos(TAU * u[1]);
        let h = Frame::around(normal).to_world(Vec3::new(sin * cos_phi, sin * sin_phi, cos as f32));
        (2.0 * wo.dot(h) * h - wo).normalize()
    }

    /// Density of [`Lobe::sample`] with respect to solid angle, in 1/sr.
    ///
    /// ```text
    /// p(ωᵢ) = (p + 1)/2π (n·h)ᵖ / (4 ωₒ·h)
    /// ```
    ///
    /// The 4 ωₒ·h is dωᵢ/dh: mirroring turns a direction by twice the angle of the normal.
    #[inline]
    #[must_use]
    pub fn pdf(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> f32 {
        let half = wo + wi;
        let cos = 0.5 * half.length();
        if cos == 0.0 {
            return 0.0;
        }
        (self.exponent + 1.0) / TAU * self.power(normal, wo, wi) / (4.0 * cos)
    }
    // ANCHOR_END: sample

    /// (n·h)ᵖ, 0 where h points below the surface.
    #[inline]
    fn power(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> f32 {
        let half = (wo + wi).normalize_or_zero();
        let cos = normal.dot(half);
        if cos > 0.0 { math::power(cos.min(1.0), self.exponent) } else { 0.0 }
    }
}
