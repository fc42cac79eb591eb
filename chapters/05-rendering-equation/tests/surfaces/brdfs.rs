//! BRDFs as the tracer uses them: a direction is drawn, weighed, and has a density.

use crate::{at_degrees, surface};
use glam::Vec3;
use ray_casting::Rgb;
use rendering_equation::directions::uniform_hemisphere;
use rendering_equation::{Brdf, Density, Frame, Lambert, Lobe};
use statistics::{Grid, Rejected, assert_directions, check_directions, seed};
use workbench::Sampler;

const ANGLES: [f64; 5] = [0.0, 30.0, 55.0, 75.0, 89.0];

fn assert_follows(name: &str, brdf: &Brdf, density: Density, grid: &Grid, samples: u32) {
    let mut sampler = Sampler::new(seed(5), 3, 0);
    assert_directions(
        &format!("{name}, viewer {}", brdf.wo),
        grid,
        samples,
        Rejected::Remainder,
        || brdf.sample(density, &mut sampler).map(|scattered| scattered.wi.to_array()),
        |wi| f64::from(brdf.pdf(density, Vec3::from_array(wi))),
    );
}

/// accuracy.md M2 for the highlight alone, for five viewers. What leads below the surface is the
/// rest that the density leaves.
#[test]
fn directions_of_a_broad_highlight_follow_their_density() {
    for exponent in [0.0, 1.0, 20.0] {
        for theta in ANGLES {
            let brdf = surface(0.0, Some((1.0, exponent)), at_degrees(theta));
            let name = format!("p = {exponent}");
            assert_follows(&name, &brdf, Density::Cosine, &Grid::SPHERE, 100_000);
        }
    }
}

/// A narrow lobe deserves a grid around the mirror direction.
#[test]
fn directions_of_a_narrow_highlight_follow_their_density() {
    for (exponent, reach) in [(300.0, 0.5), (2000.0, 0.2)] {
        for theta in [0.0, 20.0, 40.0, 50.0, 60.0] {
            let wo = at_degrees(theta);
            let mirrored = Vec3::new(-wo.x, -wo.y, wo.z);
            let grid = Grid::SPHERE.around(mirrored.to_array()).within(reach);
            let brdf = surface(0.0, Some((0.5, exponent)), wo);
            assert_follows(&format!("p = {exponent}"), &brdf, Density::Cosine, &grid, 100_000);
        }
    }
}

#[test]
fn directions_of_a_mixture_follow_their_density() {
    for theta in ANGLES {
        let brdf = surface(0.3, Some((0.5, 30.0)), at_degrees(theta));
        assert_follows("mixture", &brdf, Density::Cosine, &Grid::SPHERE, 200_000);
    }
    let brdf = surface(0.3, Some((0.5, 30.0)), at_degrees(40.0));
    assert_follows("mixture, uniform", &brdf, Density::Uniform, &Grid::SPHERE, 200_000);
}

/// Where the mesh has normals, the cosine's normal and the surface's differ: nothing may be drawn
/// below either.
#[test]
fn directions_under_an_interpolated_normal_follow_their_density() {
    let mut brdf = surface(0.5, Some((0.3, 10.0)), at_degrees(30.0));
    brdf.facing = Vec3::new(0.3, 0.1, 1.0).normalize();
    assert_follows("bent", &brdf, Density::Cosine, &Grid::SPHERE, 200_000);
}

/// The same mixture with a wrong share of the highlight: 1 % of the samples move.
#[test]
fn a_wrong_share_of_the_highlight_is_found() {
    let wo = at_degrees(55.0);
    let drawn = surface(0.3, Some((0.5, 30.0)), wo);
    let claimed = surface(0.33, Some((0.5, 30.0)), wo);
    let mut sampler = Sampler::new(seed(5), 4, 0);
    let found = check_directions(
        "planted",
        &Grid::SPHERE,
        1_000_000,
        Rejected::Remainder,
        || drawn.sample(Density::Cosine, &mut sampler).map(|scattered| scattered.wi.to_array()),
        |wi| f64::from(claimed.pdf(Density::Cosine, Vec3::from_array(wi))),
    );
    assert!(found.is_err(), "a share of 0.602 passed for one of 0.625: {found:?}");
}

