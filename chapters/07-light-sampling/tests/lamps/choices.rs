//! Which light is asked: its probability, and what is drawn.

use glam::{Vec3, vec3};
use light_sampling::{Choice, Light, Lights, Measure, Nearby};
use ray_casting::{Rgb, Scene, SurfacePoint};
use statistics::{assert_chi_squared, check_chi_squared, seed};
use workbench::Sampler;

use crate::scenes::{
    LAMP, add_point_light, add_quad, add_sphere, add_triangle, empty, in_ball, viewer,
};

/// Lights of all kinds, `n` of each but the sky, within 4 of the origin.
fn all_kinds(n: u32, sampler: &mut Sampler) -> Scene {
    let mut scene = empty();
    for _ in 0..n {
        let place = 3.0 * in_ball(sampler);
        let corners = [(); 3].map(|()| place + in_ball(sampler));
        add_triangle(&mut scene, corners, LAMP);
    }
    for _ in 0..n {
        let place = 3.0 * in_ball(sampler);
        let [x, y] = [vec3(0.5, 0.3, 0.1), vec3(-0.3, 0.2, 0.5)];
        add_quad(&mut scene, [place, place + x, place + x + y, place + y], LAMP);
    }
    for _ in 0..n {
        let radius = 0.1 + 0.5 * sampler.next_1d();
        add_sphere(&mut scene, 3.0 * in_ball(sampler), radius, LAMP);
    }
    for _ in 0..n {
        let intensity = sampler.next_1d();
        add_point_light(&mut scene, 3.0 * in_ball(sampler), intensity);
    }
    scene.background = Rgb::splat(0.02);
    scene
}

/// A surface at a random place.
fn anywhere(sampler: &mut Sampler) -> SurfacePoint {
    let facing = in_ball(sampler).normalize();
    viewer(4.0 * in_ball(sampler), facing)
}

/// What the weights of [`Nearby`] come from, once more, in the plainest form and in double
/// precision: I cos θ' cos θ / (d² + r²), and half of π L of the sky. `allowance` is added to the cosines.
fn weight(light: &Light, surface: &SurfacePoint, allowance: f64) -> f64 {
    let pi = std::f64::consts::PI;
    let sum = |rgb: Rgb| f64::from(rgb.element_sum());
    let (middle, radius, normal, intensity) = match light {
        Light::Flat(lamp) => {
            let intensity = lamp.area() * sum(lamp.radiance);
            (lamp.middle, lamp.radius, Some(lamp.normal), intensity)
        }
        Light::Sphere(lamp) => {
            let radius = f64::from(lamp.sphere.radius);
            let intensity = pi * radius * radius * sum(lamp.radiance);
            (lamp.sphere.center, lamp.sphere.radius, None, intensity)
        }
        Light::Point { position, intensity } => (*position, 0.0, None, sum(*intensity)),
        Light::Sky { radiance } => return 0.5 * pi * sum(*radiance),
    };
    let way = middle.as_dvec3() - surface.position.as_dvec3();
    let squared = way.length_squared() + f64::from(radius) * f64::from(radius);
    let cos = |height: f64| (height / squared.sqrt() + allowance).max(0.0);
    let cos_lamp = normal.map_or(1.0, |normal| cos(-normal.as_dvec3().dot(way)));
    let facing = surface.facing_normal().as_dvec3();
    intensity * cos_lamp * cos(facing.dot(way) + f64::from(radius)) / squared
}

/// They lie between the formula and the formula with the allowance for rounding, which is at most
/// γ(8) and, as none of these scenes is larger than 8, twice γ(2) · 8 over a distance of ½.
#[test]
fn nearby_lights_have_the_probabilities_of_the_plain_formula() {
    let mut sampler = Sampler::new(seed(0x7107), 0, 0);
    for n in [1, 2, 5, 9] {
        let scene = all_kinds(n, &mut sampler);
        let lights = Lights::new(&scene);
        for _ in 0..500 {
            let surface = anywhere(&mut sampler);
            let weights = |allowance: f64| -> Vec<f64> {
                lights.all().iter().map(|light| weight(light, &surface, allowance)).collect()
            };
            let (least, most) = (weights(0.0), weights(5e-6));
            let (least_sum, most_sum) = (least.iter().sum::<f64>(), most.iter().sum::<f64>());
            for (number, (least, most)) in least.iter().zip(&most).enumerate() {
                let pmf = lights.pmf(surface.position, surface.facing_normal(), number);
                let bounds = (1.0 - 1e-6) * least / most_sum..=(1.0 + 1e-6) * most / least_sum;
                assert!(
                    bounds.contains(&f64::from(pmf)),
                    "light {number}: {pmf} not in {bounds:?}"
                );
            }
        }
    }
}

