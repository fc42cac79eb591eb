//! Samplers of directions that know nothing of a surface, against their densities: accuracy.md M2.

use crate::normals;
use glam::Vec3;
use rendering_equation::Frame;
use rendering_equation::directions::{
    UNIFORM_SPHERE_PDF, cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere,
    uniform_hemisphere_pdf, uniform_sphere,
};
use statistics::{Grid, Rejected, assert_directions, check_directions, seed};
use workbench::Sampler;

const SAMPLES: u32 = 300_000;

/// The harness also finds ∫ p dω, which must be 1 to 10⁻⁴ (M3), and that p is above 0 wherever a
/// sample lies.
fn assert_hemisphere(name: &str, sample: fn([f32; 2]) -> Vec3, pdf: fn(f32) -> f32) {
    for (i, normal) in normals().into_iter().enumerate() {
        let frame = Frame::around(normal);
        let mut sampler = Sampler::new(seed(5), 0, i as u64);
        let grid = Grid::SPHERE.around(normal.to_array());
        assert_directions(
            &format!("{name} around {normal}"),
            &grid,
            SAMPLES,
            Rejected::Never,
            || Some(frame.to_world(sample(sampler.next_2d())).to_array()),
            |wi| f64::from(pdf(normal.dot(Vec3::from_array(wi)))),
        );
    }
}

#[test]
fn cosine_directions_follow_their_density() {
    assert_hemisphere("cosine", cosine_hemisphere, cosine_hemisphere_pdf);
}

#[test]
fn uniform_directions_of_a_hemisphere_follow_their_density() {
    assert_hemisphere("uniform", uniform_hemisphere, uniform_hemisphere_pdf);
}

#[test]
fn uniform_directions_of_the_sphere_follow_their_density() {
    for (i, grid) in [Grid::SPHERE, Grid::ODD].into_iter().enumerate() {
        let mut sampler = Sampler::new(seed(5), 1, i as u64);
        let sample = || Some(uniform_sphere(sampler.next_2d()).to_array());
        let pdf = |_: [f32; 3]| f64::from(UNIFORM_SPHERE_PDF);
        assert_directions("sphere", &grid, 1_000_000, Rejected::Never, sample, pdf);
    }
}

/// The densities are called by mistake for one another, and one pair of numbers is used in the wrong
/// order.
#[test]
fn planted_mistakes_of_samplers_are_found() {
    let check = |sample: fn([f32; 2]) -> Vec3, pdf: fn(f32) -> f32| {
        let mut sampler = Sampler::new(seed(5), 2, 0);
        let sample = || Some(sample(sampler.next_2d()).to_array());
        let pdf = |wi: [f32; 3]| f64::from(pdf(wi[2]));
        check_directions("planted", &Grid::SPHERE, SAMPLES, Rejected::Never, sample, pdf)
    };
    let right = check(cosine_hemisphere, cosine_hemisphere_pdf);
    assert!(right.is_ok(), "the right one: {right:?}");
    let swapped = check(cosine_hemisphere, uniform_hemisphere_pdf);
    assert!(swapped.is_err(), "cosine directions passed for uniform ones");
    let cubed = |u: [f32; 2]| cosine_hemisphere([1.0 - (1.0 - u[0]).sqrt(), u[1]]);
    let cubed = check(cubed, cosine_hemisphere_pdf);
    assert!(cubed.is_err(), "cos³ θ passed for cos θ");
    let half = check(|u| cosine_hemisphere([u[0], 0.5 * u[1]]), cosine_hemisphere_pdf);
    assert!(half.is_err(), "half of the azimuths passed for all");
    let correlated = check(|u| cosine_hemisphere([u[0], u[0]]), cosine_hemisphere_pdf);
    assert!(correlated.is_err(), "one number passed for two");
}
