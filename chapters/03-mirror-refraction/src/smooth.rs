//! Reflection and refraction at a point of the scene, whose normal may be interpolated.

use glam::Vec3;
use ray_casting::{Scene, SurfacePoint};

use crate::fresnel::{Split, reflect};

/// Where a mirror sends the viewer's ray: by the interpolated normal, unless that is into the
/// surface.
#[must_use]
pub fn mirror_direction(scene: &Scene, surface: &SurfacePoint) -> Vec3 {
    let facing = surface.facing_normal();
    let direction = reflect(surface.wo, scene.shading_normal(surface));
    if direction.dot(facing) > 0.0 { direction } else { reflect(surface.wo, facing) }
}

/// What a boundary does to the viewer's ray, where η = ηᵢ/ηₜ: by the interpolated normal, unless
/// that leads to the wrong side of the surface.
#[must_use]
pub fn split(scene: &Scene, surface: &SurfacePoint, eta: f32) -> Split {
    let facing = surface.facing_normal();
    let split = Split::new(surface.wo, scene.shading_normal(surface), eta);
    if split.respects(facing) { split } else { Split::new(surface.wo, facing, eta) }
}
