//! Discrete oriented polytopes: slabs along k/2 fixed directions.

use std::array;

use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

use crate::aabb::Aabb;
use crate::bounding_volume::{BoundingVolume, FourIntervals, PADDING};
use crate::item::{Item, extent_along};
use crate::slab::{SlabQuery, overlap};

/// A polytope with k = 2 `N` faces in fixed directions \[Klosowski98]: k = 6, 14, 18 or 26.
///
/// The directions need not have unit length: a slab is the same whatever the scale of its normal.
#[derive(Clone, Copy, Debug)]
pub struct KDop<const N: usize> {
    slabs: [Interval; N],
}

/// The directions of k = 26. Those of the others are subsets.
const AXES: [Vec3; 3] = Vec3::AXES;
const CORNERS: [Vec3; 4] =
    [Vec3::ONE, Vec3::new(-1.0, 1.0, 1.0), Vec3::new(1.0, -1.0, 1.0), Vec3::new(1.0, 1.0, -1.0)];
const EDGES: [Vec3; 6] = [
    Vec3::new(1.0, 1.0, 0.0),
    Vec3::new(1.0, -1.0, 0.0),
    Vec3::new(1.0, 0.0, 1.0),
    Vec3::new(1.0, 0.0, -1.0),
    Vec3::new(0.0, 1.0, 1.0),
    Vec3::new(0.0, 1.0, -1.0),
];

impl<const N: usize> KDop<N> {
    /// The faces' directions: the axes, then towards corners of a cube (k = 14), towards its edges
    /// (k = 18), or both (k = 26).
    #[must_use]
    pub const fn directions() -> [Vec3; N] {
        assert!(matches!(N, 3 | 7 | 9 | 13), "there are k-DOPs with k = 6, 14, 18 and 26");
        let mut directions = [Vec3::ZERO; N];
        let mut i = 0;
        while i < N {
            directions[i] = match (i, N) {
                (0..3, _) => AXES[i],
                (_, 9) => EDGES[i - 3],
                (3..7, _) => CORNERS[i - 3],
                _ => EDGES[i - 7],
            };
            i += 1;
        }
        directions
    }
}

impl<const N: usize> BoundingVolume for KDop<N> {
    type Four = [Self; 4];
    type Query = [SlabQuery; N];

    const EMPTY: Self = Self { slabs: [Interval::EMPTY; N] };

    fn enclosing(_: &Aabb, items: &[Item], geometry: &Geometry) -> Self {
        let slabs = Self::directions().map(|n| extent_along(n, Vec3::ZERO, items, geometry));
        Self { slabs }
    }

    // ANCHOR: clip
    /// n·**o** and n·**d** are sums that can cancel: double precision keeps their relative error at
    /// u. A padding of E along each axis is one of E (|n_x| + |n_y| + |n_z|) along n.
    fn query(ray: &Ray, reach: f32) -> Self::Query {
        let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        Self::directions().map(|n| {
            let padding = PADDING * reach * n.abs().element_sum();
            let n = n.as_dvec3();
            SlabQuery::new(n.dot(o) as f32, n.dot(d) as f32, padding)
        })
    }

    #[inline]
    fn clip(&self, query: &Self::Query) -> Interval {
        let slabs = self.slabs.iter().zip(query);
        slabs.fold(Interval::FORWARD, |inside, (&slab, query)| overlap(query.clip(slab), inside))
    }
    // ANCHOR_END: clip

    fn four(volumes: &[Self; 4]) -> [Self; 4] {
        *volumes
    }

    #[inline]
    fn clip_four(four: &[Self; 4], query: &Self::Query) -> FourIntervals {
        FourIntervals::one_by_one(four, query)
    }

    /// The area of the box around it: a k-DOP's own has no short formula.
    fn surface_area(&self) -> f32 {
        let [x, y, z] = array::from_fn(|i| self.slabs[i].length());
        2.0 * (x * y + y * z + z * x)
    }
}
