//! What a bounding volume has to promise.

use ray_casting::{Geometry, Interval, Ray};

use crate::aabb::Aabb;
use crate::four::mask;
use crate::item::Item;
use crate::slab::smaller;

// ANCHOR: trait
/// A simple shape around some primitives: a ray that misses it misses them all.
///
/// Every volume of this chapter is an intersection of *slabs*, the spaces between two parallel
/// planes n·p = lo and n·p = hi. A ray is inside a slab for an [`Interval`] of t, and inside the
/// volume where all of its intervals overlap. An AABB has three slabs along the axes, an OBB three
/// along directions of its own, a k-DOP k/2 along fixed directions \[KayKajiya86].
pub trait BoundingVolume: Copy + Send + Sync + 'static {
    /// A ray as this volume wants it: whatever can be computed once a ray instead of once a test.
    type Query: Copy;

    /// A volume around `items`, whose common box is `bounds`. May be larger than needed, never
    /// smaller.
    fn enclosing(bounds: &Aabb, items: &[Item], geometry: &Geometry) -> Self;

    /// Prepares `ray`. `reach` is the largest |component| of (point of the tree − ray origin).
    fn query(ray: &Ray, reach: f32) -> Self::Query;

    /// The t ≥ 0 for which the ray is inside; empty if it misses.
    ///
    /// Conservative: whatever was rounded, here or in the primitive's own test, a primitive inside
    /// that reports a hit at t makes this interval contain t.
    fn clip(&self, query: &Self::Query) -> Interval;

    /// A volume around nothing, which no ray enters.
    const EMPTY: Self;

    /// Four volumes in the form in which they are tested together.
    type Four: Copy + Send + Sync;

    /// Puts four volumes side by side.
    fn four(volumes: &[Self; 4]) -> Self::Four;

    /// What [`clip`](Self::clip) says of each of the four.
    fn clip_four(four: &Self::Four, query: &Self::Query) -> FourIntervals;

    /// Area of the volume's surface, in squared scene units: how likely a random line meets it.
    fn surface_area(&self) -> f32;
}
// ANCHOR_END: trait

/// Four intervals of t, their ends side by side.
#[derive(Clone, Copy, Debug)]
pub struct FourIntervals {
    /// Where each begins.
    pub min: [f32; 4],
    /// Where each ends; before its beginning if it is empty.
    pub max: [f32; 4],
}

impl FourIntervals {
    /// Bit i is set if interval i is not empty and begins at most at `max`.
    #[inline(always)]
    pub(crate) fn begin_before(&self, max: f32) -> u32 {
        let begins = |i: usize| self.min[i] <= smaller(self.max[i], max);
        mask([begins(0), begins(1), begins(2), begins(3)])
    }

    /// Clips four volumes one after the other: the plain way.
    #[inline]
    pub fn one_by_one<V: BoundingVolume>(volumes: &[V; 4], query: &V::Query) -> Self {
        // Without `map`, which the compiler may make calls of.
        let clip = |i: usize| volumes[i].clip(query);
        let (a, b, c, d) = (clip(0), clip(1), clip(2), clip(3));
        Self { min: [a.min, b.min, c.min, d.min], max: [a.max, b.max, c.max, d.max] }
    }
}

/// By how much a volume must be widened for each unit of `reach`, in every direction.
///
/// The watertight triangle test moves a vertex v by at most γ(6) max |v − o| before it decides (see
/// `ray_casting::triangle`), so it may report a hit on a ray that passes the triangle at that
/// distance. It may also put a hit forward to the origin that rounding has left behind; the volume
/// then holds a point behind the origin, of the moved triangle, and one ahead of it, of the true
/// one, and so the origin between them. γ(12) leaves room for the roundings of this padding itself.
pub(crate) const PADDING: f32 = ray_casting::math::gamma(12);
