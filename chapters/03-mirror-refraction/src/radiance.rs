//! The recursion: what a mirror or glass shows is found by asking the same question again.

use blinn_phong::reflection::{Arriving, diffuse, specular};
use blinn_phong::{Material, Picture};
use ray_casting::{Intersect, PointLight, Ray, Rgb, Scene, SurfacePoint};
use workbench::{Counter, Probe, SurfaceKind};

use crate::boundaries::Boundaries;
use crate::limits::Limits;
use crate::material::Surface;
use crate::media::Media;
use crate::smooth::{mirror_direction, split};

/// Whitted's method, over whatever finds the hits.
pub struct RayTracer<'a, G, P> {
    scene: &'a Scene,
    pictures: &'a [Picture],
    geometry: &'a G,
    probe: &'a P,
    limits: Limits,
    boundaries: Boundaries<'a>,
    at_eye: Media,
}

/// How a ray came to be.
#[derive(Clone, Copy)]
struct Path {
    /// Reflections and refractions so far.
    events: u32,
    /// The share of what the ray finds that reaches the eye.
    throughput: Rgb,
    /// What the ray is in.
    media: Media,
}

impl<'a, G: Intersect, P: Probe> RayTracer<'a, G, P> {
    /// A tracer for the surfaces that `geometry`, the searchable form of the scene's own, finds.
    pub fn new(
        scene: &'a Scene,
        pictures: &'a [Picture],
        geometry: &'a G,
        probe: &'a P,
        limits: Limits,
    ) -> Self {
        let boundaries = Boundaries::new(scene);
        let at_eye = boundaries.media_at_eye(geometry);
        Self { scene, pictures, geometry, probe, limits, boundaries, at_eye }
    }

