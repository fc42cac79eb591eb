//! Renders that stop when they are good enough.

use crate::scenes::{ROULETTE, asset, matte, room, scene};
use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::PathTracer;
use ray_casting::{LinearSearch, Scene};
use rendering_equation::{Density, Opaque};
use statistics::{TEST_ALPHA, binomial_at_least, seed};
use workbench::{Estimate, FilmSettings, Unwatched, expose, expose_until};

const SIZE: [u32; 2] = [6, 6];

/// The picture that `--error` renders with this seed.
fn render(scene: &Scene, error: f64, seed: u64) -> Estimate {
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(scene, &[], &geometry, &Unwatched, Density::Cosine, ROULETTE);
    let settings = FilmSettings { size: SIZE, samples: u32::MAX, seed, threads: None };
    expose_until(&settings, error, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

/// The Cornell box to 50 %, with 150 seeds, against a picture of more than ten times as many paths
/// as each of them. If the true error exceeded the stated one in 5 % of all renders,
/// there would be 7.5 ± 2.7 of them here; so many more that chance explains it once in 10⁵ times
/// are a failure. The mean error without the margin would be one: half of all renders exceed it.
#[test]
fn the_true_error_is_below_the_stated_one_in_95_of_100_renders() {
    const RENDERS: u64 = 150;
    let scene = asset("cornell-box");
    let truth = {
        let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
        let tracer: PathTracer<'_, _, _, Opaque> =
            PathTracer::new(&scene, &[], &geometry, &Unwatched, Density::Cosine, ROULETTE);
        let settings = FilmSettings { size: SIZE, samples: 12_000, seed: seed(1), threads: None };
        expose(&settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
    };
    let [mut beyond, mut beyond_the_mean] = [0, 0];
    let mut samples = 0.0;
    for i in 0..RENDERS {
        let estimate = render(&scene, 0.5, seed(1000 + i));
        let stated = estimate.relative_error();
        assert!(stated <= 0.5, "seed {i} stopped at {stated}");
        let true_error = estimate.image.rel_mse(&truth);
        beyond += u64::from(true_error > stated * stated);
        beyond_the_mean += u64::from(true_error > estimate.rel_mse());
        samples += f64::from(estimate.samples) / RENDERS as f64;
    }
    let by_chance = |beyond| binomial_at_least(beyond, RENDERS, 0.05);
    let p = by_chance(beyond);
    assert!(p >= TEST_ALPHA, "beyond the stated error in {beyond} of {RENDERS}: p = {p:e}");
    let p = by_chance(beyond_the_mean);
    assert!(
        p < TEST_ALPHA,
        "beyond the mean error in {beyond_the_mean}: p = {p}, so what is tested?"
    );
    assert!(samples < 1_000.0, "{samples} samples: the truth is not much better than that");
}

/// A furnace has no variance: every sample is the same to the last bit, so the error is 0, and the
/// first look at it ends the render.
#[test]
fn a_furnace_stops_at_once_without_an_error() {
    let scene = scene(0.0, &(matte("all", 0.5, 1.0) + &room("all")));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let tracer: PathTracer<'_, _, _, Opaque> = PathTracer::new(
        &scene,
        &[],
        &geometry,
        &Unwatched,
        Density::Cosine,
        crate::scenes::depth(24),
    );
    let settings = FilmSettings { size: [16, 16], samples: u32::MAX, seed: 0, threads: None };
    let estimate = expose_until(&settings, 0.001, |point, s| {
        tracer.incident_radiance(scene.camera.ray(point), s)
    });
    assert_eq!(estimate.samples, 16, "samples");
    assert_eq!(estimate.relative_error(), 0.0, "the error");
}
