//! A coordinate system around a normal.

use glam::Vec3;

/// Three unit vectors at right angles: samplers work around +z and are turned by this.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Image of the x axis.
    pub tangent: Vec3,
    /// Image of the y axis.
    pub bitangent: Vec3,
    /// Image of the z axis.
    pub normal: Vec3,
}

impl Frame {
    // ANCHOR: around
    /// A frame whose z axis is `normal` (unit length).
    ///
    /// ```text
    /// s = ±1 with the sign of n_z,   a = −1 / (s + n_z),   b = n_x n_y a
    /// t = (1 + s n_x² a, s b, −s n_x),   u = (b, s + n_y² a, −n_y)
    /// ```
    ///
    /// The sign keeps s + n_z away from 0, so no direction is singular: the version without it loses
    /// all digits as **n** nears −z. Departs from nothing in \[Duff17].
    #[inline]
    #[must_use]
    pub fn around(normal: Vec3) -> Self {
        let n = normal;
        let sign = 1.0_f32.copysign(n.z);
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        Self {
            tangent: Vec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            bitangent: Vec3::new(b, sign + n.y * n.y * a, -n.y),
            normal,
        }
    }
    // ANCHOR_END: around

    /// Turns a direction given around +z into one around the normal.
    #[inline]
    #[must_use]
    pub fn to_world(&self, local: Vec3) -> Vec3 {
        local.x * self.tangent + local.y * self.bitangent + local.z * self.normal
    }
}

#[cfg(test)]
mod tests {
    use super::Frame;
    use crate::directions::uniform_sphere;
    use glam::Vec3;
    use workbench::Sampler;

    /// accuracy.md M7: the axes, zeros of both signs, Duff's two vectors, and a million at random.
    #[test]
    fn every_normal_gets_three_unit_vectors_at_right_angles() {
        let mut sampler = Sampler::new(0, 0, 0);
        let awkward = [
            Vec3::X,
            Vec3::NEG_X,
            Vec3::Y,
            Vec3::NEG_Y,
            Vec3::Z,
            Vec3::NEG_Z,
            Vec3::new(-0.0, -0.0, 1.0),
            Vec3::new(0.0, -0.0, -1.0),
            Vec3::new(1.0, 0.0, -0.0),
            Vec3::new(0.000_380_096_67, 0.000_188_508_62, -0.999_999_9),
            Vec3::new(-0.000_195_399_06, -0.000_097_741_83, -0.999_999_94),
        ];
        let random = (0..1_000_000).map(|_| uniform_sphere(sampler.next_2d()));
        for normal in awkward.into_iter().chain(random) {
            let Frame { tangent, bitangent, .. } = Frame::around(normal);
            let (t, b, n) = (tangent.as_dvec3(), bitangent.as_dvec3(), normal.as_dvec3());
            let errors = [
                t.length() - 1.0,
                b.length() - 1.0,
                t.dot(b),
                t.dot(n),
                b.dot(n),
                t.cross(b).dot(n) - 1.0,
            ];
            let worst = errors.into_iter().fold(0.0, |worst: f64, e| worst.max(e.abs()));
            assert!(worst <= 5e-7, "{normal}: off by {worst:e}");
        }
    }
}
