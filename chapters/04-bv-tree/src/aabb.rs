//! Axis-aligned bounding boxes.

use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

use crate::bounding_volume::{BoundingVolume, FourIntervals, PADDING};
use crate::four::{Four, larger_of, mul, smaller_of, sub};
use crate::item::Item;
use crate::slab::{SlabQuery, overlap};

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

/// A ray as boxes want it: what a [`SlabQuery`] holds, for each axis, and four times each number.
#[derive(Clone, Copy, Debug)]
pub struct AabbQuery {
    axes: [AxisQuery; 3],
}

/// One axis of an [`AabbQuery`].
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
struct AxisQuery {
    origin_near: Four,
    origin_far: Four,
    inverse_near: Four,
    inverse_far: Four,
    is_backward: bool,
}

impl From<SlabQuery> for AxisQuery {
    #[inline(always)]
    fn from(slab: SlabQuery) -> Self {
        Self {
            origin_near: [slab.origin_near; 4],
            origin_far: [slab.origin_far; 4],
            inverse_near: [slab.inverse_near; 4],
            inverse_far: [slab.inverse_far; 4],
            is_backward: slab.is_backward(),
        }
    }
}

/// Four boxes: for each axis the planes min of all of them, then the planes max.
pub type FourBoxes = [[[f32; 4]; 2]; 3];

impl BoundingVolume for Aabb {
    type Query = AabbQuery;
    type Four = FourBoxes;

    const EMPTY: Self = Self::EMPTY;

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        *bounds
    }

    #[inline(always)]
    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        let (o, d, padding) = (ray.origin, ray.direction, PADDING * reach);
        AabbQuery {
            axes: [
                SlabQuery::new(o.x, d.x, padding).into(),
                SlabQuery::new(o.y, d.y, padding).into(),
                SlabQuery::new(o.z, d.z, padding).into(),
            ],
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
        for (i, axis) in query.axes.iter().enumerate() {
            let (mut enter, mut leave) = (self.min[i], self.max[i]);
            if axis.is_backward {
                (enter, leave) = (leave, enter);
            }
            let enter = (enter - axis.origin_near[0]) * axis.inverse_near[0];
            let leave = (leave - axis.origin_far[0]) * axis.inverse_far[0];
            inside = overlap(Interval::new(enter, leave), inside);
        }
        inside
    }
    // ANCHOR_END: clip

    fn four(volumes: &[Self; 4]) -> FourBoxes {
        [0, 1, 2]
            .map(|i| [volumes.map(|volume| volume.min[i]), volumes.map(|volume| volume.max[i])])
    }

    // ANCHOR: clip_four
    /// As [`clip`](Self::clip), for four boxes at a time: the compiler turns each line into
    /// instructions that work on four numbers.
    #[inline(always)]
    fn clip_four(planes: &FourBoxes, query: &AabbQuery) -> FourIntervals {
        let (mut min, mut max) = ([0.0; 4], [f32::INFINITY; 4]);
        for (planes, axis) in planes.iter().zip(&query.axes) {
            let enter = planes[usize::from(axis.is_backward)];
            let leave = planes[usize::from(!axis.is_backward)];
            let enter = mul(sub(enter, axis.origin_near), axis.inverse_near);
            let leave = mul(sub(leave, axis.origin_far), axis.inverse_far);
            (min, max) = (larger_of(enter, min), smaller_of(leave, max));
        }
        FourIntervals { min, max }
    }
    // ANCHOR_END: clip_four

    /// From halves of the sides: none of them is ∞, so none makes 0 · ∞ with one that is 0. Halving
    /// changes no digit.
    fn surface_area(&self) -> f32 {
        let half = (0.5 * self.max - 0.5 * self.min).max(Vec3::ZERO);
        8.0 * (half.x * half.y + half.y * half.z + half.z * half.x)
    }
}
