//! Glass in, beside and across other glass.

use crate::scenes::{
    add_block, add_quad, add_sphere, asset, black, difference, glass, picture, radiance, white,
};
use glam::{Vec3, vec3};
use mirror_refraction::{Boundaries, Contacts, Limits};
use ray_casting::{LinearSearch, Ray, Scene};
use workbench::{MaterialRecord, Unwatched};

const U: f32 = f32::EPSILON / 2.0;
const SIZE: [u32; 2] = [48, 36];

type Block = (Vec3, Vec3);

fn limits() -> Limits {
    Limits::new(Some(8), Limits::CUTOFF)
}

/// Turned so that no coordinate is a round number, and moved away from the origin.
fn askew(v: Vec3) -> Vec3 {
    let turned = vec3(0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z);
    vec3(turned.x, 0.28 * turned.y - 0.96 * turned.z, 0.96 * turned.y + 0.28 * turned.z) + 0.1
}

/// Glass blocks over the checkered floor of `touching-glass`, instead of its own.
fn blocks(parts: &[Block], place: fn(Vec3) -> Vec3) -> Scene {
    let mut scene = asset("touching-glass");
    let (floor, glass) = (scene.attributes.materials[0], scene.attributes.materials[2]);
    scene.geometry.triangles.truncate(2);
    scene.attributes.materials = vec![floor; 2];
    for &(a, b) in parts {
        add_block(&mut scene, a, b, glass, |v| place(v) + vec3(0.0, 0.7, 0.0));
    }
    scene
}

/// Asserts that two ways of cutting a body into blocks look the same, straight and askew.
///
/// A ray that passes through a face starts anew there and is rounded: hence the tolerance.
fn assert_same_body(one: &[Block], other: &[Block]) {
    for (name, place) in [("straight", (|v| v) as fn(Vec3) -> Vec3), ("askew", askew)] {
        let expected = picture(&blocks(one, place), SIZE, limits());
        let got = picture(&blocks(other, place), SIZE, limits());
        let (worst, count) = difference(&expected, &got, 1e-4);
        assert!(count == 0, "{name}: {count} pixels differ, by up to {worst}");
    }
}

/// The shared face is one whichever of the two is numbered first.
#[test]
fn two_touching_blocks_look_like_one() {
    let (left, right) = (vec3(-1.0, -0.5, -0.5), vec3(1.0, 0.5, 0.5));
    let (a, b) = ((left, vec3(0.1, 0.5, 0.5)), (vec3(0.1, -0.5, -0.5), right));
    for parts in [[a, b], [b, a]] {
        assert_same_body(&[(left, right)], &parts);
    }
}

/// A small block on the middle of a large one, cut as such, and cut into three columns.
#[test]
fn blocks_that_touch_in_part_look_like_one_body() {
    let base = (vec3(-1.0, -0.5, -0.5), vec3(1.0, 0.1, 0.5));
    let top = (vec3(-0.3, 0.1, -0.2), vec3(0.4, 0.6, 0.5));
    let column = (vec3(-0.3, -0.5, -0.2), vec3(0.4, 0.6, 0.5));
    let left = (base.0, vec3(-0.3, 0.1, 0.5));
    let right = (vec3(0.4, -0.5, -0.5), base.1);
    let back = (vec3(-0.3, -0.5, -0.5), vec3(0.4, 0.1, -0.2));
    assert_same_body(&[base, top], &[left, column, back, right]);
    assert_same_body(&[top, base], &[back, right, left, column]);
}

/// A scene of slabs from (−1, −1) to (1, 1), one for each material, before a black wall.
fn slabs(slabs: &[(f32, f32)], materials: &[MaterialRecord]) -> Scene {
    let mut scene = white(materials.iter().cloned().chain([black()]));
    for (material, &(back, front)) in slabs.iter().enumerate() {
        add_block(
            &mut scene,
            vec3(-1.0, -1.0, back),
            vec3(1.0, 1.0, front),
            material as u32,
            |v| v,
        );
    }
    let wall = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)];
    add_quad(&mut scene, wall.map(|(x, y)| vec3(x, y, -5.0)), materials.len() as u32);
    scene
}

