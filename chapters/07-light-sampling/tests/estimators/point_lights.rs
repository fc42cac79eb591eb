//! Light from points, which only light sampling finds (errata 22).

use blinn_phong::{Shader, Terms};
use glam::{Vec3, vec3};
use light_sampling::Estimator;
use ray_casting::{LinearSearch, Ray, Rgb, Scene};
use rendering_equation::Anything;
use statistics::assert_mean;
use workbench::{Sampler, Unwatched};

use crate::scenes::{
    RECEIVING, add_block, add_quad, add_sphere, at_receiver, dark, limited, matte, point_light,
    radiance, receiver,
};

/// The unit in the last place of 1, halved.
const U: f32 = f32::EPSILON / 2.0;

/// A wide floor under one point light.
fn floor(kd: Rgb, position: Vec3, intensity: Rgb) -> Scene {
    let mut record = matte(0.0);
    record.kd = kd.to_array();
    let mut scene = dark([record]);
    let corners = [(-9.0, 9.0), (9.0, 9.0), (9.0, -9.0), (-9.0, -9.0)];
    add_quad(&mut scene, corners.map(|(x, z)| vec3(x, 0.0, z)), 0);
    scene.lights.push(point_light(position, intensity));
    scene
}

/// One brightness in all chapters: a matte surface under a point light is as bright as in chapter
/// 2, sample by sample, since nothing is random about it.
#[test]
fn a_matte_floor_is_as_bright_as_in_chapter_2() {
    let scene = floor(vec3(0.7, 0.5, 0.3), vec3(0.4, 2.0, -0.3), vec3(10.0, 20.0, 5.0));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let shader = Shader::new(&scene, &[], &geometry, &Unwatched, Terms::All);
    let mut sampler = Sampler::new(1, 0, 0);
    for _ in 0..10_000 {
        let [x, z] = sampler.next_2d().map(|u| 16.0 * u - 8.0);
        let eye = vec3(1.0, 3.0, 2.0);
        let ray = Ray::new(eye, (vec3(x, 0.0, z) - eye).normalize());
        let expected = shader.incident_radiance(ray);
        for estimator in [Estimator::Light, Estimator::Mis] {
            let settings = limited(estimator, 1);
            let tracer: light_sampling::LightTracer<'_, _, _, Anything> =
                light_sampling::LightTracer::new(&scene, &[], &geometry, &Unwatched, settings);
            let seen = tracer.incident_radiance(ray, &mut sampler);
            let error = ((seen - expected) / expected).abs().max_element();
            assert!(error <= 8.0 * U, "({x}, {z}): {seen}, in chapter 2 {expected}");
        }
    }
}

/// accuracy.md BP11.
#[test]
fn a_point_light_of_intensity_pi_gives_the_value_of_the_catalogue() {
    let kd = 0.5 / std::f32::consts::PI;
    let scene = floor(Rgb::splat(kd), Vec3::Y, Rgb::splat(std::f32::consts::PI));
    let origin = vec3(2.0, 1.0, 0.1);
    let ray = Ray::new(origin, (vec3(2.0, 0.0, 0.0) - origin).normalize());
    let samples = radiance(&scene, limited(Estimator::Mis, 1), ray, 10);
    let expected = 0.5 / f64::powf(5.0, 1.5);
    assert!((expected - 0.044_721_4).abs() < 1e-7, "accuracy.md's value for {expected}");
    let error = (samples.mean() / expected - 1.0).abs();
    assert!(error <= 8.0 * f64::from(U), "{} for {expected}", samples.mean());
}

/// A point between other points: the choice among them must not change their sum.
#[test]
fn several_point_lights_add_up() {
    let lights = [(vec3(1.0, 1.0, 0.0), 4.0), (vec3(-2.0, 2.0, 1.0), 9.0), (Vec3::Y, 0.0)];
    let mut scene = receiver([]);
    let expected = lights.iter().map(|&(position, i)| {
        let squared = f64::from((position - RECEIVING).length_squared());
        f64::from(i) / squared * f64::from(position.y) / squared.sqrt()
    });
    let expected = expected.sum();
    scene.lights.extend(lights.map(|(position, i)| point_light(position, Rgb::splat(i))));
    for estimator in [Estimator::Light, Estimator::Mis] {
        let samples = radiance(&scene, limited(estimator, 1), at_receiver(), 100_000);
        assert_mean(&format!("{estimator:?}"), &samples, expected);
    }
    let chance = radiance(&scene, limited(Estimator::Scatter, 1), at_receiver(), 1000);
    assert_mean("no random direction hits a point", &chance, 0.0);
}

#[test]
fn a_light_inside_a_body_lights_nothing_outside() {
    let closed = |add: fn(&mut Scene)| {
        let mut scene = receiver([matte(0.5)]);
        add(&mut scene);
        scene.lights.push(point_light(vec3(0.1, 2.0, 0.2), Rgb::ONE));
        scene
    };
    let ball = closed(|scene| add_sphere(scene, vec3(0.0, 2.0, 0.0), 1.0, 1));
    let block = closed(|scene| add_block(scene, vec3(-1.0, 1.0, -1.0), vec3(1.0, 3.0, 1.0), 1));
    for scene in [ball, block] {
        let samples = radiance(&scene, limited(Estimator::Mis, 1), at_receiver(), 1000);
        assert_mean("a light in a body", &samples, 0.0);
    }
}

/// Exactly at the light there is no direction, and no light is sent; next to it, much is.
#[test]
fn a_point_light_on_the_surface_is_finite() {
    for height in [0.0, f32::MIN_POSITIVE, 1e-30, 1e-12, 1e-6] {
        let mut scene = receiver([]);
        scene.lights.push(point_light(RECEIVING + height * Vec3::Y, Rgb::ONE));
        let samples = radiance(&scene, limited(Estimator::Mis, 1), at_receiver(), 100);
        assert!(samples.mean().is_finite(), "{} at height {height:e}", samples.mean());
        assert_eq!(samples.non_finite(), 0, "samples at height {height:e}");
    }
}