#[test]
fn the_probabilities_of_all_lights_add_up_to_one() {
    let mut sampler = Sampler::new(seed(0x7207), 0, 0);
    for choice in [Choice::Uniform, Choice::Power, Choice::Nearby] {
        for n in [1, 4, 40, 300] {
            let scene = all_kinds(n, &mut sampler);
            let lights = Lights::with(&scene, choice, Measure::SolidAngle);
            for _ in 0..200 {
                let surface = anywhere(&mut sampler);
                let pmf = |number| lights.pmf(surface.position, surface.facing_normal(), number);
                let sum: f64 = (0..lights.all().len()).map(|number| f64::from(pmf(number))).sum();
                assert!((sum - 1.0).abs() <= 1e-5, "{choice:?}, {n} of each kind: {sum}");
            }
        }
    }
}

/// How often each light is picked at one place, of `n` times.
fn picks(nearby: &Nearby, surface: &SurfacePoint, lights: usize, n: u32) -> Vec<u64> {
    let mut sampler = Sampler::new(seed(0x7307), 0, 0);
    let mut counts = vec![0; lights];
    for _ in 0..n {
        let (position, facing) = (surface.position, surface.facing_normal());
        let (number, pmf) = nearby.pick(position, facing, sampler.next_1d()).expect("a light");
        assert_eq!(Some(pmf), nearby.pmf(position, facing, number), "light {number}");
        counts[number] += 1;
    }
    counts
}

/// A place where no light has more than two thirds of the probability.
fn where_several_count(lights: &Lights, sampler: &mut Sampler) -> SurfacePoint {
    let several = |surface: &SurfacePoint| {
        let pmf = |number| lights.pmf(surface.position, surface.facing_normal(), number);
        (0..lights.all().len()).all(|number| pmf(number) < 2.0 / 3.0)
    };
    let mut places = (0..1000).map(|_| anywhere(sampler));
    places.find(several).expect("such a place")
}

/// χ² of the picks, where many lights count and where few do. That the probabilities are those of a
/// place half a unit away, in a scene of eight units, is noticed.
#[test]
fn lights_are_picked_as_often_as_they_say() {
    const PICKS: u32 = 100_000;
    let mut sampler = Sampler::new(seed(0x7407), 0, 0);
    for n in [4, 12, 30] {
        let scene = all_kinds(n, &mut sampler);
        let lights = Lights::new(&scene);
        let nearby = Nearby::new(lights.all()).expect("more than one light");
        for place in 0..3 {
            let surface = where_several_count(&lights, &mut sampler);
            let counts = picks(&nearby, &surface, lights.all().len(), PICKS);
            let expected = |position: Vec3| -> Vec<f64> {
                let facing = surface.facing_normal();
                let pmf = |number| nearby.pmf(position, facing, number).expect("a light");
                (0..counts.len()).map(|k| f64::from(PICKS) * f64::from(pmf(k))).collect()
            };
            let name = format!("{n} of each kind, place {place}");
            assert_chi_squared(&name, &counts, &expected(surface.position));
            let elsewhere = expected(surface.position + vec3(0.3, -0.3, 0.3));
            let result = check_chi_squared(&name, &counts, &elsewhere);
            assert!(result.is_err(), "{name}: the pmf of another place passes: {result:?}");
        }
    }
}

/// Whatever the size of a scene and its distance from the origin, and however flat the way: a light
/// from which anything can arrive above the horizon may be chosen.
#[test]
fn no_light_that_can_send_anything_has_the_probability_0() {
    let mut sampler = Sampler::new(seed(0x7507), 0, 0);
    let (mut arrived, mut grazing) = (0, 0);
    for scale in [1e-6_f32, 1.0, 1e6] {
        for offset in [0.0, 1.0, 1e3, 1e5] {
            for _ in 0..100 {
                let place = offset * in_ball(&mut sampler).normalize();
                let at = |local: Vec3| scale * (place + local);
                let mut scene = empty();
                let mut corners = [(); 3].map(|()| at(in_ball(&mut sampler)));
                add_triangle(&mut scene, corners, LAMP);
                let radius = scale * (0.01 + 0.5 * sampler.next_1d());
                add_sphere(&mut scene, at(2.0 * in_ball(&mut sampler)), radius, LAMP);
                add_point_light(&mut scene, at(2.0 * in_ball(&mut sampler)), 1.0);
                let lights = Lights::new(&scene);
                for i in 0..100 {
                    // Every other place lies nearly in the plane of the triangle, every other
                    // horizon passes nearly through a light.
                    let mut position = at(2.0 * in_ball(&mut sampler));
                    if i % 2 == 0 {
                        corners.rotate_left(1);
                        let [a, b, c] = corners;
                        let [x, y] = sampler.next_2d().map(|u| 4.0 * u - 2.0);
                        position = a + x * (b - a) + y * (c - a);
                    }
                    let mut facing = in_ball(&mut sampler).normalize();
                    if i % 4 < 2 {
                        let middle = match &lights.all()[i / 4 % lights.all().len()] {
                            Light::Flat(lamp) => lamp.middle,
                            Light::Sphere(lamp) => lamp.sphere.center,
                            Light::Point { position, .. } => *position,
                            Light::Sky { .. } => Vec3::ZERO,
                        };
                        let way = middle - position;
                        facing = facing.reject_from(way).normalize_or(facing);
                    }
                    let surface = viewer(position, facing);
                    for (number, light) in lights.all().iter().enumerate() {
                        for _ in 0..4 {
                            let Some(sample) = light.sample(&surface, sampler.next_2d()) else {
                                continue;
                            };
                            let cos = facing.dot(sample.wi);
                            if cos <= 0.0 {
                                continue;
                            }
                            arrived += 1;
                            grazing += u32::from(cos < 1e-5);
                            let pmf = lights.pmf(position, facing, number);
                            assert!(pmf > 0.0, "{light:?} sends {sample:?} to {surface:?}");
                        }
                    }
                }
            }
        }
    }
    assert!(arrived > 100_000 && grazing > 1000, "only {arrived}, of which {grazing} grazing");
}

