//! Runs of a stage that estimates, from the command line to what is said and written.

use std::fs;
use std::time::{Duration, Instant};

use serde_json::Value;

use super::Run;
use crate::{
    Counter, Exposure, Film, FilmPoint, FilmSettings, NoExtra, Options, Sampler, Stage,
    StatsTarget, Unwatched, expose_until,
};

const STAGE: Stage =
    Stage { name: "stage", about: "", scene: "teapot", samples: 9, depth: None, estimates: true };

const EXPOSURE: Exposure = Exposure { size: [40, 30], samples: None };

fn noise(_: FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
    [sampler.next_1d(), 0.0, 1.0]
}

fn run_of(stage: &'static Stage, line: &'static str) -> Run<NoExtra> {
    let arguments = line.split_whitespace().map(Into::into);
    let options = Options::parse_for(stage, arguments);
    Run::new(stage, options.unwrap_or_else(|error| panic!("{line}: {error}")))
}

fn render(line: &'static str) -> (Run<NoExtra>, Film) {
    let run = run_of(&STAGE, line);
    let film = run.render(EXPOSURE, &Unwatched, noise);
    (run, film.unwrap_or_else(|error| panic!("{line}: {error}")))
}

/// Samples a pixel, rounded down.
fn average(film: &Film) -> u64 {
    film.total_samples() / (40 * 30)
}

#[test]
fn the_error_ends_the_render_and_stands_in_the_summary() {
    let (run, film) = render("stage --error 5%");
    let settings = FilmSettings { size: [40, 30], samples: u32::MAX, seed: 0, threads: None };
    let expected = expose_until(&settings, 0.05, noise);
    assert_eq!(film.image().hash(), expected.image.hash(), "the picture");
    assert_eq!(film.estimated_error(), Some(expected.relative_error()), "the error");
    let text = run.summary(&film, false);
    let samples = format!(" ({} to {}) samples", film.samples()[0], film.samples()[1]);
    let samples = format!("40×30 pixels, {}{samples} a pixel, estimated error 4.", average(&film));
    assert!(text.contains(&samples) && text.contains(" % (relMSE 2."), "no `{samples}` in: {text}");
    assert!(!text.contains("note:"), "{text}");
}

/// A quiet half and a noisy one.
fn half_noisy(point: FilmPoint, sampler: &mut Sampler) -> [f32; 3] {
    let u = sampler.next_1d();
    [if point.x < 20.0 {
        0.9 + 0.2 * u
    } else if u < 0.1 {
        10.0
    } else {
        0.0
    }; 3]
}

/// The variance of a sample is 1/300 and 9. For the same error, all alike need n = 4.5/relMSE
/// samples a pixel. If one half of n goes to all alike and the other to the noisy half, it is
/// 4.5/(3/2 n) = relMSE: a third is saved, and a little more by the stated errors, whose doubts
/// shrink as well.
#[test]
fn fewer_samples_do_where_some_pixels_are_quiet() {
    let of = |line| {
        let run = run_of(&STAGE, line);
        let film = run.render(EXPOSURE, run.recorder().expect("--stats"), half_noisy);
        let film = film.unwrap_or_else(|error| panic!("{line}: {error}"));
        let skipped = run.recorder().map(|recorder| recorder.get(Counter::SamplesNotNeeded));
        let error = film.estimated_error().expect("an error");
        assert!((0.05..=0.1).contains(&error), "{line}: stopped at {error}");
        (film.total_samples() as f64 * error * error, film.samples(), skipped)
    };
    let (shared, counts, skipped) = of("stage --error 10% --stats -");
    let (even, same, none) = of("stage --error 10% --stats - --no-skip samples_not_needed");
    let ratio = shared / even;
    assert!((0.58..0.69).contains(&ratio), "{ratio} of the samples for the same error");
    assert_eq!((same[0], none), (same[1], Some(0)), "without the skip all are alike");
    let [fewest, most] = counts.map(f64::from);
    assert!(most > 2.5 * fewest, "{fewest} to {most} samples a pixel");
    // Half of the pixels miss half of the average.
    let missing = skipped.unwrap_or(0) as f64 / (600.0 * fewest);
    assert!((0.9..1.1).contains(&missing), "{skipped:?} samples not needed, at least {fewest}");
}

