//! Light on the visible surface: equations 1 to 3, for every light that is not hidden.

use clap::ValueEnum;
use ray_casting::{Intersect, PointLight, Ray, Rgb, Scene, SurfacePoint};
use workbench::{Counter, Probe};

use crate::material::Material;
use crate::picture::Picture;
use crate::reflection::{Arriving, diffuse, specular};

/// Which terms of equation 3 are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Terms {
    /// I = I_a + I_d + I_s.
    #[default]
    All,
    /// I_a alone.
    Ambient,
    /// I_d alone.
    Diffuse,
    /// I_s alone.
    Specular,
}

/// Shades the nearest surface along each ray.
pub struct Shader<'a, G, P> {
    scene: &'a Scene,
    geometry: &'a G,
    probe: &'a P,
    terms: Terms,
    materials: Vec<Material>,
    pictures: &'a [Picture],
}

impl<'a, G: Intersect, P: Probe> Shader<'a, G, P> {
    /// A shader for the surfaces that `geometry`, the searchable form of the scene's own, finds.
    pub fn new(
        scene: &'a Scene,
        pictures: &'a [Picture],
        geometry: &'a G,
        probe: &'a P,
        terms: Terms,
    ) -> Self {
        let materials = scene.materials.iter().map(Material::from).collect();
        Self { scene, geometry, probe, terms, materials, pictures }
    }

    // ANCHOR: incident_radiance
    /// The light that arrives against `ray` from the surface it meets first.
    ///
    /// ```text
    /// I = I_a + Σ V (I_d + I_s)    over all lights
    /// ```
    ///
    /// Equation 3, with what the review leaves out (errata 9): the sum over the lights, and V,
    /// which is 1 if the light sees the point and 0 if not.
    #[must_use]
    pub fn incident_radiance(&self, ray: Ray) -> Rgb {
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));
        let Some(hit) = self.geometry.intersect(&ray) else {
            self.probe.tell(|| "the ray leaves the scene".to_owned());
            return self.scene.background;
        };
        let surface = self.scene.surface(&ray, &hit);
        self.probe.tell(|| format!("hits {hit:?} at {}", surface.position));

        if self.materials[surface.material as usize].map_kd.is_none() {
            let coordinates = || self.scene.texture_coordinates(&surface);
            self.probe.skip(Counter::TextureCoordinates, coordinates);
        }
        let lights = self.scene.lights.iter();
        let reflected = lights.fold(Rgb::ZERO, |sum, light| sum + self.reflected(&surface, light));
        if matches!(self.terms, Terms::All | Terms::Ambient) {
            self.scene.ambient + reflected
        } else {
            reflected
        }
    }

    /// V (I_d + I_s) of one light. No shadow ray is cast where nothing could be reflected.
    fn reflected(&self, surface: &SurfacePoint, light: &PointLight) -> Rgb {
        let material = &self.materials[surface.material as usize];
        let is_visible = || self.is_visible(surface, light);
        if material.is_black() || self.terms == Terms::Ambient {
            self.probe.skip(Counter::ShadowRaysNothingToReflect, is_visible);
            return Rgb::ZERO;
        }
        let arriving = Arriving::new(light, surface.position);
        // Light from behind the surface does not reach it, whatever interpolated normals say.
        let faces_away = surface.facing_normal().dot(arriving.direction) <= 0.0;
        if faces_away || arriving.strength == Rgb::ZERO {
            self.probe.skip(Counter::ShadowRaysFacingAway, is_visible);
            self.probe.tell(|| format!("no light comes to this side from {}", light.position));
            return Rgb::ZERO;
        }

        let normal = self.scene.shading_normal(surface);
        let mut reflected = Rgb::ZERO;
        if matches!(self.terms, Terms::All | Terms::Diffuse) {
            let coordinates = || self.scene.texture_coordinates(surface);
            let kd = material.diffuse_reflectance(self.pictures, coordinates);
            reflected += diffuse(kd, &arriving, normal);
        }
        if matches!(self.terms, Terms::All | Terms::Specular) {
            reflected += specular(material.ks, material.ns, &arriving, normal, surface.wo);
        }
        if reflected == Rgb::ZERO {
            self.probe.skip(Counter::ShadowRaysNothingToReflect, is_visible);
            return Rgb::ZERO;
        }

        let visible = is_visible();
        self.probe.tell(|| format!("light at {}: {reflected}, visible: {visible}", light.position));
        if visible { reflected } else { Rgb::ZERO }
    }

    /// V, by a shadow ray.
    fn is_visible(&self, surface: &SurfacePoint, light: &PointLight) -> bool {
        self.probe.count(Counter::ShadowRays, 1);
        light.is_visible_from(surface, self.geometry)
    }
    // ANCHOR_END: incident_radiance
}
