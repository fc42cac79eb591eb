//! The error that a picture states of itself, against the true one, over many seeds.
//!
//! The "renderers" are random numbers with a known mean, so that the true error is known too.
//! Each case is rendered with 400 seeds. If the true error exceeded the stated one in 5 % of them,
//! there would be 20 ± 4.4 such seeds; 34 are allowed, so the false-alarm rate of a case is 0.1 %.
//! A share of 12 % is noticed with a probability of 98 %.

use std::sync::atomic::{AtomicU32, Ordering};

use workbench::{Estimate, FilmPoint, FilmSettings, Image, Sampler, expose, expose_until};

const SEEDS: u64 = 400;
const ALLOWED: u32 = 34;

/// A renderer whose pixels have the means that `mean` tells, times a factor with the mean 1.
struct Case {
    name: &'static str,
    size: [u32; 2],
    /// What `--error` asks for, a fraction of 1.
    error: f64,
    mean: fn(FilmPoint) -> [f32; 3],
    factor: fn(FilmPoint, &mut Sampler) -> f32,
}

const CASES: [Case; 7] = [
    Case { name: "uniform", size: [8, 8], error: 0.05, mean: white, factor: uniform },
    Case { name: "exponential", size: [8, 8], error: 0.1, mean: colours, factor: exponential },
    Case { name: "rare", size: [8, 8], error: 0.2, mean: colours, factor: rare },
    Case { name: "caustic", size: [16, 16], error: 0.7, mean: white, factor: caustic },
    Case { name: "two noisy pixels", size: [16, 16], error: 0.05, mean: white, factor: noisy },
    Case { name: "a noisy half", size: [16, 16], error: 0.1, mean: white, factor: half_rare },
    Case { name: "one pixel", size: [1, 1], error: 0.03, mean: white, factor: exponential },
];

fn white(_: FilmPoint) -> [f32; 3] {
    [1.0; 3]
}

/// Means from 0.02 to 1.5, different in every pixel and channel.
fn colours(point: FilmPoint) -> [f32; 3] {
    let (x, y) = (point.x.floor(), point.y.floor());
    [0.05 + 0.2 * x, 0.4 + 0.1 * y, 0.02 + 0.01 * x * y]
}

fn uniform(_: FilmPoint, sampler: &mut Sampler) -> f32 {
    2.0 * sampler.next_1d()
}

fn exponential(_: FilmPoint, sampler: &mut Sampler) -> f32 {
    -libm::logf(1.0 - sampler.next_1d())
}

/// One path in twenty finds the lamp.
fn rare(_: FilmPoint, sampler: &mut Sampler) -> f32 {
    if sampler.next_1d() < 0.05 { 20.0 } else { 0.0 }
}

/// An even ground, and one sample in 500 is 125 times as bright: 0.998 · 0.8 + 0.002 · 100.8 = 1.
fn caustic(_: FilmPoint, sampler: &mut Sampler) -> f32 {
    if sampler.next_1d() < 0.002 { 100.8 } else { 0.8 }
}

fn noisy(point: FilmPoint, sampler: &mut Sampler) -> f32 {
    if point.x < 1.0 && point.y < 2.0 { exponential(point, sampler) } else { 1.0 }
}

/// On the left, samples hardly differ: there samples are saved, and on the right they are taken.
fn half_rare(point: FilmPoint, sampler: &mut Sampler) -> f32 {
    if point.x < 8.0 { 0.8 + 0.2 * uniform(point, sampler) } else { rare(point, sampler) }
}

impl Case {
    fn settings(&self, seed: u64) -> FilmSettings {
        FilmSettings { size: self.size, samples: u32::MAX, seed, threads: None }
    }

    fn radiance(&self, point: FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
        let factor = (self.factor)(point, sampler);
        (self.mean)(point).map(|mean| mean * factor)
    }

    fn render(&self, seed: u64) -> Estimate {
        expose_until(&self.settings(seed), self.error, |p, s| self.radiance(p, s))
    }

    fn truth(&self) -> Image {
        let settings = FilmSettings { samples: 1, ..self.settings(0) };
        expose(&settings, |point, _| (self.mean)(point))
    }
}

/// In how many of the seeds the true relMSE exceeds what each of `stated` states.
fn misses<const N: usize>(case: &Case, stated: impl Fn(&Estimate) -> [f64; N]) -> [u32; N] {
    let truth = case.truth();
    let mut misses = [0; N];
    for seed in 0..SEEDS {
        let estimate = case.render(seed);
        let error = estimate.image.rel_mse(&truth);
        assert!(error.is_finite(), "{}, seed {seed}: the true error is {error}", case.name);
        for (misses, stated) in misses.iter_mut().zip(stated(&estimate)) {
            // A stated NaN is a miss.
            *misses += u32::from(stated.is_nan() || error > stated);
        }
    }
    misses
}

