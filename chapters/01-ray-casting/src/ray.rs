//! Rays and the stretch of them that is still of interest.
//!
//! A ray is the half-line **p**(t) = **o** + t **d**. It always carries the interval of t in which
//! a hit would still count, so "nearest so far" and "as far as the light" are the same idea.

use glam::Vec3;

use crate::interval::Interval;

// ANCHOR: ray
/// A half-line restricted to `extent`.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// **o**, in scene units.
    pub origin: Vec3,
    /// **d**, unit length up to rounding. The intersection kernels work for any length, and t then
    /// counts in multiples of it.
    pub direction: Vec3,
    /// The values of t at which a hit counts: `extent.min < t ≤ extent.max`.
    ///
    /// The lower end is left out, so that a ray that starts on a surface (t = 0) does not hit it.
    pub extent: Interval,
    /// The primitive that it starts on, or [`Ray::NO_PRIMITIVE`]. A triangle is flat: a ray that
    /// starts on it does not meet it again, and no search needs to ask.
    pub origin_primitive: u32,
    /// The triangle just before which it ends, or [`Ray::NO_PRIMITIVE`]: it does not meet that one,
    /// either.
    pub end_primitive: u32,
}
// ANCHOR_END: ray

impl Ray {
    /// The index of no primitive.
    pub const NO_PRIMITIVE: u32 = u32::MAX;

    /// The whole half-line in front of `origin`, which is a point in space.
    #[inline]
    #[must_use]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        let (extent, none) = (Interval::FORWARD, Self::NO_PRIMITIVE);
        Self { origin, direction, extent, origin_primitive: none, end_primitive: none }
    }

    /// Whether it starts or ends on this triangle.
    #[inline]
    #[must_use]
    pub const fn starts_or_ends_on(&self, triangle: u32) -> bool {
        (triangle == self.origin_primitive) | (triangle == self.end_primitive)
    }

    /// Whether a hit at `t` counts. False for NaN.
    #[inline]
    #[must_use]
    pub fn admits(&self, t: f32) -> bool {
        self.extent.min < t && t <= self.extent.max
    }

    /// **p**(t) = **o** + t **d**.
    #[inline]
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
}
