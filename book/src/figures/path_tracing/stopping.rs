//! Renders that stop when they are good enough.

use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::PathTracer;
use ray_casting::Scene;
use rendering_equation::{Anything, Density};
use workbench::{Estimate, FilmSettings, Image, Unwatched, expose_until};

use super::rooms::closed_box;
use super::stage::{ROULETTE, draw, settings};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::table::{Table, count};

/// The picture that `--error` renders.
fn until(scene: &Scene, size: [u32; 2], error: f64, seed: u64) -> Estimate {
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &[], &geometry, &Unwatched, Density::Cosine, ROULETTE);
    let settings = FilmSettings { seed, ..settings(size, u32::MAX) };
    expose_until(&settings, error, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

fn truth(scene: &Scene, size: [u32; 2], samples: u32) -> Image {
    let settings = FilmSettings { seed: 1_000_000, ..settings(size, samples) };
    draw(scene, ROULETTE, &settings)
}

/// Errors that were asked for, stated and true.
pub(super) fn errors() -> Drawing {
    let mut table =
        Table::new(&["`--error`", "paths a pixel", "stated", "likely", "true", "paths in all"]);
    let scene = closed_box();
    let size = [24, 24];
    let truth = truth(&scene, size, 2_000);
    let percent = |error: f64| format!("{:.1} %", 100.0 * error);
    for error in [0.4, 0.2, 0.1, 0.07] {
        let estimate = until(&scene, size, error, 0);
        let all: u64 = estimate.counts.iter().map(|&count| u64::from(count)).sum();
        table.row([
            format!("{:.0} %", 100.0 * error),
            count(all / (24 * 24)),
            percent(estimate.relative_error()),
            percent(estimate.rel_mse().sqrt()),
            percent(estimate.image.rel_mse(&truth).sqrt()),
            count(all),
        ]);
    }
    table.into()
}

/// In how many of 200 renders the true error is below the stated one, and below the likely one.
pub(super) fn coverage() -> Drawing {
    const RENDERS: u64 = 200;
    let scene = closed_box();
    let size = [8, 8];
    let truth = truth(&scene, size, 6_000);
    let [mut stated, mut likely] = [0, 0];
    for seed in 0..RENDERS {
        let estimate = until(&scene, size, 0.2, seed);
        let error = estimate.image.rel_mse(&truth);
        stated += u64::from(error <= estimate.relative_error() * estimate.relative_error());
        likely += u64::from(error <= estimate.rel_mse());
    }
    let mut numbers = Numbers::new();
    let percent = |n: u64| format!("{:.1}", 100.0 * n as f64 / RENDERS as f64);
    numbers.add("renders", RENDERS);
    numbers.add("stated", percent(stated));
    numbers.add("likely", percent(likely));
    numbers.into()
}
