//! The game that ends paths, and its variance.

use crate::mistakes::{Mistake, Mistaken};
use crate::scenes::{
    ROULETTE, across, assert_sees, constant, found, matte, plates, scene, values, with_paths,
};
use path_tracing::{Ending, Roulette};
use ray_casting::{Rgb, Scene};
use rendering_equation::Density;
use statistics::{Moments, assert_chi_squared, check_chi_squared, check_mean};

/// Two wide plates that shine with 1 and reflect `albedo`.
fn furnace(albedo: f32) -> Scene {
    scene(0.0, &(matte("all", albedo, 1.0) + &plates("all")))
}

/// How many of `values`, whole numbers from 1, are 1, 2, 3 …; the last place counts all others.
fn histogram(values: impl Iterator<Item = f64>, places: usize) -> Vec<u64> {
    let mut counts = vec![0; places];
    values.for_each(|value| counts[(value as usize - 1).min(places - 1)] += 1);
    counts
}

/// accuracy.md E10: while q = ρ, the throughput of a survivor stays 1, and what a path finds in the
/// furnace is how many walls it has met. That number is geometric: P(k) = (1 − q) qᵏ⁻¹.
#[test]
fn the_number_of_vertices_of_a_path_is_geometric() {
    for q in [0.5_f32, 0.8, 0.95] {
        let scene = furnace(q);
        let n = 200_000;
        let places = if q > 0.9 { 200 } else { 60 };
        let lengths: Vec<f64> = with_paths(&scene, constant(q), Density::Cosine, |follow| {
            values(n, |sampler| follow(across(sampler), sampler)).collect()
        });
        let moments: Moments = lengths.iter().copied().collect();
        let q = f64::from(q);
        let mut expected: Vec<f64> =
            (0..places).map(|k| n as f64 * (1.0 - q) * q.powi(k)).collect();
        expected[places as usize - 1] /= 1.0 - q;
        let counts = histogram(lengths.iter().copied(), places as usize);
        assert_chi_squared(&format!("q = {q}"), &counts, &expected);

        let variance = q / ((1.0 - q) * (1.0 - q));
        let relative = moments.variance() / variance - 1.0;
        assert!(relative.abs() < 0.05, "q = {q}: the variance is off by {relative}");

        // One path in 25 that is one vertex longer would be seen.
        let longer =
            lengths.iter().enumerate().map(|(i, k)| if i % 25 == 0 { k + 1.0 } else { *k });
        let wrong = check_chi_squared("longer", &histogram(longer, places as usize), &expected);
        assert!(q > 0.9 || wrong.is_err(), "q = {q}: {wrong:?}");
    }
}

/// E[S²] = (1 + 2 ρ m) Σ ρᵏ βₖ, with the mean m = 1/(1 − ρ), and the throughput βₖ that a path has
/// after k events.
///
/// βₖ Pₖ = ρᵏ, if Pₖ is the probability to get there: that is what being unbiased means. A path
/// that gets there finds βₖ, and all that comes after finds βₖ ρ m on average; so of the square of
/// the sum, k and what follows it have Pₖ βₖ² (1 + 2 ρ m). With a constant q, βₖ = (ρ/q)ᵏ and the
/// sum is 1/(1 − ρ²/q).
fn second_moment(albedo: f64, roulette: Roulette) -> f64 {
    let (mut sum, mut power, mut throughput) = (0.0, 1.0, 1.0);
    for events in 1..100_000 {
        sum += power * throughput;
        power *= albedo;
        throughput *= albedo;
        throughput /= f64::from(roulette.survival(Rgb::splat(throughput as f32), events));
    }
    (1.0 + 2.0 * albedo / (1.0 - albedo)) * sum
}

/// For second moments.
const PATHS: u64 = 100_000;

/// What each of so many paths finds.
fn one_by_one(scene: &Scene, mistake: Mistake, ending: Ending) -> Vec<f64> {
    let paths = Mistaken::new(scene, mistake, Density::Cosine, ending);
    values(PATHS, |sampler| paths.radiance(across(sampler), sampler)).collect()
}

/// Whether the second moment of `samples` paths is what it should be: the smallest visible bias.
fn check_second_moment(samples: &[f64], expected: f64) -> Result<f64, String> {
    let squares: Moments = samples.iter().map(|s| s * s).collect();
    check_mean("the second moment", &squares, expected)
}

