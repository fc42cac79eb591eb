//! What chapter 5 measures: what a second of rendering brings, for several N.

use std::hint::black_box;
use std::time::Instant;

use bv_tree::{Aabb, Builder, BvTree};
use rendering_equation::{Density, DistributedTracer, Opaque};
use workbench::{FilmSettings, Unwatched, expose};

use super::Measurement;
use crate::figures::Drawing;
use crate::figures::rendering_equation::explosion::{CURVES, DEPTH, SIZE, curves, plot, prices};
use crate::figures::rendering_equation::stage::{branching, scene};
use crate::table::Table;

pub(super) const MEASUREMENTS: &[Measurement] = &[
    Measurement { file: "05-rendering-equation/errors-time.svg", take: errors },
    Measurement { file: "05-rendering-equation/branching.md", take: table },
];

/// How often each N runs, in turn with the others.
const ROUNDS: usize = 101;

/// The time of one sample a pixel for each N of [`CURVES`], on one thread, in terms of N = 1: the
/// median over the rounds of the ratio within a round, so that what slows the machine down for
/// longer than a round does not count.
fn times() -> [f64; CURVES.len()] {
    let scene = scene("cornell-box");
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let seconds = |directions: u32, seed: u64| {
        // About as many rays for each.
        let samples = (64 / directions.pow(2)).max(1);
        let film = FilmSettings { size: SIZE, samples, seed, threads: Some(1) };
        let branching = branching(directions, DEPTH, Density::Cosine);
        let tracer: DistributedTracer<'_, _, _, Opaque> =
            DistributedTracer::new(&scene, &[], &tree, &Unwatched, branching);
        let start = Instant::now();
        black_box(expose(&film, |point, sampler| {
            tracer.incident_radiance(scene.camera.ray(point), sampler)
        }));
        start.elapsed().as_secs_f64() / f64::from(samples)
    };
    let rounds: Vec<[f64; CURVES.len()]> = (0..ROUNDS as u64)
        .map(|round| {
            let seconds = CURVES.map(|(directions, _)| seconds(directions, round));
            seconds.map(|s| s / seconds[ONE])
        })
        .collect();
    std::array::from_fn(|i| {
        let mut ratios: Vec<f64> = rounds.iter().map(|ratios| ratios[i]).collect();
        ratios.sort_by(f64::total_cmp);
        ratios[ROUNDS / 2]
    })
}

/// The last of [`CURVES`], in whose terms the others are said.
const ONE: usize = CURVES.len() - 1;

/// Errors against time; 1 is one path a pixel with N = 1.
fn errors() -> Drawing {
    let times = times();
    let series = curves(&prices(), |i, _, samples| f64::from(samples) * times[i]);
    plot("time / one path a pixel with N = 1", series).into()
}

/// What a sample costs, and how long the same error takes, in terms of N = 1.
fn table() -> Drawing {
    // The last point of each curve has the most samples.
    let prices = prices().map(|prices| prices[prices.len() - 1]);
    let mut table = Table::new(&[
        "$N$",
        "rays a sample",
        "time a sample",
        "time a ray",
        "rays for the same error",
        "time for the same error",
    ]);
    let one = prices[ONE];
    for (((n, _), price), time) in CURVES.iter().zip(&prices).zip(times()).rev() {
        let rays = price.rays / one.rays;
        let variance = price.rel_mse / one.rel_mse;
        table.row([
            n.to_string(),
            format!("{:.1}", price.rays),
            format!("{time:.2}"),
            format!("{:.2}", time / rays),
            // The variance is uncertain by about a tenth.
            format!("{:.1}", rays * variance),
            format!("{:.1}", time * variance),
        ]);
    }
    table.into()
}
