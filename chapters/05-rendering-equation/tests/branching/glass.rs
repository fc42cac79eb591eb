//! Glass whose two ways are chosen by chance.

use crate::scenes::{
    anywhere, assert_sees, asset, block, branching, found, glass, matte, quad, scene, sphere,
};
use blinn_phong::Picture;
use glam::Vec3;
use mirror_refraction::fresnel::fresnel;
use ray_casting::{LinearSearch, Ray, Scene};
use rendering_equation::directions::cosine_hemisphere;
use rendering_equation::{Anything, Density, DistributedTracer, Opaque};
use statistics::check_mean;
use workbench::{FilmSettings, Sampler, SurfaceKind, Unwatched, expose};

const N: f32 = 1.5;

/// ∫ F cos θ dω / π from a medium of index ratio η = ηᵢ/ηₜ, by the midpoint rule.
fn hemispherical(eta: f32) -> f64 {
    let n = 200_000;
    let share = |i: i32| {
        let cos2 = (f64::from(i) + 0.5) / f64::from(n);
        let sin2 = f64::from(eta).powi(2) * (1.0 - cos2);
        if sin2 >= 1.0 {
            return 1.0;
        }
        f64::from(fresnel(cos2.sqrt() as f32, (1.0 - sin2).sqrt() as f32, eta))
    };
    (0..n).map(share).sum::<f64>() / f64::from(n)
}

/// accuracy.md F9: the two numbers, and that they belong together.
#[test]
fn the_hemispherical_reflectances_of_glass_obey_reciprocity() {
    let (outside, inside) = (hemispherical(1.0 / N), hemispherical(N));
    assert!((outside - 0.091_778_0).abs() < 1e-6, "from outside {outside}");
    assert!((inside - 0.596_345_8).abs() < 1e-6, "from inside {inside}");
    let identity = (1.0 - inside) * f64::from(N).powi(2) - (1.0 - outside);
    assert!(identity.abs() < 1e-6, "(1 − R_in) n² − (1 − R_out) = {identity:e}");
}

/// A wide block of glass with a floor in it. What the surface reflects is white and what it lets
/// through is black, or the other way round.
fn pond(sky: f32, floor: f32) -> Scene {
    let x = 1.0e5;
    let bottom = [[-x, -1.0, x], [x, -1.0, x], [x, -1.0, -x], [-x, -1.0, -x]];
    let records = glass("water", N)
        + &matte("floor", 0.0, floor)
        + &block([0.0, -2.0, 0.0], [1.1e5, 2.0, 1.1e5], true, "water")
        + &quad(bottom, "floor");
    scene([0.0, 1.0, 0.0], sky, &records)
}

/// accuracy.md F9 by chance, from outside.
#[test]
fn glass_reflects_nine_percent_of_an_even_sky() {
    let scene = pond(1.0, 0.0);
    let moments = found(&scene, branching(1, 2, Density::Cosine), 1_000_000, |sampler| {
        let w = cosine_hemisphere(sampler.next_2d());
        Ray::new(Vec3::new(0.0, 1.0, 0.0), Vec3::new(w.x, -w.z, w.y))
    });
    assert_sees(0.022, "R_out", &moments, 0.091_778_0);
    let planted = check_mean("planted", &moments, 0.091_778_0 * 1.025);
    assert!(planted.is_err(), "a reflectance too small by 2.5 % passed: {}", moments.mean());
}

/// accuracy.md F9 by chance, from inside: total internal reflection beyond 41.8°. What comes back
/// from the surface is what the floor shines with.
#[test]
fn glass_reflects_sixty_percent_from_within() {
    let mut scene = pond(0.0, 1.0);
    scene.camera.eye = Vec3::new(0.0, -0.5, 0.0);
    let moments = found(&scene, branching(1, 2, Density::Cosine), 400_000, |sampler| {
        let w = cosine_hemisphere(sampler.next_2d());
        Ray::new(Vec3::new(0.0, -0.5, 0.0), Vec3::new(w.x, w.z, w.y))
    });
    assert_sees(0.01, "R_in", &moments, 0.596_345_8);
}

