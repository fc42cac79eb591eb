//! Point lights, and the point lights that stand in for lamps.

use std::f32::consts::PI;
use std::ops::Range;

use glam::Vec3;

use crate::intersect::Intersect;
use crate::rgb::Rgb;
use crate::surface_point::SurfacePoint;

/// Light that comes from a single point.
#[derive(Clone, Debug)]
pub struct PointLight {
    /// In scene units.
    pub position: Vec3,
    /// I of equations 1 and 2: a white Lambertian surface at distance r, facing the light, has the
    /// radiance I/r².
    pub intensity: Rgb,
    /// The side a lamp shines to (unit length); `None` shines all around.
    pub normal: Option<Vec3>,
    /// The primitives of the lamp that this light stands in for. They cast no shadow of their own.
    pub lamp: Range<u32>,
}

impl PointLight {
    /// A light of the scene file.
    #[must_use]
    pub const fn new(position: Vec3, intensity: Rgb) -> Self {
        Self { position, intensity, normal: None, lamp: 0..0 }
    }

    /// Stands in for a flat lamp of this `area`, which emits `radiance` to the side of `normal`.
    ///
    /// Far away, a lamp sends E = L A cos θ / r² to a surface that faces it, and a white Lambertian
    /// surface answers with E/π: hence I = L A / π, times the lamp's own cos θ.
    #[must_use]
    pub fn flat_lamp(
        position: Vec3,
        normal: Vec3,
        area: f32,
        radiance: Rgb,
        lamp: Range<u32>,
    ) -> Self {
        Self { position, intensity: radiance * (area / PI), normal: Some(normal), lamp }
    }

    /// Stands in for a sphere of this `radius`, which shows the disk A = π r² to every side.
    #[must_use]
    pub fn sphere_lamp(position: Vec3, radius: f32, radiance: Rgb, lamp: Range<u32>) -> Self {
        Self { position, intensity: radiance * (radius * radius), normal: None, lamp }
    }

    /// I toward `point`: with the lamp's cosine, and zero behind it.
    #[must_use]
    pub fn intensity_toward(&self, point: Vec3) -> Rgb {
        match self.normal {
            None => self.intensity,
            Some(normal) => {
                let direction = (point - self.position).normalize_or_zero();
                self.intensity * normal.dot(direction).max(0.0)
            }
        }
    }

    /// Whether nothing stands between `surface` and the light.
    ///
    /// The lamp that the light stands in for does not count: it is stepped over.
    #[must_use]
    pub fn is_visible_from<G: Intersect>(&self, surface: &SurfacePoint, geometry: &G) -> bool {
        let mut ray = surface.spawn_to(self.position);
        if self.lamp.is_empty() {
            return !geometry.occluded(&ray);
        }
        while let Some(hit) = geometry.intersect(&ray) {
            if !self.lamp.contains(&hit.primitive) {
                return false;
            }
            if hit.t >= ray.extent.max {
                break;
            }
            ray.extent.min = hit.t;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::PointLight;
    use crate::rgb::Rgb;
    use glam::{Vec3, vec3};

    /// A lamp of area π and radiance 1 stands in with I = 1 straight ahead, and cos θ aside.
    #[test]
    fn a_flat_lamp_shines_with_the_cosine_and_not_behind() {
        let area = std::f32::consts::PI;
        let light = PointLight::flat_lamp(Vec3::ZERO, Vec3::Y, area, Rgb::ONE, 0..2);
        for (point, expected) in [
            (vec3(0.0, 5.0, 0.0), 1.0),
            (vec3(3.0, 4.0, 0.0), 0.8),
            (vec3(1.0, 0.0, 0.0), 0.0),
            (vec3(0.0, -1.0, 0.0), 0.0),
        ] {
            let intensity = light.intensity_toward(point).x;
            assert!((intensity - expected).abs() <= f32::EPSILON, "{point}: {intensity}");
        }
    }
}
