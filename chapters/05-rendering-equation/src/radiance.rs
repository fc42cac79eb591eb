//! The rendering equation, solved by looking in N random directions from every hit.

use std::hint::black_box;

use blinn_phong::Picture;
use mirror_refraction::{Boundaries, Media, mirror_direction, split};
use ray_casting::{Intersect, Ray, Rgb, Scene, SurfacePoint, Surfaces};
use workbench::{Counter, Probe, Sampler};

use crate::brdf::Brdf;
use crate::directions::Density;
use crate::material::{Material, Materials};
use crate::survey::Has;

/// How many directions, how deep, and drawn how.
#[derive(Clone, Copy, Debug)]
pub struct Branching {
    /// N: directions that are followed from a matte surface, at least 1.
    pub directions: u32,
    /// D: most scattering events between the eye and a lamp. The light of longer ways is lost.
    pub depth: u32,
    /// How the directions are drawn.
    pub density: Density,
}

/// Distributed ray tracing, over whatever finds the hits. `H`: what scenes it is compiled for.
pub struct DistributedTracer<'a, G, P, H> {
    scene: &'a Scene,
    surfaces: Surfaces<'a>,
    materials: Materials<'a, H>,
    geometry: &'a G,
    probe: &'a P,
    branching: Branching,
    boundaries: Boundaries<'a>,
    at_eye: Media,
}

impl<'a, G: Intersect, P: Probe, H: Has> DistributedTracer<'a, G, P, H> {
    /// A tracer for the surfaces that `geometry`, the searchable form of the scene's own, finds.
    pub fn new(
        scene: &'a Scene,
        pictures: &'a [Picture],
        geometry: &'a G,
        probe: &'a P,
        branching: Branching,
    ) -> Self {
        let boundaries = Boundaries::new(scene);
        let at_eye = boundaries.media_at_eye(geometry);
        let surfaces = Surfaces::new(scene);
        let materials = Materials::new(scene, pictures);
        Self { scene, surfaces, materials, geometry, probe, branching, boundaries, at_eye }
    }

