//! Functions over the hemisphere whose integrals are known.

use std::f64::consts::{PI, TAU};

use clap::ValueEnum;
use glam::Vec3;
use ray_casting::math;

/// What is integrated, with respect to solid angle, over the hemisphere around +z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Integrand {
    /// cos θ: the light that a sky of radiance 1 sends onto the ground
    #[default]
    Cosine,
    /// 1: the solid angle of the hemisphere
    SolidAngle,
    /// (n·h)¹⁰ cos θ: a broad highlight, seen from straight above
    #[value(name = "lobe-10")]
    Lobe10,
    /// (n·h)¹⁰⁰ cos θ: a narrow one
    #[value(name = "lobe-100")]
    Lobe100,
    /// L cos θ, where L = 100 in a patch of sky of radius 5° at 60° from the zenith, else 0
    SkyPatch,
}

/// The patch of sky: its radiance, its radius and its distance from the zenith.
const PATCH: (f64, f64, f64) = (100.0, PI / 36.0, PI / 3.0);

impl Integrand {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 5] =
        [Self::Cosine, Self::SolidAngle, Self::Lobe10, Self::Lobe100, Self::SkyPatch];

    /// f(ω) for a unit vector above the ground.
    #[must_use]
    pub fn eval(self, wi: Vec3) -> f64 {
        let cos = f64::from(wi.z);
        match self {
            Self::Cosine => cos,
            Self::SolidAngle => 1.0,
            Self::Lobe10 => lobe(cos, 10.0),
            Self::Lobe100 => lobe(cos, 100.0),
            Self::SkyPatch => {
                let (radiance, radius, zenith) = PATCH;
                let (sin, cos_zenith) = math::sin_cos_f64(zenith);
                let to_center = f64::from(wi.x) * sin + cos * cos_zenith;
                let (_, edge) = math::sin_cos_f64(radius);
                if to_center > edge { radiance * cos } else { 0.0 }
            }
        }
    }

    /// ∫ f dω, exactly.
    ///
    /// ```text
    /// ∫ cos θ dω = π,   ∫ dω = 2π
    /// ∫ (n·h)ᵖ cos θ dω = 8π (2^(−p/2) + p) / ((p + 2)(p + 4))   seen along n
    /// ∫ L cos θ dω = π L sin²α cos β   for a disk of radius α at β from the zenith
    /// ```
    #[must_use]
    pub fn integral(self) -> f64 {
        match self {
            Self::Cosine => PI,
            Self::SolidAngle => TAU,
            Self::Lobe10 => lobe_integral(10.0),
            Self::Lobe100 => lobe_integral(100.0),
            Self::SkyPatch => {
                let (radiance, radius, zenith) = PATCH;
                let (sin, _) = math::sin_cos_f64(radius);
                let (_, cos_zenith) = math::sin_cos_f64(zenith);
                PI * radiance * sin * sin * cos_zenith
            }
        }
    }

    /// The integral as a formula.
    #[must_use]
    pub const fn formula(self) -> &'static str {
        match self {
            Self::Cosine => "∫ cos θ dω = π",
            Self::SolidAngle => "∫ dω = 2π",
            Self::Lobe10 => "∫ (n·h)¹⁰ cos θ dω = 8π (2⁻⁵ + 10)/(12 · 14)",
            Self::Lobe100 => "∫ (n·h)¹⁰⁰ cos θ dω = 8π (2⁻⁵⁰ + 100)/(102 · 104)",
            Self::SkyPatch => "∫ L cos θ dω = 100 π sin² 5° cos 60°",
        }
    }

    /// a, where f falls as cosᵃ θ toward the horizon; `None` if it is 0 there.
    #[must_use]
    pub const fn power_at_horizon(self) -> Option<i32> {
        match self {
            Self::Cosine | Self::Lobe10 | Self::Lobe100 => Some(1),
            Self::SolidAngle => Some(0),
            Self::SkyPatch => None,
        }
    }
}

/// (n·h)ᵖ cos θ for ωₒ = n: the halfway vector stands at θ/2, and cos² θ/2 = (1 + cos θ)/2.
fn lobe(cos: f64, p: f64) -> f64 {
    math::power_f64(0.5 * (1.0 + cos), 0.5 * p) * cos
}

fn lobe_integral(p: f64) -> f64 {
    8.0 * PI * (math::exp2_f64(-0.5 * p) + p) / ((p + 2.0) * (p + 4.0))
}