#[test]
fn samples_that_come_first_are_noted() {
    let (run, film) = render("stage --error 1% --samples 24");
    assert_eq!(film.samples(), [24, 24], "samples");
    let text = run.summary(&film, false);
    assert!(text.contains("note: `--error 1%` was not reached, the estimated error"), "{text}");
}

#[test]
fn the_default_samples_count_only_when_nothing_else_ends_the_render() {
    assert_eq!(render("stage").1.samples(), [9, 9], "the stage's samples");
    let (_, film) = render("stage --error 5%");
    assert!(film.samples()[0] > 9, "under --error: {:?}", film.samples());
}

#[test]
fn a_stage_that_does_not_estimate_says_no_error() {
    const PLAIN: Stage = Stage { estimates: false, ..STAGE };
    let run = run_of(&PLAIN, "stage --samples 16");
    let film = run.render(EXPOSURE, &Unwatched, noise).expect("a small film");
    assert_eq!(film.estimated_error(), None, "the error");
    assert!(!run.summary(&film, false).contains("error"), "{}", run.summary(&film, false));
    assert_eq!(film.image().hash(), render("stage --samples 16").1.image().hash(), "the picture");
}

#[test]
fn one_pixel_ends_by_its_own_error() {
    let (_, film) = render("stage --error 1% --pixel 7,3");
    let [samples, _] = film.samples();
    assert!((4096..100_000).contains(&samples), "{samples} samples");
    let error = film.estimated_error().expect("an error");
    assert!(error <= 0.01, "the error is {error}");
    let mean = film.image().pixel(0, 0)[0];
    assert!((mean - 0.5).abs() < 0.02, "the mean is {mean}");
}

#[test]
fn the_statistics_have_the_error_or_null() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("s.json");
    for (line, is_known) in [("stage --samples 3", false), ("stage --samples 4", true)] {
        let (run, film) = render(line);
        run.write_statistics(&film, &StatsTarget::File(path.clone())).expect("they are written");
        let text = fs::read_to_string(&path).expect("they are read");
        let all: Value = serde_json::from_str(&text).expect("they are JSON");
        let error = all.get("estimated_error").expect("the field");
        assert_eq!(error.as_f64(), film.estimated_error(), "{line}: {error}");
        assert_eq!(error.is_f64(), is_known, "{line}: {error}");
    }
}

/// A pass that doubles the samples of this picture of six tiles would take up to half of the time,
/// and most tiles would not get their part of it.
#[test]
fn the_time_ends_the_render_with_even_samples() {
    let start = Instant::now();
    let (run, film) = render("stage --time 400ms");
    let elapsed = start.elapsed();
    let [fewest, most] = film.samples();
    assert!(elapsed >= Duration::from_millis(400), "it took {elapsed:?}");
    // Long enough for a machine that does other work as well.
    assert!(elapsed < Duration::from_secs(2), "it took {elapsed:?}");
    assert!(fewest > 100 && most < fewest + fewest / 2, "{fewest} to {most} samples a pixel");
    let text = run.summary(&film, false);
    assert!(
        text.contains(" samples a pixel, estimated error ") && !text.contains("note"),
        "{text}"
    );
}

#[test]
fn time_error_and_samples_end_the_render_whichever_comes_first() {
    let (run, film) = render("stage --time 200ms --error 0.0001%");
    assert!(run.summary(&film, false).contains("note: `--error 0.0001%` was not reached"), "time");
    let (_, film) = render("stage --time 1h --error 10%");
    assert_eq!(film.image().hash(), render("stage --error 10%").1.image().hash(), "error");
    let (_, film) = render("stage --time 1h --samples 5");
    assert_eq!(film.samples(), [5, 5], "samples");
}

#[test]
fn a_picture_too_large_to_be_estimated_is_an_error() {
    let run = run_of(&STAGE, "stage --size 8192x8192");
    let message = run.render(EXPOSURE, &Unwatched, noise).expect_err("64 Mpixel").to_string();
    assert!(message.contains("8192×4096"), "{message}");
}
