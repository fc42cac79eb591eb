//! The review's listings, run as they are printed.

use crate::as_printed::AsPrinted;
use crate::mistakes::{Mistake, Mistaken};
use crate::scenes::{
    ROULETTE, anywhere, assert_sees, block, depth, found, gather, matte, room, scene, sphere,
};
use glam::{Vec3, vec3};
use ray_casting::{LinearSearch, Ray, Rgb, Scene};
use rendering_equation::{Brdf, Density, Lambert};
use statistics::{Moments, check_mean};
use workbench::{Sampler, Unwatched};

/// A closed room with a red, a green and four grey faces; `lamp` is a ball in it that shines with 1
/// and reflects nothing.
fn coloured_room() -> Scene {
    let red = "[materials.red]\nkd = [0.6, 0.05, 0.05]\n";
    let green = "[materials.green]\nkd = [0.1, 0.5, 0.1]\n";
    let walls = block([0.0; 3], [1.0; 3], false, ["red", "green", "grey", "grey", "grey", "grey"]);
    let lamp = matte("lamp", 0.0, 1.0) + &sphere([0.0, 0.9, 0.0], 0.35, "lamp");
    scene(0.0, &(matte("grey", 0.7, 0.0) + red + green + &lamp + &walls))
}

/// The mean of what `shade` returns for rays along `direction`.
fn printed(
    scene: &Scene,
    density: Density,
    most: u32,
    samples: u64,
    direction: Vec3,
    shade: impl Fn(&AsPrinted<'_, LinearSearch<'_, Unwatched>>, Ray, &mut Sampler) -> Rgb,
) -> Moments {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(scene, &geometry, density, most);
    let ray = Ray::new(Vec3::ZERO, direction);
    gather(samples, |sampler| shade(&review, ray, sampler))
}

/// Errata 15: ∫ p · (1/p) dω is the size of the hemisphere, 2π, whatever p is; tested with a
/// mixture of the two densities, for which 1/p is bounded.
#[test]
fn erratum_15_the_mean_of_one_over_the_density_is_two_pi() {
    let lambert = Lambert { albedo: Rgb::ONE };
    let brdf = Brdf { normal: Vec3::Z, facing: Vec3::Z, wo: Vec3::Z, lambert, lobe: None };
    let moments = gather(200_000, |sampler| {
        let density = if sampler.next_1d() < 0.5 { Density::Cosine } else { Density::Uniform };
        let drawn = brdf.sample(density, sampler).expect("every direction is above the surface");
        let pdf = |density| brdf.pdf(density, drawn.wi);
        Rgb::splat(2.0 / (pdf(Density::Cosine) + pdf(Density::Uniform)))
    });
    assert_sees(0.01, "1/p", &moments, std::f64::consts::TAU);
}

/// Errata 15: in a closed room the first listing grows with its depth. The lamp, of radiance 1, is
/// black, and nothing reflects more than 0.7, so no light in the room exceeds 1.
#[test]
fn erratum_15_the_first_listing_grows_with_its_depth() {
    let scene = coloured_room();
    let down = vec3(0.2, -1.0, 0.1).normalize();
    let means = [1, 2, 3, 4, 6, 8].map(|most| {
        let samples = if most <= 4 { 150_000 } else { 20_000 };
        let shade = printed(&scene, Density::Uniform, most, samples, down, |review, ray, s| {
            review.first(ray, 0, 1, s)
        });
        shade.mean()
    });
    let right = found(&scene, ROULETTE, Density::Cosine, 100_000, |_| Ray::new(Vec3::ZERO, down));
    assert!(right.mean() < 0.5, "the right radiance is {}", right.mean());
    // One bounce more adds 2π times what the one before added, less what lamps have ended.
    let steps = [means[1] - means[0], means[2] - means[1], means[3] - means[2]];
    for pair in steps.windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((4.5..7.5).contains(&ratio), "the steps {steps:?} grow by {ratio}");
    }
    assert!(means[5] > 10_000.0, "at a depth of 8: {means:?}");
}

/// The same with N = 2: more directions do not mend it.
#[test]
fn erratum_15_more_directions_do_not_mend_the_first_listing() {
    let scene = coloured_room();
    let down = vec3(0.2, -1.0, 0.1).normalize();
    let [one, two] = [1, 2].map(|n| {
        printed(&scene, Density::Uniform, 3, 40_000, down, |review, ray, s| {
            review.first(ray, 0, n, s)
        })
    });
    statistics::assert_same_mean("N = 1, N = 2", &one, &two);
    assert!(two.mean() > 1.0, "{}", two.mean());
}

