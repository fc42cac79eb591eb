//! Scenes that are hard to build a tree over.

use glam::{Vec3, vec3};
use workbench::Sampler;

use super::rays::in_cube;
use crate::geometry::Geometry;
use crate::math;
use crate::sphere::Sphere;

/// Every geometry of the suite, with its name.
pub(super) fn all() -> Vec<(&'static str, Geometry)> {
    vec![
        ("nothing", Geometry::default()),
        ("one triangle", soup(1, 1.0)),
        ("one sphere", spheres(1)),
        ("two triangles", soup(2, 1.0)),
        ("nine triangles", soup(9, 0.5)),
        ("many small triangles", soup(700, 0.1)),
        ("few large triangles", soup(60, 2.0)),
        ("spheres", spheres(300)),
        ("triangles and spheres", joined(soup(200, 0.3), spheres(150))),
        ("a closed mesh", ball(Vec3::ZERO)),
        ("a closed mesh far from the origin", ball(vec3(1000.0, -2000.0, 500.0))),
        ("a closed mesh very far from the origin", ball(vec3(148_376.0, 1234.0, -223_423.0))),
        ("a flat grid in y = 0", grid()),
        ("identical triangles", repeated(500)),
        ("centroids on a line", line()),
        ("triangles at powers of two", powers_of_two()),
        ("slivers", slivers()),
        ("a triangle of NaN among others", with_bad_vertex(f32::NAN)),
        ("a triangle of ∞ among others", with_bad_vertex(f32::INFINITY)),
        ("a triangle of the largest numbers among others", with_bad_vertex(f32::MAX)),
        ("points and segments instead of triangles", collapsed()),
    ]
}

fn from_triangles(triangles: impl IntoIterator<Item = [Vec3; 3]>) -> Geometry {
    let vertices: Vec<Vec3> = triangles.into_iter().flatten().collect();
    let triangles = (0..vertices.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Geometry { vertices, triangles, spheres: Vec::new() }
}

fn soup(count: u64, size: f32) -> Geometry {
    from_triangles((0..count).map(|i| {
        let mut sampler = Sampler::new(3, i, count);
        let center = in_cube(&mut sampler);
        [(); 3].map(|()| center + size * in_cube(&mut sampler))
    }))
}

fn spheres(count: u64) -> Geometry {
    let sphere = |i| {
        let mut sampler = Sampler::new(4, i, count);
        Sphere { center: in_cube(&mut sampler), radius: 0.02 + 0.2 * sampler.next_1d() }
    };
    Geometry { spheres: (0..count).map(sphere).collect(), ..Geometry::default() }
}

fn joined(mut first: Geometry, second: Geometry) -> Geometry {
    first.spheres.extend(second.spheres);
    first
}

/// A sphere of 16 × 16 rings and sectors whose vertices are moved in and out, shared by neighbours.
fn ball(center: Vec3) -> Geometry {
    const N: u32 = 16;
    let vertex = |ring: u32, sector: u32| {
        let mut sampler = Sampler::new(5, u64::from(ring), u64::from(sector));
        let at_pole = ring == 0 || ring == N;
        let radius = if at_pole { 3.0 } else { 1.0 + 5.0 * sampler.next_1d() };
        let (sin_theta, cos_theta) = math::sin_cos(std::f32::consts::PI * ring as f32 / N as f32);
        let (sin_phi, cos_phi) = math::sin_cos(std::f32::consts::TAU * sector as f32 / N as f32);
        let sin_theta = if at_pole { 0.0 } else { sin_theta };
        center + radius * vec3(sin_theta * cos_phi, cos_theta, sin_theta * sin_phi)
    };
    let vertices =
        (0..=N).flat_map(|ring| (0..N).map(move |sector| vertex(ring, sector))).collect();
    let mut triangles = Vec::new();
    for ring in 0..N {
        for sector in 0..N {
            let (next, below) = ((sector + 1) % N, ring + 1);
            let [a, b] = [ring * N + sector, ring * N + next];
            let [c, d] = [below * N + next, below * N + sector];
            if ring > 0 {
                triangles.push([a, b, c]);
            }
            if below < N {
                triangles.push([a, c, d]);
            }
        }
    }
    // All copies of a pole are one vertex.
    for vertex in triangles.iter_mut().flatten() {
        *vertex = if *vertex < N { 0 } else { (*vertex).min(N * N) };
    }
    Geometry { vertices, triangles, spheres: Vec::new() }
}

fn grid() -> Geometry {
    let corner = |x: u32, z: u32| vec3(x as f32, 0.0, z as f32);
    let cells = (0..12).flat_map(|x| (0..12).map(move |z| (x, z)));
    from_triangles(cells.flat_map(|(x, z)| {
        let [a, b, c, d] = [corner(x, z), corner(x, z + 1), corner(x + 1, z + 1), corner(x + 1, z)];
        [[a, b, c], [a, c, d]]
    }))
}

fn repeated(count: usize) -> Geometry {
    from_triangles(vec![[Vec3::X, Vec3::Y, Vec3::Z]; count])
}

fn line() -> Geometry {
    from_triangles((0..300).map(|i| {
        let center = 0.25 * i as f32 * Vec3::ONE;
        [center + Vec3::X, center + Vec3::Y, center - Vec3::X - Vec3::Y]
    }))
}

fn powers_of_two() -> Geometry {
    from_triangles((-60..=60).map(|exponent| {
        let x = f32::from_bits(((127 + exponent) as u32) << 23);
        [vec3(x, -1.0, -1.0), vec3(x, 1.0, -1.0), vec3(x, 0.0, 2.0)]
    }))
}

fn slivers() -> Geometry {
    from_triangles((0..200).map(|i| {
        let mut sampler = Sampler::new(6, i, 0);
        let (start, along) = (in_cube(&mut sampler), 4.0 * in_cube(&mut sampler));
        [start, start + along, start + 0.5 * along + 1e-5 * in_cube(&mut sampler)]
    }))
}

fn with_bad_vertex(bad: f32) -> Geometry {
    let mut geometry = soup(100, 0.3);
    geometry.vertices[151].y = bad;
    geometry
}

fn collapsed() -> Geometry {
    let mut geometry = soup(50, 0.5);
    for (i, corners) in geometry.triangles.iter_mut().enumerate() {
        match i % 3 {
            0 => corners[1] = corners[0],
            1 => *corners = [corners[0]; 3],
            _ => {}
        }
    }
    geometry
}
