//! The triangles that a ray starts and ends on are not tested.

use std::path::Path;

use bv_tree::{Aabb, Builder, BvTree};
use glam::{Vec3, vec2};
use ray_casting::{EndPoint, ExactPoint, Hit, Intersect, LinearSearch, Ray, Scene};
use workbench::{Counter, FilmPoint, Recorder, Sampler, Unwatched};

use crate::tools::in_cube;

/// Bits of a hit.
fn bits(hit: Option<Hit>) -> Option<(u32, u32)> {
    hit.map(|hit| (hit.t.to_bits(), hit.primitive))
}

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).expect(name)
}

/// A walk from surface to surface, in random directions, which the search through everything has to
/// confirm: it knows nothing of where a ray starts. Some directions run nearly along the surface.
fn check(name: &str, walks: u64) {
    let scene = load(name);
    let recorder = Recorder::new();
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &recorder);
    let all = LinearSearch::new(&scene.geometry, &Unwatched);
    let mut rays = 0;
    for walk in 0..walks {
        let mut sampler = Sampler::new(9, walk, 0);
        let point = FilmPoint::in_pixel([0, 0], sampler.next_2d(), [1, 1]);
        let mut ray = scene.camera.ray(point);
        for step in 0..8 {
            let hit = tree.intersect(&ray);
            assert_eq!(bits(hit), bits(all.intersect(&ray)), "{name}: {ray:?}");
            assert_eq!(tree.occluded(&ray), hit.is_some(), "{name}: occluded, {ray:?}");
            rays += 1;
            let Some(hit) = hit else { break };
            let surface = scene.surface(&ray, &hit);
            let normal = surface.facing_normal();
            let direction = in_cube(&mut sampler).normalize_or(Vec3::Z);
            let tilt = if step % 2 == 0 { 1.0 } else { 1e-6 };
            let along = direction - (1.0 - tilt) * direction.dot(normal) * normal;
            ray = surface.spawn(along.normalize_or(normal));
            let on_it = ray.origin_primitive == hit.primitive;
            assert!(on_it, "{name}: starts on {hit:?}: {ray:?}");
        }
    }
    let skipped = recorder.get(Counter::OwnTriangles);
    assert!(skipped > rays / 4, "{name}: {skipped} own triangles of {rays} rays, twice each");
    assert_eq!(Ray::new(Vec3::ZERO, Vec3::X).origin_primitive, Ray::NO_PRIMITIVE, "in space");
}

/// Rays from surfaces to points of triangles, with some that look along them.
fn check_ends(name: &str, rays: u64) {
    let scene = load(name);
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let all = LinearSearch::new(&scene.geometry, &Unwatched);
    let [mut asked, mut free] = [0, 0];
    for i in 0..rays {
        let mut sampler = Sampler::new(10, i, 0);
        let point = FilmPoint::in_pixel([0, 0], sampler.next_2d(), [1, 1]);
        let ray = scene.camera.ray(point);
        let Some(hit) = all.intersect(&ray) else { continue };
        let triangles = scene.geometry.triangles.len() as f32;
        let primitive = (sampler.next_1d() * triangles) as u32;
        let corners = scene.geometry.corners(primitive);
        let [u, v] = sampler.next_2d().map(|u| 0.5 * u);
        let there = ExactPoint::of_triangle(corners, vec2(u, v));
        let end = EndPoint::new(there.position, there.extent, there.normal.as_vec3());
        let ray = scene.surface(&ray, &hit).spawn_toward(&EndPoint { primitive, ..end });
        assert_eq!(ray.end_primitive, primitive, "{name}: the end");
        let expected = all.occluded(&ray);
        assert_eq!(tree.occluded(&ray), expected, "{name}: {ray:?}");
        asked += 1;
        free += u64::from(!expected);
    }
    assert!(asked > rays / 4 && free > asked / 20, "{name}: {asked} rays, {free} of them free");
}

#[test]
fn a_ray_that_ends_at_a_triangle_meets_what_the_search_through_everything_meets() {
    check_ends("cornell-box", 20_000);
    check_ends("teapot", 500);
}

#[test]
fn a_ray_that_leaves_a_triangle_meets_what_the_search_through_everything_meets() {
    check("cornell-box", 4000);
    check("teapot", 100);
    check("whitted-teapot", 100);
}
