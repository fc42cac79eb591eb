//! Lamps that are triangles.

use glam::{DVec3, Vec3};
use ray_casting::{EndPoint, Rgb};
use rendering_equation::measures;

use crate::light::LightSample;

/// A triangle that shines from its front. A quad is two of them.
#[derive(Clone, Copy, Debug)]
pub struct TriangleLamp {
    /// One corner, in scene units,
    corner: Vec3,
    /// and the ways from there to the other two.
    edges: [Vec3; 2],
    /// Unit normal of the front.
    normal: Vec3,
    /// 1 / area: the density per unit area of a uniform point.
    pdf_area: f32,
    /// Lₑ, in W m⁻² sr⁻¹.
    pub radiance: Rgb,
}

impl TriangleLamp {
    /// The lamp with these corners, counter-clockwise seen from the front.
    #[must_use]
    pub fn new([v0, v1, v2]: [Vec3; 3], radiance: Rgb) -> Self {
        let (e1, e2) = (v1 - v0, v2 - v0);
        let cross = e1.as_dvec3().cross(e2.as_dvec3());
        Self {
            corner: v0,
            edges: [e1, e2],
            normal: cross.normalize().as_vec3(),
            pdf_area: (2.0 / cross.length()) as f32,
            radiance,
        }
    }

    /// In squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        1.0 / f64::from(self.pdf_area)
    }

    // ANCHOR: sample
    /// Draws a uniform point of the triangle, as a direction from `viewer`.
    ///
    /// ```text
    /// b₁ = 1 − √u₀,   b₂ = u₁ √u₀
    /// ```
    ///
    /// Lines parallel to an edge get shorter in proportion to their distance from it; the root makes
    /// the long ones as much more likely. Density: [`TriangleLamp::pdf`].
    #[inline]
    #[must_use]
    pub fn sample(&self, viewer: Vec3, u: [f32; 2]) -> Option<LightSample> {
        let root = u[0].sqrt();
        let (b1, b2) = (1.0 - root, u[1] * root);
        let [e1, e2] = self.edges.map(|edge| edge.as_dvec3());
        let corner = self.corner.as_dvec3();
        let position: DVec3 = corner + f64::from(b1) * e1 + f64::from(b2) * e2;
        let end = EndPoint::new(position, corner.abs() + e1.abs() + e2.abs(), self.normal);

        let path = end.position - viewer;
        let distance_squared = path.length_squared();
        let wi = path / distance_squared.sqrt();
        let pdf_solid_angle = self.pdf(wi, distance_squared)?;
        let radiance = self.radiance;
        Some(LightSample { wi, radiance, pdf_solid_angle, is_delta: false, end: Some(end) })
    }

    /// Density with respect to solid angle, in 1/sr, with which a viewer draws the direction `wi`,
    /// in which the lamp is √`distance_squared` away; `None` if it does not shine there.
    #[inline]
    #[must_use]
    pub fn pdf(&self, wi: Vec3, distance_squared: f32) -> Option<f32> {
        let cos_theta = -self.normal.dot(wi);
        let pdf = measures::pdf_solid_angle(self.pdf_area, distance_squared, cos_theta);
        (cos_theta > 0.0 && 0.0 < pdf && pdf < f32::INFINITY).then_some(pdf)
    }
    // ANCHOR_END: sample
}
