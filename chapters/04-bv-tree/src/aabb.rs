//! Axis-aligned bounding boxes.

use glam::{Vec3, vec3};
use ray_casting::{Geometry, Interval, Ray};

use crate::bounding_volume::{BoundingVolume, PADDING};
use crate::item::Item;
use crate::slab::{SlabQuery, larger, smaller};

/// The points between two corners: three slabs along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Aabb {
    /// The corner with the smallest coordinates, in scene units.
    pub min: Vec3,
    /// The corner with the largest.
    pub max: Vec3,
}

impl Aabb {
    /// No point at all, and the neutral element of [`Aabb::union`].
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The smallest box around these points.
    #[must_use]
    pub fn around(points: &[Vec3]) -> Self {
        let min = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let max = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        Self { min, max }
    }

    /// The smallest box around both.
    #[inline]
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The largest |component| of (point of the box − `origin`).
    #[inline]
    #[must_use]
    pub fn reach(&self, origin: Vec3) -> f32 {
        (self.min - origin).abs().max((self.max - origin).abs()).max_element()
    }
}

/// A ray as boxes want it: one [`SlabQuery`] an axis, turned into vectors.
#[derive(Clone, Copy, Debug)]
pub struct AabbQuery {
    origin_for_min: Vec3,
    origin_for_max: Vec3,
    inverse_for_min: Vec3,
    inverse_for_max: Vec3,
}

impl BoundingVolume for Aabb {
    type Query = AabbQuery;

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        *bounds
    }

    #[inline]
    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        let axis = |i| SlabQuery::new(ray.origin[i], ray.direction[i], PADDING * reach);
        let (x, y, z) = (axis(0), axis(1), axis(2));
        AabbQuery {
            origin_for_min: vec3(x.origin_for_min, y.origin_for_min, z.origin_for_min),
            origin_for_max: vec3(x.origin_for_max, y.origin_for_max, z.origin_for_max),
            inverse_for_min: vec3(x.inverse_for_min, y.inverse_for_min, z.inverse_for_min),
            inverse_for_max: vec3(x.inverse_for_max, y.inverse_for_max, z.inverse_for_max),
        }
    }

    // ANCHOR: clip
    /// ```text
    /// t at a plane x = c:  (c − o) / d;   the smaller of the two enters, the larger leaves
    /// ```
    ///
    /// [`SlabQuery`] argues why no rounding can turn a hit into a miss. A NaN (0 · ∞, an origin
    /// exactly on a plane that the ray runs along) loses every comparison and constrains nothing.
    #[inline]
    fn clip(&self, query: &AabbQuery) -> Interval {
        let a = (self.min - query.origin_for_min) * query.inverse_for_min;
        let b = (self.max - query.origin_for_max) * query.inverse_for_max;
        let enter = larger(larger(smaller(a.x, b.x), smaller(a.y, b.y)), larger(smaller(a.z, b.z), 0.0));
        let leave = smaller(smaller(larger(a.x, b.x), larger(a.y, b.y)), smaller(larger(a.z, b.z), f32::INFINITY));
        Interval::new(enter, leave)
    }
    // ANCHOR_END: clip

    fn surface_area(&self) -> f32 {
        let size = (self.max - self.min).max(Vec3::ZERO);
        2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
    }
}
