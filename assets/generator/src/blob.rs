//! The blob: a ball with two sets of bumps, for measurements at any number of triangles.

use crate::{Mesh, Surface, globe};
use libm::{cos, sin};

/// A closed, bumpy ball of radius about 1 around the origin, with outward triangles.
///
/// ```text
/// r(θ, φ) = 1 + 0.08 sin 9θ sin 8φ + 0.03 sin(31θ + 2) sin 29φ
/// ```
///
/// The bumps make neighbouring triangles differ in direction, as in a scanned object; a plain
/// sphere would flatter every bounding volume alike. n = 320 is the mesh of the reference images.
#[derive(Clone, Copy, Debug)]
pub struct Blob {
    /// Sectors around the y axis, and one more than the rings between the poles; at least 3.
    pub n: u32,
}

/// The mesh of [`Blob`], with 2n(n − 1) triangles.
///
/// # Panics
/// If `n` is less than 3, which encloses nothing.
#[must_use]
pub fn blob(n: u32) -> Mesh {
    assert!(n >= 3, "a blob needs at least 3 sectors, not {n}");
    Blob { n }.mesh()
}

impl Surface for Blob {
    fn positions(&self) -> impl Iterator<Item = [f64; 3]> {
        let n = self.n;
        let sectors: Vec<Sector> = (0..n).map(|j| Sector::new(globe::phi(n, j))).collect();
        let rings = (1..n).flat_map(move |i| {
            let theta = globe::theta(n, i);
            let (coarse, fine) = (0.08 * sin(9.0 * theta), 0.03 * sin(31.0 * theta + 2.0));
            let (sin_theta, cos_theta) = (sin(theta), cos(theta));
            sectors.clone().into_iter().map(move |sector| {
                let r = 1.0 + coarse * sector.sin_8_phi + fine * sector.sin_29_phi;
                let across = r * sin_theta;
                [across * sector.cos_phi, r * cos_theta, across * sector.sin_phi]
            })
        });
        [[0.0, 1.0, 0.0]].into_iter().chain(rings).chain([[0.0, -1.0, 0.0]])
    }

    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        globe::triangles(self.n)
    }
}

/// What a ring needs to know of an azimuth φ.
#[derive(Clone, Copy)]
struct Sector {
    sin_phi: f64,
    cos_phi: f64,
    sin_8_phi: f64,
    sin_29_phi: f64,
}

impl Sector {
    fn new(phi: f64) -> Self {
        Self {
            sin_phi: sin(phi),
            cos_phi: cos(phi),
            sin_8_phi: sin(8.0 * phi),
            sin_29_phi: sin(29.0 * phi),
        }
    }
}
