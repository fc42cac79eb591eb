//! Lamps that are flat: triangles and parallelograms.

use clap::ValueEnum;
use glam::{DVec3, Vec3};
use ray_casting::math::gamma;
use ray_casting::{EndPoint, Ray, Rgb};
use rendering_equation::measures;

use crate::light::LightSample;
use crate::spherical_triangle::SphericalTriangle;

/// In which measure a flat lamp is sampled uniformly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Measure {
    /// By area, from everywhere.
    Area,
    /// By solid angle from near, by area from afar
    #[default]
    SolidAngle,
}

/// The outline of a flat lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outline {
    Triangle,
    Parallelogram,
}

/// A triangle or a parallelogram that shines from its front.
#[derive(Clone, Copy, Debug)]
pub struct FlatLamp {
    outline: Outline,
    /// One corner, in scene units,
    corner: DVec3,
    /// and the ways from there to its two neighbours.
    edges: [DVec3; 2],
    /// The size of the numbers that go into a point, for each axis.
    extent: DVec3,
    /// How far the fourth corner may lie from where a parallelogram has it, for each axis.
    bend: Vec3,
    /// Unit normal of the front.
    pub normal: Vec3,
    /// 1 / area: the density per unit area of a uniform point.
    pdf_area: f32,
    /// The mean of the corners, in scene units,
    pub middle: Vec3,
    /// and how far the farthest of them is from there.
    pub radius: f32,
    /// The square of the distance to the middle below which a viewer is near; 0 if none ever is.
    near: f32,
    /// Lₑ, in W m⁻² sr⁻¹.
    pub radiance: Rgb,
    /// The triangle of the scene that it is, or the first of the two; [`Ray::NO_PRIMITIVE`] if it is
    /// none.
    primitive: u32,
}

impl FlatLamp {
    /// Within so many radii of its middle, a viewer is near to a lamp.
    ///
    /// What makes points of equal area bad is that r²/cos θ' differs from one to the next, and at a
    /// distance of several radii it hardly does. It has no bound at the lamp itself, and whoever is
    /// within half a radius of any of its points is within 1½ radii of its middle.
    const REACH: f32 = 1.5;

    /// The triangle with these corners, counter-clockwise seen from the front.
    #[must_use]
    pub fn triangle(corners: [Vec3; 3], radiance: Rgb, measure: Measure) -> Self {
        let [v0, v1, v2] = corners.map(|corner| corner.as_dvec3());
        Self::new(Outline::Triangle, v0, [v1 - v0, v2 - v0], radiance, measure)
    }

    /// The parallelogram with these corners, counter-clockwise seen from the front; `None` if they
    /// are not one.
    ///
    /// They are if their rounding to single precision may be why v₀ + v₂ differs from v₁ + v₃.
    #[must_use]
    pub fn parallelogram(corners: [Vec3; 4], radiance: Rgb, measure: Measure) -> Option<Self> {
        let [v0, v1, v2, v3] = corners.map(|corner| corner.as_dvec3());
        let bend = (v0 + v2 - v1 - v3).abs();
        let rounding = f64::from(gamma(1)) * (v0.abs() + v1.abs() + v2.abs() + v3.abs());
        let lamp = Self::new(Outline::Parallelogram, v0, [v1 - v0, v3 - v0], radiance, measure);
        bend.cmple(rounding).all().then_some(Self { bend: bend.as_vec3(), ..lamp })
    }

