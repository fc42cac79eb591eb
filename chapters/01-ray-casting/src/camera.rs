//! The pinhole camera.

use glam::{DVec3, Vec3};
use workbench::{CameraRecord, FilmPoint};

use crate::math;
use crate::ray::Ray;

/// A pinhole at `eye` that looks along `forward`.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// The pinhole, in scene units.
    pub eye: Vec3,
    /// Unit vector to the middle of the picture.
    pub forward: Vec3,
    /// Unit vector along the picture's rows.
    pub right: Vec3,
    /// Unit vector along the picture's columns, upwards.
    pub up: Vec3,
    /// Half the picture's height at distance 1: tan(fov / 2).
    pub half_height: f32,
}

impl Camera {
    // ANCHOR: ray
    /// The ray through `point` of the film.
    ///
    /// ```text
    /// d ∝ forward + s_x right + s_y up
    /// s_x = (2x − width) / height · tan(fov/2),   s_y = (height − 2y) / height · tan(fov/2)
    /// ```
    ///
    /// Both are divided by the height: pixels are square.
    #[inline]
    #[must_use]
    pub fn ray(&self, point: FilmPoint) -> Ray {
        let [width, height] = point.size.map(|n| n as f32);
        let s_x = (2.0 * point.x - width) / height * self.half_height;
        let s_y = (height - 2.0 * point.y) / height * self.half_height;
        let direction = self.forward + s_x * self.right + s_y * self.up;
        Ray::new(self.eye, direction.normalize())
    }
    // ANCHOR_END: ray
}

impl From<&CameraRecord> for Camera {
    /// Builds the frame: right = forward × up, which then makes the third vector exact.
    ///
    /// The record has been checked: the target is not the eye, and `up` not parallel to the view.
    fn from(record: &CameraRecord) -> Self {
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let forward = (vector(record.target) - vector(record.eye)).normalize();
        let right = forward.cross(vector(record.up)).normalize();
        let up = right.cross(forward);
        let half_angle = f64::from(record.fov).to_radians() / 2.0;
        Self {
            eye: Vec3::from_array(record.eye),
            forward: forward.as_vec3(),
            right: right.as_vec3(),
            up: up.as_vec3(),
            half_height: math::tan(half_angle) as f32,
        }
    }
}
