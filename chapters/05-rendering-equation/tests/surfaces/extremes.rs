//! Random numbers at the ends of their range: accuracy.md M5 and M6.

use crate::{at_degrees, normals, surface};
use glam::Vec3;
use rendering_equation::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
    uniform_sphere,
};
use rendering_equation::{Density, Frame, Lobe};
use workbench::Sampler;

const U: f32 = f32::EPSILON / 2.0;

fn extremes() -> impl Iterator<Item = [f32; 2]> {
    let values = [0.0, U, 0.5, 1.0 - U];
    values.into_iter().flat_map(move |a| values.map(|b| [a, b]))
}

fn assert_unit(name: &str, u: [f32; 2], direction: Vec3) {
    let error = (direction.as_dvec3().length() - 1.0).abs();
    assert!(error <= f64::from(4.0 * U), "{name} of {u:?} is {direction}, off by {error:e}");
}

#[test]
fn extreme_numbers_give_unit_vectors_of_positive_density() {
    for u in extremes() {
        let cosine = cosine_hemisphere(u);
        assert_unit("cosine", u, cosine);
        assert!(cosine_hemisphere_pdf(cosine.z) > 0.0, "cosine, u = {u:?}: {cosine}");
        let uniform = uniform_hemisphere(u);
        assert_unit("uniform", u, uniform);
        assert!(uniform_hemisphere_pdf(uniform.z) > 0.0, "uniform, u = {u:?}: {uniform}");
        assert_unit("sphere", u, uniform_sphere(u));
        for exponent in [0.0, 1.0, 10.0, 1e4, 1e9] {
            let lobe = Lobe::new(Vec3::ONE, exponent);
            for theta in [0.0, 45.0, 89.9] {
                let wi = lobe.sample(Vec3::Z, at_degrees(theta), u);
                assert_unit("lobe", u, wi);
            }
        }
    }
}

/// accuracy.md M6: no direction lies in the plane, for any `u` below 1.
#[test]
fn cosine_directions_stay_off_the_plane() {
    let lowest = cosine_hemisphere([1.0 - U, 0.3]).z;
    assert!(lowest >= 2.44e-4, "the lowest cosine is {lowest:e}");
}

#[test]
fn turning_keeps_the_length() {
    for normal in normals() {
        let frame = Frame::around(normal);
        for u in extremes() {
            let turned = frame.to_world(cosine_hemisphere(u)).as_dvec3().length();
            assert!((turned - 1.0).abs() <= 5e-7, "around {normal}, u = {u:?}: {turned}");
        }
    }
}

/// No weight is NaN or infinite, for exponents far beyond what rounded normals can resolve.
#[test]
fn weights_are_finite_for_every_exponent_and_viewer() {
    let mut sampler = Sampler::new(0, 0, 0);
    for exponent in [0.0, 1e-30, 0.5, 1.0, 1e3, 1e6, 1e8, 1e12, 3e38] {
        for theta in [0.0, 30.0, 80.0, 89.99, 90.0] {
            for kd in [0.0, 0.5] {
                for density in [Density::Uniform, Density::Cosine] {
                    let brdf = surface(kd, Some((0.5, exponent)), at_degrees(theta));
                    for _ in 0..300 {
                        let Some(sample) = brdf.sample(density, &mut sampler) else { continue };
                        let weight = sample.weight;
                        assert!(
                            weight.is_finite() && weight.min_element() >= 0.0,
                            "p = {exponent}, {theta}°, kd = {kd}, {density:?}: {sample:?}"
                        );
                    }
                }
            }
        }
    }
}

/// At p = 2²⁴ the smallest step of n·h is a factor of e, and still nothing breaks (accuracy.md BP3).
#[test]
fn a_power_of_a_cosine_just_below_one_is_right() {
    let p = 16_777_216.0;
    let power = ray_casting::math::power(1.0 - U, p);
    assert!((power - 0.367_879_4).abs() <= 4.0 * U * power, "(1 − u)^(2²⁴) = {power}");
}
