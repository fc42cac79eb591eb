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
                nearest = Some(hit);
            }
        }
        self.probe.count(Counter::PrimitiveTests, u64::from(self.geometry.primitives()));
        nearest
    }

    fn occluded(&self, ray: &Ray) -> bool {
        let prepared = ShearedRay::new(ray);
        let first = (0..self.geometry.primitives())
            .find(|&primitive| self.geometry.intersect_primitive(&prepared, primitive).is_some());
        let tests = first.map_or(self.geometry.primitives(), |primitive| primitive + 1);
        self.probe.count(Counter::PrimitiveTests, u64::from(tests));
        first.is_some()
    }
}
// ANCHOR_END: linear-search
