//! The point of a primitive that a ray has met, as exactly as it is needed.

use glam::{DVec3, Vec2, Vec3};

use crate::ray::Ray;
use crate::sphere::Sphere;

/// A point and its normal in double precision, not yet rounded.
#[derive(Clone, Copy, Debug)]
pub struct ExactPoint {
    /// In scene units.
    pub position: DVec3,
    /// The size of the numbers that went into the position, for each axis.
    pub extent: DVec3,
    /// Unit normal of the front.
    pub normal: DVec3,
}

impl ExactPoint {
    /// The point of the triangle with these `corners`.
    #[inline(always)]
    #[must_use]
    pub fn of_triangle(corners: [Vec3; 3], barycentric: Vec2) -> Self {
        let [v0, v1, v2] = corners.map(|v| v.as_dvec3());
        let (e1, e2) = (v1 - v0, v2 - v0);
        let b = barycentric.as_dvec2();
        Self {
            position: v0 + b.x * e1 + b.y * e2,
            extent: v0.abs() + e1.abs() + e2.abs(),
            normal: e1.cross(e2).normalize(),
        }
    }

    /// The point of `sphere` that `ray` meets at `t`.
    ///
    /// **o** + t **d** is wrong by the rounding of t, far more than by its own: it is pulled back
    /// onto the sphere, \[PBR4] §6.8.5.
    #[inline]
    #[must_use]
    pub fn of_sphere(sphere: &Sphere, ray: &Ray, t: f32) -> Self {
        let (center, radius) = (sphere.center.as_dvec3(), f64::from(sphere.radius));
        let reached = ray.origin.as_dvec3() + f64::from(t) * ray.direction.as_dvec3();
        let normal = (reached - center).normalize();
        Self {
            position: center + radius * normal,
            extent: center.abs() + DVec3::splat(radius),
            normal,
        }
    }
}
