//! Triangles without gaps between them.
//!
//! The test is that of Woop, Benthin and Wald \[Woop13]. The vertices are moved into a frame in
//! which the ray is the z axis; the ray then hits the triangle when the origin of the xy plane lies
//! on the same side of all three edges. What an edge says depends on its two end points alone, so
//! two triangles that share an edge can never both deny a ray that passes through it: a closed mesh
//! has no holes.
//!
//! Departures from the paper, each argued where it stands:
//! 1. whatever the single-precision edge functions do not reject is decided again in double
//!    precision, where their signs are exact, instead of only when one of them is zero;
//! 2. t too is computed in double precision, so that a sliver seen edge-on gives a sane distance;
//! 3. a hit so near that rounding could have moved it across the origin is decided by the exact
//!    plane.

use glam::{DVec3, Vec2, Vec3};

use crate::hit::Hit;
use crate::math::gamma;
use crate::ray::Ray;

/// A ray made ready for many triangles: with the frame in which it is the z axis.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    /// The ray itself.
    pub ray: Ray,
    /// The axes that take the place of x, y and z. z is the longest of the direction.
    pub axes: [usize; 3],
    /// **o**, its components in the order of `axes`.
    pub origin: [f32; 3],
    /// d_x/d_z and d_y/d_z, both in [−1, 1].
    pub shear: [f32; 2],
    /// 1/d_z, where d_z has the largest magnitude of the three.
    inverse_z: f64,
}

/// The two axes that follow each axis. A `static`, since the compiler writes a constant array to the
/// stack anew for every ray.
static FOLLOWING: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

impl ShearedRay {
    /// Chooses the frame for `ray`.
    ///
    /// A direction of zero or with a NaN gives a frame in which nothing is ever hit.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction.to_array();
        let size = d.map(f32::abs);
        let z =
            if size[2] >= larger(size[0], size[1]) { 2 } else { usize::from(size[1] >= size[0]) };
        let [x, y] = FOLLOWING[z];
        let o = ray.origin.to_array();
        Self {
            ray: *ray,
            axes: [x, y, z],
            origin: [o[x], o[y], o[z]],
            shear: [d[x] / d[z], d[y] / d[z]],
            inverse_z: 1.0 / f64::from(d[z]),
        }
    }

    /// From now on only hits at `t` or nearer count.
    #[inline]
    pub const fn shorten_to(&mut self, t: f32) {
        self.ray.extent.max = t;
    }

    /// From now on only hits nearer than `t` count.
    #[inline]
    pub const fn shorten_below(&mut self, t: f32) {
        self.shorten_to(t.next_down());
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
    decide(ray, [a, b, c], || *vertices, primitive)
}

/// The second half of [`intersect`], for the few triangles that single precision cannot reject.
/// `vertices` is asked for only where the sheared ones do not tell which side the ray starts on.
///
/// A product of two `f32` is exact in `f64`, and a difference of exact products has the right sign:
/// the decision is the exact one for the sheared vertices.
#[inline]
#[must_use]
pub fn decide(
    ray: &ShearedRay,
    sheared: [[f32; 3]; 3],
    vertices: impl FnOnce() -> [Vec3; 3],
    primitive: u32,
) -> Option<Hit> {
    // Without `map`, which the compiler may make a call.
    let double = |[x, y, z]: [f32; 3]| [f64::from(x), f64::from(y), f64::from(z)];
    let [a, b, c] = [double(sheared[0]), double(sheared[1]), double(sheared[2])];
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    // One branch that is hardly ever taken. Asked one after the other, the signs tell which side of
    // the triangle the ray sees, and that no processor foresees. The product is not rounded to zero:
    // all three are multiples of 2⁻²⁹⁸. With a NaN, whatever is decided here, there will be no t.
    let (least, most) = (smaller(u, smaller(v, w)), larger(u, larger(v, w)));
    if least * most < 0.0 {
        return None;
    }
    // Exchanging v and w, as reversing the winding does, changes no bit of these sums.
    let det = u + (v + w);
    let inverse = 1.0 / det;
    let z = (u * a[2] + (v * b[2] + w * c[2])) * inverse;
    let mut t = (z * ray.inverse_z) as f32;
    let in_reach = t <= ray.ray.extent.max && t < f32::INFINITY;
    if !in_reach {
        return None;
    }
    let forward = 1.0_f64.copysign(ray.inverse_z);
    if t <= ray.ray.extent.min {
        if lies_in_front(-forward, &sheared, z, det) || is_passed(ray, &sheared, t) {
            return None;
        }
        t = settle(&ray.ray, vertices(), t)?;
    } else if !lies_in_front(forward, &sheared, z, det) {
        t = settle(&ray.ray, vertices(), t)?;
    }
    let barycentric = Vec2::new((v * inverse) as f32, (w * inverse) as f32);
    ray.ray.admits(t).then_some(Hit { t, primitive, barycentric })
}
// ANCHOR_END: intersect

