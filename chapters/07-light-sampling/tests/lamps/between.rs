//! What is left out of the search for shadows throws none.

use std::path::Path;

use bv_tree::{Aabb, Builder, BvTree};
use glam::{Quat, Vec3, vec3};
use light_sampling::{Lights, between};
use ray_casting::{Intersect, LinearSearch, Ray, Scene};
use statistics::seed;
use workbench::{FilmPoint, Sampler, Unwatched};

use crate::scenes::{LAMP, MATTE, add_point_light, add_quad, add_sphere, empty, in_ball};

/// The eight corners of a box around the origin: bit i of the number is the side along axis i.
fn corners(half: Vec3) -> [Vec3; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
        let side = |bit: i32| if i & bit == 0 { -1.0 } else { 1.0 };
        half * vec3(side(1), side(2), side(4))
    })
}

/// The sides of a box, turned and moved.
fn add_box(scene: &mut Scene, half: Vec3, place: impl Fn(Vec3) -> Vec3) {
    let c = corners(half).map(place);
    for [a, b, d, e] in
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6]]
    {
        add_quad(scene, [c[a], c[b], c[d], c[e]], MATTE);
    }
}

/// A room around the origin with a box in it, and a lamp below the ceiling: primitives 0 to 11 are
/// the walls, 12 to 23 the box, 24 and 25 the lamp.
fn room(place: impl Fn(Vec3) -> Vec3) -> Scene {
    let mut scene = empty();
    add_box(&mut scene, Vec3::ONE, &place);
    let tilt = Quat::from_rotation_y(0.3);
    add_box(&mut scene, vec3(0.2, 0.3, 0.4), |p| place(tilt * p - 0.5 * Vec3::Y));
    let lamp = [vec3(-0.2, 0.9, -0.2), vec3(0.2, 0.9, -0.2), vec3(0.2, 0.9, 0.2)];
    let [a, b, c] = lamp.map(&place);
    add_quad(&mut scene, [a, b, c, place(vec3(-0.2, 0.9, 0.2))], LAMP);
    scene
}

fn names(scene: &Scene) -> Option<Vec<u32>> {
    between(scene, &Lights::new(scene))
}

#[test]
fn walls_and_the_only_lamp_are_left_out_and_nothing_else() {
    let scene = room(|p| p);
    assert_eq!(names(&scene), Some((12..24).collect()), "the box alone");

    // Another lamp on the floor: each can stand in the light of the other.
    let mut two = room(|p| p);
    let floor = -0.9 * Vec3::Y;
    add_quad(
        &mut two,
        [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Z, Vec3::Z].map(|p| 0.1 * p + floor),
        LAMP,
    );
    assert_eq!(names(&two), Some((12..28).collect()), "the box and both lamps");

    // So can the lamp in that of a point light.
    let mut point = room(|p| p);
    add_point_light(&mut point, 0.95 * Vec3::Y, 1.0);
    assert_eq!(names(&point), Some((12..26).collect()), "the box and the lamp");
}

/// Whatever reaches through a wall, or shines from beyond it, makes a way through it possible.
#[test]
fn a_wall_with_something_on_either_side_stays() {
    let right = [2, 3, 6, 7]; // the walls z = 1 and x = 1, two triangles each
    let mut sphere = room(|p| p);
    add_sphere(&mut sphere, vec3(0.9, 0.0, 0.9), 0.2, MATTE);
    let mut outside = room(|p| p);
    add_point_light(&mut outside, vec3(2.0, 0.0, 2.0), 1.0);
    for (name, scene) in [("a sphere", sphere), ("a light", outside)] {
        let left = names(&scene).expect(name);
        let walls: Vec<u32> = left.into_iter().filter(|&i| i < 12).collect();
        assert_eq!(walls, right, "{name}: walls that can stand between");
    }
    // One that touches both from inside does not.
    let mut inside = room(|p| p);
    add_sphere(&mut inside, vec3(0.75, 0.0, 0.75), 0.25, MATTE);
    let left = names(&inside).expect("walls");
    assert!(left.iter().all(|&i| i >= 12), "walls among {left:?}");
}

#[test]
fn where_nothing_can_be_left_out_there_is_no_second_tree() {
    let mut open = empty();
    add_sphere(&mut open, Vec3::ZERO, 1.0, MATTE);
    add_sphere(&mut open, 3.0 * Vec3::Y, 1.0, LAMP);
    assert_eq!(names(&open), None, "two spheres");
    let mut many = room(|p| p);
    for i in 0..1000 {
        add_sphere(&mut many, 0.5 * Vec3::NEG_Y, 1e-3 * (i + 1) as f32 * 0.1, MATTE);
    }
    assert_eq!(names(&many), None, "{} primitives", many.geometry.primitives());
}