/// The variance law of accuracy.md E10, where the fourth moment is finite, too (q > ρ^(4/3)): the
/// test needs it. Mistakes in the division are found by it as well.
#[test]
fn the_variance_of_roulette_follows_its_law() {
    let q = Roulette::Constant;
    for (albedo, roulette) in
        [(0.5, q(0.5)), (0.5, q(0.75)), (0.8, q(0.875)), (0.9, Roulette::Throughput)]
    {
        let scene = furnace(albedo);
        let expected = second_moment(f64::from(albedo), roulette);
        if let Roulette::Constant(q) = roulette {
            let (albedo, q) = (f64::from(albedo), f64::from(q));
            let law = (1.0 + 2.0 * albedo / (1.0 - albedo)) / (1.0 - albedo * albedo / q);
            assert!((expected / law - 1.0).abs() < 1e-6, "{expected} for {law}");
        }
        let ending = Ending { depth: u32::MAX, roulette };
        let paths: Moments = found(&scene, ending, Density::Cosine, PATHS, across);
        let right = one_by_one(&scene, Mistake::None, ending);
        let moments: Moments = right.iter().copied().collect();
        assert_eq!(moments, paths, "the loop of the tests, and the stage's");
        let bias = check_second_moment(&right, expected);
        assert!(bias.as_ref().is_ok_and(|b| *b < 0.08), "ρ = {albedo}, {roulette:?}: {bias:?}");
        let wrong = one_by_one(&scene, Mistake::NeverDivides, ending);
        let verdict = check_second_moment(&wrong, expected);
        assert!(verdict.is_err(), "ρ = {albedo}, {roulette:?}: the mistake was not found");
    }
}

/// Where q ≤ ρ², the second moment has no limit: M_D = 1 + 2 ρ m_{D−1} + (ρ²/q) M_{D−1} grows with
/// every bounce. (q is just below ρ² here, so that the estimate of M itself is still good.)
#[test]
fn below_the_square_of_the_albedo_each_bounce_adds_to_the_variance() {
    let (albedo, q) = (0.8_f64, 0.625_f64);
    let scene = furnace(albedo as f32);
    let mut second = 1.0;
    let mut mean = 1.0;
    let mut variances = Vec::new();
    for most in 1..=12_u32 {
        second = 1.0 + 2.0 * albedo * mean + albedo * albedo / q * second;
        mean = 1.0 + albedo * mean;
        if most % 4 != 0 {
            continue;
        }
        let ending = Ending { depth: most, roulette: Roulette::Constant(q as f32) };
        let values = one_by_one(&scene, Mistake::None, ending);
        let moments: Moments = values.iter().copied().collect();
        let verdict = check_second_moment(&values, second);
        assert!(verdict.as_ref().is_ok_and(|b| *b < 0.3), "D = {most}: {verdict:?}");
        variances.push(moments.variance());
    }
    let grows = variances.windows(2).all(|pair| pair[1] > 1.5 * pair[0]);
    assert!(grows, "variances at depths 4, 8, 12: {variances:?}");
}

/// A room that loses nothing and is dark: without an end of its own, no path would leave it.
#[test]
fn a_path_that_loses_nothing_ends() {
    let scene = scene(0.0, &(matte("white", 1.0, 0.0) + &plates("white")));
    let moments = found(&scene, ROULETTE, Density::Cosine, 2_000, across);
    assert_eq!(moments.mean(), 0.0, "light in a dark room");
}

/// The second rule of roulette must not make the variance infinite, as a constant q would: at
/// ρ = 0.995, the square is 0.99, and the rule has q = 0.985 at event 128.
#[test]
fn a_long_series_keeps_a_finite_variance() {
    let albedo = 0.995_f32;
    let expected = 1.0 / (1.0 - f64::from(albedo));
    let moments = found(&furnace(albedo), ROULETTE, Density::Cosine, 8_000, across);
    assert_sees(0.1, "ρ = 0.995", &moments, expected);
    let variance = second_moment(f64::from(albedo), Roulette::Throughput) - expected * expected;
    let ratio = moments.variance() / variance;
    assert!((0.8..1.25).contains(&ratio), "{} for {variance}", moments.variance());
}

/// A uniform number is a multiple of 2⁻²⁴, so a probability must be one, too. Divided by the
/// probability that was asked for, 1.5 · 2⁻²⁴, survivors would count 4/3 of what they should.
#[test]
fn probabilities_are_those_that_the_generator_can_have() {
    let step = 2.0_f32.powi(-24);
    for q in [1.5 * step, 1e-7, 0.1, 0.3, 0.49999997, 0.7, 1.0 - step, 1.0] {
        let drawn = Roulette::Constant(q).survival(Rgb::ONE, 1);
        let steps = drawn / step;
        assert!(steps == steps.trunc() && drawn >= q && drawn <= q + step, "{q}: {drawn}");
    }
    let tiny = Roulette::Throughput.survival(Rgb::splat(1e-12), 1);
    assert_eq!(tiny, step, "the smallest probability");
    assert_eq!(Roulette::Throughput.survival(Rgb::ZERO, 1), 0.0, "of a path that carries nothing");
    assert_eq!(Roulette::Off.survival(Rgb::ZERO, 1000), 1.0, "without a game");
}

#[test]
fn roulette_is_read_from_the_command_line() {
    let read = |text: &str| text.parse::<Roulette>();
    assert_eq!(read("off"), Ok(Roulette::Off), "off");
    assert_eq!(read("throughput"), Ok(Roulette::Throughput), "throughput");
    assert_eq!(read("0.5"), Ok(Roulette::Constant(0.5)), "0.5");
    assert_eq!(read("1"), Ok(Roulette::Constant(1.0)), "1");
    for text in ["0", "-0", "-0.5", "2", "1.0000001", "nan", "inf", "-inf", "1e-50", "", "on"] {
        let error = read(text).expect_err(text);
        assert!(error.contains("above 0, at most 1"), "{text}: {error}");
    }
}
