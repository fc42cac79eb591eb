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

/// One path; `add` is told of each contribution, and of the number of events before it.
pub(crate) fn follow(
    scene: &Scene,
    mistake: Mistake,
    density: Density,
    ending: Ending,
    mut ray: Ray,
    sampler: &mut Sampler,
    mut add: impl FnMut(u32, Rgb),
) {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let materials = Materials::new(scene, &[]);
    let mut throughput = Rgb::ONE;
    for events in 0..=ending.depth {
        let Some(hit) = geometry.intersect(&ray) else {
            return add(events, throughput * scene.background);
        };
        let surface = scene.surface(&ray, &hit);
        let emitted = materials.emitted(&surface);
        add(events, throughput * emitted);
        if events == ending.depth || mistake == Mistake::LampsOnlyShine && emitted != Rgb::ZERO {
            return;
        }
        let &Material::Matte { kd, map_kd, lobe } = materials.at(&surface) else { return };
        let brdf = materials.brdf(&surface, kd, map_kd, lobe);
        if brdf.is_black() {
            return;
        }
        let Some(scattered) = brdf.sample(density, sampler) else { return };
        throughput *= match mistake {
            Mistake::NoCosine => brdf.eval(scattered.wi) / scattered.pdf_solid_angle,
            Mistake::NoDensity => brdf.eval(scattered.wi) * brdf.cos_theta(scattered.wi),
            Mistake::OnePercent => scattered.weight * 1.01,
            _ => scattered.weight,
        };
        ray = surface.spawn(scattered.wi);

        let q = ending.roulette.survival(throughput, events + 1);
        if q < 1.0 {
            if sampler.next_1d() >= q {
                return;
            }
            throughput /= match mistake {
                Mistake::NeverDivides => 1.0,
                Mistake::DividesTwice => q * q,
                _ => q,
            };
        }
    }
}

/// The sum of all contributions of one path.
pub(crate) fn radiance(
    scene: &Scene,
    mistake: Mistake,
    density: Density,
    ending: Ending,
    ray: Ray,
    sampler: &mut Sampler,
) -> Rgb {
    let mut sum = Rgb::ZERO;
    follow(scene, mistake, density, ending, ray, sampler, |_, part| sum += part);
    sum
}
