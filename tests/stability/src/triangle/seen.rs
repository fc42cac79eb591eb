//! Vertices as a ray sees them.

use std::cmp::Ordering;

use glam::{DVec3, Vec3, dvec3};
use ray_casting::{Ray, ShearedRay};

use crate::bits::gamma;

/// A vertex as a ray sees it, in double precision.
#[derive(Clone, Copy)]
pub(super) struct Seen {
    /// The sheared vertex.
    at: DVec3,
    /// By how much single precision may have moved its x and its y: γ(6) max |v − o|.
    error: f64,
}

impl Seen {
    pub(super) fn new(ray: &Ray, vertex: Vec3) -> Self {
        let frame = ShearedRay::new(ray);
        let d = ray.direction.as_dvec3();
        let v = vertex.as_dvec3() - ray.origin.as_dvec3();
        let [x, y, z] = frame.axes;
        let at = dvec3(v[x] - d[x] / d[z] * v[z], v[y] - d[y] / d[z] * v[z], v[z]);
        Self { at, error: gamma(6) * v.abs().max_element() }
    }

    /// On which side of the edge from `self` to `to` the ray passes; `Equal` if the roundings of
    /// the vertices decide that. Those of double precision are 2⁻²⁶ as large and do not count.
    pub(super) fn side(&self, to: &Self) -> Ordering {
        let (a, b) = (self.at, to.at);
        let cross = a.x * b.y - a.y * b.x;
        let [size_a, size_b] = [a, b].map(|p| p.x.abs() + p.y.abs());
        let zone = self.error * size_b + to.error * size_a + 2.0 * self.error * to.error;
        if cross.abs() <= 1.001 * zone { Ordering::Equal } else { cross.total_cmp(&0.0) }
    }
}
