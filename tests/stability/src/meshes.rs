//! Closed meshes, whose every ray from within has to hit something.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, Vec3, dvec3};
use ray_casting::Geometry;

use crate::random::Random;

/// Rings and sectors of the ball.
const N: u32 = 16;

/// A ball whose vertices are moved in and out between the radii 1 and 6; neighbours share them.
///
/// pbrt's mesh for this purpose (`src/pbrt/shapes_test.cpp`, `Triangle, Watertight`), made anew: no
/// point within 0.28 √3 < ½ of the centre lies outside.
#[must_use]
pub fn ball(center: Vec3, random: &mut Random) -> Geometry {
    let mut vertex = |ring: u32, sector: u32| {
        let (sin_theta, cos_theta) = libm::sincos(PI * f64::from(ring) / f64::from(N));
        let (sin_phi, cos_phi) = libm::sincos(TAU * f64::from(sector) / f64::from(N));
        let direction = dvec3(sin_theta * cos_phi, cos_theta, sin_theta * sin_phi);
        (center.as_dvec3() + random.between(1.0, 6.0) * direction).as_vec3()
    };
    let places = (1..N).flat_map(|ring| (0..N).map(move |sector| (ring, sector)));
    let vertices = places.chain([(0, 0), (N, 0)]).map(|(ring, sector)| vertex(ring, sector));
    Geometry { vertices: vertices.collect(), triangles: sphere_triangles(), spheres: Vec::new() }
}

/// The triangles of a sphere whose vertices run ring by ring from the north, its poles last.
fn sphere_triangles() -> Vec<[u32; 3]> {
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
    triangles
}

/// A point near the centre of a [`ball`].
#[must_use]
pub fn within(center: Vec3, random: &mut Random) -> Vec3 {
    let beside: DVec3 = 0.28 * random.in_cube();
    (center.as_dvec3() + beside).as_vec3()
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use glam::Vec3;

    use super::ball;
    use crate::random::Random;

    /// Closed and oriented: every edge is walked once in each direction.
    #[test]
    fn every_edge_of_a_ball_has_two_sides() {
        let ball = ball(Vec3::ZERO, &mut Random::new(0, 0));
        let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
        for [a, b, c] in &ball.triangles {
            for edge in [[*a, *b], [*b, *c], [*c, *a]] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        for ([a, b], count) in &edges {
            let back = edges.get(&[*b, *a]).copied().unwrap_or(0);
            assert_eq!((*count, back), (1, 1), "edge {a}-{b} and back");
        }
        assert_eq!(
            edges.len(),
            3 * ball.triangles.len(),
            "edges of {} triangles",
            ball.triangles.len()
        );
    }
}
