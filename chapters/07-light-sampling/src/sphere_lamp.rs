//! Lamps that are spheres.

use std::f64::consts::{PI, TAU};

use glam::Vec3;
use ray_casting::{EndPoint, Rgb, Sphere, math};
use rendering_equation::Frame;

use crate::light::LightSample;

/// A sphere that shines outward.
#[derive(Clone, Copy, Debug)]
pub struct SphereLamp {
    /// In scene units.
    pub sphere: Sphere,
    /// Lₑ, in W m⁻² sr⁻¹.
    pub radiance: Rgb,
}

/// The cone in which a viewer sees a sphere.
#[derive(Clone, Copy, Debug)]
struct Cone {
    /// Unit vector toward the centre.
    axis: Vec3,
    /// sin θ_max.
    sin_max: f64,
    /// 1 − cos θ_max.
    one_minus_cos_max: f64,
}

impl SphereLamp {
    /// In squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        4.0 * PI * f64::from(self.sphere.radius) * f64::from(self.sphere.radius)
    }

    // ANCHOR: sample
    /// Draws a direction of the cone in which `viewer` sees the sphere, all equally likely.
    ///
    /// ```text
    /// 1 − cos θ = u₀ (1 − cos θ_max),   φ = 2π u₁
    /// sin β = sin θ / sin θ_max,   α = β − θ
    /// ```
    ///
    /// β is the angle at the sphere between the ray and the normal, and α, at the centre, says which
    /// point of the sphere is met first. Everything grows from 1 − cos θ, which keeps its digits
    /// when the lamp is tiny: cos θ itself rounds to 1. `None` from inside, where it is dark.
    #[inline]
    #[must_use]
    pub fn sample(&self, viewer: Vec3, u: [f32; 2]) -> Option<LightSample> {
        let cone = self.cone(viewer)?;
        let x = f64::from(u[0]) * cone.one_minus_cos_max;
        let (cos, sin) = (1.0 - x, (x * (2.0 - x)).sqrt());
        let sin_beta = (sin / cone.sin_max).min(1.0);
        let cos_beta = ((1.0 - sin_beta) * (1.0 + sin_beta)).sqrt();
        let cos_alpha = cos * cos_beta + sin * sin_beta;
        let sin_alpha = cos * sin_beta - sin * cos_beta;

        let (sin_phi, cos_phi) = math::sin_cos(TAU as f32 * u[1]);
        let frame = Frame::around(cone.axis);
        let aside = (cos_phi * frame.tangent + sin_phi * frame.bitangent).as_dvec3();
        let normal = (sin_alpha * aside - cos_alpha * cone.axis.as_dvec3()).normalize();
        let (center, radius) = (self.sphere.center.as_dvec3(), f64::from(self.sphere.radius));
        let position = center + radius * normal;
        let end = EndPoint::new(position, center.abs() + radius, normal.as_vec3());
        Some(LightSample {
            wi: (position - viewer.as_dvec3()).normalize().as_vec3(),
            radiance: self.radiance,
            pdf_solid_angle: cone.pdf(),
            is_delta: false,
            end: Some(end),
        })
    }

    /// Density with respect to solid angle, in 1/sr, with which `viewer` draws each direction in
    /// which it sees the sphere; `None` from inside.
    #[inline]
    #[must_use]
    pub fn pdf(&self, viewer: Vec3) -> Option<f32> {
        Some(self.cone(viewer)?.pdf())
    }
    // ANCHOR_END: sample

    /// The cone in which `viewer` sees the sphere; `None` from inside.
    #[inline]
    fn cone(&self, viewer: Vec3) -> Option<Cone> {
        let (center, radius) = (self.sphere.center.as_dvec3(), f64::from(self.sphere.radius));
        let path = center - viewer.as_dvec3();
        let distance = path.length();
        if distance <= radius {
            return None;
        }
        let sin_max = radius / distance;
        let cos_max = ((distance - radius) * (distance + radius)).sqrt() / distance;
        let one_minus_cos_max = sin_max * sin_max / (1.0 + cos_max);
        Some(Cone { axis: (path / distance).as_vec3(), sin_max, one_minus_cos_max })
    }
}

impl Cone {
    /// 1 / (2π (1 − cos θ_max)): one over the solid angle of the cone.
    #[inline]
    fn pdf(&self) -> f32 {
        (1.0 / (TAU * self.one_minus_cos_max)) as f32
    }
}
