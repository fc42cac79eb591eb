//! Highlights on balls: growing exponents, and other half vectors.

use blinn_phong::Material;
use blinn_phong::reflection::{Arriving, diffuse};
use glam::{Vec3, vec3};
use ray_casting::{Geometry, Intersect, PointLight, Rgb, Scene, Sphere, SurfacePoint, math};
use workbench::{FilmSettings, MaterialRecord};

use super::still_life::{PANEL, clay, draw, draw_otherwise, still_life, tree};
use crate::figures::Drawing;
use crate::picture::Picture;

/// Far away, so that all balls are seen alike.
const EYE: Vec3 = vec3(0.0, 0.0, 60.0);

/// Balls in a row, with the exponents `ns` from left to right; no ball shades another.
fn balls(ns: &[f32]) -> Scene {
    let ball = |i: usize| {
        let x = 2.3 * (i as f32 - 0.5 * (ns.len() - 1) as f32);
        Sphere { center: vec3(x, 0.0, 0.0), radius: 1.0 }
    };
    let spheres = (0..ns.len()).map(ball).collect();
    let mut scene = still_life(EYE, Vec3::ZERO, 2.27, Geometry { spheres, ..Geometry::default() });
    scene.materials = ns.iter().map(|&ns| MaterialRecord { ns, ..clay() }).collect();
    scene.attributes.materials = (0..ns.len() as u32).collect();
    scene
}

/// The same ball with five exponents. The light is far away, so that it is the same for all.
pub(super) fn exponents() -> Drawing {
    let mut scene = balls(&[1.0, 4.0, 16.0, 64.0, 256.0]);
    scene.lights.push(super::still_life::light(vec3(-600.0, 600.0, 800.0), 1.0));
    let settings = FilmSettings { size: [800, 160], ..PANEL };
    Picture::from(&draw(&scene, &settings)).into()
}

/// The angles between the directions to the eye and to the lights, in degrees.
const ANGLES: [f32; 3] = [20.0, 65.0, 110.0];

/// A ball under lights at growing angles to the eye: as the stage draws it, with half of **l** +
/// **v** in place of a unit vector, and with Phong's mirrored direction.
pub(super) fn halfway() -> Drawing {
    let mut scene = balls(&[64.0]);
    for (i, angle) in ANGLES.into_iter().enumerate() {
        let (sin, cos) = math::sin_cos(angle.to_radians());
        // Each light is a third of the way around from the one before.
        let (y, x) = math::sin_cos((90.0 + 120.0 * i as f32).to_radians());
        scene.lights.push(super::still_life::light(1e3 * vec3(sin * x, sin * y, cos), 0.6));
    }
    let geometry = tree(&scene);
    let not_normalised = |n: Vec3, l: Vec3, v: Vec3| n.dot(0.5 * (l + v)).max(0.0);
    let mirrored = |n: Vec3, l: Vec3, v: Vec3| (2.0 * n.dot(l) * n - l).dot(v).max(0.0);
    let panels = [
        draw(&scene, &PANEL),
        draw_otherwise(&scene, &geometry, &PANEL, |surface, material, light| {
            with_lobe(surface, material, light, &geometry, not_normalised, 1.0)
        }),
        draw_otherwise(&scene, &geometry, &PANEL, |surface, material, light| {
            with_lobe(surface, material, light, &geometry, mirrored, 0.25)
        }),
    ];
    Picture::side_by_side(&panels.each_ref().map(Picture::from), 8).into()
}

/// The stage's reflection with another cosine in the highlight, and the exponent times `sharpness`.
fn with_lobe(
    surface: &SurfacePoint,
    material: &Material,
    light: &PointLight,
    geometry: &impl Intersect,
    cosine: fn(Vec3, Vec3, Vec3) -> f32,
    sharpness: f32,
) -> Rgb {
    let arriving = Arriving::new(light, surface.position);
    let (n, l) = (surface.facing_normal(), arriving.direction);
    if n.dot(l) <= 0.0 || !light.is_visible_from(surface, geometry) {
        return Rgb::ZERO;
    }
    let lobe = math::power(cosine(n, l, surface.wo).min(1.0), sharpness * material.ns);
    diffuse(material.kd, &arriving, n) + material.ks * arriving.strength * lobe
}
