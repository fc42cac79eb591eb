//! Mirrors: a path has one way to go, so chance has no part in it.

use crate::scenes::{ROULETTE, anywhere, asset, depth, found, matte, quad, scene, special, sphere};
use blinn_phong::Picture;
use glam::{Vec3, vec3};
use mirror_refraction::{Limits, RayTracer};
use path_tracing::PathTracer;
use ray_casting::{LinearSearch, Ray, Scene};
use rendering_equation::{Anything, Density, Opaque};
use workbench::{FilmSettings, Sampler, Unwatched, expose};

const U: f32 = f32::EPSILON / 2.0;

/// accuracy.md F15: two facing mirrors so long that a ray at 45° meets them `k` times before it
/// leaves for the sky.
fn zigzag(k: u16) -> (Scene, Ray) {
    let (x, y) = (f32::from(k), 0.5);
    let wall = |z| quad([[0.0, -y, z], [x, -y, z], [x, y, z], [0.0, y, z]], "mirror");
    let scene = scene(
        1.0,
        &(special("mirror", "mirror", "kr", "[0.9, 0.9, 0.9]") + &wall(0.0) + &wall(1.0)),
    );
    (scene, Ray::new(vec3(0.0, 0.1, 0.5), vec3(1.0, 0.0, 1.0).normalize()))
}

#[test]
fn facing_mirrors_dim_by_a_tenth_each_time_until_the_depth_ends() {
    for k in [1_u16, 2, 3, 7, 20] {
        let (scene, ray) = zigzag(k);
        let seen = |ending| found(&scene, ending, Density::Cosine, 2, |_| ray).mean();
        let expected = 0.9_f64.powi(k.into());
        let error = (seen(depth(k.into())) - expected).abs();
        assert!(error <= f64::from(k) * f64::from(U), "0.9^{k} is off by {error:e}");
        assert_eq!(seen(depth(u32::from(k) - 1)), 0.0, "beyond the depth");
    }
}

/// accuracy.md I4: with mirrors and a sky alone, a path is the recursion of chapter 3.
#[test]
fn a_scene_of_mirrors_looks_as_in_chapter_3() {
    let mirrors = special("mirror", "mirror", "kr", "[0.9, 0.7, 0.5]");
    let balls: String = (0..5_u8)
        .map(|i| {
            let i = f32::from(i);
            sphere([i - 2.0, 0.3 * i - 0.6, -6.0 - i * i % 3.0], 0.6, "mirror")
        })
        .collect();
    let scene = scene(0.8, &(mirrors + &balls));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let settings = FilmSettings { size: [64, 64], samples: 2, seed: 0, threads: None };
    let limits = Limits::new(Some(40), 0.0);
    let whitted = RayTracer::new(&scene, &[], &geometry, &Unwatched, limits);
    let path: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(&scene, &[], &geometry, &Unwatched, Density::Cosine, depth(40));
    let a = expose(&settings, |point, _| whitted.incident_radiance(scene.camera.ray(point)));
    let b = expose(&settings, |point, s| path.incident_radiance(scene.camera.ray(point), s));
    let (a, b) = (a.pixels.as_flattened(), b.pixels.as_flattened());
    let worst = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(worst <= 8.0 * U, "the pictures differ by {worst:e}");
    let dimmed = b.iter().filter(|value| **value < 0.5).count();
    assert!(dimmed > 500, "only {dimmed} values show a second reflection");
}

/// A path may cross boundaries that are none (a ball of air) before each of its events. It must not
/// be cut off as if they were events: here every one of 100 reflections lies behind such a ball.
#[test]
fn boundaries_that_are_none_do_not_count_toward_the_depth() {
    let mirror = special("mirror", "mirror", "kr", "[0.9, 0.9, 0.9]\nke = [1.0, 1.0, 1.0]");
    let air = special("air", "glass", "ni", "1");
    let wall = |z: f32| {
        let s = -z.signum(); // fronts face each other
        quad([[-1.0, -s, z], [1.0, -s, z], [1.0, s, z], [-1.0, s, z]], "mirror")
    };
    let records = mirror + &air + &wall(1.0) + &wall(-1.0) + &sphere([0.0; 3], 0.5, "air");
    let scene = scene(0.0, &records);
    let straight = |_: &mut Sampler| Ray::new(vec3(0.1, 0.2, 0.9), Vec3::NEG_Z);
    // The last wall lies behind the ball, too.
    for most in [0, 1, 2, 100] {
        let seen = found(&scene, depth(most), Density::Cosine, 2, straight).mean();
        let expected = (1.0 - 0.9_f64.powi(most as i32 + 1)) / 0.1;
        assert!((seen / expected - 1.0).abs() < 1e-5, "depth {most}: {seen} for {expected}");
    }
}

/// Errata 22: no random direction hits a point, so scenes of the first four chapters are dark; and
/// a mirror shows what it shows because it is a case of its own.
#[test]
fn erratum_22_random_directions_never_find_a_point_light() {
    let floor = [[-5.0, -1.0, 5.0], [5.0, -1.0, 5.0], [5.0, -1.0, -5.0], [-5.0, -1.0, -5.0]];
    let light = "[[point_light]]\nposition = [0, 3, 0]\nintensity = [40, 40, 40]\n";
    let scene = scene(0.0, &(matte("floor", 0.8, 0.0) + &quad(floor, "floor") + light));
    let moments = found(&scene, ROULETTE, Density::Cosine, 10_000, anywhere);
    assert_eq!((moments.mean(), moments.variance()), (0.0, 0.0), "the light was found");
}

/// The scenes of the earlier chapters have nothing that could not be followed.
#[test]
fn every_sample_of_every_scene_is_finite() {
    for name in
        ["whitted", "two-mirrors", "nested-glass", "touching-glass", "glass-slab", "furnace"]
    {
        let scene = asset(name);
        let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        let tracer: PathTracer<'_, _, _, Anything> =
            PathTracer::new(&scene, &pictures, &geometry, &Unwatched, Density::Cosine, ROULETTE);
        let settings = FilmSettings { size: [24, 16], samples: 4, seed: 0, threads: None };
        let image =
            expose(&settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s));
        let bad =
            image.pixels.as_flattened().iter().filter(|v| !v.is_finite() || **v < 0.0).count();
        assert_eq!(bad, 0, "{name}: values that are not finite, or negative");
    }
}
