//! Closed rooms, whose light is a geometric series.

use crate::scenes::{
    Pierced, anywhere, assert_sees, block, branching, found, gather, matte, scene, sphere,
    with_tracer_over,
};
use glam::Vec3;
use ray_casting::{LinearSearch, Ray, Scene};
use rendering_equation::Density;
use workbench::{Sampler, Unwatched};

/// A closed room with a ball in it; all of it shines with 1 and reflects `albedo`.
fn furnace(albedo: f32) -> Scene {
    let ball = sphere([0.5, -0.4, 0.3], 0.25, "all");
    let records = matte("all", albedo, 1.0) + &block([0.0; 3], [1.0; 3], false, "all") + &ball;
    scene([0.0; 3], 0.0, &records)
}

/// Σ ρⁱ for i up to the depth.
fn series(ratio: f64, depth: u32) -> f64 {
    (0..=depth).map(|i| ratio.powi(i as i32)).sum()
}

/// accuracy.md E1 for a path of k events, with directions of cosine density: every single estimate is
/// the sum, whatever N, because every weight is the albedo.
#[test]
fn in_a_furnace_every_estimate_is_the_sum_of_the_series() {
    for (albedo, n, depth) in [(0.5, 1, 30), (0.8, 1, 60), (0.95, 1, 400), (0.8, 2, 6), (0.5, 3, 4)]
    {
        let cosine = branching(n, depth, Density::Cosine);
        let moments = found(&furnace(albedo), cosine, 200, |s| anywhere(Vec3::ZERO, s));
        let expected = series(f64::from(albedo), depth);
        let tolerance = f64::from(depth + 1) * f64::from(f32::EPSILON) * expected;
        let error = (moments.mean() - expected).abs();
        assert!(error <= tolerance, "ρ = {albedo}, N = {n}, D = {depth}: off by {error:e}");
        let spread = moments.variance().sqrt();
        assert!(spread <= tolerance, "ρ = {albedo}, N = {n}: a deviation of {spread:e}");
    }
}

/// With 400 events the whole series is there: 1/(1 − ρ).
#[test]
fn a_furnace_has_the_radiance_one_over_one_minus_albedo() {
    for (albedo, expected) in [(0.5, 2.0), (0.8, 5.0), (0.95, 20.0)] {
        let deep = branching(1, 400, Density::Cosine);
        let moments = found(&furnace(albedo), deep, 50, |s| anywhere(Vec3::ZERO, s));
        let error = (moments.mean() - expected).abs();
        assert!(error <= 1e-3, "ρ = {albedo}: {}", moments.mean());
    }
}

/// With uniform directions the weight is 2ρ cos θ, and the mean the same.
#[test]
fn a_furnace_is_as_bright_with_uniform_directions() {
    for (albedo, n, depth, samples) in
        [(0.5, 1, 6, 40_000), (0.5, 2, 6, 6_000), (0.8, 2, 4, 16_000)]
    {
        let uniform = branching(n, depth, Density::Uniform);
        let moments = found(&furnace(albedo), uniform, samples, |s| anywhere(Vec3::ZERO, s));
        let name = format!("ρ = {albedo}, N = {n}");
        assert_sees(0.02, &name, &moments, series(f64::from(albedo), depth));
        assert!(moments.variance() > 1e-3, "{name}: the variance is {}", moments.variance());
    }
}

