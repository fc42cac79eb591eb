//! How much a surface reflects in all: never more than it gets.

use std::f64::consts::{PI, TAU};

use crate::{at_degrees, surface};
use glam::{DVec3, Vec3};
use rendering_equation::{Brdf, Density, Lobe};
use statistics::{Moments, assert_mean, check_mean, seed};
use workbench::Sampler;

/// accuracy.md BP10: p and ∫ (n·h)ᵖ (n·l) dω for the viewer at n.
const BP10: [(f32, f64); 5] = [
    (0.0, PI),
    (1.0, 2.860_284_9),
    (10.0, 1.500_671_5),
    (100.0, 0.236_922_52),
    (1000.0, 0.024_982_646),
];

/// ∫ f cos θ dω of the stage's own f32 code for the viewer at n, by the midpoint rule over √(1 − cos
/// θ), which puts most points where a narrow lobe is.
fn head_on(f: impl Fn(Vec3) -> f32) -> f64 {
    let n = 40_000;
    let midpoint = |i: i32| {
        let s = (f64::from(i) + 0.5) / f64::from(n);
        let cos = 1.0 - s * s;
        let wi = DVec3::new((1.0 - cos * cos).sqrt(), 0.0, cos).as_vec3();
        f64::from(f(wi)) * f64::from(wi.z) * 2.0 * s
    };
    TAU * (0..n).map(midpoint).sum::<f64>() / f64::from(n)
}

/// The formula of the lobe in double precision, with the same direction.
fn oracle(exponent: f32, wi: Vec3) -> f32 {
    let half = (wi.as_dvec3() + DVec3::Z).normalize();
    half.z.powf(f64::from(exponent)) as f32
}

/// The tolerance: 10⁻⁶ for the rule and the table, and p·u/2 for the code. Its n·h is rounded to
/// 1 − k u, and raising that to the power p multiplies a relative error by p; over many directions
/// half an ulp is left of it on average.
#[test]
fn the_highlight_has_the_integral_of_the_closed_form() {
    for (exponent, expected) in BP10 {
        let exact = head_on(|wi| oracle(exponent, wi));
        assert!((exact / expected - 1.0).abs() < 1e-6, "p = {exponent}: {exact} in f64");
        let lobe = Lobe::new(Vec3::ONE, exponent);
        let peak = lobe.eval(Vec3::Z, Vec3::Z, Vec3::Z).x;
        let integral = head_on(|wi| lobe.eval(Vec3::Z, Vec3::Z, wi).x / peak);
        let tolerance = 1e-6 + 0.5 * f64::from(exponent * f32::EPSILON);
        let error = integral / expected - 1.0;
        assert!(error.abs() < tolerance, "p = {exponent}: {integral}, off by {error:e}");
        let albedo = head_on(|wi| lobe.eval(Vec3::Z, Vec3::Z, wi).x);
        assert!((albedo - 1.0).abs() < tolerance, "p = {exponent}: an albedo of {albedo}");
    }
}

/// The same by chance, with each density: the estimate that the tracer makes.
fn reflected(brdf: &Brdf, density: Density, samples: u64) -> Moments {
    let mut sampler = Sampler::new(seed(5), 10, 0);
    let weight = |_| brdf.sample(density, &mut sampler).map_or(0.0, |s| f64::from(s.weight.x));
    (0..samples).map(weight).collect()
}

#[test]
fn the_highlight_reflects_its_ks_head_on() {
    // A broad lobe is drawn badly: half of its directions lead below the surface.
    let counts = [2_000_000, 1_500_000, 400_000, 100_000, 100_000];
    for ((exponent, _), samples) in BP10.into_iter().zip(counts) {
        let brdf = surface(0.0, Some((0.8, exponent)), Vec3::Z);
        let moments = reflected(&brdf, Density::Cosine, samples);
        let bias = assert_mean(&format!("p = {exponent}"), &moments, 0.8);
        assert!(bias <= 0.01, "p = {exponent}: only a bias of {bias} would be seen");
    }
    for (exponent, samples) in [(0.0, 500_000), (10.0, 2_000_000)] {
        let brdf = surface(0.0, Some((0.8, exponent)), Vec3::Z);
        let moments = reflected(&brdf, Density::Uniform, samples);
        let bias = assert_mean(&format!("p = {exponent}, uniform"), &moments, 0.8);
        assert!(bias <= 0.01, "p = {exponent}: only a bias of {bias} would be seen");
    }
}