/// accuracy.md F12: whatever a ray does in the ball, it ends in the same light. Every estimate is 1,
/// because the two factors η² of a way in and out cancel.
#[test]
fn a_glass_ball_in_even_light_is_invisible() {
    let ball = glass("glass", N) + &sphere([0.0, 0.0, -3.0], 1.0, "glass");
    let scene = scene([0.0; 3], 1.0, &ball);
    let moments = found(&scene, branching(1, 500, Density::Cosine), 100_000, |sampler| {
        let [x, y] = sampler.next_2d().map(|u| 8.0 * u);
        scene.camera.ray(workbench::FilmPoint { x, y, size: [8, 8] })
    });
    let tolerance = 4.0 * f64::from(f32::EPSILON);
    assert!((moments.mean() - 1.0).abs() <= tolerance, "the mean is {}", moments.mean());
    assert!(moments.variance() <= tolerance * tolerance, "variance {:e}", moments.variance());
}

/// Radiance is n² times as large in glass: the eye in the middle of a ball sees 2.25, whichever way
/// it looks, and would see 1 without the η².
#[test]
fn light_is_n_squared_times_as_bright_in_glass() {
    let ball = glass("glass", N) + &sphere([0.0; 3], 1.0, "glass");
    let mut scene = scene([0.2, 0.1, 0.3], 1.0, &ball);
    scene.camera.eye = Vec3::new(0.2, 0.1, 0.3);
    let eye = scene.camera.eye;
    let moments = found(&scene, branching(1, 500, Density::Cosine), 50_000, |s| anywhere(eye, s));
    assert!((moments.mean() - 2.25).abs() <= 1e-5, "the mean is {}", moments.mean());
    let without = check_mean("without η²", &moments, 1.0);
    assert!(without.is_err(), "1 passed for {}", moments.mean());
}

/// What the scene does not need is not in the code that runs, and is not missed either.
#[test]
fn scenes_without_glass_are_the_same_to_the_bit_with_and_without_it() {
    for name in ["cornell-box", "furnace", "two-mirrors", "teapot", "sphereflake"] {
        let scene = asset(name);
        let glassy = scene.materials.iter().any(|m| m.surface == SurfaceKind::Glass);
        assert!(!glassy, "{name} has glass");
        let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
        let probe = &Unwatched;
        let tree = bv_tree::BvTree::<bv_tree::Aabb, _>::build(
            &scene.geometry,
            bv_tree::Builder::Sah,
            probe,
        );
        let linear = LinearSearch::new(&scene.geometry, probe);
        let settings = FilmSettings { size: [16, 12], samples: 2, seed: 0, threads: None };
        let options = branching(2, 3, Density::Cosine);
        let with: DistributedTracer<'_, _, _, Anything> =
            DistributedTracer::new(&scene, &pictures, &tree, probe, options);
        let without: DistributedTracer<'_, _, _, Opaque> =
            DistributedTracer::new(&scene, &pictures, &tree, probe, options);
        let camera = |point| scene.camera.ray(point);
        let with = expose(&settings, |p, s: &mut Sampler| with.incident_radiance(camera(p), s));
        let without = expose(&settings, |p, s| without.incident_radiance(camera(p), s));
        assert_eq!(with.hash(), without.hash(), "{name}: {:?}, {:?}", with.mean(), without.mean());
        if scene.geometry.primitives() < 100 {
            let plain: DistributedTracer<'_, _, _, Opaque> =
                DistributedTracer::new(&scene, &pictures, &linear, probe, options);
            let plain = expose(&settings, |p, s| plain.incident_radiance(camera(p), s));
            assert_eq!(plain.hash(), without.hash(), "{name}, without a tree");
        }
    }
}

/// Straight through a ball of air at depth 0, and on from the wall behind it at depth 1.
#[test]
fn a_boundary_that_is_none_does_not_count_toward_the_depth() {
    let wall = [[-9.0, -9.0, -2.0], [9.0, -9.0, -2.0], [9.0, 9.0, -2.0], [-9.0, 9.0, -2.0]];
    let records = glass("air", 1.0)
        + &matte("wall", 0.5, 1.0)
        + &sphere([0.0; 3], 1.0, "air")
        + &quad(wall, "wall");
    let scene = scene([0.0, 0.0, 5.0], 1.0, &records);
    for (depth, expected) in [(0, 1.0), (1, 1.5)] {
        let straight = |_: &mut Sampler| Ray::new(Vec3::new(0.1, 0.2, 5.0), Vec3::NEG_Z);
        let seen = found(&scene, branching(2, depth, Density::Cosine), 64, straight).mean();
        assert!((seen - expected).abs() < 1e-6, "depth {depth}: {seen} for {expected}");
    }
}
