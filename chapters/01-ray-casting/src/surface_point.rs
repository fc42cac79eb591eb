//! What is known about the point a ray has met, and how to leave it.

use glam::{DVec3, Vec3};

use crate::hit::Hit;
use crate::interval::Interval;
use crate::math::gamma;
use crate::ray::Ray;

/// A point of a surface: everything that every kind of shading needs.
///
/// What only some need, interpolated normals and texture coordinates, is looked up on demand by
/// [`Scene`](crate::Scene) from `hit`.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// In scene units.
    pub position: Vec3,
    /// How far the exact point may lie from `position`, for each axis; in scene units.
    pub position_error: Vec3,
    /// Unit normal of the front: of a triangle the side from which its vertices run
    /// counter-clockwise, of a sphere the outside.
    pub geometric_normal: Vec3,
    /// Unit vector toward the viewer.
    pub wo: Vec3,
    /// Index into [`Scene::materials`](crate::Scene::materials).
    pub material: u32,
    /// What the search found.
    pub hit: Hit,
}

impl SurfacePoint {
    /// Whether the viewer looks at the front.
    #[inline]
    #[must_use]
    pub fn is_front(&self) -> bool {
        self.geometric_normal.dot(self.wo) > 0.0
    }

    /// The geometric normal, turned to the viewer's side.
    #[inline]
    #[must_use]
    pub fn facing_normal(&self) -> Vec3 {
        if self.is_front() { self.geometric_normal } else { -self.geometric_normal }
    }

    /// A ray that leaves along `direction` (unit length) and does not meet this surface again.
    #[inline]
    #[must_use]
    pub fn spawn(&self, direction: Vec3) -> Ray {
        self.ray(self.offset_origin(direction), direction, f32::INFINITY)
    }

    /// A ray that leaves for `target` and ends there.
    #[inline]
    #[must_use]
    pub fn spawn_to(&self, target: Vec3) -> Ray {
        let origin = self.offset_origin(target - self.position);
        let path = target - origin;
        let distance = path.length();
        self.ray(origin, path / distance, distance)
    }

    /// A ray that leaves for the surface that `end` lies on, and ends just before it.
    ///
    /// It starts on the side of this surface on which the target lies, and ends on the side of the
    /// other one from which it comes, so neither of the two is in its own way. Three roundings are
    /// accounted for besides those of the two points:
    ///
    /// - The direction is rounded, so far away the ray passes beside its end, by γ(3) of the way for
    ///   each axis. As much is added to the error of the end, or a surface that is seen along its
    ///   edge would be met a long way before it.
    /// - The length of a rounded path is off by γ(4) of it, and a hit's t by its own rounding: γ(8)
    ///   of the length is left out at the end.
    #[inline]
    #[must_use]
    pub fn spawn_toward(&self, end: &EndPoint) -> Ray {
        let way = end.position - self.position;
        let passes_by = gamma(3) * way.abs();
        let end = EndPoint { position_error: end.position_error + passes_by, ..*end };
        let origin = self.offset_origin(way);
        let path = end.offset(origin) - origin;
        let distance = path.length();
        let ray = self.ray(origin, path / distance, distance * (1.0 - gamma(8)));
        Ray { end_primitive: end.primitive, ..ray }
    }

    /// A ray from this surface, as far as `max`.
    #[inline]
    const fn ray(&self, origin: Vec3, direction: Vec3, max: f32) -> Ray {
        let extent = Interval::new(0.0, max);
        let (origin_primitive, end_primitive) = (self.hit.primitive, Ray::NO_PRIMITIVE);
        Ray { origin, direction, extent, origin_primitive, end_primitive }
    }

    /// An origin that lies surely on the side of the surface to which `direction` points.
    #[inline]
    fn offset_origin(&self, direction: Vec3) -> Vec3 {
        offset(self.position, self.position_error, self.geometric_normal, direction)
    }
}

// ANCHOR: offset
/// A point that lies surely on the side of the surface to which `direction` points.
///
/// ```text
/// o = p ± δ n,   δ = Σ |nᵢ| (eᵢ + γ(2) |pᵢ|)
/// ```
///
/// The exact point lies in the box **p** ± **e**, and no corner of that box is farther from **p**
/// along **n** than Σ |nᵢ| eᵢ \[PBR4] §6.8.6. Adding δ **n** rounds once more, by at most u |pᵢ| for
/// each component: that is moved away from as well. The last factor covers the roundings of δ itself.
/// No constant is involved: the step is a few units in the last place of **p**, at every scale.
/// [`offset_by_epsilon`] is what it replaces.
#[inline]
fn offset(position: Vec3, error: Vec3, n: Vec3, direction: Vec3) -> Vec3 {
    let distance = (1.0 + gamma(8)) * n.abs().dot(error + gamma(2) * position.abs());
    position + distance.copysign(direction.dot(n)) * n
}
// ANCHOR_END: offset

/// A point of a surface that another point wants to see: of a lamp, as a rule.
#[derive(Clone, Copy, Debug)]
pub struct EndPoint {
    /// In scene units.
    pub position: Vec3,
    /// How far the exact point may lie from `position`, for each axis; in scene units.
    pub position_error: Vec3,
    /// Unit normal of the surface, of either side.
    pub normal: Vec3,
    /// The triangle that it lies on, or [`Ray::NO_PRIMITIVE`].
    pub primitive: u32,
}

impl EndPoint {
    /// A point computed in double precision from numbers as large as `extent`, for each axis. It lies
    /// on no triangle until it is said to.
    #[inline]
    #[must_use]
    pub fn new(position: DVec3, extent: DVec3, normal: Vec3) -> Self {
        let position = position.as_vec3();
        let position_error = rounding_box(position, extent.as_vec3());
        Self { position, position_error, normal, primitive: Ray::NO_PRIMITIVE }
    }

    /// A place that has no surface, such as a point light's.
    #[inline]
    #[must_use]
    pub const fn in_space(position: Vec3) -> Self {
        let (zero, primitive) = (Vec3::ZERO, Ray::NO_PRIMITIVE);
        Self { position, position_error: zero, normal: zero, primitive }
    }

    /// The point, moved off its surface to the side of `viewer`.
    #[inline]
    fn offset(&self, viewer: Vec3) -> Vec3 {
        offset(self.position, self.position_error, self.normal, viewer - self.position)
    }
}

/// The error box around a point whose components were rounded once from (nearly) exact values.
///
/// Half a unit in the last place is u |p|; γ(2) |p| leaves as much again for the double-precision
/// computation behind it, and `extent` is the size of the numbers that went into that.
#[inline]
#[must_use]
pub(crate) fn rounding_box(position: Vec3, extent: Vec3) -> Vec3 {
    gamma(2) * position.abs() + DOUBLE_ROUNDING * extent
}

/// γ(16) of double precision, as a bound for sums and products of a handful of terms.
const DOUBLE_ROUNDING: f32 = 16.0 * f64::EPSILON as f32;

// ANCHOR: offset_by_epsilon
/// The folklore version, kept to show what it breaks: moves by a constant, whatever the scale.
///
/// Too small a constant leaves points in their own shadow (acne), too large a one detaches shadows
/// from what casts them; which of the two depends on the size of the scene.
#[must_use]
pub fn offset_by_epsilon(surface: &SurfacePoint, direction: Vec3, epsilon: f32) -> Ray {
    let extent = Interval::new(epsilon, f32::INFINITY);
    Ray { extent, ..Ray::new(surface.position, direction) }
}
// ANCHOR_END: offset_by_epsilon
