//! A closed mesh has no holes, and with the test of Möller and Trumbore it has.

use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, LinearSearch, Ray, math, moller_trumbore, triangle};
use workbench::{Sampler, Unwatched};

use crate::tools::in_cube;

/// Rays of each kind.
const RAYS: u64 = 20_000;

/// Rings and sectors of the ball.
const N: u32 = 16;

/// A ball whose vertices are moved in and out between the radii 1 and 6; neighbours share them.
fn ball(center: Vec3) -> Geometry {
    let vertex = |ring: u32, sector: u32| {
        let radius = 1.0 + 5.0 * Sampler::new(1, u64::from(ring), u64::from(sector)).next_1d();
        let (sin_theta, cos_theta) = math::sin_cos(std::f32::consts::PI * ring as f32 / N as f32);
        let (sin_phi, cos_phi) = math::sin_cos(std::f32::consts::TAU * sector as f32 / N as f32);
        center + radius * vec3(sin_theta * cos_phi, cos_theta, sin_theta * sin_phi)
    };
    let rings = (1..N).flat_map(|ring| (0..N).map(move |sector| vertex(ring, sector)));
    let poles = [center + 3.0 * Vec3::Y, center - 3.0 * Vec3::Y];
    let [north, south] = [(N - 1) * N, (N - 1) * N + 1];
    let mut triangles = Vec::new();
    for sector in 0..N {
        let next = (sector + 1) % N;
        triangles.push([north, next, sector]);
        for ring in 0..N - 2 {
            let [a, b] = [ring * N + sector, ring * N + next];
            triangles.extend([[a, b, b + N], [a, b + N, a + N]]);
        }
        triangles.push([south, (N - 2) * N + sector, (N - 2) * N + next]);
    }
    Geometry { vertices: rings.chain(poles).collect(), triangles, spheres: Vec::new() }
}

#[derive(Clone, Copy, Debug)]
enum Aim {
    Random,
    Vertex,
    Edge,
}

/// A ray from less than ½ beside the centre.
fn ray(ball: &Geometry, center: Vec3, aim: Aim, i: u64) -> Ray {
    let mut sampler = Sampler::new(2, i, aim as u64);
    let origin = center + 0.28 * in_cube(&mut sampler);
    let direction = in_cube(&mut sampler);
    let triangle = (sampler.next_1d() * ball.triangles.len() as f32) as u32;
    let [from, to, _] = ball.corners(triangle);
    let direction = match aim {
        Aim::Random => direction,
        Aim::Vertex => from - origin,
        Aim::Edge => from.lerp(to, sampler.next_1d()) - origin,
    };
    Ray::new(origin, direction.normalize())
}

fn misses(ball: &Geometry, center: Vec3, aim: Aim, is_hit: impl Fn(&Ray) -> bool) -> usize {
    (0..RAYS).filter(|&i| !is_hit(&ray(ball, center, aim, i))).count()
}

/// accuracy T3, T4: near the origin, and at two places where coordinates are coarse.
#[test]
fn no_ray_leaves_a_closed_mesh() {
    let far = vec3(148_376.0, 1234.0, -223_423.0);
    for center in [Vec3::ZERO, vec3(1000.0, -2000.0, 500.0), far] {
        let ball = ball(center);
        let search = LinearSearch::new(&ball, &Unwatched);
        for aim in [Aim::Random, Aim::Vertex, Aim::Edge] {
            let lost = misses(&ball, center, aim, |ray| search.occluded(ray));
            assert_eq!(lost, 0, "of {RAYS} rays aimed {aim:?} from within a ball at {center}");
        }
    }
}

/// accuracy §1: several per cent of those aimed at vertices and edges get lost.
#[test]
fn rays_slip_through_the_triangles_of_moller_and_trumbore() {
    let ball = ball(Vec3::ZERO);
    let is_hit = |ray: &Ray| {
        let triangles = 0..ball.triangles.len() as u32;
        triangles.clone().any(|i| moller_trumbore::intersect(ray, ball.corners(i), i).is_some())
    };
    let [random, vertex, edge] =
        [Aim::Random, Aim::Vertex, Aim::Edge].map(|aim| misses(&ball, Vec3::ZERO, aim, is_hit));
    assert!(random <= 2, "{random} of {RAYS} random rays are lost");
    let expected = RAYS as usize / 50..RAYS as usize / 5;
    assert!(expected.contains(&vertex), "{vertex} of {RAYS} rays aimed at vertices are lost");
    assert!(expected.contains(&edge), "{edge} of {RAYS} rays aimed at edges are lost");
}

/// accuracy T2: the two triangles of a square, and rays whose every coordinate says "diagonal".
#[test]
fn no_ray_slips_through_the_diagonal_of_a_square() {
    let [a, b, c, d] =
        [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(1.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0)];
    for i in 0..65_536_u64 {
        let mut sampler = Sampler::new(3, i, 0);
        let target = sampler.next_1d();
        let start = 4.0 * sampler.next_1d() - 2.0;
        let slope = if i % 2 == 0 { 0.0 } else { start - target };
        let origin = vec3(target + slope, target + slope, -1.0);
        let ray = Ray::new(origin, vec3(-slope, -slope, 1.0));
        let sheared = triangle::ShearedRay::new(&ray);
        let hits = [[a, b, c], [a, c, d]].map(|t| triangle::intersect(&sheared, &t, 0));
        assert!(hits.iter().any(Option::is_some), "ray {i}, {ray:?}, misses both triangles");
    }
}