    // ANCHOR: incident_radiance
    /// An estimate of the light that arrives against `ray`, which starts at the eye.
    pub fn incident_radiance(&self, ray: Ray, sampler: &mut Sampler) -> Rgb {
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));
        self.radiance(ray, self.at_eye, 0, sampler)
    }

    /// An estimate of Lᵢ, the radiance that arrives against `ray`, in W m⁻² sr⁻¹.
    ///
    /// ```text
    /// Lₒ(ωₒ) = Lₑ(ωₒ) + ∫ f(ωₒ, ωᵢ) Lᵢ(ωᵢ) |cos θᵢ| dωᵢ
    ///        ≈ Lₑ(ωₒ) + 1/N Σₖ f(ωₒ, ωₖ) Lᵢ(ωₖ) |cos θₖ| / p(ωₖ)
    /// ```
    ///
    /// The rendering equation \[Kajiya86] in its radiance form, and equation 6 with the factors that
    /// the review's first listing lacks (errata 15). A lamp both shines and reflects (errata 21). A
    /// mirror or a boundary of glass has one way to go, or two of which chance chooses one: N rays
    /// into the same direction would tell nothing new.
    fn radiance(&self, mut ray: Ray, mut media: Media, events: u32, sampler: &mut Sampler) -> Rgb {
        let mut radiance = Rgb::ZERO;
        let mut passed = Rgb::ONE;
        for _ in 0..=self.boundaries.most_crossings() {
            let Some(hit) = self.geometry.intersect(&ray) else {
                self.probe.tell(|| "the ray leaves the scene".to_owned());
                let background = if H::SKY { self.scene.background } else { Rgb::ZERO };
                return radiance + passed * background;
            };
            let mut surface = self.surfaces.at(&ray, &hit);
            if H::GLASS {
                surface = self.boundaries.opaque_contact(&ray, surface);
            }
            self.probe.tell(|| format!("hits {:?} at {}", surface.hit, surface.position));
            radiance += passed * self.materials.emitted(&surface);
            let material = self.materials.at(&surface);

            // A boundary between equal indices is no event: straight on.
            let crossing = match material {
                Material::Glass => Some(self.boundaries.crossing(&ray, &surface, &media)),
                _ => None,
            };
            if let Some(crossing) = crossing.filter(|crossing| crossing.eta == 1.0) {
                let split = || split(self.scene, &surface, crossing.eta);
                self.probe.skip(Counter::FresnelSplits, split);
                passed *= crossing.kt;
                media = crossing.beyond;
                ray = crossing.far.spawn(ray.direction);
                continue;
            }
            if events == self.branching.depth {
                self.probe.tell(|| "the depth ends the path".to_owned());
                self.probe.count(Counter::PathsEndedByDepth, 1);
                return radiance;
            }

            match material {
                Material::Matte { kd, map_kd, lobe } => {
                    if map_kd.is_none() {
                        let coordinates = || self.scene.texture_coordinates(&surface);
                        self.probe.skip(Counter::TextureCoordinates, coordinates);
                    }
                    let brdf = self.materials.brdf(&surface, kd, map_kd, lobe);
                    if brdf.is_black() {
                        let next = || self.go_on(&surface, &brdf, sampler.clone());
                        self.probe.skip(Counter::PathsEndedByBlack, next);
                        return radiance;
                    }
                    let n = self.branching.directions;
                    let mut reflected = Rgb::ZERO;
                    for _ in 0..n {
                        let density = self.branching.density;
                        let Some(scattered) = brdf.sample(density, sampler) else { continue };
                        let next = surface.spawn(scattered.wi);
                        self.tell(Counter::ScatterRays, events + 1, &next, scattered.weight);
                        // f |cos θ| / p times Lᵢ
                        reflected +=
                            scattered.weight * self.radiance(next, media, events + 1, sampler);
                    }
                    return radiance + passed * reflected / n as f32;
                }
                Material::Mirror { kr } => {
                    let next = surface.spawn(mirror_direction(self.scene, &surface));
                    self.tell(Counter::ReflectionRays, events + 1, &next, kr);
                    let reflected = kr * self.radiance(next, media, events + 1, sampler);
                    return radiance + passed * reflected;
                }
                Material::Glass => {
                    let Some(crossing) = crossing else { return radiance };
                    let split = split(self.scene, &surface, crossing.eta);
                    let u = sampler.next_1d();
                    let arriving = match split.refracted {
                        Some(refracted) if u >= split.reflectance => {
                            // Divided by its probability, the share 1 − F is 1. Radiance grows by
                            // η² where the rays are crowded together.
                            let weight = crossing.kt * (crossing.eta * crossing.eta);
                            let next = crossing.far.spawn(refracted);
                            self.tell(Counter::RefractionRays, events + 1, &next, weight);
                            weight * self.radiance(next, crossing.beyond, events + 1, sampler)
                        }
                        _ => {
                            let next = crossing.near.spawn(split.reflected);
                            self.tell(Counter::ReflectionRays, events + 1, &next, Rgb::ONE);
                            self.radiance(next, media, events + 1, sampler)
                        }
                    };
                    return radiance + passed * arriving;
                }
            }
        }
        radiance
    }
    // ANCHOR_END: incident_radiance

    /// The next rays of a path that goes on, for nothing, where the surface is black.
    fn go_on(&self, surface: &SurfacePoint, brdf: &Brdf, mut sampler: Sampler) {
        for _ in 0..self.branching.directions {
            let Some(scattered) = brdf.sample(self.branching.density, &mut sampler) else {
                continue;
            };
            self.probe.count(Counter::ScatterRays, 1);
            black_box(self.geometry.intersect(&surface.spawn(scattered.wi)));
        }
    }

    /// Counts a ray, and tells of it under `--pixel`.
    fn tell(&self, kind: Counter, events: u32, ray: &Ray, weight: Rgb) {
        self.probe.count(kind, 1);
        self.probe.tell(|| {
            let Ray { origin, direction, .. } = ray;
            format!("{kind:?} {events}: from {origin} along {direction}, weight {weight}")
        });
    }
}

/// What a stage that waits to meet lamps shows more plainly than the scene asks, one sentence each.
#[must_use]
pub fn simplifications(scene: &Scene) -> Vec<String> {
    let mut sentences = remarks(scene);
    if scene.point_lights().next().is_some() {
        sentences
            .push("a random direction never hits a point light: they are dark here".to_owned());
    }
    sentences
}

/// What every physical stage has to say of a scene, one sentence each.
#[must_use]
pub fn remarks(scene: &Scene) -> Vec<String> {
    scene.notices.iter().cloned().chain(unphysical(scene)).collect()
}

/// Names of the materials that would reflect more light than arrives.
fn unphysical(scene: &Scene) -> Option<String> {
    use workbench::SurfaceKind::Diffuse;
    let gains = |kd: [f32; 3], ks: [f32; 3]| kd.iter().zip(ks).any(|(kd, ks)| kd + ks > 1.0);
    let creating = scene.materials.iter().filter(|m| m.surface == Diffuse && gains(m.kd, m.ks));
    let names: Vec<_> = creating.map(|material| format!("`{}`", material.name)).collect();
    (!names.is_empty())
        .then(|| format!("kd + ks is above 1 in {}: such a surface makes light", names.join(", ")))
}
