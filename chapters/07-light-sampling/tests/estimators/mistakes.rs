//! Planted bugs: the tests of this folder must notice them.
//!
//! An estimator of direct light, written once more in its plainest form, with a place for each
//! mistake. Without one it must pass, with any of them it must fail, on the scenes and with the
//! numbers of samples of the other tests.

use glam::{Vec3, vec3};
use light_sampling::{Estimator, Heuristic, Lights};
use ray_casting::{Intersect, LinearSearch, Rgb, Scene};
use rendering_equation::{Brdf, Density, Lambert};
use statistics::{Moments, check_mean, seed};
use workbench::{Sampler, Unwatched};

use crate::scenes::{add_quad, at_receiver, lamp, limited, radiance, receiver};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mistake {
    Nothing,
    /// Both ways to find a lamp are added, without weights.
    CountedTwice,
    /// The density does not say how rarely the lamp was chosen.
    NoPmf,
    /// The density is left as it was drawn, per unit area.
    WrongMeasure,
    /// The cosine at the receiver is left out.
    NoCosine,
    /// Only one of the two ways is weighted.
    OneWeight,
    /// A lamp that is met is told how often it is chosen where it is, not where it was looked for.
    PmfOfElsewhere,
}

/// Two unequal square lamps, far enough apart that each is a small part of the sky.
fn two_lamps() -> Scene {
    let mut scene = receiver([lamp(1.0, 0.0), lamp(3.0, 0.0)]);
    let square = |x0: f32, z0: f32, y: f32, size: f32| {
        let corners = [(x0, z0), (x0 + size, z0), (x0 + size, z0 + size), (x0, z0 + size)];
        corners.map(|(x, z)| vec3(x, y, z))
    };
    add_quad(&mut scene, square(0.0, 0.0, 1.0, 1.0), 1);
    add_quad(&mut scene, square(-3.0, 0.0, 3.0, 3.0), 2);
    scene
}

/// The same square at one corner or the other: F = 0.1385316 for both, so E = π F (1 + 3).
const EXPECTED: f64 = 4.0 * 0.138_531_6;

/// L of the receiver by both ways, weighted; one of them with a mistake.
fn direct_light(scene: &Scene, mistake: Mistake, n: u32) -> Moments {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let ray = at_receiver();
    let hit = geometry.intersect(&ray).expect("the receiver is there");
    let surface = scene.surface(&ray, &hit);
    let normal = surface.facing_normal();
    let lambert = Lambert { albedo: Rgb::ONE };
    let brdf = Brdf { normal, facing: normal, wo: surface.wo, lambert, lobe: None };
    let lights = Lights::new(scene);
    let weight = |own: f32, other: f32| match mistake {
        Mistake::CountedTwice => 1.0,
        _ => Heuristic::Power.weight(own, other),
    };
    let mut sampler = Sampler::new(seed(0x77), 0, 0);
    let mut once = || {
        let mut sum = 0.0;
        if let Some(light) = lights.sample(&surface, &mut sampler)
            && brdf.is_above(light.wi)
            && !geometry.occluded(&light.shadow_ray(&surface))
        {
            let pdf = light.pdf_solid_angle;
            let cos = if mistake == Mistake::NoCosine { 1.0 } else { brdf.cos_theta(light.wi) };
            let wrong = match mistake {
                Mistake::NoPmf => 0.5, // of one lamp of about two
                Mistake::WrongMeasure => {
                    let end = light.end.expect("a flat lamp");
                    let path = end.position - surface.position;
                    path.length_squared() / path.normalize().y
                }
                _ => 1.0,
            };
            let w = weight(pdf, brdf.pdf(Density::Cosine, light.wi));
            sum += w * wrong * brdf.eval(light.wi).x * cos * light.radiance.x / pdf;
        }
        if let Some(scattered) = brdf.sample(Density::Cosine, &mut sampler) {
            let ray = surface.spawn(scattered.wi);
            if let Some(hit) = geometry.intersect(&ray) {
                let met = scene.surface(&ray, &hit);
                let emitted = scene.materials[met.material as usize].ke[0];
                let mut pdf = lights.pdf_of_lamp(surface.position, normal, &met);
                if mistake == Mistake::PmfOfElsewhere {
                    let number = (met.hit.primitive as usize - 2) / 2;
                    let right = lights.pmf(surface.position, normal, number);
                    let there = met.position + 0.1 * met.geometric_normal;
                    pdf *= lights.pmf(there, -met.geometric_normal, number) / right;
                }
                if emitted > 0.0 && met.is_front() {
                    let w = match mistake {
                        Mistake::OneWeight => 1.0,
                        _ => weight(scattered.pdf_solid_angle, pdf),
                    };
                    sum += w * scattered.weight.x * emitted;
                }
            }
        }
        f64::from(sum)
    };
    (0..n).map(|_| once()).collect()
}

#[test]
fn planted_bugs_are_noticed_and_their_absence_is_not() {
    let scene = two_lamps();
    let of = |mistake| {
        check_mean(&format!("{mistake:?}"), &direct_light(&scene, mistake, 60_000), EXPECTED)
    };
    let right = of(Mistake::Nothing);
    assert!(right.as_ref().is_ok_and(|bias| *bias < 0.02), "without a mistake: {right:?}");
    for mistake in [
        Mistake::CountedTwice,
        Mistake::NoPmf,
        Mistake::WrongMeasure,
        Mistake::NoCosine,
        Mistake::OneWeight,
        Mistake::PmfOfElsewhere,
    ] {
        let result = of(mistake);
        assert!(result.is_err(), "{mistake:?} passes: {result:?}");
    }
}

/// Without a competitor, each way alone is right.
#[test]
fn the_two_ways_alone_are_right_too() {
    let scene = two_lamps();
    for (estimator, n) in [(Estimator::Scatter, 400_000), (Estimator::Light, 60_000)] {
        let samples = radiance(&scene, limited(estimator, 1), at_receiver(), n);
        let result = check_mean(&format!("{estimator:?}"), &samples, EXPECTED);
        assert!(result.is_ok(), "{result:?}");
    }
}

/// The tests see 1 %: a lamp that is so much brighter fails against the closed form, and against
/// itself as it was.
#[test]
fn one_percent_more_light_is_noticed() {
    let n = [1_000_000, 60_000, 60_000];
    for (estimator, n) in crate::scenes::ESTIMATORS.into_iter().zip(n) {
        let seen = |ke: f32| {
            let mut scene = receiver([lamp(ke, 0.0)]);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            add_quad(&mut scene, corners.map(|(x, z)| Vec3::new(x, 1.0, z)), 1);
            let samples = radiance(&scene, limited(estimator, 1), at_receiver(), n);
            check_mean(&format!("{estimator:?} with {ke}"), &samples, 0.554_126_4)
        };
        let (right, brighter) = (seen(1.0), seen(1.01));
        assert!(right.is_ok(), "{right:?}");
        assert!(brighter.is_err(), "{estimator:?}: 1 % passes: {brighter:?}");
    }
}