fn squared(error: f64) -> f64 {
    error * error
}

#[test]
fn the_true_error_is_below_the_stated_one_in_95_of_100_seeds() {
    for case in &CASES {
        let [misses] = misses(case, |estimate| {
            let stated = estimate.relative_error();
            assert!(stated <= case.error, "{}: stopped at {stated}", case.name);
            [squared(stated)]
        });
        assert!(misses <= ALLOWED, "{}: above the bound in {misses} of {SEEDS}", case.name);
    }
}

/// The test above would find each of these mistakes in the case that it is made for.
#[test]
fn planted_mistakes_are_found() {
    let mistakes = |case| {
        misses(case, |estimate| {
            let twice = squared(estimate.relative_error()) / f64::from(estimate.samples);
            [estimate.rel_mse(), twice, with_means_of_the_same_samples(estimate)]
        })
    };
    let [no_margin, divided_twice, _] = mistakes(&CASES[0]);
    assert!(no_margin > ALLOWED, "without the margin: {no_margin} misses");
    assert!(divided_twice > ALLOWED, "divided by n twice: {divided_twice} misses");
    let [_, divided_twice, same] = mistakes(&CASES[3]);
    assert!(divided_twice > ALLOWED, "divided by n twice: {divided_twice} misses");
    assert!(same > ALLOWED, "with means of the same samples: {same} misses");
}

/// The bound as it would be if each pixel's variance were divided by the brightness that the same
/// samples have.
fn with_means_of_the_same_samples(estimate: &Estimate) -> f64 {
    let pixels = estimate.image.pixels.iter().zip(&estimate.variance_of_mean.pixels);
    let variances = pixels.map(|(mean, variance)| {
        let channel = |c: usize| f64::from(variance[c]) / (squared(f64::from(mean[c])) + 0.01);
        (channel(0) + channel(1) + channel(2)) / 3.0
    });
    let (sum, squares) = variances.fold((0.0, 0.0), |(sum, squares), v| (sum + v, squares + v * v));
    (sum + 2.0 * f64::sqrt(2.0 * squares)) / estimate.image.pixels.len() as f64
}

/// The end of a render depends on its samples. If that favoured dark pictures, the mean over the
/// seeds would be too dark. Compared within 4 standard errors, a false alarm of 0.006 % a case. A
/// bias of 8 standard errors, at most 1.5 % of the mean, is seen with the same certainty.
#[test]
fn stopping_does_not_darken_the_picture() {
    for case in &CASES {
        let truth = case.truth().mean()[0];
        let mut deviations: Vec<f64> =
            (0..SEEDS).map(|seed| case.render(seed).image.mean()[0] / truth - 1.0).collect();
        let bias = deviations.iter().sum::<f64>() / SEEDS as f64;
        for deviation in &mut deviations {
            *deviation = squared(*deviation - bias);
        }
        let variance = deviations.iter().sum::<f64>() / (SEEDS - 1) as f64;
        let limit = 4.0 * f64::sqrt(variance / SEEDS as f64);
        assert!(bias.abs() <= limit, "{}: bias {bias}, limit {limit}", case.name);
        // The test is worth something only if it can see a bias of 1.5 %.
        assert!(limit < 0.0075, "{}: limit {limit}", case.name);
    }
}

/// Pixels that stop by their own estimate are too dark: the reason why none has a say in its number.
#[test]
fn stopping_each_pixel_for_itself_would_darken_it() {
    let mut sum = 0.0;
    let pixels: u32 = 4000;
    for pixel in 0..pixels {
        let bright = |samples: std::ops::Range<u64>| {
            let lit = samples
                .filter(|&sample| Sampler::new(1, u64::from(pixel), sample).next_1d() < 0.05);
            lit.count() as f64
        };
        let first = bright(0..64);
        // 3.2 bright samples are expected. With two or fewer the variance looks small, too.
        sum += if first <= 2.0 { first / 64.0 } else { (first + bright(64..640)) / 640.0 };
    }
    let mean = 20.0 * sum / f64::from(pixels);
    assert!(mean < 0.95, "the mean is {mean} of 1");
}

