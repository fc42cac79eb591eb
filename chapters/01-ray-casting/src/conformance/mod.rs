//! One suite that every implementation of [`Intersect`] passes.
//!
//! The oracle is [`LinearSearch`]: the same primitive, the same t and the same weights, bit for
//! bit, on random scenes, on meshes whose vertices and edges are aimed at, and on degenerate input.

mod geometries;
mod rays;

use workbench::Unwatched;

use crate::geometry::Geometry;
use crate::hit::Hit;
use crate::intersect::{Intersect, LinearSearch};
use crate::interval::Interval;
use crate::ray::Ray;

/// Compares what `build` makes of many geometries with [`LinearSearch`].
///
/// # Panics
/// At the first ray on which the two differ, naming the geometry and the ray's exact bits.
pub fn check<G: Intersect>(build: impl Fn(&Geometry) -> G) {
    for (name, geometry) in geometries::all() {
        let oracle = LinearSearch::new(&geometry, &Unwatched);
        let candidate = build(&geometry);
        for ray in rays::all(&geometry) {
            compare(name, &oracle, &candidate, &ray);
        }
    }
}

/// Compares the two on `ray`, and on its pieces before, at and behind the nearest hit.
fn compare(name: &str, oracle: &impl Intersect, candidate: &impl Intersect, ray: &Ray) {
    let expected = compare_once(name, oracle, candidate, ray);
    let Some(hit) = expected else { return };
    for extent in [
        Interval::new(ray.extent.min, hit.t),
        Interval::new(ray.extent.min, hit.t.next_down()),
        Interval::new(hit.t, ray.extent.max),
    ] {
        compare_once(name, oracle, candidate, &Ray { extent, ..*ray });
    }
}

fn compare_once(
    name: &str,
    oracle: &impl Intersect,
    candidate: &impl Intersect,
    ray: &Ray,
) -> Option<Hit> {
    let expected = oracle.intersect(ray);
    let found = candidate.intersect(ray);
    assert!(
        bits(expected) == bits(found),
        "{name}: {found:?} instead of {expected:?}\n{ray:?}\nbits: {}",
        ray_bits(ray),
    );
    let occluded = candidate.occluded(ray);
    assert!(
        occluded == expected.is_some(),
        "{name}: occluded = {occluded}, but the nearest hit is {expected:?}\n{ray:?}\nbits: {}",
        ray_bits(ray),
    );
    expected
}

fn bits(hit: Option<Hit>) -> Option<(u32, u32, [u32; 2])> {
    hit.map(|h| (h.primitive, h.t.to_bits(), h.barycentric.to_array().map(f32::to_bits)))
}

fn ray_bits(ray: &Ray) -> String {
    let hex = |v: [f32; 3]| v.map(|x| format!("{:08x}", x.to_bits())).join(" ");
    format!("origin {}, direction {}", hex(ray.origin.to_array()), hex(ray.direction.to_array()))
}
