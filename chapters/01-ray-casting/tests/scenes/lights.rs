//! Point lights, and those that stand in for lamps.

use std::f32::consts::PI;

use glam::{Vec3, vec3};
use ray_casting::{LinearSearch, PointLight, Rgb, Scene, SurfacePoint};
use workbench::Unwatched;

use crate::tools::{scene, scene_with_mesh, surface};

/// A floor at y = 0, and a lamp of 1 × 2 at y = 4 that faces down.
const ROOM: &str = "[[quad]]\nmaterial = 'white'\n\
    vertices = [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, -9]]\n\
    [[quad]]\nmaterial = 'lamp'\n\
    vertices = [[-1, 4, -0.5], [1, 4, -0.5], [1, 4, 0.5], [-1, 4, 0.5]]\n";

fn sphere(center: [f32; 3], radius: f32, material: &str) -> String {
    format!("[[sphere]]\ncenter = {center:?}\nradius = {radius}\nmaterial = '{material}'\n")
}

/// The point of the floor under (x, 1, 0).
fn floor(scene: &Scene, x: f32) -> SurfacePoint {
    surface(scene, vec3(x, 0.5, 0.0), Vec3::NEG_Y)
}

fn sees(scene: &Scene, point: &SurfacePoint, light: &PointLight) -> bool {
    light.is_visible_from(point, &LinearSearch::new(&scene.geometry, &Unwatched))
}

#[test]
fn a_quad_lamp_is_a_point_light_at_its_centre() {
    let room = scene(ROOM);
    let [light] = &room.lights[..] else { panic!("{:?}", room.lights) };
    assert_eq!(light.position, vec3(0.0, 4.0, 0.0), "its place");
    assert_eq!(light.normal, Some(Vec3::NEG_Y), "the side it shines to");
    assert_eq!(light.lamp, 2..4, "the triangles it stands in for");
    let error = (light.intensity - Rgb::new(1.0, 2.0, 4.0) * 2.0 / PI).abs().max_element();
    assert!(error <= f32::EPSILON, "L A / π = {}", light.intensity);
    let behind = light.intensity_toward(vec3(0.0, 5.0, 0.0));
    assert_eq!(behind, Rgb::ZERO, "nothing behind it");
}

#[test]
fn a_quad_lamp_casts_no_shadow_of_its_own() {
    let room = scene(ROOM);
    for x in [-8.0, -0.3, 0.0, 0.25, 5.0] {
        assert!(sees(&room, &floor(&room, x), &room.lights[0]), "the floor at x = {x}");
    }
}

#[test]
fn other_things_stand_in_the_way_of_a_lamp() {
    let room = scene(&format!("{ROOM}{}", sphere([2.0, 2.0, 0.0], 0.5, "white")));
    let light = &room.lights[0];
    assert!(!sees(&room, &floor(&room, 4.0), light), "behind the sphere");
    assert!(sees(&room, &floor(&room, 0.0), light), "beside it");
}

#[test]
fn lamps_stand_in_each_others_way() {
    let lamps = sphere([2.0, 2.0, 0.0], 0.5, "lamp") + &sphere([0.0, 6.0, 0.0], 0.5, "lamp");
    let room = scene(&format!("{ROOM}{lamps}"));
    let [flat, low, high] = &room.lights[..] else { panic!("{:?}", room.lights) };
    let (behind, below) = (floor(&room, 4.0), floor(&room, 0.0));
    assert!(!sees(&room, &behind, flat), "the low sphere hides the flat lamp");
    assert!(sees(&room, &behind, low), "the low sphere does not hide itself");
    assert!(!sees(&room, &below, high), "the flat lamp hides the high sphere");
    assert!(sees(&room, &below, flat), "the flat lamp does not hide itself");
}