    fn new(
        outline: Outline,
        corner: DVec3,
        edges: [DVec3; 2],
        radiance: Rgb,
        measure: Measure,
    ) -> Self {
        let [e1, e2] = edges;
        let cross = e1.cross(e2);
        let (area, middle, farthest) = match outline {
            Outline::Triangle => (0.5 * cross.length(), (e1 + e2) / 3.0, DVec3::ZERO),
            Outline::Parallelogram => (cross.length(), (e1 + e2) / 2.0, e1 + e2),
        };
        let distances = [DVec3::ZERO, e1, e2, farthest].map(|corner| corner.distance(middle));
        let radius = distances.into_iter().fold(0.0, f64::max) as f32;
        let reach = match measure {
            Measure::Area => 0.0,
            Measure::SolidAngle => Self::REACH * radius,
        };
        Self {
            outline,
            corner,
            edges,
            extent: corner.abs() + e1.abs() + e2.abs(),
            bend: Vec3::ZERO,
            normal: cross.normalize().as_vec3(),
            pdf_area: (1.0 / area) as f32,
            middle: (corner + middle).as_vec3(),
            radius,
            near: reach * reach,
            radiance,
            primitive: Ray::NO_PRIMITIVE,
        }
    }

    /// The same lamp, known to be this triangle of the scene, or this one and another in its plane.
    #[must_use]
    pub const fn of_primitive(mut self, primitive: u32) -> Self {
        self.primitive = primitive;
        self
    }

