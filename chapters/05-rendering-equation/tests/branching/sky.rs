//! Light from an even sky.

use crate::scenes::{
    assert_sees, asset, block, branching, found, matte, quad, scene, sphere, with_tracer,
};
use glam::Vec3;
use ray_casting::{Ray, Scene};
use rendering_equation::{Anything, Density};
use statistics::{Moments, seed};
use workbench::{FilmSettings, Sampler, expose};

const U: f64 = f32::EPSILON as f64 / 2.0;

/// Straight down onto the ground beneath the ball of E8.
pub(crate) fn down() -> Ray {
    Ray::new(Vec3::new(0.0, 0.5, 0.0), Vec3::NEG_Y)
}

/// accuracy.md E8: a white sky, and a black ball of radius 1, two units above a ground of albedo
/// 0.6. The ball takes sin² θ = ¼ of the light, and 0.45 is left.
pub(crate) fn eclipse() -> Scene {
    let materials = matte("ground", 0.6, 0.0) + &matte("black", 0.0, 0.0);
    let x = 1.0e3;
    let ground = [[-x, 0.0, x], [x, 0.0, x], [x, 0.0, -x], [-x, 0.0, -x]];
    let records = materials + &quad(ground, "ground") + &sphere([0.0, 2.0, 0.0], 1.0, "black");
    scene([0.0, 0.5, 0.0], 1.0, &records)
}

#[test]
fn a_black_ball_takes_a_quarter_of_the_sky() {
    let scene = eclipse();
    for (n, density, samples) in [
        (1, Density::Cosine, 300_000),
        (4, Density::Cosine, 75_000),
        (1, Density::Uniform, 800_000),
        (4, Density::Uniform, 200_000),
    ] {
        let moments = found(&scene, branching(n, 1, density), samples, |_| down());
        assert_sees(0.01, &format!("N = {n}, {density:?}"), &moments, 0.45);
    }
}

/// accuracy.md E9: drawn in proportion to the cosine, every estimate of one bounce is ρ L.
#[test]
fn under_an_even_sky_every_estimate_is_the_same() {
    let grey = matte("grey", 0.3, 0.0) + &sphere([0.0, 0.0, -5.0], 1.0, "grey");
    let scene = scene([0.0; 3], 3.0, &grey);
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.05, 0.1, -1.0).normalize());
    for n in [1, 5] {
        let moments = found(&scene, branching(n, 1, Density::Cosine), 5_000, |_| ray);
        let expected = 3.0 * f64::from(0.3_f32);
        let error = (moments.mean() - expected).abs();
        assert!(error <= 8.0 * U, "N = {n}: {} for {expected}", moments.mean());
        assert!(moments.variance() <= (8.0 * U).powi(2), "variance {:e}", moments.variance());
    }
    let uniform = found(&scene, branching(1, 1, Density::Uniform), 400_000, |_| ray);
    assert_sees(0.01, "uniform", &uniform, 0.9);
    // (2ρL cos θ)² has the mean 4/3 (ρL)².
    let variance = 0.81 / 3.0;
    assert!((uniform.variance() / variance - 1.0).abs() < 0.02, "{}", uniform.variance());
}

/// The scene that students meet: every pixel of the ball is 0.5, and only its outline is not.
#[test]
fn the_white_furnace_shows_a_flat_grey_disk() {
    let scene = asset("furnace");
    with_tracer(&scene, branching(2, 1, Density::Cosine), |radiance| {
        let settings = 3;
        for i in 0..settings {
            let mut sampler = Sampler::new(seed(5), 40, i);
            let point = workbench::FilmPoint { x: 60.0 + i as f32, y: 64.5, size: [128, 128] };
            let grey = radiance(scene.camera.ray(point), &mut sampler);
            assert_eq!(grey, Vec3::splat(0.5), "pixel {i}");
        }
    });
}

/// accuracy.md E14: radiance does not fall off with distance.
#[test]
fn a_lamp_that_fills_the_view_is_as_bright_from_anywhere() {
    for distance in [1.0, 10.0, 1000.0] {
        let wide = 1.0e4;
        let wall = block([0.0, 0.0, wide - distance], [wide; 3], false, "lamp");
        let scene = scene([0.0; 3], 0.0, &(matte("lamp", 0.0, 2.5) + &wall));
        let moments: Moments = found(&scene, branching(2, 4, Density::Cosine), 100, |sampler| {
            let [x, y] = sampler.next_2d().map(|u| 8.0 * u);
            scene.camera.ray(workbench::FilmPoint { x, y, size: [8, 8] })
        });
        let [mean, variance] = [moments.mean(), moments.variance()];
        assert!(mean == 2.5 && variance == 0.0, "at {distance}: {mean}, variance {variance:e}");
    }
}

/// Emission leaves the front only: seen from above, where its corners run counter-clockwise, the lamp
/// shines, and from below it does not; what is below gets no light of it either.
#[test]
fn a_lamp_is_dark_from_behind() {
    let lamp = [[-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
    let floor = lamp.map(|[x, _, z]| [x, -1.0, z]);
    let records = matte("lamp", 0.0, 2.5)
        + &matte("floor", 1.0, 0.0)
        + &quad(lamp, "lamp")
        + &quad(floor, "floor");
    let scene = scene([0.0; 3], 0.0, &records);
    for (from, direction, expected) in [
        (Vec3::Y, Vec3::NEG_Y, 2.5),
        (Vec3::new(0.0, -0.5, 0.0), Vec3::Y, 0.0),
        (Vec3::new(0.0, -0.5, 0.0), Vec3::NEG_Y, 0.0),
    ] {
        let options = branching(4, 1, Density::Cosine);
        let moments = found(&scene, options, 100, |_| Ray::new(from, direction));
        let [mean, variance] = [moments.mean(), moments.variance()];
        assert!(mean == expected && variance == 0.0, "from {from} along {direction}: {mean}");
    }
}

/// accuracy.md E16: the variance of a mean is what its samples say, over 64 renders.
#[test]
fn the_means_of_renders_spread_as_their_samples_do() {
    let samples = 400;
    let scene = eclipse();
    let single = found(&scene, branching(1, 1, Density::Cosine), 100_000, |_| down());
    let means: Moments = with_tracer_means(&scene, 64, samples);
    let expected = single.variance() / f64::from(samples);
    statistics::assert_variance("means of 400", &means, expected);
}

fn with_tracer_means(scene: &Scene, renders: u64, samples: u32) -> Moments {
    let mean = |render: u64| {
        let settings =
            FilmSettings { size: [1, 1], samples, seed: seed(500) + render, threads: None };
        let geometry = ray_casting::LinearSearch::new(&scene.geometry, &workbench::Unwatched);
        let tracer: rendering_equation::DistributedTracer<'_, _, _, Anything> =
            rendering_equation::DistributedTracer::new(
                scene,
                &[],
                &geometry,
                &workbench::Unwatched,
                branching(1, 1, Density::Cosine),
            );
        let image = expose(&settings, |_, sampler| tracer.incident_radiance(down(), sampler));
        f64::from(image.pixels[0][0])
    };
    (0..renders).map(mean).collect()
}
