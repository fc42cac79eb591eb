//! The path's loop for matte scenes, with one mistake at a time.
//!
//! Tests of means and variances are only worth what they would find: each mistake here is one that
//! real programs had.

use ray_casting::{Intersect, LinearSearch, Ray, Rgb, Scene};
use rendering_equation::{Density, Material, Materials};
use workbench::{Sampler, Unwatched};

use path_tracing::Ending;

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mistake {
    /// Nothing: the stage's loop.
    None,
    /// Survivors of roulette are divided by q twice.
    DividesTwice,
    /// They are not divided at all.
    NeverDivides,
    /// f / p, with the density cos θ / π: as if the cosine were in the density alone.
    NoCosine,
    /// f cos θ, without the density.
    NoDensity,
    /// Every event reflects one percent too much.
    OnePercent,
    /// A path ends at the first lamp, as in the review's listings.
    LampsOnlyShine,
}

/// The loop with that mistake.
pub(crate) struct Mistaken<'a> {
    scene: &'a Scene,
    geometry: LinearSearch<'a, Unwatched>,
    materials: Materials<'a>,
    mistake: Mistake,
    density: Density,
    ending: Ending,
}

impl<'a> Mistaken<'a> {
    pub(crate) fn new(
        scene: &'a Scene,
        mistake: Mistake,
        density: Density,
        ending: Ending,
    ) -> Self {
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        let materials = Materials::new(scene, &[]);
        Self { scene, geometry, materials, mistake, density, ending }
    }

    /// What one path finds.
    pub(crate) fn radiance(&self, ray: Ray, sampler: &mut Sampler) -> Rgb {
        let mut sum = Rgb::ZERO;
        self.follow(ray, sampler, |_, part| sum += part);
        sum
    }

    /// One path; `add` is told of each contribution, and of the number of events before it.
    pub(crate) fn follow(&self, mut ray: Ray, s: &mut Sampler, mut add: impl FnMut(u32, Rgb)) {
        let mut throughput = Rgb::ONE;
        for events in 0..=self.ending.depth {
            let Some(hit) = self.geometry.intersect(&ray) else {
                return add(events, throughput * self.scene.background);
            };
            let surface = self.scene.surface(&ray, &hit);
            let emitted = self.materials.emitted(&surface);
            add(events, throughput * emitted);
            let stops = self.mistake == Mistake::LampsOnlyShine && emitted != Rgb::ZERO;
            if events == self.ending.depth || stops {
                return;
            }
            let Material::Matte { kd, map_kd, lobe } = self.materials.at(&surface) else {
                return;
            };
            let brdf = self.materials.brdf(&surface, kd, map_kd, lobe);
            if brdf.is_black() {
                return;
            }
            let Some(scattered) = brdf.sample(self.density, s) else { return };
            throughput *= match self.mistake {
                Mistake::NoCosine => brdf.eval(scattered.wi) / scattered.pdf_solid_angle,
                Mistake::NoDensity => brdf.eval(scattered.wi) * brdf.cos_theta(scattered.wi),
                Mistake::OnePercent => scattered.weight * 1.01,
                _ => scattered.weight,
            };
            ray = surface.spawn(scattered.wi);

            let q = self.ending.roulette.survival(throughput, events + 1);
            if q < 1.0 {
                if s.next_1d() >= q {
                    return;
                }
                throughput /= match self.mistake {
                    Mistake::NeverDivides => 1.0,
                    Mistake::DividesTwice => q * q,
                    _ => q,
                };
            }
        }
    }
}
