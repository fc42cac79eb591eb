//! A closed room in the dark, and the light that gets in.

use glam::{Vec3, vec3};
use ray_casting::{Camera, Geometry, Intersect, LinearSearch, Ray, SurfacePoint, surface_point};
use rendering_equation::Frame;
use rendering_equation::directions::cosine_hemisphere;
use workbench::{FilmSettings, Unwatched, expose};

use crate::figures::{Drawing, scene_file};
use crate::numbers::Numbers;
use crate::picture::Picture;
use crate::table::count;

const SIZE: [u32; 2] = [240, 200];
const SAMPLES: u32 = 16;

/// A hundredth of the room: somebody had set it for a larger one.
const EPSILON: f32 = 1e-2;

/// How a ray leaves a surface in a direction.
type Leave = fn(&SurfacePoint, Vec3) -> Ray;

fn by_constant(surface: &SurfacePoint, direction: Vec3) -> Ray {
    surface_point::offset_by_epsilon(surface, direction, EPSILON)
}

/// Six walls without thickness around the unit cube.
fn room() -> Geometry {
    let corner = |i: u32| vec3((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2 & 1) as f32);
    let walls =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    Geometry {
        vertices: (0..8).map(corner).collect(),
        triangles: walls.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        ..Geometry::default()
    }
}

/// Grey walls, and in them the share of rays that get out: where there should be none.
fn draw(leave: Leave) -> (Picture, u64) {
    let scene = ray_casting::Scene::load(&scene_file("furnace"));
    let mut scene = scene.unwrap_or_else(|error| panic!("{error}"));
    scene.geometry = room();
    scene.attributes.materials = vec![0; 12];
    let camera = Camera {
        eye: vec3(0.5, 0.5, 0.02),
        forward: Vec3::Z,
        right: Vec3::NEG_X,
        up: Vec3::Y,
        half_height: 0.9,
    };
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let escaped = |surface: &SurfacePoint, direction: Vec3| {
        geometry.intersect(&leave(surface, direction)).is_none()
    };
    let settings = FilmSettings { size: SIZE, samples: SAMPLES, seed: 0, threads: None };
    let image = expose(&settings, |point, sampler| {
        let ray = camera.ray(point);
        let Some(hit) = geometry.intersect(&ray) else { return [1.0, 0.0, 1.0] };
        let surface = scene.surface(&ray, &hit);
        let normal = surface.facing_normal();
        let up = Frame::around(normal).to_world(cosine_hemisphere(sampler.next_2d()));
        let grey = 0.04 + 0.06 * normal.dot(ray.direction).abs();
        let light = if escaped(&surface, up) { 2.0 } else { 0.0 };
        [grey + light, grey + light, grey]
    });
    // What is lit is brighter than any wall in red, and not in blue.
    let lit = image.pixels.iter().filter(|pixel| pixel[0] > pixel[2] + 1e-3).count();
    (Picture::from(&image), lit as u64)
}

/// The room by a constant, and by the bound.
pub(super) fn leaks() -> Drawing {
    let ways: [Leave; 2] = [by_constant, SurfacePoint::spawn];
    Picture::side_by_side(&ways.map(|leave| draw(leave).0), 16).into()
}

pub(super) fn numbers() -> Drawing {
    let ([by_constant, by_bound], pixels_in_all) = lit();
    let mut numbers = Numbers::new();
    numbers.add("pixels", count(pixels_in_all));
    numbers.add("rays", count(pixels_in_all * u64::from(SAMPLES)));
    numbers.add("by-constant", count(by_constant));
    numbers.add("by-bound", count(by_bound));
    numbers.into()
}

/// How many pixels of the dark room are lit by a constant and by the bound, and how many they are.
pub(crate) fn lit() -> ([u64; 2], u64) {
    let pixels = u64::from(SIZE[0]) * u64::from(SIZE[1]);
    ([draw(by_constant).1, draw(SurfacePoint::spawn).1], pixels)
}
