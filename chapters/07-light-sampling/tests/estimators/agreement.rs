//! Pictures of the course's scenes: the estimators agree wherever each of them can see the light.

use light_sampling::Estimator;
use path_tracing::PathTracer;
use ray_casting::{LinearSearch, Scene};
use rendering_equation::{Anything, Density, Opaque};
use statistics::{Criterion, Noisy, assert_images, compare_images, seed};
use workbench::{Estimate, FilmSettings, Unwatched, expose_estimate};

use crate::scenes::{ESTIMATORS, asset, endless, limited, picture};

const SIZE: [u32; 2] = [24, 24];

fn film(samples: u32, seed: u64) -> FilmSettings {
    FilmSettings { size: SIZE, samples, seed, threads: None }
}

fn noisy(estimate: &Estimate) -> Noisy<'_> {
    Noisy {
        mean: &estimate.image.pixels,
        variance: &estimate.variance_of_mean.pixels,
        samples: estimate.samples,
    }
}

/// 8 × 8 blocks, as accuracy.md I1 asks.
const BLOCKS: Criterion = Criterion { block: 8, ..Criterion::SUITE };

fn assert_agreement(name: &str, pictures: &[(Estimator, Estimate)]) {
    let size = SIZE.map(|n| n as usize);
    for (i, (first, a)) in pictures.iter().enumerate() {
        for (second, b) in &pictures[..i] {
            let name = format!("{name}, {first:?} and {second:?}");
            let agreement = assert_images(&name, size, &noisy(a), &noisy(b), &BLOCKS);
            let bias = agreement.visible_bias;
            // Chance meets a small lamp so rarely that it is not a sharp judge of the others.
            let by_chance = *first == Estimator::Scatter || *second == Estimator::Scatter;
            let visible = if by_chance { 0.2 } else { 0.1 };
            assert!(bias <= visible, "{name}: only a bias of {bias} would be seen");
        }
    }
}

/// With several times as many samples by chance alone, whose noise is several times as large.
fn assert_all_agree(name: &str, samples: [u32; 3]) {
    let scene = asset(name);
    let numbered = ESTIMATORS.into_iter().zip(samples).zip(1_u64..);
    let pictures = numbered.map(|((estimator, samples), i)| {
        (estimator, picture::<Anything>(&scene, endless(estimator), &film(samples, seed(i))))
    });
    assert_agreement(name, &pictures.collect::<Vec<_>>());
}

#[test]
fn in_the_cornell_box() {
    assert_all_agree("cornell-box", [2000, 500, 500]);
}

#[test]
fn in_the_cornell_box_with_spheres() {
    assert_all_agree("cornell-spheres", [2000, 1000, 1000]);
}

#[test]
fn under_many_lights() {
    assert_all_agree("many-lights", [2000, 100, 100]);
}

#[test]
fn in_the_furnace() {
    assert_all_agree("furnace", [64, 64, 64]);
}

/// Random directions do not hit point lights; the two that ask the lamps must agree.
#[test]
fn under_point_lights_and_a_sky() {
    for name in ["whitted", "nested-glass", "touching-glass", "glass-slab", "two-mirrors"] {
        let scene = asset(name);
        let pictures = [(Estimator::Light, 11), (Estimator::Mis, 12)].map(|(estimator, s)| {
            (estimator, picture::<Anything>(&scene, endless(estimator), &film(300, seed(s))))
        });
        assert_agreement(name, &pictures);
    }
}

/// The blocks must see what they are there to see.
#[test]
fn a_lamp_that_is_a_tenth_brighter_is_noticed_in_the_cornell_box() {
    let mut scene = asset("cornell-box");
    let settings = limited(Estimator::Mis, 8);
    let right = picture::<Anything>(&scene, settings, &film(300, seed(21)));
    for material in &mut scene.materials {
        material.ke = material.ke.map(|ke| 1.1 * ke);
    }
    let brighter = picture::<Anything>(&scene, settings, &film(300, seed(22)));
    let size = SIZE.map(|n| n as usize);
    let result = compare_images("10 % more", size, &noisy(&brighter), &noisy(&right), &BLOCKS);
    assert!(result.is_err(), "10 % passes: {result:?}");
}

/// What only chance may find is found as in chapter 6, with the same random numbers.
#[test]
fn by_chance_alone_the_picture_is_that_of_chapter_6_to_the_bit() {
    for name in ["cornell-box", "cornell-spheres", "furnace", "nested-glass", "two-mirrors"] {
        let scene = asset(name);
        let settings = endless(Estimator::Scatter);
        let got = picture::<Anything>(&scene, settings, &film(4, 3)).image;
        let expected = by_chance(&scene, settings.ending, &film(4, 3)).image;
        assert_eq!(got.hash(), expected.hash(), "{name}: {:?}, {:?}", got.mean(), expected.mean());
    }
}

fn by_chance(scene: &Scene, ending: path_tracing::Ending, film: &FilmSettings) -> Estimate {
    let pictures = blinn_phong::Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &pictures, &geometry, &Unwatched, Density::Cosine, ending);
    expose_estimate(film, |point, sampler| {
        tracer.incident_radiance(scene.camera.ray(point), sampler)
    })
}

#[test]
fn without_glass_the_code_without_glass_gives_the_same_bits() {
    for name in ["cornell-box", "many-lights", "furnace", "two-mirrors"] {
        let scene = asset(name);
        for estimator in ESTIMATORS {
            let with = picture::<Anything>(&scene, endless(estimator), &film(4, 5)).image;
            let without = picture::<Opaque>(&scene, endless(estimator), &film(4, 5)).image;
            assert_eq!(with.hash(), without.hash(), "{name}, {estimator:?}");
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    for name in ["cornell-spheres", "many-lights"] {
        let scene = asset(name);
        for estimator in ESTIMATORS {
            let hashes = [1, 2, 5].map(|threads| {
                let film = FilmSettings { threads: Some(threads), ..film(4, 6) };
                picture::<Anything>(&scene, endless(estimator), &film).image.hash()
            });
            let same = hashes.iter().all(|hash| *hash == hashes[0]);
            assert!(same, "{name}, {estimator:?}, 1, 2, 5 threads: {hashes:x?}");
        }
    }
}
