//! What a ray tests: exact counts.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, Interval, Ray};
use workbench::{Counter, Recorder};

use crate::tools::{BUILDERS, rays, soup, tests, triangles};

fn check_outside<V: BoundingVolume>(name: &str, geometry: &Geometry) {
    let ray = Ray::new(vec3(0.0, 0.0, 5.0), Vec3::X);
    let ended = Ray { extent: Interval::new(0.0, 1.0), ..Ray::new(5.0 * Vec3::Z, Vec3::NEG_Z) };
    let behind = Ray::new(5.0 * Vec3::Z, Vec3::Z);
    for (case, ray) in [("beside", ray), ("before", ended), ("behind", behind)] {
        for builder in BUILDERS {
            // Four each for `intersect` and `occluded`: the children of the root alone.
            let counts = tests::<V>(geometry, builder, [ray]);
            assert_eq!(counts, [8, 0], "{name}, {builder:?}: a ray that passes {case}");
        }
    }
}

/// accuracy V12.
#[test]
fn a_ray_outside_of_everything_tests_the_children_of_the_root_alone() {
    let geometry = soup(500, 0.1);
    check_outside::<Aabb>("AABB", &geometry);
    check_outside::<Obb>("OBB", &geometry);
    check_outside::<KDop<7>>("14-DOP", &geometry);
}

/// accuracy V13, by counts instead of a clock.
#[test]
fn a_ray_that_is_not_finite_tests_nothing() {
    let geometry = soup(500, 0.1);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let broken = [
            Ray::new(Vec3::splat(bad), Vec3::X),
            Ray::new(Vec3::ZERO, Vec3::splat(bad)),
            Ray::new(vec3(0.0, bad, 0.0), Vec3::Z),
            Ray::new(Vec3::ZERO, vec3(1.0, 0.0, bad)),
            Ray::new(Vec3::ZERO, Vec3::ZERO),
        ];
        for builder in BUILDERS {
            let counts = tests::<Aabb>(&geometry, builder, broken);
            assert_eq!(counts, [0, 0], "{builder:?}: volume and primitive tests with {bad}");
        }
    }
}

/// accuracy V12: each ray by itself.
#[test]
fn no_ray_tests_more_primitives_than_there_are() {
    let count: u64 = 400;
    let geometry = soup(count, 0.3);
    for builder in BUILDERS {
        let recorder = Recorder::new();
        let tree = BvTree::<Aabb, _>::build(&geometry, builder, &recorder);
        for ray in rays(5000) {
            let before = recorder.get(Counter::PrimitiveTests);
            tree.intersect(&ray);
            let tested = recorder.get(Counter::PrimitiveTests) - before;
            assert!(tested <= count, "{builder:?}: {tested} tests of {count} primitives, {ray:?}");
        }
    }
}

/// The heuristic is worth its time: fewer tests than halving by count, far fewer than all.
#[test]
fn the_surface_area_heuristic_saves_tests() {
    // Half of the triangles crowd into a corner, which halving by count cannot know.
    let mut geometry = soup(4000, 0.05);
    for vertex in &mut geometry.vertices[..6000] {
        *vertex = 0.9 + 0.1 * *vertex;
    }
    let sum = |builder| -> u64 { tests::<Aabb>(&geometry, builder, rays(2000)).iter().sum() };
    let (median, sah) = (sum(Builder::Median), sum(Builder::Sah));
    assert!(sah < median, "{sah} tests by area, {median} by count");
    let all = 2 * 2000 * 4000;
    assert!(sah * 20 < all, "{sah} tests instead of {all}");
}

/// Near children first: of a thousand sheets, one behind the other, the nearest is found on the way
/// to one leaf, from either end. Far children first, every node is opened: more than 1000 tests.
#[test]
fn near_children_first_save_tests() {
    let sheets = 1000;
    let geometry = triangles((0..sheets).map(|i| {
        let z = i as f32;
        [vec3(-1.0, -1.0, z), vec3(1.0, -1.0, z), vec3(0.0, 1.0, z)]
    }));
    let (first, last) = (0, sheets - 1);
    for (ray, nearest) in [
        (Ray::new(vec3(0.0, 0.0, -1.0), Vec3::Z), first),
        (Ray::new(vec3(0.0, 0.0, sheets as f32), Vec3::NEG_Z), last),
    ] {
        for builder in BUILDERS {
            let recorder = Recorder::new();
            let tree = BvTree::<Aabb, _>::build(&geometry, builder, &recorder);
            let hit = tree.intersect(&ray).map(|hit| hit.primitive);
            assert_eq!(hit, Some(nearest), "{builder:?}: {ray:?}");
            let tests = [Counter::VolumeTests, Counter::PrimitiveTests].map(|c| recorder.get(c));
            // Five levels of four children reach 4⁵ leaves, and a leaf has four primitives at most.
            let enough = tests[0] <= 24 && tests[1] <= 8;
            assert!(enough, "{builder:?}: volumes and primitives tested: {tests:?}");
        }
    }
}

/// A shadow ray stops at the first hit: it never tests more than the search for the nearest.
#[test]
fn a_shadow_ray_tests_no_more_than_a_search() {
    let geometry = soup(2000, 0.3);
    let recorder = Recorder::new();
    let tree = BvTree::<Aabb, _>::build(&geometry, Builder::Sah, &recorder);
    let tested = || recorder.get(Counter::VolumeTests) + recorder.get(Counter::PrimitiveTests);
    let (mut nearest, mut any) = (0, 0);
    for ray in rays(2000) {
        let before = tested();
        let hit = tree.intersect(&ray);
        let between = tested();
        let occluded = tree.occluded(&ray);
        let after = tested();
        assert_eq!(occluded, hit.is_some(), "{ray:?}");
        // Without a hit to stop at, both go the same way.
        assert!(
            hit.is_some() || after - between == between - before,
            "{} and {} tests without a hit: {ray:?}",
            between - before,
            after - between
        );
        (nearest, any) = (nearest + between - before, any + after - between);
    }
    assert!(any * 5 < nearest * 4, "{any} tests for any hit, {nearest} for the nearest");
}

/// Counting changes no answer.
#[test]
fn a_watched_tree_answers_like_an_unwatched_one() {
    let geometry = soup(300, 0.3);
    let recorder = Recorder::new();
    let watched = BvTree::<Aabb, _>::build(&geometry, Builder::Sah, &recorder);
    let unwatched = crate::tools::tree::<Aabb>(&geometry, Builder::Sah);
    for ray in rays(1000) {
        assert_eq!(watched.intersect(&ray), unwatched.intersect(&ray), "{ray:?}");
    }
}
