//! The path that asks the lamps at every hit.

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use glam::Vec3;
use mirror_refraction::{Boundaries, Media, mirror_direction, split};
use path_tracing::Ending;
use ray_casting::{Hit, Intersect, Ray, Rgb, Scene, SurfacePoint, Surfaces};
use rendering_equation::{Brdf, Density, Has, Material, Materials};
use workbench::{Counter, Probe, Sampler};

use crate::between::between;
use crate::choice::Choice;
use crate::flat_lamp::Measure;
use crate::heuristic::{Estimator, Heuristic};
use crate::lights::Lights;

/// How light is looked for, and where paths end.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// How lamps are found.
    pub estimator: Estimator,
    /// How both ways are weighed, where both are used.
    pub heuristic: Heuristic,
    /// Which of many lights is asked.
    pub choice: Choice,
    /// Which points of a flat lamp are.
    pub measure: Measure,
    /// How paths end.
    pub ending: Ending,
}

impl Settings {
    /// What the stage does unless it is told otherwise, with paths that end like this.
    #[must_use]
    pub fn new(ending: Ending) -> Self {
        Self {
            estimator: Estimator::default(),
            heuristic: Heuristic::default(),
            choice: Choice::default(),
            measure: Measure::default(),
            ending,
        }
    }
}

/// Path tracing with light sampling, over whatever finds the hits. `H`: what scenes it is compiled
/// for.
pub struct LightTracer<'a, G, P, H> {
    scene: &'a Scene,
    surfaces: Surfaces<'a>,
    materials: Materials<'a, H>,
    lights: Lights,
    geometry: &'a G,
    /// What can throw a shadow, if that is not everything.
    between: Option<BvTree<'a, Aabb, P>>,
    probe: &'a P,
    settings: Settings,
    boundaries: Boundaries<'a>,
    at_eye: Media,
    longest: u32,
}

/// Where a path was scattered last, if light sampling could have found what it meets next.
#[derive(Clone, Copy)]
struct Scattering {
    position: Vec3,
    facing: Vec3,
    pdf_solid_angle: f32,
}

impl<'a, G: Intersect, P: Probe, H: Has> LightTracer<'a, G, P, H> {
    /// A tracer for the surfaces that `geometry`, the searchable form of the scene's own, finds.
    pub fn new(
        scene: &'a Scene,
        pictures: &'a [Picture],
        geometry: &'a G,
        probe: &'a P,
        settings: Settings,
    ) -> Self {
        let boundaries = Boundaries::new(scene);
        let at_eye = boundaries.media_at_eye(geometry);
        let surfaces = Surfaces::new(scene);
        let materials = Materials::new(scene, pictures);
        let lights = Lights::with(scene, settings.choice, settings.measure);
        let asks = settings.estimator != Estimator::Scatter;
        let between = if asks { between(scene, &lights) } else { None };
        let between = between.map(|some| {
            let is_one = |primitive| some.binary_search(&primitive).is_ok();
            BvTree::build_over(&scene.geometry, is_one, Builder::Sah, probe)
        });
        // Before every event and after the last one, a ray may cross boundaries that are none.
        let straight = boundaries.most_crossings().saturating_add(1);
        let longest = settings.ending.depth.saturating_add(1).saturating_mul(straight);
        Self {
            scene,
            surfaces,
            materials,
            lights,
            geometry,
            between,
            probe,
            settings,
            boundaries,
            at_eye,
            longest,
        }
    }