/// Whether rounding has put the start of a shadow ray, in a corner, into the other wall or behind it:
/// it then leaves through that wall at once. The search among some finds the lamp, and is right.
fn starts_in(all: &LinearSearch<'_, Unwatched>, some: &[u32], ray: &Ray) -> bool {
    let size = ray.origin.abs().max_element() + ray.extent.max;
    let is_left_out = |primitive| some.binary_search(&primitive).is_err();
    let near = 16.0 * f32::EPSILON * size;
    all.intersect(ray).is_some_and(|hit| hit.t < near && is_left_out(hit.primitive))
}

/// Walks from surface to surface and asks from each point for the light of a lamp: what the search
/// among all primitives says of the shadow ray has to be what that among some says. Every second
/// direction leads nearly along the surface, into the corners.
fn agree(name: &str, scene: &Scene, ray: impl Fn(&mut Sampler) -> Ray, walks: u64) -> [u64; 2] {
    let lights = Lights::new(scene);
    let Some(some) = between(scene, &lights) else { return [0; 2] };
    let is_one = |primitive| some.binary_search(&primitive).is_ok();
    let tree = BvTree::<Aabb, _>::build_over(&scene.geometry, is_one, Builder::Sah, &Unwatched);
    let all = LinearSearch::new(&scene.geometry, &Unwatched);
    let [mut asked, mut dark, mut odd] = [0, 0, 0];
    for walk in 0..walks {
        let mut sampler = Sampler::new(seed(0xBE7), walk, 0);
        let mut ray = ray(&mut sampler);
        for step in 0..6 {
            let Some(hit) = all.intersect(&ray) else { break };
            let surface = scene.surface(&ray, &hit);
            let normal = surface.facing_normal();
            if let Some(light) = lights.sample(&surface, &mut sampler)
                && light.end.is_some()
                && normal.dot(light.wi) > 0.0
            {
                let shadow_ray = light.shadow_ray(&surface);
                if starts_in(&all, &some, &shadow_ray) {
                    odd += 1;
                    continue;
                }
                let expected = all.occluded(&shadow_ray);
                assert_eq!(tree.occluded(&shadow_ray), expected, "{name}: {shadow_ray:?}");
                asked += 1;
                dark += u64::from(expected);
            }
            let direction = (normal + in_ball(&mut sampler).normalize()).normalize_or(normal);
            let tilt = if step % 2 == 0 { 1.0 } else { 1e-5 };
            let along = direction - (1.0 - tilt) * direction.dot(normal) * normal;
            ray = surface.spawn(along.normalize_or(normal));
        }
    }
    // Every second ray runs along a wall into a corner, on purpose.
    assert!(odd * 20 <= asked, "{name}: {odd} rays start in another wall, {asked} do not");
    [asked, dark]
}

#[test]
fn the_search_for_shadows_among_some_finds_what_the_search_among_all_finds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    for name in ["cornell-box", "cornell-spheres", "veach-plates", "whitted"] {
        let scene = Scene::load(&folder.join(name).with_extension("toml")).expect(name);
        let camera = |sampler: &mut Sampler| {
            scene.camera.ray(FilmPoint::in_pixel([0, 0], sampler.next_2d(), [1, 1]))
        };
        let [asked, dark] = agree(name, &scene, camera, 10_000);
        assert!(asked > 5000 && dark > 100, "{name}: {asked} asked, {dark} dark");
    }
}

/// Of any size, anywhere, turned at random: the corners of the walls are rounded, and some walls are
/// no longer flat. Those stay in the search.
#[test]
fn rooms_at_every_scale_and_place_throw_the_same_shadows() {
    let [mut asked, mut dark] = [0, 0];
    for i in 0..400 {
        let mut sampler = Sampler::new(seed(0xBE8), i, 0);
        let scale = [1e-6, 1e-3, 1.0, 1e3, 1e6][(i % 5) as usize];
        let away =
            scale * [0.0, 1.0, 1e2][(i / 5 % 3) as usize] * in_ball(&mut sampler).normalize();
        let turn = if i % 2 == 0 {
            Quat::IDENTITY
        } else {
            Quat::from_axis_angle(in_ball(&mut sampler).normalize(), 3.0)
        };
        let place = |p: Vec3| away + scale * (turn * p);
        let scene = room(place);
        let from_middle = |sampler: &mut Sampler| Ray::new(place(Vec3::ZERO), in_ball(sampler));
        let name = format!("scale {scale:e}, away by {away}, turned by {turn}");
        let [more, darker] = agree(&name, &scene, from_middle, 100);
        (asked, dark) = (asked + more, dark + darker);
    }
    assert!(asked > 50_000 && dark > 1000, "{asked} asked, {dark} dark");
}