    /// In squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        1.0 / f64::from(self.pdf_area)
    }

    // ANCHOR: sample
    /// Draws a point of the lamp, as a direction from `viewer`; `None` if it does not shine there.
    ///
    /// ```text
    /// parallelogram   b₁ = u₀,         b₂ = u₁
    /// triangle        b₁ = 1 − √u₀,   b₂ = u₁ √u₀
    /// ```
    ///
    /// From afar, a uniform point: b₁ and b₂ are its way along the two edges. In a triangle, lines
    /// parallel to an edge get shorter in proportion to their distance from it; the root makes the
    /// long ones as much more likely. From near, a uniform direction. Density: [`FlatLamp::pdf`].
    #[inline(always)]
    #[must_use]
    pub fn sample(&self, viewer: Vec3, u: [f32; 2]) -> Option<LightSample> {
        if self.is_behind(viewer) {
            return None;
        }
        if self.is_near(viewer) {
            return self.sample_solid_angle(viewer, u).map(LightSample::anew);
        }
        let (b1, b2) = match self.outline {
            Outline::Parallelogram => (u[0], u[1]),
            Outline::Triangle => {
                let root = u[0].sqrt();
                (1.0 - root, u[1] * root)
            }
        };
        let end = self.point(f64::from(b1), f64::from(b2));
        let path = end.position - viewer;
        let distance_squared = path.length_squared();
        let wi = path / distance_squared.sqrt();
        let pdf_solid_angle = self.pdf_of_area(wi, distance_squared)?;
        let radiance = self.radiance;
        Some(LightSample { wi, radiance, pdf_solid_angle, is_delta: false, end: Some(end) })
    }

    /// Density with respect to solid angle, in 1/sr, with which `viewer` draws the direction `wi`,
    /// in which the lamp is √`distance_squared` away; `None` if it does not shine there.
    #[inline]
    #[must_use]
    pub fn pdf(&self, viewer: Vec3, wi: Vec3, distance_squared: f32) -> Option<f32> {
        if self.is_behind(viewer) {
            None
        } else if self.is_near(viewer) {
            pdf_of(&self.halves(viewer))
        } else {
            self.pdf_of_area(wi, distance_squared)
        }
    }

    /// Whether the lamp surely turns its back on `viewer`.
    ///
    /// Not if the roundings could be why: γ(8) of the numbers that go in is more than those of the
    /// middle, of the way, of the normal and of their product together.
    #[inline]
    fn is_behind(&self, viewer: Vec3) -> bool {
        let way = viewer - self.middle;
        let doubt = gamma(8) * (way.abs() + self.middle.abs()).element_sum();
        self.normal.dot(way) < -doubt
    }

    /// Whether the lamp is sampled by solid angle from here. It depends on nothing but the place, so
    /// that whoever asks for a density later gets that of the way which was taken.
    #[inline]
    fn is_near(&self, viewer: Vec3) -> bool {
        viewer.distance_squared(self.middle) < self.near
    }

    /// p_ω = p_A r² / cos θ'.
    #[inline]
    fn pdf_of_area(&self, wi: Vec3, distance_squared: f32) -> Option<f32> {
        let cos_theta = -self.normal.dot(wi);
        let pdf = measures::pdf_solid_angle(self.pdf_area, distance_squared, cos_theta);
        (cos_theta > 0.0 && 0.0 < pdf && pdf < f32::INFINITY).then_some(pdf)
    }
    // ANCHOR_END: sample

    /// Draws one of all directions in which `viewer` sees the lamp, all equally likely.
    ///
    /// A parallelogram is two triangles, chosen in proportion to their solid angles. The direction is
    /// met with the lamp's plane; what rounding put outside the outline is moved back to its edge.
    #[inline(never)]
    fn sample_solid_angle(&self, viewer: Vec3, u: [f32; 2]) -> Option<LightSample> {
        let halves = self.halves(viewer);
        let solid_angles = halves.map(|half| half.map_or(0.0, |half| half.solid_angle));
        let pdf_solid_angle = pdf_of(&halves)?;
        let chosen = f64::from(u[0]) * (solid_angles[0] + solid_angles[1]);
        let (half, rest) = if chosen < solid_angles[0] {
            (halves[0]?, chosen / solid_angles[0])
        } else {
            (halves[1]?, (chosen - solid_angles[0]) / solid_angles[1])
        };
        let direction = half.sample([rest, f64::from(u[1])]);

        let [e1, e2] = self.edges;
        let normal = e1.cross(e2);
        let corner = self.corner - viewer.as_dvec3();
        let way = corner.dot(normal) / direction.dot(normal) * direction - corner;
        let b1 = share(way.cross(e2).dot(normal) / normal.length_squared());
        let b2 = share(e1.cross(way).dot(normal) / normal.length_squared());
        let beyond = match self.outline {
            Outline::Triangle => (b1 + b2).max(1.0),
            Outline::Parallelogram => 1.0,
        };
        let end = self.point(b1 / beyond, b2 / beyond);
        // Not the way to the end, which is rounded: of a lamp that is as near as the last digit of a
        // coordinate, as the one that the viewer lies on, it may lead anywhere.
        let (wi, radiance) = (direction.as_vec3(), self.radiance);
        let sample = LightSample { wi, radiance, pdf_solid_angle, is_delta: false, end: Some(end) };
        (end.position != viewer).then_some(sample)
    }

    /// The one or two triangles that `viewer` sees.
    fn halves(&self, viewer: Vec3) -> [Option<SphericalTriangle>; 2] {
        let [e1, e2] = self.edges;
        let v0 = self.corner - viewer.as_dvec3();
        let (v1, v2, v3) = (v0 + e1, v0 + e1 + e2, v0 + e2);
        let second = match self.outline {
            Outline::Triangle => None,
            Outline::Parallelogram => SphericalTriangle::new([v2, v3, v1]),
        };
        [SphericalTriangle::new([v0, v1, v3]), second]
    }

    /// The corner + b₁ e₁ + b₂ e₂.
    #[inline]
    fn point(&self, b1: f64, b2: f64) -> EndPoint {
        let [e1, e2] = self.edges;
        let end = EndPoint::new(self.corner + b1 * e1 + b2 * e2, self.extent, self.normal);
        let position_error = end.position_error + self.bend;
        EndPoint { position_error, primitive: self.primitive, ..end }
    }
}

/// b, from 0 to 1. So near to the plane that it is 0/0, any point of the lamp will do.
fn share(b: f64) -> f64 {
    if b > 0.0 { b.min(1.0) } else { 0.0 }
}

/// 1/Ω of what is seen of a lamp; `None` if nothing is.
fn pdf_of(halves: &[Option<SphericalTriangle>; 2]) -> Option<f32> {
    let solid_angle: f64 = halves.iter().flatten().map(|half| half.solid_angle).sum();
    let pdf = (1.0 / solid_angle) as f32;
    (0.0 < pdf && pdf < f32::INFINITY).then_some(pdf)
}
