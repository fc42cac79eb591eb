//! Glass in even light: whatever a path does, the answer is known.

use crate::scenes::{
    ROULETTE, anywhere, assert_sees, block, constant, found, matte, quad, scene, special, sphere,
};
use glam::{Vec3, vec3};
use path_tracing::Ending;
use ray_casting::{Ray, Scene};
use rendering_equation::Density;
use rendering_equation::directions::{cosine_hemisphere, uniform_sphere};
use statistics::Moments;
use workbench::Sampler;

const U: f64 = f32::EPSILON as f64 / 2.0;

fn glass(name: &str, ni: f32) -> String {
    special(name, "glass", "ni", &format!("{ni:?}"))
}

/// A scene in a sky of radiance 1, with the eye outside of everything: paths begin in what is around
/// the eye, also those of [`from_outside`].
fn outside(records: &str) -> Scene {
    let mut scene = scene(1.0, records);
    scene.camera.eye = vec3(0.0, 0.0, 9.0);
    scene
}

/// From far away, through a random point of the ball of radius 2 around the origin.
fn from_outside(sampler: &mut Sampler) -> Ray {
    let eye = 5.0 * uniform_sphere(sampler.next_2d());
    let target = 2.0 * sampler.next_1d() * uniform_sphere(sampler.next_2d());
    Ray::new(eye, (target - eye).normalize())
}

/// Where all light is the same, each path finds it: neither the choice between reflection and
/// refraction nor η² leaves a trace, and roulette ends no path within its patience.
fn assert_invisible(name: &str, scene: &Scene, samples: u64) {
    let moments = found(scene, ROULETTE, Density::Cosine, samples, from_outside);
    let mean = moments.mean();
    let deviation = moments.variance().sqrt();
    assert!((mean - 1.0).abs() <= 64.0 * U, "{name}: the mean is {mean}");
    assert!(deviation <= 64.0 * U, "{name}: the standard deviation is {deviation:e}");
}

/// accuracy.md F12, and the arrangements of chapter 3.
#[test]
fn glass_is_invisible_in_even_light() {
    let ball = |radius, material| sphere([0.0; 3], radius, material);
    let one = outside(&(glass("glass", 1.5) + &ball(1.5, "glass")));
    assert_invisible("a ball", &one, 20_000);

    let bubble = glass("glass", 1.5) + &glass("air", 1.0) + &ball(1.5, "glass") + &ball(1.2, "air");
    assert_invisible("a bubble in a ball", &outside(&bubble), 20_000);

    let core = glass("glass", 1.5) + &glass("core", 2.4) + &ball(1.5, "glass") + &ball(0.8, "core");
    assert_invisible("a core in a ball", &outside(&core), 20_000);

    let blocks = |right: &str| {
        let left = block([-0.75, 0.0, 0.0], [0.75, 0.8, 0.7], true, ["left"; 6]);
        let right = block([0.75, 0.0, 0.0], [0.75, 0.8, 0.7], true, [right; 6]);
        outside(&(glass("left", 1.5) + &glass("right", 1.9) + &left + &right))
    };
    assert_invisible("two blocks of one glass that touch", &blocks("left"), 20_000);
    assert_invisible("two blocks of two glasses that touch", &blocks("right"), 20_000);
}

/// Radiance in glass is η² times that outside: 2.25 from within a ball, whatever the direction.
#[test]
fn an_eye_within_glass_sees_the_square_of_the_index() {
    let scene = scene(1.0, &(glass("glass", 1.5) + &sphere([0.2, 0.1, 0.0], 1.0, "glass")));
    let moments = found(&scene, ROULETTE, Density::Cosine, 20_000, anywhere);
    let mean = moments.mean();
    assert!((mean - 2.25).abs() <= 32.0 * U, "the mean is {mean}");
}

