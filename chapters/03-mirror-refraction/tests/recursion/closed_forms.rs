//! What physics answers exactly.

use crate::scenes::{add_block, add_quad, add_sphere, black, glass, mirror, radiance, white};
use glam::{Vec3, vec3};
use mirror_refraction::Limits;
use ray_casting::{Ray, Rgb, Scene};

const U: f32 = f32::EPSILON / 2.0;

fn depth(depth: u32) -> Limits {
    Limits::new(Some(depth), 0.0)
}

/// From z = 5 along −z, through (x, y).
fn head_on(x: f32, y: f32) -> Ray {
    Ray::new(vec3(x, y, 5.0), Vec3::NEG_Z)
}

/// A black wall, seen from the front.
fn add_wall(scene: &mut Scene, z: f32, material: u32) {
    let corner = |x: f32, y: f32| vec3(x, y, z);
    let corners = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)];
    add_quad(scene, corners.map(|(x, y)| corner(x, y)), material);
}

/// accuracy F11: R = 1/13, by one more round trip for every two levels of the recursion. The ray
/// through the middle meets the diagonals on which the quads are cut.
#[test]
fn a_glass_slab_reflects_a_thirteenth() {
    let mut scene = white([glass(1.5), black()]);
    add_block(&mut scene, vec3(-1.0, -1.0, 0.0), Vec3::ONE, 0, |v| v);
    add_wall(&mut scene, -5.0, 1);
    let partial = [(1, 0.04), (2, 0.04), (3, 0.076_864), (5, 0.076_922_98), (30, 1.0 / 13.0)];
    for (x, y) in [(0.0, 0.0), (0.3, -0.4), (0.5, 0.5)] {
        for (levels, expected) in partial {
            let reflected = radiance(&scene, head_on(x, y), depth(levels)).x;
            let error = (reflected - expected).abs();
            assert!(error <= 4.0 * U, "depth {levels} at ({x}, {y}): {reflected} for {expected}");
        }
    }
}

/// F11 from the other side: T = 12/13.
#[test]
fn a_glass_slab_lets_twelve_thirteenths_through() {
    let mut scene = white([glass(1.5), black()]);
    add_block(&mut scene, vec3(-1.0, -1.0, 0.0), Vec3::ONE, 0, |v| v);
    add_wall(&mut scene, 7.0, 1);
    let through = radiance(&scene, head_on(0.3, -0.4), depth(30)).x;
    assert!((through - 12.0 / 13.0).abs() <= 8.0 * U, "T = {through}");
}

/// accuracy F12: what a depth of D loses is the light that has been reflected inside D − 1 times.
#[test]
fn a_glass_sphere_in_white_surroundings_loses_only_the_tail_beyond_the_depth() {
    let mut scene = white([glass(1.5)]);
    add_sphere(&mut scene, Vec3::ZERO, 1.0, 0);
    for i in 0..20 {
        let x = (i as f32 + 0.5) / 20.0;
        let cos_i = (1.0 - x * x).sqrt();
        let cos_t = (1.0 - x * x / 2.25).sqrt();
        let r = mirror_refraction::fresnel::fresnel(cos_i, cos_t, 1.0 / 1.5);
        for levels in [1, 2, 3, 5, 8, 20] {
            let expected = 1.0 - (1.0 - r) * r.powi(levels as i32 - 1);
            let seen = radiance(&scene, head_on(x, 0.0), depth(levels)).x;
            // Near the rim, the rounding of x changes R by as much as 1/cos θ times itself.
            let tolerance = 40.0 * U / cos_i;
            let error = (seen - expected).abs();
            assert!(error <= tolerance, "x = {x}, depth {levels}: {seen} for {expected}");
        }
    }
}

/// accuracy F15: the ray zigzags between two mirrors, and leaves after k reflections.
#[test]
fn facing_mirrors_dim_by_a_tenth_each_time_until_the_depth_ends() {
    for k in [1_u16, 2, 3, 7, 20] {
        let seen = |levels| zigzag(k, 0.9, depth(levels)).x;
        let expected = 0.9_f32.powi(k.into());
        let enough = seen(u32::from(k));
        assert!((enough - expected).abs() <= f32::from(k) * U, "0.9^{k}: {enough}");
        assert_eq!(seen(u32::from(k) - 1), 0.0, "beyond the depth");
    }
}

/// The deepest recursion there is fits on the stack of a test's thread; more is cut off.
#[test]
fn a_thousand_reflections_do_not_overflow_the_stack() {
    let deep = |k, levels| zigzag(k, 1.0, Limits::new(levels, 0.0)).x;
    assert_eq!(deep(1000, None), 1.0, "1000 reflections");
    assert_eq!(deep(1001, Some(u32::MAX)), 0.0, "1001 reflections");
}

/// Two mirrors so long that a ray at 45° meets them `k` times.
fn zigzag(k: u16, kr: f32, limits: Limits) -> Rgb {
    let mut scene = white([mirror(kr)]);
    for z in [0.0, 1.0] {
        let (x, y) = (f32::from(k), 0.5);
        let corners = [(0.0, -y), (x, -y), (x, y), (0.0, y)];
        add_quad(&mut scene, corners.map(|(x, y)| vec3(x, y, z)), 0);
    }
    let direction = vec3(1.0, 0.0, 1.0).normalize();
    radiance(&scene, Ray::new(vec3(0.0, 0.1, 0.5), direction), limits)
}

/// k_t counts once at each crossing, not for reflections: T = kt² · 0.96².
#[test]
fn the_tint_of_glass_counts_once_a_crossing() {
    let mut green = glass(1.5);
    green.kt = [0.5, 1.0, 0.25];
    let mut scene = white([green, black()]);
    add_block(&mut scene, vec3(-1.0, -1.0, 0.0), Vec3::ONE, 0, |v| v);
    add_wall(&mut scene, 7.0, 1);
    let through = radiance(&scene, head_on(0.3, -0.4), depth(2));
    let expected = 0.96 * 0.96 * Rgb::new(0.25, 1.0, 0.0625);
    assert!((through - expected).abs().max_element() <= 4.0 * U, "{through} for {expected}");
}

/// A ball of glass is a lens: rays near its axis meet at n / (2 (n − 1)) of its radius from the
/// centre, 1.5 for n = 1.5. There stands a black card, in white surroundings: what is not reflected
/// on the way, (1 − 0.04)² of the light, is dark. With the indices exchanged the rays spread.
#[test]
fn a_glass_ball_focuses_where_the_lens_formula_says() {
    let mut scene = white([glass(1.5), black()]);
    let card = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    add_quad(&mut scene, card.map(|(x, y)| vec3(0.01 * x, 0.01 * y, -1.5)), 1);
    add_sphere(&mut scene, Vec3::ZERO, 1.0, 0);
    for (x, y) in [(0.1, 0.0), (-0.1, 0.0), (0.0, 0.1), (0.06, -0.08)] {
        let light = radiance(&scene, head_on(x, y), depth(8)).x;
        assert!((0.04..0.1).contains(&light), "({x}, {y}) sees {light}");
    }
}
