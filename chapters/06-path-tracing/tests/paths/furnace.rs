//! Rooms in which the right answer is a geometric series.

use crate::mistakes::{Mistake, Mistaken};
use crate::scenes::{
    BOUNDED, ROULETTE, across, anywhere, assert_sees, block, constant, depth, found, gather, matte,
    plates, room, scene, sphere,
};
use ray_casting::Scene;
use rendering_equation::Density;
use statistics::check_mean;

const U: f64 = f32::EPSILON as f64 / 2.0;

/// A closed room with a ball in it; all of it shines with 1 and reflects `albedo`.
fn furnace(albedo: f32) -> Scene {
    let ball = sphere([0.5, -0.4, 0.3], 0.25, "all");
    scene(0.0, &(matte("all", albedo, 1.0) + &room("all") + &ball))
}

/// accuracy.md E1: 1/(1 − ρ), with the roulette of the stage.
#[test]
fn a_furnace_has_the_radiance_one_over_one_minus_albedo() {
    for (albedo, samples) in [(0.5, 30_000), (0.8, 35_000), (0.95, 45_000)] {
        let moments = found(&furnace(albedo), ROULETTE, Density::Cosine, samples, anywhere);
        let expected = 1.0 / (1.0 - f64::from(albedo));
        assert_sees(0.01, &format!("ρ = {albedo}"), &moments, expected);
    }
}

/// The same between two wide plates, with a constant probability to go on, and with directions of
/// equal density, whose weights are not constant.
#[test]
fn a_furnace_is_as_bright_however_its_paths_are_drawn_and_ended() {
    let plates = |albedo| scene(0.0, &(matte("all", albedo, 1.0) + &plates("all")));
    let cases = [
        (0.5, Density::Cosine, constant(0.75), 120_000, 0.01),
        (0.8, Density::Cosine, constant(0.875), 250_000, 0.01),
        (0.95, Density::Cosine, constant(0.98), 40_000, 0.03),
        (0.5, Density::Uniform, ROULETTE, 200_000, 0.01),
        (0.8, Density::Uniform, ROULETTE, 150_000, 0.03),
    ];
    for (albedo, density, ending, samples, visible) in cases {
        let moments = found(&plates(albedo), ending, density, samples, across);
        let expected = 1.0 / (1.0 - f64::from(albedo));
        let name = format!("ρ = {albedo}, {density:?}, {ending:?}");
        assert_sees(visible, &name, &moments, expected);
    }
}

/// Errata 20: of 1/(1 − ρ), a path of at most D events finds Σ ρⁱ and loses the share ρ^(D+1), to
/// the last digits: no path differs from any other.
#[test]
fn erratum_20_a_depth_limit_loses_albedo_to_the_power_of_depth_plus_one() {
    for (albedo, most, lost) in
        [(0.5, 5, 0.0156), (0.8, 5, 0.262), (0.8, 10, 0.086), (0.8, 20, 0.0092), (0.95, 20, 0.341)]
    {
        let moments = found(&furnace(albedo), depth(most), Density::Cosine, 100, anywhere);
        let whole = 1.0 / (1.0 - f64::from(albedo));
        let missing = 1.0 - moments.mean() / whole;
        let formula = f64::from(albedo).powi(most as i32 + 1);
        let tolerance = f64::from(most + 2) * 4.0 * U;
        assert!((missing - formula).abs() <= tolerance, "ρ = {albedo}, D = {most}: {missing}");
        assert!((missing - lost).abs() < 6e-4, "ρ = {albedo}, D = {most}: {missing} for {lost}");
        assert!(moments.variance() <= 1e-10, "variance {:e}", moments.variance());
    }
}

/// accuracy.md E9: under a constant sky, drawn in proportion to the cosine, every path of one
/// bounce finds ρ L.
#[test]
fn under_an_even_sky_every_path_finds_the_same() {
    let scene = scene(3.0, &(matte("grey", 0.3, 0.0) + &sphere([0.0, 0.0, -5.0], 1.0, "grey")));
    let down = |_: &mut workbench::Sampler| {
        scene.camera.ray(workbench::FilmPoint { x: 4.0, y: 4.0, size: [8, 8] })
    };
    let moments = found(&scene, depth(1), Density::Cosine, 10_000, down);
    let expected = 3.0 * f64::from(0.3_f32);
    assert!((moments.mean() - expected).abs() <= 8.0 * U, "{} for {expected}", moments.mean());
    assert!(moments.variance() <= (8.0 * U).powi(2), "variance {:e}", moments.variance());
    let uniform = found(&scene, depth(1), Density::Uniform, 400_000, down);
    assert_sees(0.01, "uniform directions", &uniform, expected);
    assert!(uniform.variance() > 0.1, "uniform directions have no variance?");
}

/// accuracy.md E14: radiance does not fall off with distance.
#[test]
fn a_lamp_that_fills_the_view_is_as_bright_from_anywhere() {
    for distance in [1.0, 10.0, 1000.0] {
        let wide = 1.0e4;
        let wall = block([0.0, 0.0, wide - distance], [wide; 3], false, ["lamp"; 6]);
        let scene = scene(0.0, &(matte("lamp", 0.0, 2.5) + &wall));
        let moments = found(&scene, ROULETTE, Density::Cosine, 100, |sampler| {
            scene.camera.ray(workbench::FilmPoint {
                x: 8.0 * sampler.next_1d(),
                y: 8.0 * sampler.next_1d(),
                size: [8, 8],
            })
        });
        let [mean, variance] = [moments.mean(), moments.variance()];
        assert!(mean == 2.5 && variance == 0.0, "at {distance}: {mean}, variance {variance:e}");
    }
}

/// What these tests are worth: the loop of the stage passes, and every mistake is found.
#[test]
fn the_furnace_finds_planted_mistakes() {
    let scene = furnace(0.8);
    let check = |mistake, density| {
        let paths = Mistaken::new(&scene, mistake, density, BOUNDED);
        let moments = gather(30_000, |sampler| paths.radiance(anywhere(sampler), sampler));
        check_mean("ρ = 0.8", &moments, 5.0)
    };
    for density in [Density::Cosine, Density::Uniform] {
        let right = check(Mistake::None, density);
        assert!(right.is_ok(), "{density:?}: {right:?}");
    }
    for mistake in
        [Mistake::DividesTwice, Mistake::NeverDivides, Mistake::OnePercent, Mistake::LampsOnlyShine]
    {
        let wrong = check(mistake, Density::Cosine);
        assert!(wrong.is_err(), "{mistake:?} was not found: {wrong:?}");
    }
    for mistake in [Mistake::NoCosine, Mistake::NoDensity] {
        let wrong = check(mistake, Density::Uniform);
        assert!(wrong.is_err(), "{mistake:?} was not found: {wrong:?}");
    }
}