#[test]
fn a_sphere_lamp_shines_to_all_sides_through_its_own_surface() {
    let room = scene(&format!(
        "{}{}",
        sphere([0.0, 0.0, 0.0], 0.5, "lamp"),
        sphere([0.0, 0.0, 0.0], 4.0, "white")
    ));
    let [light] = &room.lights[..] else { panic!("{:?}", room.lights) };
    assert_eq!((light.position, light.normal), (Vec3::ZERO, None), "a light all around");
    assert_eq!(light.intensity, Rgb::new(0.25, 0.5, 1.0), "L r²");
    for direction in [Vec3::X, Vec3::NEG_Y, vec3(1.0, -2.0, 0.5)] {
        let wall = surface(&room, direction.normalize(), direction);
        assert!(sees(&room, &wall, light), "the wall along {direction}");
    }
}

#[test]
fn a_shadow_is_cast_by_what_lies_before_a_light_and_not_behind() {
    let light = "[[point_light]]\nposition = [0, 2, 0]\nintensity = [1, 1, 1]\n";
    for (y, visible) in [(1.0, false), (2.0, false), (2.5, true)] {
        let room = scene(&format!("{ROOM}{light}{}", sphere([0.0, y, 0.0], 0.25, "white")));
        let point = surface(&room, vec3(0.0, 0.5, 0.0), Vec3::NEG_Y);
        assert_eq!(sees(&room, &point, &room.lights[0]), visible, "a sphere at height {y}");
    }
}

#[test]
fn the_lights_of_the_file_come_first() {
    let room =
        scene(&format!("{ROOM}[[point_light]]\nposition = [1, 2, 3]\nintensity = [4, 5, 6]"));
    assert_eq!(room.lights.len(), 2, "the lights");
    assert_eq!(room.lights[0].position, vec3(1.0, 2.0, 3.0), "the first");
    assert!(room.lights[0].lamp.is_empty(), "it stands in for nothing");
}

/// A closed mesh has no mean normal: a cube of side 2 shines like a sphere with its area.
#[test]
fn a_closed_mesh_that_shines_is_a_light_all_around() {
    let corners =
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    let faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let mesh = "[[mesh]]\nfile = 'a.obj'\nmaterial = 'lamp'\ntranslate = [0, 5, 0]\n";
    let room = scene_with_mesh(mesh, &format!("{corners}{faces}"));
    let [light] = &room.lights[..] else { panic!("{:?}", room.lights) };
    assert_eq!((light.position, light.normal), (Vec3::new(0.0, 5.0, 0.0), None), "the light");
    assert_eq!(light.lamp, 0..12, "the triangles it stands in for");
    let expected = 24.0 / (4.0 * PI);
    let error = (light.intensity.x - expected).abs();
    assert!(error <= 4.0 * f32::EPSILON, "L A / 4π = {} for {expected}", light.intensity.x);
}

/// Materials of one mesh alternate; each that shines becomes one light for all its triangles.
#[test]
fn the_shining_triangles_of_a_mesh_become_one_light() {
    let obj = "mtllib a.mtl\nv 0 4 0\nv 1 4 0\nv 0 4 -1\nv 5 4 0\nv 6 4 0\nv 5 4 -1\nv 9 4 0\nv 10 4 0\n\
               v 9 4 -1\nusemtl shine\nf 1 3 2\nusemtl dull\nf 4 6 5\nusemtl shine\nf 7 9 8\n";
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("the file is written");
    };
    write("a.obj", obj);
    write("a.mtl", "newmtl shine\nKe 3 3 3\nnewmtl dull\nKd 1 1 1\n");
    write(
        "scene.toml",
        "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 40\nsize = [4, 3]\n\
         [[mesh]]\nfile = 'a.obj'\n",
    );
    let path = folder.path().join("scene.toml");
    let room = Scene::load(&path).unwrap_or_else(|error| panic!("{error}"));
    let [light] = &room.lights[..] else { panic!("{:?}", room.lights) };
    assert_eq!(light.lamp.len(), 2, "the triangles it stands in for: {:?}", light.lamp);
    let error = light.position.distance(vec3(14.0 / 3.0 + 1.0 / 6.0, 4.0, -1.0 / 3.0));
    assert!(error <= 1e-5, "its place is {}", light.position);
    for triangle in light.lamp.clone() {
        let x = room.geometry.corners(triangle)[0].x;
        assert!(x == 0.0 || x == 9.0, "triangle {triangle} of the lamp starts at x = {x}");
    }
}
