//! The plane of a triangle, and on which side of it something lies.

use glam::{DVec3, Vec3};

/// 64 roundings of double precision.
const DOUBLE: f64 = 64.0 * f64::EPSILON;

/// The plane through three points.
///
/// Whoever asks on which side of it something lies wants to leave out what lies on none. Nothing may
/// be left out wrongly: a point belongs to the plane only if it is seen from the first corner within
/// 64 ε of it, in double precision. That is as near to it as rounding puts points of the plane
/// itself; of a needle, whose normal is lost in rounding, even its own corners may lie beside it.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// a, one of the points.
    point: DVec3,
    /// **n**, of any length.
    normal: DVec3,
}

impl Plane {
    /// The plane of the triangle with these corners.
    #[must_use]
    pub fn through(corners: [Vec3; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        Self { point: a, normal: (b - a).cross(c - a) }
    }

    /// Whether some of the ball around `center` lies in front of the plane, and whether some of it
    /// lies behind. A point is a ball of radius 0.
    ///
    /// ```text
    /// n·(c − a) ± |n| r,   compared with ± 64 ε |n| (|c − a| + r)
    /// ```
    #[must_use]
    pub fn sides_of(&self, center: Vec3, radius: f32) -> [bool; 2] {
        let (way, r) = (center.as_dvec3() - self.point, f64::from(radius));
        let (height, n) = (self.normal.dot(way), self.normal.length());
        let beside = DOUBLE * n * (way.length() + r);
        [height + n * r > beside, height - n * r < -beside]
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};
    use workbench::Sampler;

    use super::Plane;

    /// A point in a cube around the origin.
    fn point(sampler: &mut Sampler) -> Vec3 {
        let [x, y] = sampler.next_2d();
        2.0 * Vec3::new(x, y, sampler.next_1d()) - 1.0
    }

    #[test]
    fn a_float_beside_a_plane_is_beside_it() {
        for scale in [1e-20, 1.0, 1e15] {
            let corners = [Vec3::ONE, Vec3::new(3.0, 1.0, 2.0), Vec3::new(2.0, 1.0, 5.0)];
            let plane = Plane::through(corners.map(|corner| scale * corner));
            let at = |y: f32| plane.sides_of(scale * Vec3::new(4.0, 0.0, 4.0) + y * Vec3::Y, 0.0);
            let (wall, front) = (scale, [false, true]);
            assert_eq!(at(wall), [false; 2], "in the plane, {scale:e}");
            assert_eq!(at(wall.next_up()), front, "one float above, {scale:e}");
            assert_eq!(at(wall.next_down()), [true, false], "one float below, {scale:e}");
        }
    }

    /// The fourth corner of a slanted rectangle, where it is a float, is not a float beside it.
    #[test]
    fn the_fourth_corner_of_an_upright_wall_is_in_its_plane() {
        for i in 0..10_000 {
            let mut sampler = Sampler::new(31, i, 0);
            let (a, b) = (point(&mut sampler), point(&mut sampler));
            let (b, up) = (Vec3::new(b.x, a.y, b.z), Vec3::new(0.0, sampler.next_1d() + 1.0, 0.0));
            let plane = Plane::through([a, b, b + up]);
            assert_eq!(plane.sides_of(a + up, 0.0), [false; 2], "{a}, {b}, {up}");
        }
    }

    /// The corners of a needle may count as being beside it. What lies clearly beside it must.
    #[test]
    fn what_lies_beside_a_needle_is_never_taken_for_a_part_of_it() {
        let mut tested = 0;
        for i in 0..10_000 {
            let mut sampler = Sampler::new(32, i, 0);
            let (a, b) = (point(&mut sampler), point(&mut sampler));
            let c = a.lerp(b, 0.5) + 1e-7 * point(&mut sampler);
            let plane = Plane::through([a, b, c]);
            let [v0, v1, v2] = [a, b, c].map(|v| v.as_dvec3());
            let aside = (v1 - v0).cross(v2 - v0).normalize_or_zero();
            let beside = (v2 + 1e-6 * aside).as_vec3();
            let height = aside.dot(beside.as_dvec3() - v0);
            if aside == DVec3::ZERO {
                continue; // no plane at all
            }
            tested += 1;
            let sides = plane.sides_of(beside, 0.0);
            assert_eq!(sides, [true, false], "{a}, {b}, {c}: {height} in front");
        }
        assert!(tested > 9000, "only {tested} needles");
    }

    #[test]
    fn a_ball_that_touches_the_plane_lies_on_one_side_of_it() {
        let plane = Plane::through([Vec3::ZERO, Vec3::Z, Vec3::X]);
        for (height, radius, sides) in [
            (1.0, 1.0, [true, false]),
            (1.0, 1.000_001, [true, true]),
            (-3.0, 2.0, [false, true]),
            (0.0, 0.5, [true, true]),
        ] {
            let got = plane.sides_of(Vec3::new(5.0, height, 7.0), radius);
            assert_eq!(got, sides, "height {height}, radius {radius}");
        }
    }
}
