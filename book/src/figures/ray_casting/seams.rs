//! Rays that slip between triangles.

use std::collections::BTreeSet;

use glam::{Vec3, vec3};
use ray_casting::{Camera, Geometry, Hit, Intersect, LinearSearch, Ray, moller_trumbore};
use workbench::{FilmSettings, Sampler, Unwatched, expose};

use crate::figures::Drawing;
use crate::picture::Picture;
use crate::table::{Table, count};

/// How many rays of each kind.
const RAYS: u64 = 10_000;

/// A closed ball of 480 triangles whose vertices are moved in and out, shared by neighbours.
fn ball(center: Vec3) -> Geometry {
    let mesh = generator::blob(16);
    let bumpy = |(i, p): (u64, &[f32; 3])| {
        let stretch = 1.0 + 0.5 * Sampler::new(3, i, 0).next_1d();
        center + stretch * Vec3::from_array(*p)
    };
    Geometry {
        vertices: (0..).zip(&mesh.positions).map(bumpy).collect(),
        triangles: mesh.triangles,
        ..Geometry::default()
    }
}

/// All triangles of a geometry by the test of Möller and Trumbore.
struct MollerTrumbore<'a>(&'a Geometry);

impl Intersect for MollerTrumbore<'_> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let triangles = 0..self.0.triangles.len() as u32;
        let hits = triangles.filter_map(|i| moller_trumbore::intersect(ray, self.0.corners(i), i));
        hits.min_by(|a, b| a.t.total_cmp(&b.t))
    }
}

/// A ray of one of the kinds of the table, from a point near the ball's centre.
#[derive(Clone, Copy)]
enum Aim {
    Random,
    Vertex,
    Edge,
}

impl Aim {
    fn ray(self, ball: &Geometry, center: Vec3, i: u64) -> Ray {
        let mut sampler = Sampler::new(4, i, self as u64);
        let mut cube = || {
            let [x, y] = sampler.next_2d();
            2.0 * vec3(x, y, sampler.next_1d()) - 1.0
        };
        let origin = center + 0.25 * cube();
        let direction = cube();
        let triangle = (sampler.next_1d() * ball.triangles.len() as f32) as u32;
        let [from, to, _] = ball.corners(triangle);
        let direction = match self {
            Self::Random => direction,
            Self::Vertex => from - origin,
            Self::Edge => from.lerp(to, sampler.next_1d()) - origin,
        };
        Ray::new(origin, direction.normalize())
    }
}

/// How many rays leave a closed mesh, by the aim of the rays and the test.
pub(super) fn missed() -> Drawing {
    let mut table =
        Table::new(&["rays from inside, aimed", "rays", "lost by Möller–Trumbore", "lost by ours"]);
    let (here, far) = (Vec3::ZERO, vec3(1000.0, -2000.0, 500.0));
    for (name, aim, center) in [
        ("at random", Aim::Random, here),
        ("at vertices", Aim::Vertex, here),
        ("at points of edges", Aim::Edge, here),
        ("at vertices, the ball around (1000, −2000, 500)", Aim::Vertex, far),
    ] {
        let [naive, watertight] = lost(aim, center).map(count);
        table.row([name.to_owned(), count(RAYS), naive, watertight]);
    }
    table.into()
}

/// How many of the rays leave the ball by the test of Möller and Trumbore, and by ours.
fn lost(aim: Aim, center: Vec3) -> [u64; 2] {
    let ball = ball(center);
    let (naive, watertight) = (MollerTrumbore(&ball), LinearSearch::new(&ball, &Unwatched));
    let rays = || (0..RAYS).map(|i| aim.ray(&ball, center, i));
    let lost = [
        rays().filter(|ray| !naive.occluded(ray)).count(),
        rays().filter(|ray| !watertight.occluded(ray)).count(),
    ];
    lost.map(|n| n as u64)
}

