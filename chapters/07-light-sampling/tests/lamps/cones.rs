//! Sphere lamps that are tiny, and viewers that are too near (accuracy.md M8, M9).

use glam::{Vec3, vec3};
use light_sampling::{Light, Lights};
use statistics::{Moments, assert_mean, seed};
use workbench::Sampler;

use crate::scenes::{LAMP, add_sphere, empty, viewer};

/// The mean of 1 − cos θ is half of that of the rim, however thin the cone: nothing collapses onto
/// the axis. 1 − cos θ = |ω − axis|²/2 keeps its digits; the rounding of ω itself adds to it what
/// is small beside 10⁻¹², the square of the thinnest cone.
#[test]
fn tiny_cones_do_not_collapse() {
    let axis = vec3(0.36, 0.48, -0.8);
    for exponent in 1..=6 {
        let sin_max = 10.0_f64.powi(-exponent);
        let mut scene = empty();
        add_sphere(&mut scene, axis, sin_max as f32, LAMP);
        let (lights, surface) = (Lights::new(&scene), viewer(Vec3::ZERO, axis));
        let mut sampler = Sampler::new(seed(0x0807), 0, 0);
        let mut on_axis = 0;
        let exact = axis.as_dvec3().normalize();
        let n = 20_000;
        let versines: Moments = (0..n)
            .map(|_| {
                let light = lights.sample(&surface, &mut sampler).expect("the lamp is in view");
                on_axis += u32::from(light.wi == axis);
                (light.wi.as_dvec3() - exact).length_squared() / 2.0
            })
            .collect();
        let expected = 0.5 * (1.0 - (1.0 - sin_max * sin_max).sqrt());
        let expected = if exponent > 3 { sin_max * sin_max / 4.0 } else { expected };
        assert_mean(&format!("θmax = 1e-{exponent}"), &versines, expected);
        assert!(on_axis < n / 50, "θmax = 1e-{exponent}: {on_axis} of {n} lie on the axis");
    }
}

/// The density too: one over the solid angle, which for a tiny cone is 1/(π sin²).
#[test]
fn the_density_of_a_tiny_cone_keeps_its_digits() {
    for exponent in 1..=15 {
        let sin_max = 10.0_f32.powi(-exponent);
        let mut scene = empty();
        add_sphere(&mut scene, Vec3::Z, sin_max, LAMP);
        let light = Lights::new(&scene)
            .sample(&viewer(Vec3::ZERO, Vec3::Z), &mut Sampler::new(1, 0, 0))
            .expect("the lamp is in view");
        let s = f64::from(sin_max);
        let versine = s * s / (1.0 + (1.0 - s * s).sqrt());
        let expected = 1.0 / (2.0 * std::f64::consts::PI * versine);
        let error = (f64::from(light.pdf_solid_angle) / expected - 1.0).abs();
        assert!(error <= 1e-6, "θmax = {sin_max:e}: off by {error:e}");
    }
}

/// Inside and on the sphere it is dark; the next float outside sees half of all directions.
#[test]
fn a_viewer_at_the_lamp_gets_finite_answers() {
    for radius in [1.0_f32, 3.7, 1e-20, 1e15] {
        for center in [Vec3::ZERO, vec3(radius, -2.0 * radius, 0.5 * radius)] {
            let mut scene = empty();
            add_sphere(&mut scene, center, radius, LAMP);
            let lights = Lights::new(&scene);
            let Light::Sphere(lamp) = lights.all()[0] else { panic!("{:?}", lights.all()) };
            let mut sampler = Sampler::new(seed(0x0907), 0, 0);
            let x = center.x + radius;
            let places = [center.x, 0.5 * (center.x + x), x.next_down(), x, x.next_up()];
            for position in places.map(|x| vec3(x, center.y, center.z)) {
                let exact = (position.as_dvec3() - center.as_dvec3()).length();
                let outside = exact > f64::from(radius);
                for _ in 0..1000 {
                    let sample = lights.sample(&viewer(position, Vec3::X), &mut sampler);
                    assert_eq!(sample.is_some(), outside, "{position} at {center}, {radius}");
                    let Some(sample) = sample else { continue };
                    let unit = (sample.wi.length() - 1.0).abs() <= 1e-6;
                    let finite = sample.pdf_solid_angle.is_finite() && sample.pdf_solid_angle > 0.0;
                    assert!(unit && finite, "{sample:?} from {position}");
                    let end = sample.end.expect("a sphere has a surface");
                    assert!(end.position.is_finite(), "{end:?} from {position}");
                }
                assert_eq!(lamp.pdf(position).is_some(), outside, "pdf from {position}");
            }
        }
    }
}

/// The corners of the unit square of random numbers are no exception.
#[test]
fn extreme_random_numbers_give_unit_vectors() {
    let extremes = [0.0, 2.0_f32.powi(-24), 0.5, 1.0_f32.next_down()];
    for distance in [1.0_f32.next_up(), 1.5, 1e6] {
        let mut scene = empty();
        add_sphere(&mut scene, distance * Vec3::Z, 1.0, LAMP);
        let lights = Lights::new(&scene);
        for u in extremes.iter().flat_map(|&a| extremes.map(|b| [a, b])) {
            let sample = lights.all()[0].sample(&viewer(Vec3::ZERO, Vec3::Z), u);
            let sample = sample.expect("the lamp is in view");
            let error = (sample.wi.length() - 1.0).abs();
            assert!(error <= 4.0 * f32::EPSILON, "{u:?} at {distance}: {sample:?}");
            assert!(sample.pdf_solid_angle > 0.0, "{u:?} at {distance}: {sample:?}");
        }
    }
}
