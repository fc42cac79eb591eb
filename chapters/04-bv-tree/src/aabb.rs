//! Axis-aligned bounding boxes.

use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

use crate::bounding_volume::{BoundingVolume, PADDING};
use crate::item::Item;
use crate::slab::{SlabQuery, larger, overlap};

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
    /// The corrected 1/d of each plane; negated for the two through which the ray leaves.
    inverses: [[f32; 4]; 3],
    /// Whether the ray enters through the planes max.
    backward: [bool; 3],
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
            inverses: axes.map(|a| match a.is_backward() {
                false => spread(a.inverse_for_min, -a.inverse_for_max),
                true => spread(-a.inverse_for_min, a.inverse_for_max),
            }),
            backward: axes.map(|a| a.is_backward()),
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
            let at_min = (self.min[i] - o[0]) * inverse[0];
            let at_max = (self.max[i] - o[2]) * inverse[2];
            let slab = match query.backward[i] {
                false => Interval::new(at_min, -at_max),
                true => Interval::new(at_max, -at_min),
            };
            inside = overlap(slab, inside);
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
    ///
    /// The t of the planes through which the ray leaves are negative here, so that the last entry
    /// and the first exit are both a maximum.
    #[inline]
    fn clip_pair(pair: &AabbPair, query: &AabbQuery) -> [Interval; 2] {
        let mut last = [0.0, 0.0, f32::NEG_INFINITY, f32::NEG_INFINITY];
        for (i, &planes) in pair.iter().enumerate() {
            let mut t = zip(zip(planes, query.origins[i], sub), query.inverses[i], mul);
            if query.backward[i] {
                t = [t[2], t[3], t[0], t[1]];
            }
            last = zip(t, last, larger);
        }
        [Interval::new(last[0], -last[2]), Interval::new(last[1], -last[3])]
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
