//! The seam between what a ray can hit and who wants to know.

use workbench::{Counter, Probe};

use crate::geometry::Geometry;
use crate::hit::Hit;
use crate::ray::Ray;
use crate::triangle::ShearedRay;

// ANCHOR: trait
/// A set of primitives that a ray can be tested against.
///
/// Chapter 1 implements this by looking at every primitive, chapter 4 by descending a tree;
/// everything in between is written once, against this trait. Every implementation passes
/// [`conformance::check`](crate::conformance::check).
pub trait Intersect: Sync {
    /// The hit with the smallest `t` that `ray` admits; of equal ones, the lowest primitive index.
    fn intersect(&self, ray: &Ray) -> Option<Hit>;

    /// Whether anything at all lies in `ray.extent`.
    ///
    /// Implementations should stop at the first hit they find.
    fn occluded(&self, ray: &Ray) -> bool {
        self.intersect(ray).is_some()
    }
}
// ANCHOR_END: trait

/// Looks at every primitive: the plainest search there is, and the oracle of all others.
pub struct LinearSearch<'a, P> {
    geometry: &'a Geometry,
    probe: &'a P,
}

impl<'a, P: Probe> LinearSearch<'a, P> {
    /// A search through all of `geometry`; `probe` counts the primitive tests.
    pub const fn new(geometry: &'a Geometry, probe: &'a P) -> Self {
        Self { geometry, probe }
    }

    /// Nobody asks where this hit is, and how the surface lies there.
    fn skip_point(&self, ray: &Ray, hit: &Hit) {
        self.probe.skip(Counter::SurfacePoints, || self.geometry.point(ray, hit));
    }
}

// ANCHOR: linear-search
impl<P: Probe> Intersect for LinearSearch<'_, P> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let mut prepared = ShearedRay::new(ray);
        let mut nearest = None;
        for primitive in 0..self.geometry.primitives() {
            if let Some(hit) = self.geometry.intersect_primitive(&prepared, primitive) {
                // Of equally near hits the first one stays.
                prepared.shorten_below(hit.t);
                if let Some(farther) = nearest.replace(hit) {
                    self.skip_point(ray, &farther);
                }
            }
        }
        self.probe.count(Counter::PrimitiveTests, u64::from(self.geometry.primitives()));
        nearest
    }

    fn occluded(&self, ray: &Ray) -> bool {
        if !self.probe.skips(Counter::AnyHitExits) {
            return self.intersect(ray).is_some();
        }
        let prepared = ShearedRay::new(ray);
        let all = self.geometry.primitives();
        let first =
            (0..all).find_map(|primitive| self.geometry.intersect_primitive(&prepared, primitive));
        let tests = first.map_or(all, |hit| hit.primitive + 1);
        self.probe.count(Counter::PrimitiveTests, u64::from(tests));
        self.probe.count(Counter::AnyHitExits, u64::from(tests < all));
        if let Some(hit) = &first {
            self.skip_point(ray, hit);
        }
        first.is_some()
    }
}
// ANCHOR_END: linear-search
