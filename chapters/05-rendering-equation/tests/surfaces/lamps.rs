//! The two measures, on a lamp: accuracy.md E7, a square of side 1 parallel to the ground, one unit
//! above, one corner straight above the point. E = π L F with F = 0.1385316.

use std::f64::consts::PI;

use glam::{Vec3, vec3};
use rendering_equation::directions::{uniform_hemisphere, uniform_hemisphere_pdf};
use rendering_equation::measures::{geometry_term, pdf_area, pdf_solid_angle};
use statistics::{Moments, assert_mean, check_mean, seed};
use workbench::Sampler;

const FORM_FACTOR: f64 = 0.138_531_6;

fn estimate(samples: u64, mut value: impl FnMut(&mut Sampler) -> f64) -> Moments {
    (0..samples).map(|i| value(&mut Sampler::new(seed(5), 20, i))).collect()
}

fn point_of_lamp(sampler: &mut Sampler) -> Vec3 {
    let [x, z] = sampler.next_2d();
    vec3(x, 1.0, z)
}

/// ∫ cos θ dω over directions, those that meet the lamp.
fn by_direction(sampler: &mut Sampler) -> f64 {
    let wi = uniform_hemisphere(sampler.next_2d());
    let (x, y) = (wi.x / wi.z, wi.y / wi.z);
    let meets = (0.0..1.0).contains(&x) && (0.0..1.0).contains(&y);
    if meets { f64::from(wi.z / uniform_hemisphere_pdf(wi.z)) } else { 0.0 }
}

#[test]
fn directions_points_and_converted_points_agree() {
    let by_area = |sampler: &mut Sampler| {
        let point = point_of_lamp(sampler);
        f64::from(geometry_term(Vec3::ZERO, Vec3::Y, point, Vec3::NEG_Y))
    };
    let converted = |sampler: &mut Sampler| {
        let point = point_of_lamp(sampler);
        let cos = point.normalize().y;
        f64::from(cos / pdf_solid_angle(1.0, point.length_squared(), cos))
    };
    let expected = PI * FORM_FACTOR;
    for (name, moments) in [
        ("directions", estimate(6_000_000, by_direction)),
        ("area form", estimate(200_000, by_area)),
        ("points, density converted", estimate(200_000, converted)),
    ] {
        let bias = assert_mean(name, &moments, expected);
        assert!(bias <= 0.01, "{name}: only a bias of {bias} would be seen");
    }
}

/// Errata 17: the density of a point used as one of a direction, and the other way round.
#[test]
fn erratum_17_mixed_measures_are_found() {
    let points_as_directions = estimate(100_000, |sampler| {
        let point = point_of_lamp(sampler);
        f64::from(point.normalize().y / 1.0)
    });
    let found = check_mean("mixed", &points_as_directions, PI * FORM_FACTOR);
    assert!(found.is_err(), "the mean {} passed", points_as_directions.mean());
    // Not even when the directions are right: p_A instead of p_ω.
    let directions_as_points = estimate(3_000_000, |sampler| {
        let wi = uniform_hemisphere(sampler.next_2d());
        let (x, y) = (wi.x / wi.z, wi.y / wi.z);
        let meets = (0.0..1.0).contains(&x) && (0.0..1.0).contains(&y);
        let pdf = pdf_area(uniform_hemisphere_pdf(wi.z), 1.0 / (wi.z * wi.z), wi.z);
        if meets { f64::from(wi.z / pdf) } else { 0.0 }
    });
    let found = check_mean("mixed", &directions_as_points, PI * FORM_FACTOR);
    assert!(found.is_err(), "the mean {} passed", directions_as_points.mean());
}
