//! What a matte or glossy surface does at one point.

use glam::Vec3;
use ray_casting::Rgb;
use workbench::Sampler;

use crate::directions::{Density, uniform_hemisphere, uniform_hemisphere_pdf};
use crate::frame::Frame;
use crate::lambert::Lambert;
use crate::lobe::Lobe;
use crate::scattered::Scattered;

/// f(ωₒ, ωᵢ) with everything looked up that does not depend on ωᵢ.
///
/// Light is reflected to the viewer's side only, and what "above the surface" means is decided by
/// the geometric normal: an interpolated one may bend the cosine, but must not let light through.
#[derive(Clone, Copy, Debug)]
pub struct Brdf {
    /// Unit normal on the viewer's side, the one of the cosine; interpolated where the mesh has
    /// normals.
    pub normal: Vec3,
    /// Unit geometric normal on the viewer's side.
    pub facing: Vec3,
    /// Unit vector toward the viewer.
    pub wo: Vec3,
    /// The matte part.
    pub lambert: Lambert,
    /// The highlight, if there is one.
    pub lobe: Option<Lobe>,
}

impl Brdf {
    // ANCHOR: eval
    /// f(ωₒ, ωᵢ), in 1/sr: the sum of the matte part and the highlight above the surface, 0 below.
    #[inline(always)]
    #[must_use]
    pub fn eval(&self, wi: Vec3) -> Rgb {
        if !self.is_above(wi) {
            return Rgb::ZERO;
        }
        let highlight = self.lobe.map_or(Rgb::ZERO, |lobe| lobe.eval(self.normal, self.wo, wi));
        self.lambert.eval() + highlight
    }
    // ANCHOR_END: eval

    /// |cos θᵢ|, between `wi` and the normal.
    #[inline]
    #[must_use]
    pub fn cos_theta(&self, wi: Vec3) -> f32 {
        self.normal.dot(wi).max(0.0)
    }

    /// Whether `wi` points to the viewer's side, for both normals.
    #[inline]
    #[must_use]
    pub fn is_above(&self, wi: Vec3) -> bool {
        self.facing.dot(wi) > 0.0 && self.normal.dot(wi) > 0.0
    }

    /// Whether the surface reflects nothing, whatever arrives.
    #[inline]
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.lambert.albedo == Rgb::ZERO && self.lobe.is_none()
    }

    // ANCHOR: sample
    /// Draws a direction; `None` if it leads below the surface, where nothing is reflected.
    ///
    /// With [`Density::Cosine`] the matte part is sampled with density cos θ/π, so that its weight
    ///
    /// ```text
    /// f cos θ / p = (albedo/π) cos θ / (cos θ/π) = albedo
    /// ```
    ///
    /// does not depend on the direction at all: it is not even computed. A surface with a highlight
    /// draws from the one or the other part by chance, and divides by the density of the mixture.
    #[inline(always)]
    pub fn sample(&self, density: Density, sampler: &mut Sampler) -> Option<Scattered> {
        let wi = match (density, self.lobe) {
            (Density::Uniform, _) => {
                Frame::around(self.normal).to_world(uniform_hemisphere(sampler.next_2d()))
            }
            (Density::Cosine, Some(lobe)) if sampler.next_1d() < self.share_of_lobe() => {
                lobe.sample(self.normal, self.wo, sampler.next_2d())
            }
            (Density::Cosine, _) => self.lambert.sample(self.normal, sampler.next_2d()),
        };
        if !self.is_above(wi) {
            return None;
        }
        let pdf_solid_angle = self.pdf(density, wi);
        if pdf_solid_angle == 0.0 {
            // A lobe so narrow that rounding alone leads out of it.
            return None;
        }
        let weight = match (density, self.lobe) {
            (Density::Cosine, None) => self.lambert.albedo,
            _ => self.eval(wi) * (self.cos_theta(wi) / pdf_solid_angle),
        };
        Some(Scattered { wi, weight, pdf_solid_angle })
    }

    /// Density with which [`Brdf::sample`] draws `wi`, in 1/sr.
    #[inline(always)]
    #[must_use]
    pub fn pdf(&self, density: Density, wi: Vec3) -> f32 {
        if !self.is_above(wi) {
            return 0.0;
        }
        match (density, self.lobe) {
            (Density::Uniform, _) => uniform_hemisphere_pdf(self.cos_theta(wi)),
            (Density::Cosine, None) => self.lambert.pdf(self.normal, wi),
            (Density::Cosine, Some(lobe)) => {
                let share = self.share_of_lobe();
                (1.0 - share) * self.lambert.pdf(self.normal, wi)
                    + share * lobe.pdf(self.normal, self.wo, wi)
            }
        }
    }
    // ANCHOR_END: sample

    /// How often the highlight is sampled: in proportion to what it can reflect.
    #[inline]
    fn share_of_lobe(&self) -> f32 {
        let matte = self.lambert.albedo.element_sum();
        let glossy = self.lobe.map_or(0.0, |lobe| lobe.ks.element_sum());
        glossy / (matte + glossy)
    }
}
