//! The same light, found in other ways.

use crate::scenes::{ROULETTE, asset, depth};
use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::Scene;
use rendering_equation::{Anything, Branching, Density, DistributedTracer, Opaque};
use statistics::{
    Criterion, Moments, Noisy, assert_images, assert_variance, check_variance, compare_images, seed,
};
use workbench::{Estimate, FilmSettings, Image, Unwatched, expose, expose_estimate};

const SIZE: [u32; 2] = [24, 24];

fn settings(samples: u32, seed: u64) -> FilmSettings {
    FilmSettings { size: SIZE, samples, seed, threads: None }
}

fn tree(scene: &Scene) -> BvTree<'_, Aabb, Unwatched> {
    BvTree::build(&scene.geometry, Builder::Sah, &Unwatched)
}

fn paths(scene: &Scene, ending: Ending, settings: &FilmSettings) -> Estimate {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = tree(scene);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &pictures, &geometry, &Unwatched, Density::Cosine, ending);
    expose_estimate(settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

fn trees(scene: &Scene, directions: u32, depth: u32, settings: &FilmSettings) -> Estimate {
    let pictures = Picture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = tree(scene);
    let branching = Branching { directions, depth, density: Density::Cosine };
    let tracer: DistributedTracer<'_, _, _, Anything> =
        DistributedTracer::new(scene, &pictures, &geometry, &Unwatched, branching);
    expose_estimate(settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

fn noisy(estimate: &Estimate) -> Noisy<'_> {
    Noisy {
        mean: &estimate.image.pixels,
        variance: &estimate.variance_of_mean.pixels,
        samples: estimate.samples,
    }
}

/// The Cornell box with a lamp as large as its ceiling, so that random directions find it often.
fn bright_box() -> Scene {
    let mut scene = asset("cornell-box");
    for material in &mut scene.materials {
        if material.name == "lamp" {
            material.kd = [0.5, 0.6, 0.4];
        }
    }
    let geometry = &mut scene.geometry;
    let lamp =
        scene.attributes.materials.iter().position(|&m| scene.materials[m as usize].ke[0] > 0.0);
    let lamp = lamp.expect("there is a lamp");
    for index in geometry.triangles[lamp].into_iter().chain(geometry.triangles[lamp + 1]) {
        let v = &mut geometry.vertices[index as usize];
        v.x = if v.x > 2.78 { 5.4 } else { 0.1 };
        v.z = if v.z > 2.78 { 5.4 } else { 0.1 };
    }
    scene
}

/// Stage 05 with N = 1 draws the same numbers for the same purposes, so it finds the same light:
/// a recursion and a loop differ by the rounding of their products.
#[test]
fn with_one_direction_chapter_5_follows_the_same_paths() {
    for name in ["cornell-box", "cornell-spheres", "teapot", "whitted", "nested-glass"] {
        let scene = asset(name);
        let tree = trees(&scene, 1, 6, &settings(8, 0));
        let path = paths(&scene, depth(6), &settings(8, 0));
        let pairs = tree.image.pixels.as_flattened().iter().zip(path.image.pixels.as_flattened());
        let worst = pairs.map(|(a, b)| (a - b).abs() / (a.abs() + 1e-3)).fold(0.0, f32::max);
        assert!(worst < 2e-5, "{name}: the pictures differ by {worst:e} of a value");
    }
}

/// Errata 18: one direction at each hit is no approximation. N = 1 and N = 2 have the same mean, in
/// every block of the picture.
#[test]
fn erratum_18_one_direction_and_two_have_the_same_mean() {
    let scene = bright_box();
    let path = paths(&scene, depth(4), &settings(512, seed(1)));
    let tree = trees(&scene, 2, 4, &settings(128, seed(2)));
    let size = SIZE.map(|n| n as usize);
    let criterion = Criterion { block: 8, ..Criterion::SUITE };
    let agreement = assert_images("N = 1, N = 2", size, &noisy(&path), &noisy(&tree), &criterion);
    assert!(agreement.visible_bias < 0.03, "{agreement:?}");

    let shallow = paths(&scene, depth(3), &settings(512, seed(3)));
    let wrong = compare_images("a bounce less", size, &noisy(&shallow), &noisy(&tree), &criterion);
    assert!(wrong.is_err(), "the bounce is not missed: {wrong:?}");
}

/// Roulette, of either kind, is no approximation either: it agrees with a depth at which nothing is
/// left to lose (0.725²⁴ < 0.0005).
#[test]
fn roulette_and_a_great_depth_have_the_same_mean() {
    let scene = bright_box();
    let deep = paths(&scene, depth(24), &settings(256, seed(4)));
    let size = SIZE.map(|n| n as usize);
    let criterion = Criterion { block: 8, ..Criterion::SUITE };
    for (i, roulette) in [Roulette::Throughput, Roulette::Constant(0.7)].into_iter().enumerate() {
        let ending = Ending { depth: u32::MAX, roulette };
        let played = paths(&scene, ending, &settings(512, seed(5 + i as u64)));
        let name = format!("{roulette:?}");
        let agreement = assert_images(&name, size, &noisy(&played), &noisy(&deep), &criterion);
        assert!(agreement.visible_bias < 0.03, "{name}: {agreement:?}");
    }
}

/// accuracy.md I7.
#[test]
fn the_number_of_threads_changes_no_bit() {
    let scene = asset("cornell-spheres");
    let hash = |threads| {
        let settings = FilmSettings { threads: Some(threads), ..settings(4, 0) };
        paths(&scene, ROULETTE, &settings).image.hash()
    };
    let hashes = [1, 2, 5].map(hash);
    assert!(hashes.iter().all(|&h| h == hashes[0]), "1, 2, 5 threads: {hashes:x?}");
}

/// What a scene does not need is left out of the code: that changes no bit.
#[test]
fn a_scene_without_glass_is_the_same_without_the_code_for_it() {
    for name in ["cornell-box", "furnace", "two-mirrors", "teapot"] {
        let scene = asset(name);
        let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
        let geometry = tree(&scene);
        let without: PathTracer<'_, _, _, Opaque> =
            PathTracer::new(&scene, &pictures, &geometry, &Unwatched, Density::Cosine, ROULETTE);
        let a: Image = expose(&settings(4, 0), |point, s| {
            without.incident_radiance(scene.camera.ray(point), s)
        });
        let b = paths(&scene, ROULETTE, &settings(4, 0)).image;
        assert_eq!(a.hash(), b.hash(), "{name}: mean {:?} for {:?}", a.mean(), b.mean());
    }
}

/// accuracy.md E16: 64 short renders, each with a seed of its own, scatter as much as each says.
#[test]
fn renders_with_different_seeds_are_independent() {
    let scene = bright_box();
    let mut means = Moments::new();
    let mut expected = Moments::new();
    for i in 0..64 {
        let estimate = paths(&scene, ROULETTE, &settings(8, seed(100 + i)));
        means.push(estimate.image.mean()[1]);
        let variances = estimate.variance_of_mean.pixels.iter().map(|v| f64::from(v[1]));
        let pixels = estimate.image.pixels.len() as f64;
        expected.push(variances.sum::<f64>() / (pixels * pixels));
    }
    assert_variance("the mean of a render", &means, expected.mean());
    // Samples that come in equal fours would make renders scatter four times as much.
    let wrong = check_variance("fours", &means, expected.mean() / 4.0);
    assert!(wrong.is_err(), "fours are not seen: {wrong:?}");
}