/// From behind a lamp and below the horizon nothing is asked, as far as rounding lets it be known.
#[test]
fn a_light_that_can_send_nothing_is_not_asked() {
    let mut scene = empty();
    add_quad(&mut scene, [Vec3::ZERO, Vec3::X, vec3(1.0, 1.0, 0.0), Vec3::Y], LAMP);
    add_sphere(&mut scene, vec3(0.0, 0.0, 9.0), 0.5, LAMP);
    let lights = Lights::new(&scene);
    let pmf = |z: f32, facing| [0, 1].map(|number| lights.pmf(vec3(0.5, 0.5, z), facing, number));
    assert_eq!(pmf(-1.0, Vec3::Z), [0.0, 1.0], "from behind the lamp");
    assert_eq!(pmf(3.0, Vec3::NEG_Z), [1.0, 0.0], "facing away from the sphere");
    let both = pmf(3.0, Vec3::X);
    assert!(both[0] > 0.0 && both[1] > 0.0, "{both:?} where either is half above the horizon");
}

/// Where the weights say nothing: below all horizons, at a point light that has no direction, at
/// distances whose squares are no numbers, and among more lights than are weighed.
#[test]
fn where_the_weights_say_nothing_power_decides() {
    let by_power = |scene: &Scene, position: Vec3, facing: Vec3| {
        let nearby = Lights::new(scene);
        let power = Lights::with(scene, Choice::Power, Measure::SolidAngle);
        for number in 0..nearby.all().len() {
            let got = nearby.pmf(position, facing, number);
            assert_eq!(got, power.pmf(position, facing, number), "light {number} at {position}");
        }
        let mut sampler = Sampler::new(seed(0x7607), 0, 0);
        for _ in 0..100 {
            let sample = nearby.sample(&viewer(position, facing), &mut sampler);
            let sound = |pdf: f32| pdf > 0.0 && pdf.is_finite();
            assert!(sample.is_none_or(|light| sound(light.pdf_solid_angle)), "{sample:?}");
        }
    };
    let mut scene = empty();
    add_point_light(&mut scene, Vec3::Z, 1.0);
    add_point_light(&mut scene, 2.0 * Vec3::Z, 3.0);
    by_power(&scene, Vec3::ZERO, Vec3::NEG_Z);
    by_power(&scene, vec3(0.0, 0.0, 1e30), Vec3::NEG_Z);
    // So near to one that the weight overflows.
    by_power(&scene, vec3(0.0, 1e-22, 1.0), Vec3::NEG_Y);

    let mut sampler = Sampler::new(seed(0x7707), 0, 0);
    let most = Nearby::MOST as u32;
    let mut scene = all_kinds(most / 4, &mut sampler);
    by_power(&scene, Vec3::ZERO, Vec3::X);
    scene.background = Rgb::ZERO;
    let lights = Lights::new(&scene);
    assert_eq!(lights.all().len(), Nearby::MOST, "lights");
    assert!(Nearby::new(lights.all()).is_some(), "as many as are weighed");
}

/// Exactly at a point light, only the others count.
#[test]
fn at_a_point_light_the_others_are_asked() {
    let mut scene = empty();
    add_point_light(&mut scene, Vec3::Z, 1.0);
    add_point_light(&mut scene, 2.0 * Vec3::Z, 3.0);
    let lights = Lights::new(&scene);
    assert_eq!([0, 1].map(|k| lights.pmf(Vec3::Z, Vec3::Z, k)), [0.0, 1.0], "at the first");
}
