//! Axis-aligned bounding boxes.

use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

use crate::bounding_volume::{BoundingVolume, PADDING};
use crate::item::Item;
use crate::slab::{SlabQuery, larger, overlap, smaller};

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

/// A ray as boxes want it: for each axis what a [`SlabQuery`] holds, laid out like [`AabbPair`].
#[derive(Clone, Copy, Debug)]
pub struct AabbQuery {
    /// [o + E, o + E, o − E, o − E].
    origins: [[f32; 4]; 3],
    /// The corrected 1/d of each plane.
    inverses: [[f32; 4]; 3],
}

/// Two boxes: for each axis the planes [left.min, right.min, left.max, right.max].
pub type AabbPair = [[f32; 4]; 3];

impl BoundingVolume for Aabb {
    type Query = AabbQuery;
    type Pair = AabbPair;

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        *bounds
    }

    #[inline]
    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        let (o, d, padding) = (ray.origin, ray.direction, PADDING * reach);
        let axes = [
            SlabQuery::new(o.x, d.x, padding),
            SlabQuery::new(o.y, d.y, padding),
            SlabQuery::new(o.z, d.z, padding),
        ];
        AabbQuery {
            origins: axes.map(|a| spread(a.origin_for_min, a.origin_for_max)),
            inverses: axes.map(|a| spread(a.inverse_for_min, a.inverse_for_max)),
        }
    }

    // ANCHOR: clip
    /// ```text
    /// t at a plane x = c:  (c − o) / d;   the smaller of the two enters, the larger leaves
    /// ```
    ///
    /// [`SlabQuery`] argues why no rounding can turn a hit into a miss.
    #[inline]
    fn clip(&self, query: &AabbQuery) -> Interval {
        let mut inside = Interval::FORWARD;
        for i in 0..3 {
            let (o, inverse) = (&query.origins[i], &query.inverses[i]);
            let a = (self.min[i] - o[0]) * inverse[0];
            let b = (self.max[i] - o[2]) * inverse[2];
            inside = overlap(Interval::new(smaller(a, b), larger(a, b)), inside);
        }
        inside
    }
    // ANCHOR_END: clip

    fn pair(left: &Self, right: &Self) -> AabbPair {
        [0, 1, 2].map(|i| [left.min[i], right.min[i], left.max[i], right.max[i]])
    }

    // ANCHOR: clip_pair
    /// As [`clip`](Self::clip), with four planes at a time: the compiler turns each line into one
    /// instruction on four numbers.
    #[inline]
    fn clip_pair(pair: &AabbPair, query: &AabbQuery) -> [Interval; 2] {
        let mut enter = [0.0; 4];
        let mut leave = [f32::INFINITY; 4];
        for ((&planes, &origins), &inverses) in pair.iter().zip(&query.origins).zip(&query.inverses)
        {
            let t = zip(zip(planes, origins, sub), inverses, mul);
            let other = [t[2], t[3], t[0], t[1]];
            enter = zip(zip(t, other, smaller), enter, larger);
            leave = zip(zip(t, other, larger), leave, smaller);
        }
        [Interval::new(enter[0], leave[0]), Interval::new(enter[1], leave[1])]
    }
    // ANCHOR_END: clip_pair

    fn surface_area(&self) -> f32 {
        let size = (self.max - self.min).max(Vec3::ZERO);
        2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
    }
}

/// A number for both boxes' planes min, and one for their planes max.
#[inline]
const fn spread(min: f32, max: f32) -> [f32; 4] {
    [min, min, max, max]
}

#[inline]
fn sub(a: f32, b: f32) -> f32 {
    a - b
}

#[inline]
fn mul(a: f32, b: f32) -> f32 {
    a * b
}

/// `f` of each pair of components.
#[inline]
fn zip(a: [f32; 4], b: [f32; 4], f: impl Fn(f32, f32) -> f32) -> [f32; 4] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])]
}