/// accuracy.md M10, and the weight is f cos θ / p.
#[test]
fn a_sample_says_what_the_density_and_the_brdf_say() {
    let mut sampler = Sampler::new(seed(5), 5, 0);
    for density in [Density::Uniform, Density::Cosine] {
        for lobe in [None, Some((0.4, 3.5)), Some((0.4, 200.0))] {
            for theta in ANGLES {
                let brdf = surface(0.5, lobe, at_degrees(theta));
                for _ in 0..2000 {
                    let Some(sample) = brdf.sample(density, &mut sampler) else { continue };
                    let pdf = brdf.pdf(density, sample.wi);
                    assert_eq!(sample.pdf_solid_angle, pdf, "{density:?}, {lobe:?}, {theta}°");
                    let weight = brdf.eval(sample.wi).x * brdf.cos_theta(sample.wi) / pdf;
                    let ratio = sample.weight.x / weight;
                    assert!((ratio - 1.0).abs() < 1e-6, "{density:?}, {lobe:?}: ratio {ratio}");
                }
            }
        }
    }
}

#[test]
fn light_goes_both_ways_alike() {
    let mut sampler = Sampler::new(seed(5), 6, 0);
    for exponent in [0.0, 1.0, 10.0, 7.3, 1000.0] {
        for _ in 0..1000 {
            let [a, b] = [(); 2].map(|()| uniform_hemisphere(sampler.next_2d()));
            let (there, back) = (
                surface(0.4, Some((0.6, exponent)), a).eval(b),
                surface(0.4, Some((0.6, exponent)), b).eval(a),
            );
            assert_eq!(there, back, "p = {exponent}, {a} and {b}");
        }
    }
}

#[test]
fn nothing_is_reflected_below_the_surface() {
    let brdf = surface(0.5, Some((0.5, 10.0)), at_degrees(30.0));
    for wi in [Vec3::NEG_Z, Vec3::X, Vec3::new(0.6, 0.0, -0.8)] {
        assert_eq!(brdf.eval(wi), Rgb::ZERO, "f toward {wi}");
        assert_eq!(brdf.pdf(Density::Cosine, wi), 0.0, "p toward {wi}");
    }
    // An interpolated normal of 30°: above it and below the surface, and the other way round.
    let tilted = Brdf { normal: at_degrees(30.0), ..brdf };
    for degrees in [100.0, -70.0] {
        let wi = at_degrees(degrees);
        assert!((tilted.facing.dot(wi) > 0.0) != (tilted.normal.dot(wi) > 0.0), "{degrees}°");
        assert_eq!(tilted.eval(wi), Rgb::ZERO, "f toward {degrees}°");
        assert_eq!(tilted.pdf(Density::Cosine, wi), 0.0, "p toward {degrees}°");
    }
}

#[test]
fn only_a_surface_without_both_parts_is_black() {
    let wo = Vec3::Z;
    assert!(surface(0.0, None, wo).is_black(), "neither part");
    assert!(!surface(0.1, None, wo).is_black(), "a matte part");
    assert!(!surface(0.0, Some((0.1, 1.0)), wo).is_black(), "a highlight");
}

/// The sampler's frame is the one of the normal: a tilted surface is a tilted copy.
#[test]
fn a_surface_may_face_anywhere() {
    for normal in crate::normals() {
        let frame = Frame::around(normal);
        let brdf = Brdf {
            normal,
            facing: normal,
            wo: frame.to_world(at_degrees(40.0)),
            lambert: Lambert { albedo: Rgb::splat(0.4) },
            lobe: Some(Lobe::new(Rgb::splat(0.4), 15.0)),
        };
        let grid = Grid::SPHERE.around(normal.to_array());
        assert_follows("tilted", &brdf, Density::Cosine, &grid, 100_000);
    }
}
