//! What a bounding volume has to promise.

use ray_casting::{Geometry, Interval, Ray};

use crate::aabb::Aabb;
use crate::item::Item;

// ANCHOR: trait
/// A simple shape around some primitives: a ray that misses it misses them all.
///
/// Every volume of this chapter is an intersection of *slabs*, the spaces between two parallel
/// planes n·p = lo and n·p = hi. A ray is inside a slab for an [`Interval`] of t, and inside the
/// volume where all of its intervals overlap. An AABB has three slabs along the axes, an OBB three
/// along directions of its own, a k-DOP k/2 along fixed directions [KayKajiya86].
pub trait BoundingVolume: Copy + Send + Sync + 'static {
    /// A ray as this volume wants it: whatever can be computed once a ray instead of once a test.
    type Query: Copy;

    /// A volume around `items`, whose common box is `bounds`. May be larger than needed, never
    /// smaller.
    fn enclosing(bounds: &Aabb, items: &[Item], geometry: &Geometry) -> Self;

    /// Prepares `ray`. `reach` is the largest |component| of (point of the tree − ray origin).
    fn query(ray: &Ray, reach: f32) -> Self::Query;

    /// The t ≥ 0 for which the ray is inside; empty if it misses. No tree holds an empty volume.
    ///
    /// Conservative: whatever was rounded, here or in the primitive's own test, a primitive inside
    /// that reports a hit at t makes this interval contain t.
    fn clip(&self, query: &Self::Query) -> Interval;

    /// Two volumes in the form in which they are tested together.
    type Pair: Copy + Send + Sync;

    /// Puts two volumes side by side.
    fn pair(left: &Self, right: &Self) -> Self::Pair;

    /// What [`clip`](Self::clip) says of the two volumes of a pair.
    fn clip_pair(pair: &Self::Pair, query: &Self::Query) -> [Interval; 2];

    /// Area of the volume's surface, in squared scene units: how likely a random line meets it.
    fn surface_area(&self) -> f32;
}
// ANCHOR_END: trait

/// By how much a volume must be widened for each unit of `reach`, in every direction.
///
/// The watertight triangle test moves a vertex v by at most γ(6) max |v − o| before it decides (see
/// `ray_casting::triangle`), so it may report a hit on a ray that passes the triangle at that
/// distance. γ(8) leaves room for the roundings of this padding itself.
pub(crate) const PADDING: f32 = ray_casting::math::gamma(8);
