//! The kinds of light.

use glam::Vec3;
use ray_casting::{EndPoint, Ray, Rgb, SurfacePoint};
use rendering_equation::Lambert;

use crate::flat_lamp::FlatLamp;
use crate::sphere_lamp::SphereLamp;

/// Something that light comes from.
#[derive(Clone, Copy, Debug)]
pub enum Light {
    /// A triangle or a parallelogram that shines from its front.
    Flat(FlatLamp),
    /// A sphere that shines outward.
    Sphere(SphereLamp),
    /// A point, which no ray hits by chance.
    Point {
        /// In scene units.
        position: Vec3,
        /// Radiant intensity, in W/sr: π times the I of the scene file, whose unit leaves the 1/π of
        /// the Lambertian BRDF out.
        intensity: Rgb,
    },
    /// What a ray finds that leaves the scene: the same radiance from everywhere.
    Sky {
        /// In W m⁻² sr⁻¹.
        radiance: Rgb,
    },
}

/// A direction toward a light, and what comes from there if nothing is in the way.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// ωᵢ: unit vector, from the surface to the light.
    pub wi: Vec3,
    /// Lᵢ along it; of a point light I/r², which stands for ∫ Lᵢ dω.
    pub radiance: Rgb,
    /// Density with which the direction was drawn, per steradian; of a point light 1.
    pub pdf_solid_angle: f32,
    /// Whether no other way of drawing directions could have found the light.
    pub is_delta: bool,
    /// Where the light is; `None` for the sky.
    pub end: Option<EndPoint>,
}

impl LightSample {
    /// The ray that finds out whether something is in the way.
    #[inline]
    #[must_use]
    pub fn shadow_ray(&self, surface: &SurfacePoint) -> Ray {
        match &self.end {
            Some(end) => surface.spawn_toward(end),
            None => surface.spawn(self.wi),
        }
    }

    /// The same, put together anew.
    ///
    /// Two ways of drawing a point are too long to be inlined; what they find they leave in memory.
    /// Passed on as it is, it makes all other ways leave theirs in the same memory, piece by piece,
    /// and whoever then reads several pieces at once waits for the last one. Put together anew, it
    /// does not matter where it came from, and the others stay in registers.
    #[inline(always)]
    pub(crate) fn anew(self) -> Self {
        let Self { wi, radiance, pdf_solid_angle, is_delta, end } = self;
        let end = end.map(|end| {
            let EndPoint { position, position_error, normal, primitive } = end;
            EndPoint { position, position_error, normal, primitive }
        });
        Self { wi, radiance, pdf_solid_angle, is_delta, end }
    }
}

impl Light {
    /// Draws a direction from `surface` toward the light; `None` if nothing can arrive.
    #[inline(always)]
    #[must_use]
    pub fn sample(&self, surface: &SurfacePoint, u: [f32; 2]) -> Option<LightSample> {
        match self {
            Self::Flat(lamp) => lamp.sample(surface.position, u),
            Self::Sphere(lamp) => lamp.sample(surface.position, u).map(LightSample::anew),
            Self::Point { position, intensity } => {
                let path = position - surface.position;
                let distance_squared = path.length_squared();
                let radiance = intensity / distance_squared;
                // At the light itself there is no direction; far away nothing is left.
                (radiance.is_finite() && radiance != Rgb::ZERO).then(|| LightSample {
                    wi: path / distance_squared.sqrt(),
                    radiance,
                    pdf_solid_angle: 1.0,
                    is_delta: true,
                    end: Some(EndPoint::in_space(*position)),
                })
            }
            Self::Sky { radiance } => {
                let (facing, white) = (surface.facing_normal(), Lambert { albedo: Rgb::ONE });
                let wi = white.sample(facing, u);
                let pdf_solid_angle = white.pdf(facing, wi);
                (pdf_solid_angle > 0.0).then_some(LightSample {
                    wi,
                    radiance: *radiance,
                    pdf_solid_angle,
                    is_delta: false,
                    end: None,
                })
            }
        }
    }

    /// The ray from `surface` to the middle of the light, or straight up to the sky.
    #[must_use]
    pub(crate) fn ray_from(&self, surface: &SurfacePoint) -> Ray {
        match self {
            Self::Flat(lamp) => surface.spawn_to(lamp.middle),
            Self::Sphere(lamp) => surface.spawn_to(lamp.sphere.center),
            Self::Point { position, .. } => surface.spawn_to(*position),
            Self::Sky { .. } => surface.spawn(surface.facing_normal()),
        }
    }

    /// How much it sends out in all, in W, added up over the colours. `radius` is that of a sphere
    /// around the scene: the sky sends through it what could reach something.
    #[must_use]
    pub fn power(&self, radius: f64) -> f64 {
        use std::f64::consts::PI;
        let sum = |rgb: &Rgb| f64::from(rgb.x) + f64::from(rgb.y) + f64::from(rgb.z);
        match self {
            Self::Flat(lamp) => PI * lamp.area() * sum(&lamp.radiance),
            Self::Sphere(lamp) => PI * lamp.area() * sum(&lamp.radiance),
            Self::Point { intensity, .. } => 4.0 * PI * sum(intensity),
            Self::Sky { radiance } => 4.0 * PI * PI * radius * radius * sum(radiance),
        }
    }
}
