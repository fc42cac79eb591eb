//! Boxes that lose what they enclose. For the wrong pictures; nothing else uses them.

use bv_tree::{Aabb, BoundingVolume, FourIntervals, Item};
use glam::Vec3;
use ray_casting::{Geometry, Interval, Ray};

/// The ray as the slab test stands in most introductions: o and 1/d.
#[derive(Clone, Copy)]
pub(crate) struct PlainQuery {
    origin: [f32; 3],
    inverse: [f32; 3],
}

impl PlainQuery {
    fn new(ray: &Ray) -> Self {
        let inverse = ray.direction.to_array().map(|d| 1.0 / d);
        Self { origin: ray.origin.to_array(), inverse }
    }
}

// ANCHOR: folklore
/// The slab test with `f32::min` and `f32::max`, which ignore whichever argument is NaN.
#[derive(Clone, Copy)]
pub(crate) struct FolkloreBox(Aabb);

/// Where the ray is between two planes that cross an axis, and ahead of its origin.
fn folklore(min: [f32; 3], max: [f32; 3], query: &PlainQuery) -> Interval {
    let mut inside = Interval::FORWARD;
    for i in 0..3 {
        let a = (min[i] - query.origin[i]) * query.inverse[i];
        let b = (max[i] - query.origin[i]) * query.inverse[i];
        inside.min = inside.min.max(a.min(b));
        inside.max = inside.max.min(a.max(b));
    }
    inside
}
// ANCHOR_END: folklore

/// The slab test with comparisons that ignore a plane whose t is NaN, but without any padding.
#[derive(Clone, Copy)]
pub(crate) struct UnpaddedBox(Aabb);

fn unpadded(min: [f32; 3], max: [f32; 3], query: &PlainQuery) -> Interval {
    let mut inside = Interval::FORWARD;
    for i in 0..3 {
        let forward = query.inverse[i] > 0.0;
        let (near, far) = if forward { (min[i], max[i]) } else { (max[i], min[i]) };
        let enter = (near - query.origin[i]) * query.inverse[i];
        let leave = (far - query.origin[i]) * query.inverse[i];
        inside.min = if enter > inside.min { enter } else { inside.min };
        inside.max = if leave < inside.max { leave } else { inside.max };
    }
    inside
}

/// What both kinds have in common: they differ in one function.
macro_rules! naive_volume {
    ($volume:ident, $clip:ident) => {
        impl BoundingVolume for $volume {
            type Query = PlainQuery;
            type Four = [Self; 4];

            const EMPTY: Self = Self(Aabb::EMPTY);

            fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
                Self(*bounds)
            }

            fn query(ray: &Ray, _: f32) -> PlainQuery {
                PlainQuery::new(ray)
            }

            fn clip(&self, query: &PlainQuery) -> Interval {
                $clip(self.0.min.to_array(), self.0.max.to_array(), query)
            }

            fn four(volumes: &[Self; 4]) -> [Self; 4] {
                *volumes
            }

            fn clip_four(four: &[Self; 4], query: &PlainQuery) -> FourIntervals {
                FourIntervals::one_by_one(four, query)
            }

            fn surface_area(&self) -> f32 {
                self.0.surface_area()
            }
        }
    };
}

naive_volume!(FolkloreBox, folklore);
naive_volume!(UnpaddedBox, unpadded);

/// A point of the triangle's first edge.
pub(super) fn point_of_edge(geometry: &Geometry, triangle: u32, share: f32) -> Vec3 {
    let [from, to, _] = geometry.corners(triangle);
    from.lerp(to, share)
}
