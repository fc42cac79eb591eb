//! What a surface does to light: densities, reflectances, measures.

mod albedo;
mod brdfs;
mod extremes;
mod hemispheres;
mod lamps;

use glam::Vec3;
use rendering_equation::{Brdf, Lambert, Lobe};

/// Five normals: an axis, its opposite, and three that are not special.
pub(crate) fn normals() -> [Vec3; 5] {
    let askew = [Vec3::new(0.3, -0.7, 0.5), Vec3::new(-0.9, 0.1, -0.02), Vec3::new(1.0, 1.0, 1.0)];
    let [a, b, c] = askew.map(Vec3::normalize);
    [Vec3::Z, Vec3::NEG_Z, a, b, c]
}

/// The direction at this many degrees from +z, at an azimuth that is not special.
pub(crate) fn at_degrees(theta: f64) -> Vec3 {
    let (sin, cos) = theta.to_radians().sin_cos();
    let (sin_phi, cos_phi) = 0.6_f64.sin_cos();
    glam::DVec3::new(sin * cos_phi, sin * sin_phi, cos).as_vec3()
}

/// A surface that faces +z.
pub(crate) fn surface(kd: f32, lobe: Option<(f32, f32)>, wo: Vec3) -> Brdf {
    Brdf {
        normal: Vec3::Z,
        facing: Vec3::Z,
        wo,
        lambert: Lambert { albedo: Vec3::splat(kd) },
        lobe: lobe.map(|(ks, exponent)| Lobe::new(Vec3::splat(ks), exponent)),
    }
}
