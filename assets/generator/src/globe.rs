//! The triangles of a globe: two poles, and rings of vertices between them.

use crate::{Sphere, Surface};
use libm::{cos, sin};
use std::f64::consts::PI;

/// The triangles of a globe of `n` sectors and `n − 1` rings, 2n(n − 1) of them, facing outwards.
///
/// Vertex 0 is the north pole, then come the rings from north to south with `n` vertices each,
/// and the south pole is the last.
pub(crate) fn triangles(n: u32) -> impl Iterator<Item = [u32; 3]> {
    let south = n * (n - 1) + 1;
    let id = move |i: u32, j: u32| 1 + n * (i - 1) + j % n;
    let north_cap = (0..n).map(move |j| [0, id(1, j + 1), id(1, j)]);
    let bands = (1..n - 1).flat_map(move |i| {
        (0..n).flat_map(move |j| {
            let (a, b, c, d) = (id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j));
            [[a, b, c], [a, c, d]]
        })
    });
    let south_cap = (0..n).map(move |j| [south, id(n - 1, j), id(n - 1, j + 1)]);
    north_cap.chain(bands).chain(south_cap)
}

/// Polar angle of ring `i`, in radians from the north pole.
pub(crate) fn theta(n: u32, i: u32) -> f64 {
    PI * f64::from(i) / f64::from(n)
}

/// Azimuth of sector `j`, in radians from +x towards +z.
pub(crate) fn phi(n: u32, j: u32) -> f64 {
    2.0 * PI * f64::from(j) / f64::from(n)
}

/// The `n` for which a globe's 2n(n − 1) triangles come nearest to `triangles`; at least 3.
#[must_use]
pub fn rings_for(triangles: u64) -> u32 {
    let n = (1.0 + (1.0 + 2.0 * triangles as f64).sqrt()) / 2.0; // 2n(n − 1) = triangles
    (n.round() as u32).max(3)
}

/// Spheres made of triangles, every one a globe of `rings` sectors and `rings − 1` rings.
///
/// The vertices lie on the spheres, so the globes are a little smaller than what they stand for.
#[derive(Clone, Debug)]
pub struct TessellatedSpheres {
    /// The spheres.
    pub spheres: Vec<Sphere>,
    /// Sectors of each globe, at least 3.
    pub rings: u32,
}

impl Surface for TessellatedSpheres {
    fn positions(&self) -> impl Iterator<Item = [f64; 3]> {
        let directions: Vec<_> = directions(self.rings).collect();
        self.spheres.iter().flat_map(move |sphere| {
            let center = sphere.center.map(f64::from);
            let radius = f64::from(sphere.radius);
            let place = move |d: [f64; 3]| [0, 1, 2].map(|k| center[k] + radius * d[k]);
            directions.clone().into_iter().map(place)
        })
    }

    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        let vertices = self.rings * (self.rings - 1) + 2;
        (0..self.spheres.len() as u32).flat_map(move |sphere| {
            triangles(self.rings).map(move |triangle| triangle.map(|i| sphere * vertices + i))
        })
    }
}

/// The unit vectors to the vertices of a globe whose poles are ±y.
fn directions(n: u32) -> impl Iterator<Item = [f64; 3]> {
    let rings = (1..n).flat_map(move |i| {
        let (sin_theta, cos_theta) = (sin(theta(n, i)), cos(theta(n, i)));
        (0..n).map(move |j| [sin_theta * cos(phi(n, j)), cos_theta, sin_theta * sin(phi(n, j))])
    });
    [[0.0, 1.0, 0.0]].into_iter().chain(rings).chain([[0.0, -1.0, 0.0]])
}
