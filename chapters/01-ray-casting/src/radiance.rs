//! The visible surface: what the eye sees first, and whether the first light sees it too.

use clap::ValueEnum;
use glam::Vec3;
use workbench::{Counter, MaterialRecord, Probe, SurfaceKind};

use crate::hit::Hit;
use crate::intersect::Intersect;
use crate::ray::Ray;
use crate::rgb::Rgb;
use crate::scene::Scene;
use crate::surface_point::SurfacePoint;

/// What is drawn at the visible point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Show {
    /// The material's colour times the cosine between surface and viewer; half that in shadow.
    #[default]
    Facing,
    /// Nearness D / (D + t), where D is how far the camera's target is: ½ at the target.
    Depth,
    /// The geometric normal, each component from −1…1 to 0…1.
    Normal,
    /// A colour for each primitive.
    Primitive,
    /// The texture coordinates as red and green.
    Uv,
}

/// How much of its brightness a point keeps that the first light does not reach.
const IN_SHADOW: f32 = 0.5;

/// Draws the nearest surface along each ray.
pub struct RayCaster<'a, G, P> {
    scene: &'a Scene,
    geometry: &'a G,
    probe: &'a P,
    show: Show,
    colors: Vec<Rgb>,
}

impl<'a, G: Intersect, P: Probe> RayCaster<'a, G, P> {
    /// A caster that looks for hits in `geometry`, the searchable form of the scene's own.
    pub fn new(scene: &'a Scene, geometry: &'a G, probe: &'a P, show: Show) -> Self {
        Self { scene, geometry, probe, show, colors: scene.materials.iter().map(color).collect() }
    }

    // ANCHOR: incident_radiance
    /// What arrives against `ray`: a stand-in for radiance until chapter 2 brings light.
    #[must_use]
    pub fn incident_radiance(&self, ray: Ray) -> Rgb {
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));
        let Some(hit) = self.geometry.intersect(&ray) else {
            self.probe.tell(|| "the ray leaves the scene".to_owned());
            return self.scene.background;
        };
        let surface = self.scene.surface(&ray, &hit);
        self.probe.tell(|| format!("hits {hit:?} at {}", surface.position));

        match self.show {
            Show::Facing => {
                let cos_theta = surface.geometric_normal.dot(surface.wo).abs();
                let visibility = if self.is_in_shadow(&surface) { IN_SHADOW } else { 1.0 };
                self.colors[surface.material as usize] * cos_theta * visibility
            }
            Show::Depth => Rgb::splat(self.scene.focus / (self.scene.focus + hit.t)),
            Show::Normal => 0.5 * (surface.geometric_normal + Vec3::ONE),
            Show::Primitive => primitive_color(hit),
            Show::Uv => self.scene.texture_coordinates(&surface).extend(0.0),
        }
    }

    /// Appel's question: does anything stand between the point and the first light?
    fn is_in_shadow(&self, surface: &SurfacePoint) -> bool {
        let Some(light) = self.scene.lights.first() else { return false };
        self.probe.count(Counter::ShadowRays, 1);
        let visible = light.is_visible_from(surface, self.geometry);
        self.probe.tell(|| format!("shadow ray to {}: visible: {visible}", light.position));
        !visible
    }
    // ANCHOR_END: incident_radiance
}

/// The one colour that this chapter knows of a material.
fn color(material: &MaterialRecord) -> Rgb {
    Rgb::from_array(match material.surface {
        SurfaceKind::Diffuse => material.kd,
        SurfaceKind::Mirror => material.kr,
        SurfaceKind::Glass => material.kt,
    })
}

/// Three bytes of the index, stirred by a multiplication so that neighbours differ.
fn primitive_color(hit: Hit) -> Rgb {
    let stirred = (hit.primitive + 1).wrapping_mul(0x9E37_79B1);
    let [_, red, green, blue] = (stirred ^ (stirred >> 15)).to_be_bytes();
    Rgb::new(f32::from(red), f32::from(green), f32::from(blue)) / 255.0
}

/// What this stage shows more plainly than the scene asks, one sentence each.
#[must_use]
pub fn simplifications(scene: &Scene) -> Vec<String> {
    let mut sentences = scene.notices.clone();
    if scene.materials.iter().any(|m| m.surface != SurfaceKind::Diffuse) {
        sentences.push("mirror and glass are drawn as plain surfaces of their colour".to_owned());
    }
    if scene.materials.iter().any(|m| m.ke != [0.0; 3]) {
        sentences.push("lamps do not shine here: a point light stands in for each".to_owned());
    }
    sentences
}
