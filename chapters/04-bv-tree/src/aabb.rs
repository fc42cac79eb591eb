//! Axis-aligned bounding boxes.

use glam::{Vec3, Vec4};
use ray_casting::{Geometry, Interval, Ray};

use crate::bounding_volume::{BoundingVolume, FourIntervals, PADDING};
use crate::four::{Four, larger_of, mul, smaller_of, sub};
use crate::item::Item;
use crate::slab::{AxisQueries, overlap};

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
        // Made four numbers, which are compared together; three would be taken apart.
        let min = (self.min - origin).abs().extend(0.0);
        let max = (self.max - origin).abs().extend(0.0);
        min.max(max).max_element()
    }
}

/// A ray as boxes want it: what a [`SlabQuery`](crate::SlabQuery) holds, for each axis, and four times
/// each number.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct AabbQuery {
    origin_near: [Four; 3],
    origin_far: [Four; 3],
    inverse_near: [Four; 3],
    inverse_far: [Four; 3],
    is_backward: [bool; 3],
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
        let axes = AxisQueries::new(ray.origin, ray.direction, PADDING * reach);
        let four_times = |v: Vec4| [[v.x; 4], [v.y; 4], [v.z; 4]];
        let backward = axes.are_backward();
        AabbQuery {
            origin_near: four_times(axes.origin_near),
            origin_far: four_times(axes.origin_far),
            inverse_near: four_times(axes.inverse_near),
            inverse_far: four_times(axes.inverse_far),
            is_backward: [backward & 1 != 0, backward & 2 != 0, backward & 4 != 0],
        }
    }

    // ANCHOR: clip
    /// ```text
    /// t at a plane x = c:  (c − o) / d;   the smaller of the two enters, the larger leaves
    /// ```
    ///
    /// [`SlabQuery`](crate::SlabQuery) argues why no rounding can turn a hit into a miss.
    #[inline]
    fn clip(&self, query: &AabbQuery) -> Interval {
        let mut inside = Interval::FORWARD;
        for i in 0..3 {
            let (mut enter, mut leave) = (self.min[i], self.max[i]);
            if query.is_backward[i] {
                (enter, leave) = (leave, enter);
            }
            let enter = (enter - query.origin_near[i][0]) * query.inverse_near[i][0];
            let leave = (leave - query.origin_far[i][0]) * query.inverse_far[i][0];
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
        for (i, planes) in planes.iter().enumerate() {
            let enter = planes[usize::from(query.is_backward[i])];
            let leave = planes[usize::from(!query.is_backward[i])];
            let enter = mul(sub(enter, query.origin_near[i]), query.inverse_near[i]);
            let leave = mul(sub(leave, query.origin_far[i]), query.inverse_far[i]);
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