/// Glass below y = 0, so wide that its sides are never met, and an opaque floor in it; the height
/// of the eye says what rays start in.
fn half_space(floor: &str, sky: f32, eye: f32) -> Scene {
    let body = block([0.0, -1.0, 0.0], [1.0e4, 1.0, 1.0e4], true, ["glass"; 6]);
    let (x, y, z) = (9.0e3, -1.0, 9.0e3);
    let floor = quad([[-x, y, z], [x, y, z], [x, y, -z], [-x, y, -z]], floor);
    let materials = glass("glass", 1.5) + &matte("black", 0.0, 0.0) + &matte("lamp", 0.0, 1.0);
    let mut scene = scene(sky, &(materials + &body + &floor));
    scene.camera.eye = vec3(0.0, eye, 0.0);
    scene.camera.forward = Vec3::Y;
    scene
}

/// Up from y = −½ or down from y = ½, in proportion to the cosine.
fn cosine(up: f32) -> impl Fn(&mut Sampler) -> Ray {
    move |sampler| {
        let d = cosine_hemisphere(sampler.next_2d());
        Ray::new(vec3(0.01, -0.5 * up, 0.02), vec3(d.x, up * d.z, d.y))
    }
}

/// accuracy.md F9: of even light, weighted with the cosine, glass of index 1.5 reflects 0.0917780
/// from outside. From inside it reflects 0.5963458, and lets 1 − 0.5963458 out; seen from within
/// that is n² as much radiance, and n² (1 − R_in) = 1 − R_out.
#[test]
fn the_mean_reflectance_of_glass_is_the_known_one_from_both_sides() {
    let mean = |floor, sky, up: f32, samples| {
        let scene = half_space(floor, sky, -0.5 * up);
        found(&scene, ROULETTE, Density::Cosine, samples, cosine(up))
    };
    let reflected = 0.091_778_0;
    assert_sees(0.03, "R_out", &mean("black", 1.0, -1.0, 600_000), reflected);
    // What comes through from a lamp within the glass is divided by n² on its way out.
    assert_sees(0.01, "T_out", &mean("lamp", 0.0, -1.0, 100_000), (1.0 - reflected) / 2.25);
    assert_sees(0.01, "n² T_in", &mean("black", 1.0, 1.0, 700_000), 1.0 - reflected);
    assert_sees(0.01, "R_in", &mean("lamp", 0.0, 1.0, 400_000), 0.596_345_8);
}

/// A white ball in a ball of glass, in even light: light that is caught in the glass is scattered
/// until it finds a way out. All of it does, so both are invisible.
#[test]
fn a_white_ball_in_glass_is_invisible_in_even_light() {
    let materials = glass("glass", 1.5) + &matte("white", 1.0, 0.0);
    let balls = sphere([0.0; 3], 1.5, "glass") + &sphere([0.3, 0.0, 0.2], 0.8, "white");
    let scene = outside(&(materials + &balls));
    let by_throughput = found(&scene, ROULETTE, Density::Cosine, 100_000, from_outside);
    assert_sees(0.01, "roulette by throughput", &by_throughput, 1.0);
    let by_constant = found(&scene, constant(0.9), Density::Cosine, 300_000, from_outside);
    assert_sees(0.01, "q = 0.9", &by_constant, 1.0);
}

/// Roulette that took squeezed radiance for weak light would end one path in two behind every face
/// of glass of index 1.9; here, with the light of all paths the same, no path has a reason to end.
#[test]
fn roulette_does_not_end_paths_because_glass_squeezes_light() {
    let scene = outside(&(glass("glass", 1.9) + &sphere([0.0; 3], 1.5, "glass")));
    let moments: Moments = found(&scene, ROULETTE, Density::Cosine, 20_000, from_outside);
    assert!(moments.variance() < 1e-10, "variance {:e}", moments.variance());
    let off = Ending { depth: 64, roulette: path_tracing::Roulette::Off };
    let without = found(&scene, off, Density::Cosine, 20_000, from_outside);
    assert!((moments.mean() - without.mean()).abs() <= 8.0 * U, "{moments:?}, {without:?}");
}