/// Errata 16: the second listing tends to the lamp's radiance wherever one looks, and in every
/// channel, whatever colour the walls have.
#[test]
fn erratum_16_the_second_listing_draws_a_constant_picture() {
    let scene = coloured_room();
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(&scene, &geometry, Density::Cosine, 400);
    let looks = [Vec3::X, Vec3::NEG_X, Vec3::NEG_Y, Vec3::Z];
    for direction in looks {
        let ray = Ray::new(Vec3::ZERO, direction);
        for channel in 0..3 {
            let moments =
                gather(2_000, |sampler| Rgb::splat(review.second(ray, 0, sampler)[channel]));
            let mean = moments.mean();
            assert!((mean - 1.0).abs() < 0.002, "along {direction}, channel {channel}: {mean}");
        }
    }
    let right = looks.map(|d| {
        found(&scene, ROULETTE, Density::Cosine, 20_000, |_| Ray::new(Vec3::ZERO, d)).mean()
    });
    // +x is green, −x is red: the red channel tells.
    assert!(right[1] > 3.0 * right[0] && right[3] > right[0], "the right picture: {right:?}");
}

/// Errata 16: what the listing computes is a room of white walls, and that to the last bit.
#[test]
fn erratum_16_the_second_listing_is_right_for_perfectly_white_walls() {
    let mut scene = coloured_room();
    for material in &mut scene.materials {
        if material.name != "lamp" {
            material.kd = [1.0; 3];
        }
    }
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let review = AsPrinted::new(&scene, &geometry, Density::Cosine, 50);
    crate::scenes::with_paths(&scene, depth(50), Density::Cosine, |follow| {
        for i in 0..2_000 {
            let sampler = || Sampler::new(0, 0, i);
            let start = |sampler: &mut Sampler| anywhere(sampler);
            let (mut a, mut b) = (sampler(), sampler());
            let printed = review.second(start(&mut a), 0, &mut a);
            let right = follow(start(&mut b), &mut b);
            assert_eq!(printed, right, "path {i}");
        }
    });
}

/// Errata 21: a lamp reflects, too. In the furnace the listings return 1 for any albedo.
#[test]
fn erratum_21_the_furnace_gives_one_as_printed() {
    for albedo in [0.5, 0.8] {
        let scene = scene(0.0, &(matte("all", albedo, 1.0) + &room("all")));
        let expected = 1.0 / (1.0 - f64::from(albedo));
        for first in [true, false] {
            let as_printed =
                printed(&scene, Density::Cosine, 50, 1_000, Vec3::X, |review, ray, s| {
                    if first { review.first(ray, 0, 1, s) } else { review.second(ray, 0, s) }
                });
            assert_eq!(as_printed.mean(), 1.0, "the furnace of albedo {albedo}, as printed");
            assert_eq!(as_printed.variance(), 0.0, "its variance");
        }
        let right = found(&scene, ROULETTE, Density::Cosine, 40_000, anywhere);
        assert_sees(0.01, "the furnace", &right, expected);
        // The loop of the chapter with only this mistake has the same answer.
        let stops = Mistaken::new(&scene, Mistake::LampsOnlyShine, Density::Cosine, ROULETTE);
        let moments = gather(1_000, |sampler| stops.radiance(anywhere(sampler), sampler));
        assert_eq!(moments.mean(), 1.0, "the loop that stops at lamps");
        assert!(check_mean("the furnace", &moments, expected).is_err(), "nobody would notice");
    }
}

/// Errata 23: what hits nothing returns 0, so that a ball under the sky is as black as the sky.
#[test]
fn erratum_23_as_printed_there_is_no_sky() {
    let scene = scene(1.0, &(matte("grey", 0.5, 0.0) + &sphere([0.0, 0.0, -5.0], 1.0, "grey")));
    for (direction, expected) in [(Vec3::NEG_Z, 0.5), (Vec3::Y, 1.0)] {
        let as_printed = printed(&scene, Density::Cosine, 50, 100, direction, |review, ray, s| {
            review.second(ray, 0, s)
        });
        assert_eq!(as_printed.mean(), 0.0, "along {direction}, as printed");
        let ray = Ray::new(Vec3::ZERO, direction);
        let right = found(&scene, ROULETTE, Density::Cosine, 1_000, |_| ray);
        assert_sees(0.01, "under the sky", &right, expected);
    }
}
