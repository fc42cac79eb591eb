//! When to end a path: several policies at the same scene, by what a ray earns.

use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::{Intersect, Ray, Rgb, Scene};
use rendering_equation::{Density, Material, Materials};
use std::sync::atomic::{AtomicU64, Ordering};
use workbench::{Sampler, Unwatched, expose_estimate};

use super::rooms::closed_box;
use super::stage::{scene, settings};
use crate::figures::Drawing;
use crate::table::Table;

/// The probability to go on, for a throughput and a number of events.
type Policy = fn(f32, u32) -> f32;

const POLICIES: &[(&str, Policy)] = &[
    ("none, depth 16", |_, events| if events < 17 { 1.0 } else { 0.0 }),
    ("q = 0.5", |_, _| 0.5),
    ("q = 0.7", |_, _| 0.7),
    ("q = 0.9", |_, _| 0.9),
    ("q = β", |throughput, _| throughput.min(1.0)),
    ("stake 0.6", |throughput, _| (throughput / 0.6).min(1.0)),
    ("stake 0.3, the stage's", |throughput, _| (throughput / 0.3).min(1.0)),
    ("stake 0.1", |throughput, _| (throughput / 0.1).min(1.0)),
    ("stake 0.03", |throughput, _| (throughput / 0.03).min(1.0)),
];

/// The loop of the chapter for matte scenes, under another policy; returns the rays, too.
fn path<G: Intersect>(
    scene: &Scene,
    materials: &Materials<'_>,
    geometry: &G,
    policy: Policy,
    mut ray: Ray,
    sampler: &mut Sampler,
) -> (Rgb, u64) {
    let (mut radiance, mut throughput) = (Rgb::ZERO, Rgb::ONE);
    for events in 1..1000 {
        let Some(hit) = geometry.intersect(&ray) else {
            return (radiance + throughput * scene.background, events);
        };
        let surface = scene.surface(&ray, &hit);
        radiance += throughput * materials.emitted(&surface);
        let Material::Matte { kd, map_kd, lobe } = materials.at(&surface) else { break };
        let brdf = materials.brdf(&surface, kd, map_kd, lobe);
        let scattered = (!brdf.is_black()).then(|| brdf.sample(Density::Cosine, sampler)).flatten();
        let Some(scattered) = scattered else { return (radiance, events) };
        throughput *= scattered.weight;
        ray = surface.spawn(scattered.wi);
        let q = policy(throughput.max_element(), events as u32);
        if q < 1.0 {
            if sampler.next_1d() >= q {
                return (radiance, events);
            }
            throughput /= q;
        }
    }
    (radiance, 1000)
}

/// Rays a path, and the relMSE of one path a pixel.
fn measured(scene: &Scene, policy: Policy, samples: u32) -> [f64; 2] {
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let materials = Materials::new(scene, &[]);
    let rays = AtomicU64::new(0);
    let settings = settings([24, 24], samples);
    let estimate = expose_estimate(&settings, |point, sampler| {
        let ray = scene.camera.ray(point);
        let (radiance, count) = path(scene, &materials, &geometry, policy, ray, sampler);
        rays.fetch_add(count, Ordering::Relaxed);
        radiance
    });
    let paths = f64::from(samples) * 24.0 * 24.0;
    [rays.into_inner() as f64 / paths, estimate.rel_mse() * f64::from(samples)]
}

pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "policy",
        "rays a path",
        "noise of a path",
        "`cornell-box`: gain",
        "rays a path",
        "noise of a path",
        "closed: gain",
    ]);
    let scenes = [(scene("cornell-box"), 640), (closed_box(), 160)];
    let row = |policy| scenes.each_ref().map(|(scene, samples)| measured(scene, policy, *samples));
    let base = row(|_, events| if events < 17 { 1.0 } else { 0.0 });
    for (name, policy) in POLICIES {
        let results = row(*policy);
        let mut cells = vec![(*name).to_owned()];
        for ([rays, error], [base_rays, base_error]) in results.into_iter().zip(base) {
            cells.push(format!("{rays:.2}"));
            cells.push(format!("{:.2}", error.sqrt()));
            cells.push(format!("{:.2}", base_rays * base_error / (rays * error)));
        }
        table.row(cells);
    }
    table.into()
}
