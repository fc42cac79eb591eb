//! Up to four triangles of a leaf, side by side.

use glam::Vec3;
use ray_casting::Ray;
use ray_casting::triangle::ShearedRay;

use crate::four::{Four, larger_of, mask, mul, smaller_of, sub};
use crate::plane::Plane;

/// The triangles of a leaf. The last places may be unused.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct FourTriangles {
    /// For each corner and each axis the coordinates of all four, in scene units.
    corners: [[Four; 3]; 3],
    /// Which primitives they are; in unused places, the first of them.
    pub(crate) names: [u32; 4],
}

impl FourTriangles {
    /// No triangle yet.
    pub(crate) const NONE: Self = Self { corners: [[[0.0; 4]; 3]; 3], names: [0; 4] };

    /// Puts a triangle into place `i`.
    pub(crate) fn set(&mut self, i: usize, corners: &[Vec3; 3], name: u32) {
        for (into, from) in self.corners.iter_mut().zip(corners) {
            for (into, from) in into.iter_mut().zip(from.to_array()) {
                into[i] = from;
            }
        }
        self.names[i] = name;
    }

    /// Whether the first `n` lie in one plane.
    pub(crate) fn are_flat(&self, n: usize) -> bool {
        let plane = Plane::through(self.corners(0));
        let mut corners = (0..n).flat_map(|i| self.corners(i));
        corners.all(|corner| plane.sides_of(corner, 0.0) == [false; 2])
    }

    /// Whether the ray starts or ends on one of them.
    #[inline(always)]
    pub(crate) fn are_ends_of(&self, ray: &Ray) -> bool {
        let is_end = |i: usize| ray.starts_or_ends_on(self.names[i]);
        mask([is_end(0), is_end(1), is_end(2), is_end(3)]) != 0
    }

    /// The corners of the triangle in place `i`.
    #[inline(always)]
    pub(crate) fn corners(&self, i: usize) -> [Vec3; 3] {
        self.corners.map(|[x, y, z]| Vec3::new(x[i], y[i], z[i]))
    }

    // ANCHOR: sheared
    /// The first half of [`triangle::intersect`](ray_casting::triangle::intersect) for all four, with
    /// the same roundings and the same verdicts.
    #[inline(always)]
    pub(crate) fn sheared(&self, ray: &ShearedRay) -> ShearedFour {
        let [a, b, c] = &self.corners;
        let (a, b, c) = (shear(a, ray), shear(b, ray), shear(c, ray));
        let u = sub(mul(c[0], b[1]), mul(c[1], b[0]));
        let v = sub(mul(a[0], c[1]), mul(a[1], c[0]));
        let w = sub(mul(b[0], a[1]), mul(b[1], a[0]));
        let least = smaller_of(w, smaller_of(v, smaller_of(u, [0.0; 4])));
        let most = larger_of(w, larger_of(v, larger_of(u, [0.0; 4])));
        // A mask at once: of numbers that are kept for later, the compiler makes single ones.
        let possible = |i: usize| least[i] >= 0.0 || most[i] <= 0.0;
        let possible = mask([possible(0), possible(1), possible(2), possible(3)]);
        ShearedFour { corners: [a, b, c], possible }
    }
    // ANCHOR_END: sheared
}

/// The corners of four triangles in the frame in which the ray is the z axis.
///
/// ```text
/// x = A_x − (d_x/d_z) A_z,   y = A_y − (d_y/d_z) A_z,   z = A_z,   A = v − o
/// ```
#[inline(always)]
fn shear(corner: &[Four; 3], ray: &ShearedRay) -> [Four; 3] {
    let [x, y, z] = ray.axes;
    let [o_x, o_y, o_z] = ray.origin;
    let [s_x, s_y] = ray.shear;
    let a_z = sub(corner[z], [o_z; 4]);
    let a_x = sub(sub(corner[x], [o_x; 4]), mul([s_x; 4], a_z));
    let a_y = sub(sub(corner[y], [o_y; 4]), mul([s_y; 4], a_z));
    [a_x, a_y, a_z]
}

/// Four triangles as a ray sees them.
pub(crate) struct ShearedFour {
    corners: [[Four; 3]; 3],
    /// Bit i is set unless one edge of triangle i says "left" and another one "right". An edge that
    /// says nothing, after an overflow, rules nothing out.
    possible: u32,
}

impl ShearedFour {
    /// Bit i is set for each of the first `n` triangles that single precision does not rule out.
    #[inline(always)]
    pub(crate) fn possible(&self, n: u32) -> u32 {
        self.possible & ((1 << n) - 1)
    }

    /// The sheared corners of triangle `i`. Written out, since the compiler may make calls of a `map`
    /// within a `map`, and there are some for every ray.
    #[inline(always)]
    pub(crate) fn corners(&self, i: usize) -> [[f32; 3]; 3] {
        let corner = |[x, y, z]: &[Four; 3]| [x[i], y[i], z[i]];
        let [a, b, c] = &self.corners;
        [corner(a), corner(b), corner(c)]
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use ray_casting::triangle::{self, ShearedRay};
    use ray_casting::{Hit, Ray};
    use workbench::Sampler;

    use super::FourTriangles;

    /// What the leaf's test says of its triangle `i`.
    fn together(four: &FourTriangles, ray: &ShearedRay, i: usize) -> Option<Hit> {
        let sheared = four.sheared(ray);
        let is_possible = sheared.possible(4) & (1 << i) != 0;
        let decide = || triangle::decide(ray, sheared.corners(i), || four.corners(i), i as u32);
        is_possible.then(decide).flatten()
    }

    /// Also where products overflow or vanish, and for rays through corners and along edges.
    #[test]
    fn four_triangles_together_are_four_triangles() {
        let mut hits = 0;
        for i in 0..200_000 {
            let mut sampler = Sampler::new(21, i, 0);
            let scale = [1.0, 1e-30, 1e20, 3e38][(i % 16 / 4).min(3) as usize];
            let mut point = || {
                let [x, y] = sampler.next_2d();
                scale * (2.0 * Vec3::new(x, y, sampler.next_1d()) - 1.0)
            };
            let mut four = FourTriangles::NONE;
            let corners = [(); 4].map(|()| [point(), point(), point()]);
            for (k, corners) in corners.iter().enumerate() {
                four.set(k, corners, k as u32);
            }
            let (origin, inside) = (point(), point());
            let target = match i % 4 {
                0 => inside,
                1 => corners[0][0],
                2 => 0.5 * (corners[1][0] + corners[1][1]),
                _ => (corners[2][0] + corners[2][1] + corners[2][2]) / 3.0,
            };
            let direction = target / scale - origin / scale;
            let ray = ShearedRay::new(&Ray::new(origin, direction));
            for (k, corners) in corners.iter().enumerate() {
                let alone = triangle::intersect(&ray, corners, k as u32);
                assert_eq!(together(&four, &ray, k), alone, "triangle {k}: {corners:?}, {ray:?}");
                hits += u32::from(alone.is_some());
            }
        }
        assert!(hits > 100_000, "only {hits} hits");
    }
}