    // ANCHOR: incident_radiance
    /// The light that arrives against `ray`, which starts at the eye.
    #[must_use]
    pub fn incident_radiance(&self, ray: Ray) -> Rgb {
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));
        self.radiance(ray, Path { events: 0, throughput: Rgb::ONE, media: self.at_eye })
    }

    /// The light that arrives against `ray`, be it from the eye or from another surface.
    ///
    /// ```text
    /// nothing      L = background
    /// diffuse      L = I_a + Σ V (I_d + I_s)                chapter 2; the recursion ends
    /// mirror       L = k_r L(reflected)
    /// transparent  L = F L(reflected) + (1 − F) k_t L(refracted)
    /// ```
    ///
    /// The review's four cases, with what it leaves out (errata 12): Fresnel's F, total internal
    /// reflection, where F = 1, and an end: [`RayTracer::follow`] says which rays are followed. A
    /// face with the same index on both sides does nothing to the ray; the loop passes through it.
    fn radiance(&self, mut ray: Ray, mut path: Path) -> Rgb {
        let mut passed = Rgb::ONE;
        for _ in 0..=self.boundaries.most_crossings() {
            let Some(hit) = self.geometry.intersect(&ray) else {
                self.probe.tell(|| "the ray leaves the scene".to_owned());
                return passed * self.scene.background;
            };
            let surface = self.scene.surface(&ray, &hit);
            let surface = self.boundaries.opaque_contact(&ray, surface);
            self.probe.tell(|| format!("hits {:?} at {}", surface.hit, surface.position));

            match self.boundaries.material(&surface) {
                Surface::Diffuse(material) => {
                    if material.map_kd.is_none() {
                        let coordinates = || self.scene.texture_coordinates(&surface);
                        self.probe.skip(Counter::TextureCoordinates, coordinates);
                    }
                    let lights = self.scene.lights.iter();
                    let reflected =
                        lights.map(|light| self.reflected(&surface, material, light)).sum::<Rgb>();
                    return passed * (self.scene.ambient + reflected);
                }
                Surface::Mirror { kr } => {
                    let reflected = surface.spawn(mirror_direction(self.scene, &surface));
                    let next = path.after(*kr);
                    return passed * *kr * self.follow(Counter::ReflectionRays, reflected, next);
                }
                Surface::Glass { .. } => {
                    let crossing = self.boundaries.crossing(&ray, &surface, &path.media);
                    let split = || split(self.scene, &surface, crossing.eta);
                    if crossing.eta == 1.0 {
                        self.probe.skip(Counter::FresnelSplits, split);
                        self.probe.tell(|| "passes straight through".to_owned());
                        passed *= crossing.kt;
                        path = Path { throughput: path.throughput * crossing.kt, ..path };
                        path.media = crossing.beyond;
                        ray = crossing.far.spawn(ray.direction);
                        continue;
                    }
                    let split = split();
                    let f = Rgb::splat(split.reflectance);
                    let reflected = crossing.near.spawn(split.reflected);
                    let mut light =
                        f * self.follow(Counter::ReflectionRays, reflected, path.after(f));
                    if let Some(refracted) = split.refracted {
                        let through = (1.0 - f) * crossing.kt;
                        let next = Path { media: crossing.beyond, ..path.after(through) };
                        let refracted = crossing.far.spawn(refracted);
                        light += through * self.follow(Counter::RefractionRays, refracted, next);
                    }
                    return passed * light;
                }
            }
        }
        Rgb::ZERO
    }

    /// L of a reflected or refracted ray; black where it is not worth following.
    ///
    /// Two facing mirrors never end, so the scattering events are limited. Long before that, most
    /// branches have a weight that no pixel shows: adaptive depth control \[HallGreenberg83].
    fn follow(&self, kind: Counter, ray: Ray, path: Path) -> Rgb {
        let weight = path.throughput;
        if !self.limits.allow_weight(weight.max_element()) {
            self.probe.tell(|| format!("{kind:?}: weight {weight} is too small"));
            self.probe.count(Counter::BranchesBelowThreshold, 1);
            return Rgb::ZERO;
        }
        if !self.limits.allow_events(path.events) {
            self.probe.tell(|| format!("{kind:?}: the depth ends here, weight {weight}"));
            return Rgb::ZERO;
        }
        self.probe.count(kind, 1);
        self.probe.tell(|| {
            let (events, origin, direction) = (path.events, ray.origin, ray.direction);
            format!("{kind:?} {events}: from {origin} along {direction}, weight {weight}")
        });
        self.radiance(ray, path)
    }
    // ANCHOR_END: incident_radiance

    // ANCHOR: reflected
    /// V (I_d + I_s) of one light on a diffuse surface: equations 1 and 2 of chapter 2.
    ///
    /// Glass throws the shadow of an opaque body: light does find ways through it, but a straight
    /// ray to the light is none of them.
    fn reflected(&self, surface: &SurfacePoint, material: &Material, light: &PointLight) -> Rgb {
        let is_visible = || self.is_visible(surface, light);
        if material.is_black() {
            self.probe.skip(Counter::ShadowRaysNothingToReflect, is_visible);
            return Rgb::ZERO;
        }
        let arriving = Arriving::new(light, surface.position);
        let faces_away = surface.facing_normal().dot(arriving.direction) <= 0.0;
        if faces_away || arriving.strength == Rgb::ZERO {
            self.probe.skip(Counter::ShadowRaysFacingAway, is_visible);
            self.probe.tell(|| format!("no light comes to this side from {}", light.position));
            return Rgb::ZERO;
        }

        let normal = self.scene.shading_normal(surface);
        let coordinates = || self.scene.texture_coordinates(surface);
        let kd = material.diffuse_reflectance(self.pictures, coordinates);
        let reflected = diffuse(kd, &arriving, normal)
            + specular(material.ks, material.ns, &arriving, normal, surface.wo);
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
    // ANCHOR_END: reflected
}

impl Path {
    /// One event on, where the light keeps this `share`.
    fn after(&self, share: Rgb) -> Self {
        Self { events: self.events + 1, throughput: self.throughput * share, media: self.media }
    }
}

/// What this stage shows more plainly than the scene asks, one sentence each.
#[must_use]
pub fn simplifications(scene: &Scene) -> Vec<String> {
    let mut sentences = scene.notices.clone();
    if scene.materials.iter().any(|m| m.surface == SurfaceKind::Glass) {
        sentences.push("glass throws the shadow of an opaque body".to_owned());
    }
    if scene.materials.iter().any(|m| m.ke != [0.0; 3]) {
        sentences.push("lamps do not shine here: a point light stands in for each".to_owned());
    }
    sentences
}