/// What slabs reflect of a ray that meets them head on, off the quads' diagonals and on them.
fn assert_reflected(scene: &Scene, depth: u32, expected: f32) {
    for (x, y) in [(0.3, -0.4), (0.0, 0.0), (0.5, 0.5), (-0.5, 0.5)] {
        let ray = Ray::new(vec3(x, y, 5.0), Vec3::NEG_Z);
        // Without a cutoff, the branches between three boundaries double with every other event.
        let reflected = radiance(scene, ray, Limits::new(Some(depth), 1e-10)).x;
        let error = (reflected - expected).abs();
        assert!(error <= 8.0 * U, "({x}, {y}): {reflected}, expected {expected}");
    }
}

/// From η = 1.5 into 2.4 there is one boundary, with R = (0.9/3.9)², and none to air.
#[test]
fn between_touching_glasses_there_is_no_air() {
    let (light, dense) = (glass(1.5), glass(2.4));
    let middle = (0.9_f32 / 3.9).powi(2);
    let expected = 0.04 + 0.96 * 0.96 * middle;
    let front_first = slabs(&[(0.0, 1.0), (-1.0, 0.0)], &[light.clone(), dense.clone()]);
    assert_reflected(&front_first, 3, expected);
    let back_first = slabs(&[(-1.0, 0.0), (0.0, 1.0)], &[dense, light]);
    assert_reflected(&back_first, 3, expected);
}

/// Two slabs of the same index are one where they overlap: what is left first changes nothing.
#[test]
fn overlapping_bodies_of_one_index_are_one_body() {
    let overlapping = slabs(&[(0.0, 1.0), (-1.0, 0.4)], &[glass(1.5), glass(1.5)]);
    assert_reflected(&overlapping, 30, 1.0 / 13.0);
}

/// A slab of air in a slab of glass: two panes.
#[test]
fn a_body_of_air_in_glass_is_a_gap() {
    let gap = slabs(&[(0.0, 3.0), (1.0, 2.0)], &[glass(1.5), glass(1.0)]);
    let pane = 1.0 / 13.0_f32;
    assert_reflected(&gap, 60, 2.0 * pane / (1.0 + pane));
}

/// And the bubble may share a face with the glass around it: one pane, and air.
#[test]
fn a_body_of_air_that_shares_a_face_with_its_glass_opens_it() {
    let open = slabs(&[(0.0, 3.0), (0.0, 2.0)], &[glass(1.5), glass(1.0)]);
    assert_reflected(&open, 30, 1.0 / 13.0);
}

/// The floor through a sphere of index 1, without lights, whose shadows would give it away.
#[test]
fn a_body_of_air_in_air_is_invisible() {
    let mut scene = blocks(&[], |v| v);
    scene.lights.clear();
    scene.ambient = Vec3::splat(0.3);
    let air = scene.materials.len() as u32;
    scene.materials.push(glass(1.0));
    let expected = picture(&scene, SIZE, limits());
    add_sphere(&mut scene, vec3(0.0, 0.7, 0.0), 0.5, air);
    let got = picture(&scene, SIZE, limits());
    let (worst, count) = difference(&expected, &got, 0.0);
    assert!(count == 0, "{count} pixels differ, by up to {worst}");
}

/// A block on the floor shows the floor, which faces the ray that is inside; both ways of
/// numbering.
#[test]
fn glass_that_stands_on_the_floor_hides_nothing() {
    let floor = |scene: &mut Scene| {
        let corners = [(-9.0, 9.0), (9.0, 9.0), (9.0, -9.0), (-9.0, -9.0)];
        add_quad(scene, corners.map(|(x, z)| vec3(x, -1.0, z)), 1);
    };
    let block = |scene: &mut Scene| {
        add_block(scene, vec3(-1.0, -1.0, -1.0), vec3(1.0, 0.5, 1.0), 0, |v| v);
    };
    let build = |parts: [&dyn Fn(&mut Scene); 2]| {
        let mut scene = white([glass(1.5), black()]);
        parts.iter().for_each(|part| part(&mut scene));
        scene
    };
    let floor_first = picture(&build([&floor, &block]), SIZE, limits());
    let block_first = picture(&build([&block, &floor]), SIZE, limits());
    let (worst, count) = difference(&floor_first, &block_first, 1e-4);
    assert!(count == 0, "{count} pixels differ, by up to {worst}");

    // Straight down through the block: what is not reflected above ends on the black floor.
    let down = Ray::new(vec3(0.3, 5.0, 0.4), Vec3::NEG_Y);
    for scene in [build([&floor, &block]), build([&block, &floor])] {
        let seen = radiance(&scene, down, Limits::new(Some(8), 0.0)).x;
        assert!((seen - 0.04).abs() <= 4.0 * U, "reflected above: {seen}");
    }
}

