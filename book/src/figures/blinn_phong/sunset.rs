//! A light below the floor: equations 1 to 3 as printed, and what is missing in them.

use blinn_phong::Material;
use blinn_phong::reflection::{Arriving, diffuse};
use glam::vec3;
use ray_casting::{PointLight, Rgb, Scene, Sphere, SurfacePoint, math};

use super::still_life::{PANEL, clay, draw, draw_otherwise, floor, still_life, tree};
use crate::figures::Drawing;
use crate::picture::Picture;

/// A ball on a floor; one light has set behind it, a weak one stands on the left.
fn evening() -> Scene {
    let mut geometry = floor(9.0);
    geometry.spheres.push(Sphere { center: vec3(1.0, 1.0, 0.0), radius: 1.0 });
    let mut scene = still_life(vec3(0.0, 2.0, 8.0), vec3(0.0, 0.6, 0.0), 30.0, geometry);
    scene.materials = vec![clay()];
    scene.materials[0].ns = 24.0;
    scene.lights.push(super::still_life::light(vec3(-3.0, -1.5, -20.0), 0.8));
    scene.lights.push(super::still_life::light(vec3(-6.0, 6.0, 5.0), 0.15));
    scene
}

/// Equation 2 as printed: no condition on n·l.
fn as_printed(surface: &SurfacePoint, material: &Material, light: &PointLight) -> Rgb {
    let arriving = Arriving::new(light, surface.position);
    let normal = surface.facing_normal();
    let half = (arriving.direction + surface.wo).normalize_or_zero();
    let cos_alpha = normal.dot(half).clamp(0.0, 1.0);
    diffuse(material.kd, &arriving, normal)
        + material.ks * arriving.strength * math::power(cos_alpha, material.ns)
}

/// As printed; with visibility, but without the condition; as the stage draws it.
pub(super) fn sunset() -> Drawing {
    let scene = evening();
    let geometry = tree(&scene);
    let with_shadows = |surface: &SurfacePoint, material: &Material, light: &PointLight| {
        let visible = light.is_visible_from(surface, &geometry);
        if visible { as_printed(surface, material, light) } else { Rgb::ZERO }
    };
    let panels = [
        draw_otherwise(&scene, &geometry, &PANEL, as_printed),
        draw_otherwise(&scene, &geometry, &PANEL, with_shadows),
        draw(&scene, &PANEL),
    ];
    Picture::side_by_side(&panels.each_ref().map(Picture::from), 8).into()
}
