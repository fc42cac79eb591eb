//! Errata 15: the review's first listing as it is printed, and what becomes of it.

use std::f64::consts::{PI, TAU};

use crate::scenes::{branching, found, gather, matte, scene, sphere};
use glam::Vec3;
use ray_casting::{Intersect, LinearSearch, Ray, Rgb, Scene};
use rendering_equation::directions::{
    cosine_hemisphere, cosine_hemisphere_pdf, uniform_hemisphere, uniform_hemisphere_pdf,
};
use rendering_equation::{Density, Frame};
use statistics::{assert_mean, check_mean};
use workbench::{Sampler, Unwatched};

/// The listing's `shade`, line by line; `n` and `most` are its N and D. A light source is what
/// shines.
struct AsPrinted<'a, G> {
    scene: &'a Scene,
    geometry: &'a G,
    n: u32,
    most: u32,
    density: Density,
}

impl<G: Intersect> AsPrinted<'_, G> {
    fn shade(&self, ray: Ray, depth: u32, sampler: &mut Sampler) -> f32 {
        let mut total = 0.0;
        if depth > self.most {
            return total;
        }
        let Some(hit) = self.geometry.intersect(&ray) else { return 0.0 };
        let surface = self.scene.surface(&ray, &hit);
        let emitted = self.scene.materials[surface.material as usize].ke[0];
        if emitted > 0.0 {
            return emitted;
        }
        for _ in 0..self.n {
            let (wi, pdf) = self.direction(sampler);
            let next = surface.spawn(Frame::around(surface.facing_normal()).to_world(wi));
            total += 1.0 / self.n as f32 * self.shade(next, depth + 1, sampler) / pdf;
        }
        total
    }

    fn direction(&self, sampler: &mut Sampler) -> (Vec3, f32) {
        match self.density {
            Density::Uniform => {
                let wi = uniform_hemisphere(sampler.next_2d());
                (wi, uniform_hemisphere_pdf(wi.z))
            }
            Density::Cosine => {
                let wi = cosine_hemisphere(sampler.next_2d());
                (wi, cosine_hemisphere_pdf(wi.z))
            }
        }
    }
}

/// A black lamp of radius 1 in a closed hollow sphere of radius 2: a room in which the wrong answer,
/// too, has a closed form. From everywhere on the wall the lamp covers the solid angle
///
/// ```text
/// Ω = 2π (1 − √(1 − ¼))
/// ```
///
/// and the rest of the hemisphere is wall.
fn room(albedo: f32) -> Scene {
    let materials = matte("lamp", 0.0, 1.0) + &matte("wall", albedo, 0.0);
    let spheres = sphere([0.0; 3], 1.0, "lamp") + &sphere([0.0; 3], 2.0, "wall");
    scene([0.0, 0.0, 1.5], 0.0, &(materials + &spheres))
}

/// From between the two at the wall.
fn at_wall() -> Ray {
    Ray::new(Vec3::new(0.0, 0.0, 1.5), Vec3::new(0.3, 0.4, 0.8).normalize())
}

fn printed(
    scene: &Scene,
    n: u32,
    most: u32,
    density: Density,
    samples: u64,
) -> statistics::Moments {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let listing = AsPrinted { scene, geometry: &geometry, n, most, density };
    gather(samples, |sampler| Rgb::splat(listing.shade(at_wall(), 0, sampler)))
}

fn lamp() -> f64 {
    TAU * (1.0 - 0.75_f64.sqrt())
}

/// Each bounce multiplies by E[1/p] = 2π, less what ends at the lamp: Ω Σ (2π − Ω)ᵏ.
#[test]
fn erratum_15_the_listing_grows_with_every_bounce() {
    let scene = room(0.5);
    let growth = TAU - lamp();
    assert!((growth - 5.44).abs() < 0.01, "the factor is {growth}");
    let expected = |most: u32| lamp() * (0..most).map(|k| growth.powi(k as i32)).sum::<f64>();
    for (most, samples) in [(1, 300_000), (2, 200_000), (3, 150_000), (5, 150_000), (8, 150_000)] {
        let moments = printed(&scene, 1, most, Density::Uniform, samples);
        let bias = assert_mean(&format!("D = {most}"), &moments, expected(most));
        assert!(bias <= 0.08, "D = {most}: only a bias of {bias} would be seen");
    }
    assert!(expected(8) > 1e5, "at D = 8 the wall is {} times as bright as the lamp", expected(8));
    // The listing's own N changes nothing.
    let moments = printed(&scene, 3, 3, Density::Uniform, 30_000);
    assert_mean("N = 3", &moments, expected(3));
}

/// The corrected listing in the same room: L = ρ (¼ + ¾ L), and it stays there.
#[test]
fn erratum_15_the_corrected_listing_converges() {
    let scene = room(0.5);
    let expected = 0.125 / (1.0 - 0.375);
    for density in [Density::Cosine, Density::Uniform] {
        let moments = found(&scene, branching(1, 40, density), 200_000, |_| at_wall());
        let bias = assert_mean(&format!("{density:?}"), &moments, expected);
        assert!(bias <= 0.05, "{density:?}: only a bias of {bias} would be seen");
    }
}

/// Colour never enters: the wall may be black, and the picture is the same.
#[test]
fn erratum_15_the_listing_does_not_know_the_colour_of_the_wall() {
    let [black, white] = [0.0, 1.0].map(|albedo| {
        let scene = room(albedo);
        printed(&scene, 1, 4, Density::Uniform, 20_000).mean()
    });
    assert_eq!(black, white, "black and white walls");
}

/// With the cosine density the mean of 1/p is the same 2π, but its variance is infinite: ∫ 1/p dω
/// diverges like a logarithm at the horizon.
#[test]
fn erratum_15_the_growth_does_not_depend_on_the_density() {
    let scene = room(0.5);
    let moments = printed(&scene, 1, 2, Density::Cosine, 1_000_000);
    let expected = lamp() * (1.0 + TAU - lamp());
    let error = (moments.mean() / expected - 1.0).abs();
    assert!(error < 0.02, "{} for {expected}", moments.mean());
    let right = check_mean("right", &moments, 0.125 / (1.0 - 0.375));
    assert!(right.is_err(), "the right answer passed for {}", moments.mean());
    assert!(expected > 2.0 * PI * 0.5, "the wall outshines the lamp: {expected}");
}