// ANCHOR: lies_in_front
/// Whether the hit, at depth `z`, lies in front of the origin whatever the roundings have done;
/// behind it, if `forward` is the sign of −d_z instead of d_z.
///
/// The plane through the vertices is z = z₀ + s_x x + s_y y. Moving vertex i by (δx, δy, δz) moves
/// it at the hit by its weight times δz − s_x δx − s_y δy, so z is off by at most
///
/// ```text
/// γ(1) S + γ(12) S (|s_x| + |s_y|),   |s_x| + |s_y| ≤ 16 S² / |U + V + W|
/// ```
///
/// where S is the largest |component| of a sheared vertex, of which those of v − o are at most the
/// double, and the slopes are quotients of products of edges. γ(16) leaves room for the slopes
/// being those of the rounded vertices. A small triangle far away has a poor bound for its slopes;
/// there it is enough that all vertices lie in front.
#[inline]
fn lies_in_front(forward: f64, sheared: &[[f32; 3]; 3], z: f64, det: f64) -> bool {
    let [a, b, c] = sheared.map(|p| forward as f32 * p[2]);
    let size = size(sheared);
    let all_are = smaller(a, smaller(b, c)) > gamma(16) * size;
    let (det, size) = (det.abs(), f64::from(size));
    let it_is = forward * z * det > f64::from(gamma(16)) * size * (det + 16.0 * size * size);
    // Both are computed, since no processor foresees whether the first one will do.
    all_are | it_is
}

/// Whether a ray that starts behind its origin, at `extent.min`, has left the hit at `t` behind. No
/// surface is left there, and the rounding of z alone, γ(1) of the size, has to be allowed for.
#[inline]
fn is_passed(ray: &ShearedRay, sheared: &[[f32; 3]; 3], t: f32) -> bool {
    let min = ray.ray.extent.min;
    min != 0.0 && f64::from(min - t) > f64::from(gamma(2) * size(sheared)) * ray.inverse_z.abs()
}

/// The largest |component|.
#[inline]
fn size(sheared: &[[f32; 3]; 3]) -> f32 {
    let [a, b, c] = sheared.map(|p| larger(p[0].abs(), larger(p[1].abs(), p[2].abs())));
    larger(a, larger(b, c))
}

/// The larger of two numbers that are not NaN: one instruction, where `f32::max` takes some more to
/// make sure that a NaN loses.
#[inline]
fn larger<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The smaller of two such numbers.
#[inline]
fn smaller<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// The t of a hit that may lie on either side of the origin, as far as `t` can say: the exact plane
/// of the triangle decides.
///
/// ```text
/// N = (v₁ − v₀) × (v₂ − v₀),   N·(v₀ − o) / N·d
/// ```
///
/// Differences of `f32` are (nearly) exact in `f64`, so both signs are right as long as they
/// matter: the origin of a spawned ray is away from its triangle by much more than the roundings
/// here. Two cases remain:
///
/// - Which side a ray is spawned on was decided by a rounded N·d, γ(5) off, and a ray toward a
///   point has its direction rounded again, by γ(2). If N·d is zero up to that, γ(8) in all, a ray
///   that starts at the surface may start on the one side and lead to the other. It runs along the
///   surface, and does not meet it.
/// - A hit that rounding has put behind the near end of the extent is put back: as near as a hit
///   can be. Otherwise a ray that starts in the corner of a room, next to one wall, would leave
///   through it. But it has to be where the exact plane is met, too: the origin then lies between
///   two points of the triangle, and no volume around the triangle can lose it.
#[inline(never)] // seldom called: it would only be in the way of the loop over triangles
fn settle(ray: &Ray, vertices: [Vec3; 3], t: f32) -> Option<f32> {
    let Ray { origin, direction, extent, .. } = *ray;
    let [v0, v1, v2] = opposite_the_longest_edge(vertices.map(|v| v.as_dvec3()));
    let (o, d) = (origin.as_dvec3(), direction.as_dvec3());
    let (e1, e2) = (v1 - v0, v2 - v0);
    let n = e1.cross(e2);
    let (distance, speed) = (n.dot(v0 - o), n.dot(d));
    let exact = distance / speed;
    // False, too, for the NaN of a triangle without area.
    let is_ahead = exact > f64::from(extent.min);
    if !is_ahead {
        return None;
    }
    let size = n.abs();
    let at_surface = distance.abs()
        <= size.dot(f64::from(gamma(8)) * o.abs() + DOUBLE * (v0.abs() + e1.abs() + e2.abs()));
    let runs_along = speed.abs() <= f64::from(gamma(8)) * size.dot(d.abs());
    if at_surface && runs_along {
        return None;
    }
    if t > extent.min {
        return Some(t);
    }
    let way = o - v0 + exact * d;
    is_beside_none([DVec3::ZERO, e1, e2].map(|v| way - v), [e1, e2 - e1, -e2], o - v0)
        .then(|| extent.min.next_up())
}

/// Whether a point of the plane is outside of no edge, by more than what vertices may be moved by.
/// `ways` lead to it from the vertices, and `from` leads from a vertex to the origin of the ray.
fn is_beside_none(ways: [DVec3; 3], edges: [DVec3; 3], from: DVec3) -> bool {
    let reach = edges.iter().fold(from.abs(), |reach, edge| reach.max(from.abs() + edge.abs()));
    let moved = f64::from(gamma(6)) * reach.max_element();
    let n = edges[0].cross(edges[1]).normalize();
    ways.iter().zip(edges).all(|(way, edge)| n.dot(edge.cross(*way)) >= -moved * edge.length())
}

/// The corners in the same order, but with that first which the two shorter edges meet in.
///
/// Two long edges of a needle are so nearly parallel that even in double precision their product
/// can lose the normal: one of length 5·10⁷ and width 0.07 was off by more than a float is wide.
fn opposite_the_longest_edge([a, b, c]: [DVec3; 3]) -> [DVec3; 3] {
    let [ab, bc, ca] = [b - a, c - b, a - c].map(DVec3::length_squared);
    if bc >= ab.max(ca) {
        [a, b, c]
    } else if ca >= ab {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// 64 roundings of double precision.
const DOUBLE: f64 = 64.0 * f64::EPSILON;
// ANCHOR_END: lies_in_front