/// The same for rays at points of edges, and how many they are.
pub(crate) fn lost_at_edges() -> ([u64; 2], u64) {
    (lost(Aim::Edge, Vec3::ZERO), RAYS)
}

const SIZE: [u32; 2] = [320, 320];

/// The ball from outside; red where a ray aimed at an edge meets neither of its triangles.
pub(super) fn seams() -> Drawing {
    let ball = ball(Vec3::ZERO);
    let camera = Camera {
        eye: vec3(0.0, 3.0, 7.4),
        forward: vec3(0.0, -0.375, -0.925),
        right: Vec3::X,
        up: vec3(0.0, 0.925, -0.375),
        half_height: 0.22,
    };
    let watertight = LinearSearch::new(&ball, &Unwatched);
    let settings = FilmSettings { size: SIZE, samples: 1, seed: 0, threads: None };
    let image = expose(&settings, |point, _| {
        let ray = camera.ray(point);
        watertight.intersect(&ray).map_or([0.05, 0.06, 0.08], |hit| {
            let [v0, v1, v2] = ball.corners(hit.primitive);
            let normal = (v1 - v0).cross(v2 - v0).normalize();
            [0.05 + 0.5 * normal.dot(ray.direction).abs(); 3]
        })
    });
    let panels = [
        with_holes(Picture::from(&image), &ball, &camera, &MollerTrumbore(&ball)),
        with_holes(Picture::from(&image), &ball, &camera, &watertight),
    ];
    Picture::side_by_side(&panels, 16).into()
}

/// Marks the points of edges that the eye sees, and that a ray by `search` passes through.
///
/// Outlines do not count: a ray aimed at one may well pass beside the ball. Both triangles of an
/// edge must turn to the eye.
fn with_holes(
    mut picture: Picture,
    ball: &Geometry,
    camera: &Camera,
    search: &impl Intersect,
) -> Picture {
    let watertight = LinearSearch::new(ball, &Unwatched);
    for [from, to] in edges_in_front(ball, camera.eye) {
        for i in 0..=250_u8 {
            let target = from.lerp(to, f32::from(i) / 250.0);
            let distance = target.distance(camera.eye);
            let ray = Ray::new(camera.eye, (target - camera.eye) / distance);
            let hidden = watertight.intersect(&ray).is_some_and(|hit| hit.t < 0.999 * distance);
            let held = search.intersect(&ray).is_some_and(|hit| hit.t < 1.001 * distance);
            if !hidden && !held {
                mark(&mut picture, camera, target);
            }
        }
    }
    picture
}

/// The end points of the edges between two triangles that both turn their front to `eye`.
fn edges_in_front(ball: &Geometry, eye: Vec3) -> Vec<[Vec3; 2]> {
    let faces_eye = |[v0, v1, v2]: [Vec3; 3]| (v1 - v0).cross(v2 - v0).dot(eye - v0) > 0.0;
    let front = (0..ball.triangles.len() as u32).filter(|&i| faces_eye(ball.corners(i)));
    let front: Vec<_> = front.map(|i| ball.triangles[i as usize]).collect();
    let directed = front.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let directed: BTreeSet<_> = directed.collect();
    let shared = directed.iter().filter(|&&(a, b)| a < b && directed.contains(&(b, a)));
    shared.map(|&(a, b)| [a, b].map(|vertex| ball.vertices[vertex as usize])).collect()
}

/// Paints the pixel in which the camera sees `target` red.
fn mark(picture: &mut Picture, camera: &Camera, target: Vec3) {
    let seen = target - camera.eye;
    let scale = SIZE[1] as f32 / (2.0 * camera.half_height * seen.dot(camera.forward));
    let x = SIZE[0] as f32 / 2.0 + scale * seen.dot(camera.right);
    let y = SIZE[1] as f32 / 2.0 - scale * seen.dot(camera.up);
    let i = 4 * (y as usize * SIZE[0] as usize + x as usize);
    picture.rgba[i..i + 4].copy_from_slice(&[255, 0, 0, 255]);
}
