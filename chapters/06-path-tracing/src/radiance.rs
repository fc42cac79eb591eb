//! The rendering equation, solved by following one random path.

use blinn_phong::Picture;
use mirror_refraction::{Boundaries, Media, mirror_direction, split};
use ray_casting::{Hit, Intersect, Ray, Rgb, Scene, SurfacePoint, Surfaces};
use rendering_equation::{Brdf, Density, Has, Material, Materials};
use workbench::{Counter, Probe, Sampler};

use crate::roulette::Ending;

/// Path tracing, over whatever finds the hits. `H`: what scenes it is compiled for.
pub struct PathTracer<'a, G, P, H> {
    scene: &'a Scene,
    surfaces: Surfaces<'a>,
    materials: Materials<'a, H>,
    geometry: &'a G,
    probe: &'a P,
    density: Density,
    ending: Ending,
    boundaries: Boundaries<'a>,
    at_eye: Media,
    longest: u32,
}

impl<'a, G: Intersect, P: Probe, H: Has> PathTracer<'a, G, P, H> {
    /// A tracer for the surfaces that `geometry`, the searchable form of the scene's own, finds.
    pub fn new(
        scene: &'a Scene,
        pictures: &'a [Picture],
        geometry: &'a G,
        probe: &'a P,
        density: Density,
        ending: Ending,
    ) -> Self {
        let boundaries = Boundaries::new(scene);
        let at_eye = boundaries.media_at_eye(geometry);
        let surfaces = Surfaces::new(scene);
        let materials = Materials::new(scene, pictures);
        // Before every event and after the last one, a ray may cross boundaries that are none.
        let straight = boundaries.most_crossings().saturating_add(1);
        let longest = ending.depth.saturating_add(1).saturating_mul(straight);
        Self {
            scene,
            surfaces,
            materials,
            geometry,
            probe,
            density,
            ending,
            boundaries,
            at_eye,
            longest,
        }
    }

    // ANCHOR: incident_radiance
    /// A one-sample estimate of Lᵢ, the radiance that arrives against `ray`, in W m⁻² sr⁻¹.
    ///
    /// ```text
    /// Lᵢ ≈ Σₖ βₖ Lₑ(xₖ),   β₀ = 1,   βₖ₊₁ = βₖ · f(ωₒ, ωᵢ) |cos θᵢ| / p(ωᵢ)
    /// ```
    ///
    /// The rendering equation \[Kajiya86] with N = 1 at every hit, unrolled into a loop: the
    /// review's second listing with the factors that it lacks (errata 16), and with lamps that
    /// reflect (errata 21).
    pub fn incident_radiance(&self, mut ray: Ray, sampler: &mut Sampler) -> Rgb {
        let mut radiance = Rgb::ZERO;
        let mut throughput = Rgb::ONE; // β
        let mut squeezed = 1.0; // how often radiance counts because of refraction, a part of β
        let mut media = self.at_eye;
        let mut events = 0;
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));

        for _ in 0..self.longest {
            let Some(hit) = self.geometry.intersect(&ray) else {
                self.probe.tell(|| "the ray leaves the scene".to_owned());
                if H::SKY {
                    radiance += throughput * self.scene.background;
                }
                break;
            };
            let mut surface = self.surfaces.at(&ray, &hit);
            if H::GLASS {
                surface = self.boundaries.opaque_contact(&ray, surface);
            }
            self.probe.tell(|| format!("hits {:?} at {}", surface.hit, surface.position));
            radiance += throughput * self.materials.emitted(&surface);
            let material = self.materials.at(&surface);

            // A boundary between equal indices is no event: straight on.
            let crossing = match material {
                Material::Glass => Some(self.boundaries.crossing(&ray, &surface, &media)),
                _ => None,
            };
            if let Some(crossing) = crossing.filter(|crossing| crossing.eta == 1.0) {
                let split = || split(self.scene, &surface, crossing.eta);
                self.probe.skip(Counter::FresnelSplits, split);
                throughput *= crossing.kt;
                media = crossing.beyond;
                ray = crossing.far.spawn(ray.direction);
                continue;
            }
            if events == self.ending.depth {
                self.probe.tell(|| "the depth ends the path".to_owned());
                self.probe.count(Counter::PathsEndedByDepth, 1);
                break;
            }

            let kind = match material {
                Material::Matte { kd, map_kd, lobe } => {
                    if map_kd.is_none() {
                        let coordinates = || self.scene.texture_coordinates(&surface);
                        self.probe.skip(Counter::TextureCoordinates, coordinates);
                    }
                    let brdf = self.materials.brdf(&surface, kd, map_kd, lobe);
                    if brdf.is_black() {
                        self.probe.tell(|| "the surface reflects nothing".to_owned());
                        let next = || self.go_on(&surface, &brdf, sampler.clone());
                        self.probe.skip(Counter::PathsEndedByBlack, next);
                        break;
                    }
                    let Some(scattered) = brdf.sample(self.density, sampler) else {
                        self.probe
                            .tell(|| "the direction drawn leads below the surface".to_owned());
                        break;
                    };
                    throughput *= scattered.weight; // f |cos θᵢ| / p
                    ray = surface.spawn(scattered.wi);
                    Counter::ScatterRays
                }
                Material::Mirror { kr } => {
                    throughput *= kr;
                    ray = surface.spawn(mirror_direction(self.scene, &surface));
                    Counter::ReflectionRays
                }
                Material::Glass => {
                    let Some(crossing) = crossing else { break };
                    let split = split(self.scene, &surface, crossing.eta);
                    // Each way is taken as often as it has light, so the weight of both is 1.
                    let u = sampler.next_1d();
                    match split.refracted {
                        Some(refracted) if u >= split.reflectance => {
                            let eta2 = crossing.eta * crossing.eta;
                            throughput *= crossing.kt * eta2;
                            squeezed *= eta2;
                            media = crossing.beyond;
                            ray = crossing.far.spawn(refracted);
                            Counter::RefractionRays
                        }
                        _ => {
                            ray = crossing.near.spawn(split.reflected);
                            Counter::ReflectionRays
                        }
                    }
                }
            };
            events += 1;

            // Light that is squeezed by glass will be spread again: it must not end a path.
            let q = self.ending.roulette.survival(throughput / squeezed, events);
            if q < 1.0 {
                if sampler.next_1d() >= q {
                    self.probe.tell(|| format!("roulette ends the path, which had q = {q}"));
                    self.probe.count(Counter::PathsEndedByRoulette, 1);
                    break;
                }
                throughput /= q;
            }
            self.probe.count(kind, 1);
            self.probe.tell(|| {
                let Ray { origin, direction, .. } = ray;
                format!("{kind:?} {events}: from {origin} along {direction}, β = {throughput}")
            });
        }
        radiance
    }
    // ANCHOR_END: incident_radiance

    /// The next ray of a path that goes on, for nothing, where the surface is black.
    fn go_on(&self, surface: &SurfacePoint, brdf: &Brdf, mut sampler: Sampler) -> Option<Hit> {
        let scattered = brdf.sample(self.density, &mut sampler)?;
        self.probe.count(Counter::ScatterRays, 1);
        self.geometry.intersect(&surface.spawn(scattered.wi))
    }
}
