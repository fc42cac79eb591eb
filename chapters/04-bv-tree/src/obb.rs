//! Oriented bounding boxes: slabs along three directions of the box's own.

use glam::{DVec3, Vec3};
use ray_casting::math::gamma;
use ray_casting::{Geometry, Interval, Ray};

use crate::aabb::Aabb;
use crate::bounding_volume::{BoundingVolume, FourIntervals};
use crate::frames;
use crate::item::{Item, extent_along};
use crate::slab::{SlabQuery, overlap};

/// A box with axes of its own \[Gottschalk96].
#[derive(Clone, Copy, Debug)]
pub struct Obb {
    /// Somewhere inside, in scene units. Slabs are measured from here.
    center: Vec3,
    /// Unit normals of the three pairs of faces, perpendicular up to rounding. Nothing depends on
    /// how perpendicular they are: the slabs enclose their content whatever their directions.
    axes: [Vec3; 3],
    /// Extent along each axis, relative to `center`.
    slabs: [Interval; 3],
}

/// A ray and the padding of a tree's boxes: each box turns the ray into its own frame.
#[derive(Clone, Copy, Debug)]
pub struct ObbQuery {
    origin: Vec3,
    direction: Vec3,
    padding: f32,
}

impl Obb {
    /// The box along `axes` around `items`.
    fn along(axes: [Vec3; 3], center: Vec3, items: &[Item], geometry: &Geometry) -> Self {
        Self { center, axes, slabs: axes.map(|n| extent_along(n, center, items, geometry)) }
    }
}

impl BoundingVolume for Obb {
    type Four = [Self; 4];
    type Query = ObbQuery;

    const EMPTY: Self = Self { center: Vec3::ZERO, axes: Vec3::AXES, slabs: [Interval::EMPTY; 3] };

    // ANCHOR: enclosing
    /// Fits several frames and keeps the box with the least surface.
    fn enclosing(bounds: &Aabb, items: &[Item], geometry: &Geometry) -> Self {
        let center = bounds.min.midpoint(bounds.max);
        let mut best = Self::along(Vec3::AXES, center, items, geometry);
        for axes in frames::candidates(items, geometry) {
            let candidate = Self::along(axes, center, items, geometry);
            if candidate.surface_area() < best.surface_area() {
                best = candidate;
            }
        }
        best
    }
    // ANCHOR_END: enclosing

    /// All of this padding in units of M = `reach`, which bounds every component of v − o and of
    /// c − o:
    ///
    /// - √3 γ(12) for the padding of the other volumes, turned into an arbitrary direction;
    /// - γ(4) · √3 for n·(o − c): a difference, a product and two sums, with Σ |nᵢ| ≤ √3;
    /// - γ(3) · √3 · √3 for n·d, whose error grows with t, and t |d| ≤ √3 M within the tree.
    ///
    /// Together below γ(40).
    fn query(ray: &Ray, reach: f32) -> ObbQuery {
        ObbQuery { origin: ray.origin, direction: ray.direction, padding: gamma(40) * reach }
    }

    // ANCHOR: clip
    #[inline]
    fn clip(&self, query: &ObbQuery) -> Interval {
        let origin = query.origin - self.center;
        let mut inside = Interval::FORWARD;
        for (axis, &slab) in self.axes.iter().zip(&self.slabs) {
            let turned = SlabQuery::new(axis.dot(origin), axis.dot(query.direction), query.padding);
            inside = overlap(turned.clip(slab), inside);
        }
        inside
    }
    // ANCHOR_END: clip

    fn four(volumes: &[Self; 4]) -> [Self; 4] {
        *volumes
    }

    #[inline]
    fn clip_four(four: &[Self; 4], query: &Self::Query) -> FourIntervals {
        FourIntervals::one_by_one(four, query)
    }

    fn surface_area(&self) -> f32 {
        let [x, y, z] = self.slabs.map(Interval::length);
        2.0 * (x * y + y * z + z * x)
    }
}

/// For the tests: the box's own frame and how far it reaches.
impl Obb {
    /// Unit normals of the three pairs of faces.
    #[must_use]
    pub const fn axes(&self) -> [Vec3; 3] {
        self.axes
    }

    /// Whether `point` lies inside, up to the rounding of double precision.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        let p: DVec3 = point.as_dvec3() - self.center.as_dvec3();
        self.axes.iter().zip(self.slabs).all(|(n, slab)| {
            let x = n.as_dvec3().dot(p);
            f64::from(slab.min) <= x && x <= f64::from(slab.max)
        })
    }
}