#[test]
fn the_picture_is_the_same_for_any_number_of_threads() {
    for case in &CASES[1..4] {
        let rendered = [Some(1), Some(2), Some(5), None].map(|threads| {
            let settings = FilmSettings { threads, ..case.settings(7) };
            let estimate = expose_until(&settings, case.error, |p, s| case.radiance(p, s));
            (estimate.samples, estimate.image.hash(), estimate.relative_error().to_bits())
        });
        assert_eq!(rendered, [rendered[0]; 4], "{} with 1, 2, 5 and all threads", case.name);
    }
}

#[test]
fn each_pixel_is_that_of_as_many_samples() {
    for case in [&CASES[1], &CASES[5]] {
        let estimate = case.render(3);
        let of = |samples| {
            let settings = FilmSettings { samples, ..case.settings(3) };
            expose(&settings, |point, sampler| case.radiance(point, sampler))
        };
        let mut counts = estimate.counts.clone();
        counts.sort_unstable();
        counts.dedup();
        assert!(counts.len() > 1, "{}: all pixels hold {counts:?}", case.name);
        for count in counts {
            let image = of(count);
            for (i, _) in estimate.counts.iter().enumerate().filter(|(_, held)| **held == count) {
                let [held, alone] = [&estimate.image, &image].map(|image| image.pixels[i]);
                assert_eq!(held, alone, "{}: pixel {i} of {count} samples", case.name);
            }
        }
    }
}

/// The variance of one sample is 0.013 on the left and 19 on the right: samples should be as the
/// roots, 1 to 38, but half of them are taken by all pixels alike.
#[test]
fn samples_go_where_they_are_needed() {
    let case = &CASES[5];
    let estimate = case.render(0);
    let [mut quiet, mut noisy] = [Vec::new(), Vec::new()];
    for (i, &count) in estimate.counts.iter().enumerate() {
        match i % 16 {
            0..6 => quiet.push(count),
            10.. => noisy.push(count),
            _ => {}
        }
    }
    let all: u32 = estimate.counts.iter().sum();
    let average = all as f32 / 256.0;
    let mean = |counts: &[u32]| counts.iter().sum::<u32>() as f32 / counts.len() as f32;
    let [quiet, noisy] = [quiet, noisy].map(|counts| mean(&counts) / average);
    assert!((0.49..0.56).contains(&quiet), "{quiet} times the average where it is quiet");
    assert!((1.4..1.6).contains(&noisy), "{noisy} times the average where it is noisy");
    let fewest = estimate.counts.iter().min();
    assert_eq!(fewest, Some(&estimate.samples), "the fewest samples");
    assert!(f64::from(estimate.samples) >= 0.49 * f64::from(average), "fewest of {average}");
}

/// A furnace with cosine-weighted directions is such a picture.
#[test]
fn samples_that_agree_are_not_repeated() {
    let settings = FilmSettings { size: [64, 48], samples: u32::MAX, seed: 0, threads: None };
    let calls = AtomicU32::new(0);
    let estimate = expose_until(&settings, 1e-6, |point, _| {
        calls.fetch_add(1, Ordering::Relaxed);
        [1.0 / 3.0, point.x.floor(), 0.0]
    });
    assert_eq!((estimate.samples, estimate.relative_error()), (16, 0.0), "samples and error");
    assert_eq!(estimate.variance_of_mean.max(), [0.0; 3], "the largest variance");
    assert_eq!(calls.into_inner(), 64 * 48 * 16, "calls");
}

#[test]
fn the_samples_may_come_first() {
    let case = &CASES[1];
    let settings = FilmSettings { samples: 27, ..case.settings(0) };
    let estimate = expose_until(&settings, 1e-3, |point, sampler| case.radiance(point, sampler));
    assert_eq!(estimate.samples, 27, "samples");
    assert!(estimate.relative_error() > 1e-3, "the error is {}", estimate.relative_error());
}

#[test]
fn a_sample_that_is_not_finite_is_seen_by_every_number() {
    let settings = FilmSettings { size: [9, 9], samples: 64, seed: 0, threads: None };
    let estimate = expose_until(&settings, 0.5, |point, sampler| {
        let u = sampler.next_1d();
        [if point.x < 1.0 && point.y < 1.0 && u < 0.5 { f32::NAN } else { u }; 3]
    });
    let [first, second] = [0, 1].map(|x| estimate.variance_of_mean.pixel(x, 0)[0]);
    assert!(first.is_nan() && second.is_finite(), "variances {first}, {second}");
    assert!(estimate.image.pixel(0, 0)[0].is_nan(), "the pixel");
    assert!(estimate.relative_error().is_nan() && estimate.rel_mse().is_nan(), "{estimate:?}");
}