    // ANCHOR: incident_radiance
    /// A one-sample estimate of Lᵢ, the radiance that arrives against `ray`, in W m⁻² sr⁻¹.
    ///
    /// ```text
    /// Lᵢ ≈ Σₖ βₖ [ w_s Lₑ(xₖ) + w_l f(ωₒ, ω) |cos θ| V Lₑ(y) / p_l(ω) ]
    /// ```
    ///
    /// At every hit, a point y of a lamp is drawn with density p_l and asked for its light; the lamps
    /// that the path itself runs into were found with the density of the scattering. The weights
    /// w_s + w_l = 1 make sure that no lamp is counted twice \[VeachGuibas95].
    pub fn incident_radiance(&self, mut ray: Ray, sampler: &mut Sampler) -> Rgb {
        let mut radiance = Rgb::ZERO;
        let mut throughput = Rgb::ONE; // β
        let mut squeezed = 1.0; // how often radiance counts because of refraction, a part of β
        let mut media = self.at_eye;
        let mut events = 0;
        let mut last = None;
        let Ending { depth, roulette } = self.settings.ending;
        self.probe.tell(|| format!("camera ray from {} along {}", ray.origin, ray.direction));

        for _ in 0..self.longest {
            let Some(hit) = self.geometry.intersect(&ray) else {
                self.probe.tell(|| "the ray leaves the scene".to_owned());
                if H::SKY {
                    let pdf = |last: &Scattering| {
                        self.lights.pdf_of_sky(last.position, last.facing, ray.direction)
                    };
                    let weight = self.weight_of_meeting(last, pdf);
                    radiance += throughput * self.scene.background * weight;
                }
                break;
            };
            let mut surface = self.surfaces.at(&ray, &hit);
            if H::GLASS {
                surface = self.boundaries.opaque_contact(&ray, surface);
            }
            self.probe.tell(|| format!("hits {:?} at {}", surface.hit, surface.position));
            let emitted = self.materials.emitted(&surface);
            if emitted != Rgb::ZERO {
                let pdf = |last: &Scattering| {
                    self.lights.pdf_of_lamp(last.position, last.facing, &surface)
                };
                radiance += throughput * emitted * self.weight_of_meeting(last, pdf);
            }
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
                last = None; // no shadow ray passes glass, not even of index 1
                media = crossing.beyond;
                ray = crossing.far.spawn(ray.direction);
                continue;
            }
            if events == depth {
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
                    if self.settings.estimator != Estimator::Scatter {
                        radiance += throughput * self.light_from_lamps(&surface, &brdf, sampler);
                    }
                    let Some(scattered) = brdf.sample(Density::Cosine, sampler) else { break };
                    throughput *= scattered.weight; // f |cos θᵢ| / p
                    ray = surface.spawn(scattered.wi);
                    last = Some(Scattering {
                        position: surface.position,
                        facing: brdf.facing,
                        pdf_solid_angle: scattered.pdf_solid_angle,
                    });
                    Counter::ScatterRays
                }
                Material::Mirror { kr } => {
                    self.skip_shadow_ray(Counter::ShadowRaysDelta, &surface, sampler);
                    throughput *= kr;
                    ray = surface.spawn(mirror_direction(self.scene, &surface));
                    last = None;
                    Counter::ReflectionRays
                }
                Material::Glass => {
                    let Some(crossing) = crossing else { break };
                    last = None;
                    self.skip_shadow_ray(Counter::ShadowRaysDelta, &surface, sampler);
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
            let q = roulette.survival(throughput / squeezed, events);
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

    /// w_l f |cos θ| V Lₑ / p_l of one direction toward a light; no ray where nothing can arrive.
    fn light_from_lamps(&self, surface: &SurfacePoint, brdf: &Brdf, sampler: &mut Sampler) -> Rgb {
        let Some(light) = self.lights.sample(surface, sampler) else {
            self.skip_shadow_ray(Counter::ShadowRaysFacingAway, surface, sampler);
            return Rgb::ZERO;
        };
        let is_visible = || self.is_visible(&light.shadow_ray(surface));
        if !brdf.is_above(light.wi) {
            self.probe.skip(Counter::ShadowRaysFacingAway, is_visible);
            return Rgb::ZERO;
        }
        let reflected = brdf.eval(light.wi) * (brdf.cos_theta(light.wi) / light.pdf_solid_angle);
        let reflected = reflected * light.radiance;
        if reflected == Rgb::ZERO {
            self.probe.skip(Counter::ShadowRaysNothingToReflect, is_visible);
            return Rgb::ZERO;
        }
        let visible = is_visible();
        self.probe.tell(|| format!("light along {}: {reflected}, visible: {visible}", light.wi));
        match (visible, self.settings.estimator) {
            (false, _) => Rgb::ZERO,
            (true, Estimator::Mis) if !light.is_delta => {
                let pdf = brdf.pdf(Density::Cosine, light.wi);
                reflected * self.settings.heuristic.weight(light.pdf_solid_angle, pdf)
            }
            (true, _) => reflected,
        }
    }

    /// V, by a shadow ray. One that ends does not pass through the walls around the scene, nor through
    /// its only lamp, and need not look for them.
    fn is_visible(&self, shadow_ray: &Ray) -> bool {
        self.probe.count(Counter::ShadowRays, 1);
        let ends = shadow_ray.extent.max < f32::INFINITY;
        match &self.between {
            Some(between) if ends && self.probe.skips(Counter::WallsLeftOut) => {
                self.probe.count(Counter::WallsLeftOut, 1);
                !between.occluded(shadow_ray)
            }
            _ => !self.geometry.occluded(shadow_ray),
        }
    }

    /// w_s of light that the path has run into. `pdf` is the density with which light sampling would
    /// have drawn it; what it could not draw counts in full.
    fn weight_of_meeting(
        &self,
        last: Option<Scattering>,
        pdf: impl FnOnce(&Scattering) -> f32,
    ) -> f32 {
        match (self.settings.estimator, last) {
            (Estimator::Scatter, _) | (_, None) => 1.0,
            (Estimator::Light, Some(_)) => 0.0,
            (Estimator::Mis, Some(last)) => {
                self.settings.heuristic.weight(last.pdf_solid_angle, pdf(&last))
            }
        }
    }
    // ANCHOR_END: incident_radiance

    /// Casts no shadow ray where no direction toward a light has been drawn that it could follow.
    /// Under `--no-skip`, it leads to the middle of a light.
    fn skip_shadow_ray(&self, counter: Counter, surface: &SurfacePoint, sampler: &Sampler) {
        if self.settings.estimator != Estimator::Scatter {
            self.probe.skip(counter, || {
                let ray = self.lights.ray_toward_any(surface, &mut sampler.clone())?;
                Some(self.is_visible(&ray))
            });
        }
    }

    /// The shadow ray and the next ray of a path that goes on, for nothing, where the surface is
    /// black.
    fn go_on(
        &self,
        surface: &SurfacePoint,
        brdf: &Brdf,
        mut sampler: Sampler,
    ) -> (Option<Rgb>, Option<Hit>) {
        let asks = self.settings.estimator != Estimator::Scatter;
        let light = asks.then(|| self.light_from_lamps(surface, brdf, &mut sampler));
        let hit = brdf.sample(Density::Cosine, &mut sampler).and_then(|scattered| {
            self.probe.count(Counter::ScatterRays, 1);
            self.geometry.intersect(&surface.spawn(scattered.wi))
        });
        (light, hit)
    }
}