/// The index around a point, looking along a slanted direction.
fn ior_at(scene: &Scene, point: Vec3) -> f32 {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let ray = Ray::new(point, vec3(0.3, 0.2, -0.9).normalize());
    Boundaries::new(scene).media_at(ray, &geometry).ior()
}

#[test]
fn an_eye_inside_glass_knows_where_it_is() {
    let mut nested = white([glass(1.5), glass(2.4), glass(1.0)]);
    add_sphere(&mut nested, Vec3::ZERO, 3.0, 0);
    add_sphere(&mut nested, Vec3::ZERO, 2.0, 1);
    add_sphere(&mut nested, vec3(0.0, 0.0, -1.0), 0.5, 2);
    for (z, expected) in [(5.0, 1.0), (2.5, 1.5), (1.0, 2.4), (-1.0, 1.0), (-2.5, 1.5)] {
        let ior = ior_at(&nested, vec3(0.0, 0.0, z));
        assert_eq!(ior, expected, "at z = {z}");
    }

    let touching = [(0.0, 1.0), (-1.0, 0.0)];
    for (slabs, materials) in [
        (slabs(&touching, &[glass(1.5), glass(2.4)]), [1.5, 2.4]),
        (slabs(&touching, &[glass(2.4), glass(1.5)]), [2.4, 1.5]),
    ] {
        for (z, expected) in [(2.0, 1.0), (0.5, materials[0]), (-0.5, materials[1]), (-2.0, 1.0)] {
            let ior = ior_at(&slabs, vec3(0.1, 0.2, z));
            assert_eq!(ior, expected, "{materials:?} at z = {z}");
        }
    }
}

/// From the inside of a slab, head on: what is not let out is let out on the other side.
#[test]
fn an_eye_inside_glass_sees_through_its_surface() {
    let mut scene = slabs(&[(4.0, 6.0)], &[glass(1.5)]);
    scene.background = Vec3::ONE;
    let forward = Ray::new(scene.camera.eye, scene.camera.forward);
    let direct = radiance(&scene, forward, Limits::new(Some(1), 0.0)).x;
    assert_eq!(direct, 0.0, "the black wall, at depth 1");
    let reflected = radiance(&scene, forward, Limits::new(Some(2), 0.0)).x;
    assert!((reflected - 0.04 * 0.96).abs() <= 4.0 * U, "by the front, from behind: {reflected}");
}

/// An open pane, seen from behind: as from within, R = 4 % head on.
#[test]
fn a_body_that_is_left_without_having_been_entered_is_one_that_the_ray_was_in() {
    let mut scene = white([glass(1.5), black()]);
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    add_quad(&mut scene, corners.map(|(x, y)| vec3(x, y, 0.0)), 0);
    let wall = corners.map(|(x, y)| vec3(9.0 * x, 9.0 * y, -5.0));
    add_quad(&mut scene, wall, 1);
    scene.camera.eye = vec3(0.0, 9.5, 5.0);
    let ray = Ray::new(vec3(0.3, -0.4, 5.0), Vec3::NEG_Z);
    let reflected = radiance(&scene, ray, Limits::new(Some(4), 0.0)).x;
    assert!((reflected - 0.04).abs() <= 4.0 * U, "R = {reflected}");
}

#[test]
fn only_what_touches_is_in_contact() {
    for (name, expected) in [
        ("whitted", 0),
        ("nested-glass", 0),
        ("glass-slab", 0),
        ("cornell-spheres", 0),
        ("touching-glass", 8), // Two triangles on two, in both orders.
    ] {
        let scene = asset(name);
        let contacts = Contacts::find(&scene);
        let count: usize =
            (0..scene.geometry.primitives()).map(|face| contacts.of(face).len()).sum();
        assert_eq!(count, expected, "{name}");
    }
}
