//! Places inside of closed meshes, and rays from there.

use glam::{DVec3, Vec3, dvec3};
use ray_casting::{Geometry, Ray};

use crate::random::Random;
use crate::scenes::toward;

/// Near the origin, and at two places where coordinates are coarse: in the second, floats are 1/64
/// apart.
pub const PLACES: [Vec3; 3] =
    [Vec3::ZERO, Vec3::new(1000.0, -2000.0, 500.0), Vec3::new(148_376.0, 1234.0, -223_423.0)];

/// The twelve triangles of a box; bit i of a corner's index says on which side of axis i it lies.
#[must_use]
pub fn brick(corner: impl Fn(DVec3) -> Vec3) -> Geometry {
    let side = |i: u32, bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Geometry {
        vertices: (0..8).map(|i| corner(dvec3(side(i, 0), side(i, 1), side(i, 2)))).collect(),
        triangles: triangles.collect(),
        spheres: Vec::new(),
    }
}

/// A point near `center` that sees all of a [`ball`](crate::meshes::ball) from inside, so that every
/// ray has but one triangle to hit; `None` if no such point is found.
///
/// It does if it lies behind all planes, by more than double precision can be wrong.
#[must_use]
pub fn heart(ball: &Geometry, center: Vec3, random: &mut Random) -> Option<Vec3> {
    let sees_all = |p: Vec3| {
        (0..ball.triangles.len() as u32).all(|i| {
            let [a, b, c] = ball.corners(i).map(|v| v.as_dvec3() - p.as_dvec3());
            a.dot(b.cross(c)) > 1e-9
        })
    };
    let way = 0.5 * random.direction();
    let mut candidates = (0..8).map(|i| center + (way / f64::from(1 << i)).as_vec3());
    candidates.find(|&p| sees_all(p))
}

/// Where a ray is aimed.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    /// Anywhere.
    Random,
    /// At a corner of a triangle.
    Vertex,
    /// At a point of an edge.
    Edge,
}

/// All aims.
pub const AIMS: [Aim; 3] = [Aim::Random, Aim::Vertex, Aim::Edge];

/// A ray from `origin` to some point of the mesh; half of those with a target are left as long as
/// the way is.
#[must_use]
pub fn aimed(mesh: &Geometry, origin: Vec3, aim: Aim, random: &mut Random) -> Ray {
    let [from, to, _] = mesh.corners(random.below(mesh.triangles.len() as u64) as u32);
    let target = match aim {
        Aim::Random => origin + random.direction().as_vec3(),
        Aim::Vertex => from,
        Aim::Edge => from.as_dvec3().lerp(to.as_dvec3(), random.unit()).as_vec3(),
    };
    let whole = Ray::new(origin, target - origin);
    if random.below(2) == 0 { whole } else { toward(origin, target).unwrap_or(whole) }
}
