//! Triangles without gaps between them.
//!
//! The test is that of Woop, Benthin and Wald [Woop13]. The vertices are moved into a frame in
//! which the ray is the z axis; the ray then hits the triangle when the origin of the xy plane lies
//! on the same side of all three edges. What an edge says depends on its two end points alone, so
//! two triangles that share an edge can never both deny a ray that passes through it: a closed mesh
//! has no holes.
//!
//! Departures from the paper, each argued where it stands:
//! 1. whatever the single-precision edge functions do not reject is decided again in double
//!    precision, where their signs are exact, instead of only when one of them is zero;
//! 2. t too is computed in double precision, so that a sliver seen edge-on gives a sane distance;
//! 3. a hit that could as well lie behind the origin, given the roundings, does not count.

use glam::{Vec2, Vec3};

use crate::hit::Hit;
use crate::interval::Interval;
use crate::math::gamma;
use crate::ray::Ray;

/// A ray made ready for many triangles: the frame in which it is the z axis.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    /// The axes that take the place of x, y and z. z is the longest of the direction.
    axes: [usize; 3],
    /// **o**, its components in the order of `axes`.
    origin: [f32; 3],
    /// d_x/d_z and d_y/d_z, both in [−1, 1].
    shear: [f32; 2],
    /// d_z, which has the largest magnitude of the three.
    direction_z: f32,
    /// As in [`Ray`].
    pub extent: Interval,
}

impl ShearedRay {
    /// Chooses the frame for `ray`.
    ///
    /// A direction of zero or with a NaN gives a frame in which nothing is ever hit.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction.to_array();
        let size = d.map(f32::abs);
        let z = if size[0] > size[1] {
            if size[0] > size[2] { 0 } else { 2 }
        } else if size[1] > size[2] {
            1
        } else {
            2
        };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let o = ray.origin.to_array();
        Self {
            axes: [x, y, z],
            origin: [o[x], o[y], o[z]],
            shear: [d[x] / d[z], d[y] / d[z]],
            direction_z: d[z],
            extent: ray.extent,
        }
    }

    // ANCHOR: shear
    /// `vertex` relative to the origin, sheared so that the ray runs along z.
    ///
    /// ```text
    /// A = v − o,   x = A_x − (d_x/d_z) A_z,   y = A_y − (d_y/d_z) A_z,   z = A_z
    /// ```
    ///
    /// z is off by at most u |A_z|, x and y by γ(6) max(|A_x|, |A_y|, |A_z|): two roundings on the
    /// first term and five on the second, whose factor d_x/d_z is at most 1, one of them shared.
    #[inline]
    fn shear(&self, vertex: &Vec3) -> [f32; 3] {
        let v: &[f32; 3] = vertex.as_ref();
        let [x, y, z] = self.axes;
        let a_z = v[z] - self.origin[2];
        let a_x = v[x] - self.origin[0] - self.shear[0] * a_z;
        let a_y = v[y] - self.origin[1] - self.shear[1] * a_z;
        [a_x, a_y, a_z]
    }
    // ANCHOR_END: shear
}

// ANCHOR: intersect
/// The hit of `ray` on the triangle with these vertices, if `ray.extent` admits it.
///
/// With the sheared vertices a, b, c, twice the signed areas that the ray cuts off are
///
/// ```text
/// U = c_x b_y − c_y b_x,   V = a_x c_y − a_y c_x,   W = b_x a_y − b_y a_x
/// t = (U a_z + V b_z + W c_z) / ((U + V + W) d_z)
/// ```
///
/// A point of an edge (one of them zero) belongs to the triangle; front and back count alike.
/// Swapping two vertices negates all three exactly, so the answer does not depend on the winding.
///
/// `primitive` is only handed on to the hit.
#[inline]
#[must_use]
pub fn intersect(ray: &ShearedRay, vertices: &[Vec3; 3], primitive: u32) -> Option<Hit> {
    let a = ray.shear(&vertices[0]);
    let b = ray.shear(&vertices[1]);
    let c = ray.shear(&vertices[2]);

    // Rounding is monotone, so p ≥ q makes fl(p) ≥ fl(q): a difference of two rounded products has
    // the right sign unless it is zero (or NaN, after an overflow), and neither zero nor NaN
    // rejects.
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    decide(ray, [a, b, c], primitive)
}

/// The second half of [`intersect`], for the few triangles that single precision cannot reject.
///
/// A product of two `f32` is exact in `f64`, and a difference of exact products has the right sign:
/// the decision is the exact one for the sheared vertices.
fn decide(ray: &ShearedRay, sheared: [[f32; 3]; 3], primitive: u32) -> Option<Hit> {
    let [a, b, c] = sheared.map(|p| p.map(f64::from));
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let det = u + v + w;
    let z = (u * a[2] + v * b[2] + w * c[2]) / det;
    let t = (z / f64::from(ray.direction_z)) as f32;
    let admitted = ray.extent.min < t && t <= ray.extent.max && t < f32::INFINITY;
    if !admitted || !lies_in_front([a, b, c], [u, v, w], f64::from(ray.direction_z).signum()) {
        return None;
    }
    Some(Hit { t, primitive, barycentric: Vec2::new((v / det) as f32, (w / det) as f32) })
}
// ANCHOR_END: intersect

// ANCHOR: lies_in_front
/// Whether the hit lies beyond the origin whatever the roundings did.
///
/// If all vertices lie in front by more than the roundings can have moved them, so does every point
/// between them. Else the triangle straddles the origin, and what matters is by how much z at
/// x = y = 0 can be wrong. The plane through the vertices is z = z₀ + s_x x + s_y y, and moving
/// vertex i by (δx, δy, δz) moves the plane at the hit by its weight times δz − s_x δx − s_y δy:
///
/// ```text
/// |δz| ≤ Σ bᵢ (γ(1) |zᵢ| + γ(6) Mᵢ (|s_x| + |s_y|)),   Mᵢ = the largest |component| of v − o
/// ```
///
/// M is read off the sheared vertices, whose largest component is at least half of it: γ(16) covers
/// twice γ(6) with room for the double-precision roundings. The slopes, too, are those of the
/// rounded vertices: γ(16) is added to them.
/// It is what keeps a ray that starts on a huge triangle from hitting it again at a grazing angle.
fn lies_in_front(sheared: [[f64; 3]; 3], weights: [f64; 3], forward: f64) -> bool {
    let rounding = f64::from(gamma(16));
    let size = sheared.map(|p| p[0].abs().max(p[1].abs()).max(p[2].abs()));
    let depth = sheared.map(|p| forward * p[2]);

    let nearest = depth[0].min(depth[1]).min(depth[2]);
    if nearest > rounding * size[0].max(size[1]).max(size[2]) {
        return true;
    }
    let [a, b, c] = sheared;
    let (e, f): ([f64; 3], [f64; 3]) =
        ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let slope = (normal[0].abs() + normal[1].abs()) / normal[2].abs();

    let det = weights[0] + weights[1] + weights[2];
    let mean = |x: [f64; 3]| (weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2]) / det;
    mean(depth) > rounding * (mean(depth.map(f64::abs)) + mean(size) * (slope + rounding))
}
// ANCHOR_END: lies_in_front