/// (p + 8)/(8π), which is common, makes light when p is small, and is found out.
#[test]
fn the_common_factor_is_wrong_for_small_exponents() {
    for (exponent, integral, gain) in [(0.0, PI, 1.0), (10.0, 1.500_671_5, 1.0748)] {
        let common = (f64::from(exponent) + 8.0) / (8.0 * PI);
        assert!((common * integral - gain).abs() < 1e-4, "p = {exponent}: {}", common * integral);
        let brdf = surface(0.0, Some((1.0, exponent)), Vec3::Z);
        let exact = f64::from(brdf.eval(Vec3::Z).x);
        let moments = reflected(&brdf, Density::Cosine, 200_000);
        let scaled: Moments = {
            let mut sampler = Sampler::new(seed(5), 10, 0);
            let mut weight = || brdf.sample(Density::Cosine, &mut sampler);
            (0..200_000)
                .map(|_| weight().map_or(0.0, |s| f64::from(s.weight.x) * common / exact))
                .collect()
        };
        assert!(check_mean("C(p)", &moments, 1.0).is_ok(), "p = {exponent}: {}", moments.mean());
        let found = check_mean("(p + 8)/8π", &scaled, 1.0).is_err();
        assert_eq!(found, gain > 1.01, "p = {exponent}: {}", scaled.mean());
    }
}

/// ∫ f cos θ dω for any viewer: the weights of a grid of random numbers, one in the middle of each of
/// 120 × 120 cells. Cells that the horizon cuts make it uncertain by about 10⁻³.
fn albedo(exponent: f32, theta: f64) -> f64 {
    const N: u16 = 120;
    let wo = at_degrees(theta);
    let lobe = Lobe::new(Vec3::ONE, exponent);
    let brdf = surface(0.0, Some((1.0, exponent)), wo);
    let at = |i: u16| (f32::from(i) + 0.5) / f32::from(N);
    let mut sum = 0.0;
    for u in (0..N).flat_map(|a| (0..N).map(move |b| [at(a), at(b)])) {
        let wi = lobe.sample(Vec3::Z, wo, u);
        let pdf = brdf.pdf(Density::Cosine, wi);
        if pdf > 0.0 {
            sum += f64::from(brdf.eval(wi).x * brdf.cos_theta(wi) / pdf);
        }
    }
    sum / f64::from(N).powi(2)
}

#[test]
fn no_highlight_reflects_more_than_it_gets_at_any_angle() {
    for exponent in [0.0, 0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 50.0, 200.0, 1e3, 1e4] {
        let mut worst = (0.0, 0.0);
        for i in 0..=22 {
            let theta = 4.0 * f64::from(i);
            let albedo = albedo(exponent, theta);
            if albedo > worst.0 {
                worst = (albedo, theta);
            }
        }
        assert!(worst.0 <= 1.002, "p = {exponent}: {} at {}°", worst.0, worst.1);
    }
}

/// k_d + k_s = 1: the matte part keeps its share, and the highlight's gets less with the angle.
#[test]
fn a_mixture_reflects_no_more_than_it_gets() {
    for (exponent, theta) in [(0.0, 70.0), (1.0, 0.0), (1.0, 60.0), (30.0, 45.0), (1e4, 80.0)] {
        let brdf = surface(0.6, Some((0.4, exponent)), at_degrees(theta));
        let moments = reflected(&brdf, Density::Cosine, 200_000);
        let expected = 0.6 + 0.4 * albedo(exponent, theta);
        let error = (moments.mean() - expected).abs();
        let limit = 4.42 * moments.standard_error() + 1e-3;
        assert!(error <= limit, "p = {exponent}, {theta}°: {} for {expected}", moments.mean());
        assert!(moments.mean() <= 1.0 + limit, "p = {exponent}, {theta}°: {}", moments.mean());
    }
}