/// accuracy.md E3, as it is built in laboratories: an integrating sphere with a port through which an
/// even light falls. Of a point's surroundings the port is always the share f, wherever the point
/// is, so the wall has L = ρ (f Lₑ + (1 − f) L).
///
/// The table's own sphere, whose lamp reflects as the wall does, has ρ f Lₑ/(1 − ρ): the port does
/// not reflect.
#[test]
fn an_integrating_sphere_is_evenly_lit() {
    let (albedo, share) = (0.8, 0.25);
    let scene =
        scene([0.0; 3], 1.0, &(matte("wall", albedo, 0.0) + &sphere([0.0; 3], 1.0, "wall")));
    let whole = LinearSearch::new(&scene.geometry, &Unwatched);
    // The area of a cap is proportional to its height: f = (1 − z)/2.
    let pierced = Pierced { whole: &whole, height: 1.0 - 2.0 * share };
    let ratio = f64::from(albedo * (1.0 - share));
    let walls = [Vec3::NEG_Z, Vec3::X, Vec3::new(-0.6, 0.64, -0.48), Vec3::new(0.3, 0.87, 0.4)];
    for (density, depth, samples) in [
        (Density::Cosine, 1, 100_000),
        (Density::Cosine, 3, 60_000),
        (Density::Cosine, 30, 40_000),
        (Density::Uniform, 1, 100_000),
        (Density::Uniform, 3, 100_000),
    ] {
        let expected = f64::from(albedo * share) * series(ratio, depth - 1);
        with_tracer_over(&scene, &pierced, branching(1, depth, density), |radiance| {
            for wall in walls {
                let ray = Ray::new(Vec3::new(0.1, -0.2, 0.05), wall.normalize());
                let moments = gather(samples, |sampler| radiance(ray, sampler));
                let name = format!("toward {wall}, D = {depth}, {density:?}");
                assert_sees(0.07, &name, &moments, expected);
            }
            // From all sides together: a smaller bias can be seen.
            let moments = gather(5 * samples, |sampler| {
                let wall = walls[(4.0 * sampler.next_1d()) as usize];
                radiance(Ray::new(Vec3::ZERO, wall.normalize()), sampler)
            });
            assert_sees(0.03, &format!("D = {depth}, {density:?}"), &moments, expected);
        });
    }
}

/// accuracy.md E4: a shining grey ball in a grey hollow ball. Occlusion and many reflections, and
/// still two equations with two unknowns:
///
/// ```text
/// B₁ = 1 + ρ₁ B₂,   B₂ = ρ₂ (¼ B₁ + ¾ B₂)
/// ```
fn concentric() -> Scene {
    let materials = matte("inner", 0.5, 1.0) + &matte("outer", 0.8, 0.0);
    let spheres = sphere([0.0; 3], 1.0, "inner") + &sphere([0.0; 3], 2.0, "outer");
    scene([0.0, 0.0, 1.5], 0.0, &(materials + &spheres))
}

/// The equations, iterated: B₁ and B₂ by at most `depth` reflections.
fn radiosities(depth: u32) -> [f64; 2] {
    (0..depth).fold([1.0, 0.0], |[b1, b2], _| [1.0 + 0.5 * b2, 0.8 * (0.25 * b1 + 0.75 * b2)])
}

#[test]
fn concentric_spheres_light_each_other() {
    let [b1, b2] = radiosities(60);
    assert!((b1 - 4.0 / 3.0).abs() < 1e-7 && (b2 - 2.0 / 3.0).abs() < 1e-7, "{b1}, {b2}");
    let scene = concentric();
    let look = |direction: Vec3| Ray::new(Vec3::new(0.0, 0.0, 1.5), direction.normalize());
    let rays = [look(Vec3::new(0.1, 0.2, -1.0)), look(Vec3::new(0.5, 0.1, 0.4))];
    for (density, n, depth, samples) in [
        (Density::Cosine, 1, 60, 50_000),
        (Density::Cosine, 3, 4, 6_000),
        (Density::Uniform, 2, 4, 15_000),
    ] {
        let expected = radiosities(depth);
        for (ray, expected) in rays.into_iter().zip(expected) {
            let moments = found(&scene, branching(n, depth, density), samples, |_| ray);
            let name = format!("N = {n}, D = {depth}, {density:?}");
            assert_sees(0.05, &name, &moments, expected);
        }
    }
}

/// A bias of 1 % in the albedo of the outer sphere is found (E4 as a measuring device).
#[test]
fn a_bias_of_one_percent_in_a_room_is_found() {
    let scene = concentric();
    let ray = Ray::new(Vec3::new(0.0, 0.0, 1.5), Vec3::Z);
    let cosine = branching(1, 3, Density::Cosine);
    let moments = found(&scene, cosine, 600_000, |_: &mut Sampler| ray);
    let [_, expected] = radiosities(3);
    assert_sees(0.01, "E4", &moments, expected);
    let planted = statistics::check_mean("planted", &moments, 1.01 * expected);
    assert!(planted.is_err(), "{} passed for {}", moments.mean(), 1.01 * expected);
}
