//! The conformance suite passes what is right and finds what is wrong.

use std::panic::catch_unwind;

use glam::Vec2;
use ray_casting::{Geometry, Hit, Intersect, LinearSearch, Ray, conformance};
use workbench::Unwatched;

/// What may be wrong with a search.
#[derive(Clone, Copy, Debug)]
enum Fault {
    None,
    DropsOnePrimitive,
    TakesTheHighestOfEqualNames,
    TakesTheFirstItFinds,
    IgnoresTheFarEnd,
    LeavesOutTheFarEnd,
    IgnoresTheNearEnd,
    ForgetsTheWeights,
    RoundsTheDistance,
    SaysOccludedToEverything,
    SaysOccludedToNothing,
    OccludedIgnoresTheFarEnd,
}

/// Linear search with a fault.
struct Faulty {
    geometry: Geometry,
    fault: Fault,
}

impl Faulty {
    fn search(&self, ray: &Ray) -> Option<Hit> {
        let search = LinearSearch::new(&self.geometry, &Unwatched);
        let mut nearest = search.intersect(ray)?;
        let mut beyond = *ray;
        beyond.extent.min = nearest.t;
        match self.fault {
            Fault::DropsOnePrimitive if nearest.primitive == 5 => search.intersect(&beyond),
            Fault::TakesTheHighestOfEqualNames => {
                let prepared = ray_casting::ShearedRay::new(ray);
                let all = 0..self.geometry.primitives();
                let mut hits = all.filter_map(|i| self.geometry.intersect_primitive(&prepared, i));
                hits.rfind(|hit| hit.t == nearest.t)
            }
            Fault::TakesTheFirstItFinds => {
                let prepared = ray_casting::ShearedRay::new(ray);
                let mut all = 0..self.geometry.primitives();
                all.find_map(|i| self.geometry.intersect_primitive(&prepared, i))
            }
            Fault::ForgetsTheWeights => {
                nearest.barycentric = Vec2::ZERO;
                Some(nearest)
            }
            Fault::RoundsTheDistance => {
                nearest.t = nearest.t.next_up();
                Some(nearest)
            }
            Fault::LeavesOutTheFarEnd if nearest.t == ray.extent.max => None,
            _ => Some(nearest),
        }
    }
}

impl Intersect for Faulty {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let mut ray = *ray;
        match self.fault {
            Fault::IgnoresTheFarEnd => ray.extent.max = f32::INFINITY,
            Fault::IgnoresTheNearEnd => ray.extent.min = 0.0,
            _ => {}
        }
        self.search(&ray)
    }

    fn occluded(&self, ray: &Ray) -> bool {
        let mut ray = *ray;
        match self.fault {
            Fault::SaysOccludedToEverything => return true,
            Fault::SaysOccludedToNothing => return false,
            Fault::OccludedIgnoresTheFarEnd => ray.extent.max = f32::INFINITY,
            _ => {}
        }
        self.search(&ray).is_some()
    }
}

fn passes(fault: Fault) -> bool {
    let build = move |geometry: &Geometry| Faulty { geometry: geometry.clone(), fault };
    catch_unwind(|| conformance::check(build)).is_ok()
}

#[test]
fn a_right_search_passes() {
    assert!(passes(Fault::None), "linear search over a copy of the geometry");
}

#[test]
fn every_fault_is_found() {
    for fault in [
        Fault::DropsOnePrimitive,
        Fault::TakesTheHighestOfEqualNames,
        Fault::TakesTheFirstItFinds,
        Fault::IgnoresTheFarEnd,
        Fault::LeavesOutTheFarEnd,
        Fault::IgnoresTheNearEnd,
        Fault::ForgetsTheWeights,
        Fault::RoundsTheDistance,
        Fault::SaysOccludedToEverything,
        Fault::SaysOccludedToNothing,
        Fault::OccludedIgnoresTheFarEnd,
    ] {
        assert!(!passes(fault), "nothing notices a search that {fault:?}");
    }
}
