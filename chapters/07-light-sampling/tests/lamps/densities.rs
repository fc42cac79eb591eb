//! The density that comes with a sample is the one that is told when asked (accuracy.md M10).

use glam::Vec3;
use light_sampling::Lights;
use ray_casting::{Intersect, LinearSearch};
use statistics::seed;
use workbench::{Sampler, Unwatched};

use crate::scenes::{LAMP, add_point_light, add_sphere, add_triangle, empty, in_ball, viewer};

#[test]
fn a_path_that_meets_a_lamp_is_told_the_density_of_its_sample() {
    let mut sampler = Sampler::new(seed(0x1007), 0, 0);
    let (mut met, mut worst) = (0, 0.0_f32);
    for _ in 0..300 {
        let mut scene = empty();
        for _ in 0..3 {
            let place = 3.0 * in_ball(&mut sampler);
            let corners = [(); 3].map(|()| place + in_ball(&mut sampler));
            add_triangle(&mut scene, corners, LAMP);
        }
        for _ in 0..3 {
            let radius = 0.3 + 0.5 * sampler.next_1d();
            add_sphere(&mut scene, 3.0 * in_ball(&mut sampler), radius, LAMP);
        }
        add_point_light(&mut scene, Vec3::ONE, 1.0);
        let (lights, geometry) =
            (Lights::new(&scene), LinearSearch::new(&scene.geometry, &Unwatched));
        for _ in 0..300 {
            let normal = in_ball(&mut sampler).normalize();
            let surface = viewer(4.0 * in_ball(&mut sampler), normal);
            let Some(light) = lights.sample(&surface, &mut sampler) else { continue };
            let ray = surface.spawn(light.wi);
            let Some(hit) = geometry.intersect(&ray) else { continue };
            let lamp = scene.surface(&ray, &hit);
            // Another lamp may be in the way, and a point light is never met.
            let end = light.end.expect("no sky");
            let near = (lamp.position - end.position).length() <= 1e-4;
            if light.is_delta || !near || !lamp.is_front() {
                continue;
            }
            met += 1;
            let asked = lights.pdf_of_lamp(surface.position, normal, &lamp);
            let error = (asked / light.pdf_solid_angle - 1.0).abs();
            // A cosine near 0 is known to fewer digits.
            let cos = lamp.geometric_normal.dot(lamp.wo);
            let tolerance = 1e-5 * (0.1 / cos).max(1.0);
            worst = worst.max(error / tolerance);
            assert!(error <= tolerance, "{asked} for {light:?}, cos θ' = {cos}");
        }
    }
    assert!(met > 20_000, "only {met} samples were compared; the worst by {worst}");
}

#[test]
fn a_path_that_leaves_the_scene_is_told_the_density_of_its_sample() {
    let mut scene = empty();
    add_sphere(&mut scene, Vec3::Y, 0.5, LAMP);
    scene.background = Vec3::ONE;
    let lights = Lights::new(&scene);
    let mut sampler = Sampler::new(seed(0x1107), 0, 0);
    for _ in 0..20_000 {
        let facing = in_ball(&mut sampler).normalize();
        let surface = viewer(5.0 * in_ball(&mut sampler), facing);
        let Some(light) = lights.sample(&surface, &mut sampler) else { continue };
        if light.end.is_none() {
            let asked = lights.pdf_of_sky(surface.position, facing, light.wi);
            let error = (asked / light.pdf_solid_angle - 1.0).abs();
            assert!(error <= 1e-5, "{asked} for {light:?}");
        }
    }
}

/// No light where there is none to be had: from behind, and for what is no lamp.
#[test]
fn what_cannot_be_drawn_has_no_density() {
    let mut scene = empty();
    add_triangle(&mut scene, [Vec3::ZERO, Vec3::X, Vec3::Y], LAMP);
    add_triangle(&mut scene, [Vec3::Z, Vec3::X, Vec3::Y], crate::scenes::MATTE);
    let lights = Lights::new(&scene);
    let front = crate::scenes::seen(0, Vec3::ZERO, Vec3::Z, Vec3::NEG_Z);
    let back = crate::scenes::seen(0, Vec3::ZERO, Vec3::Z, Vec3::Z);
    let no_lamp = crate::scenes::seen(1, Vec3::ZERO, Vec3::Z, Vec3::NEG_Z);
    assert!(lights.pdf_of_lamp(Vec3::Z, Vec3::NEG_Z, &front) > 0.0, "the front of the lamp");
    assert_eq!(lights.pdf_of_lamp(Vec3::NEG_Z, Vec3::Z, &back), 0.0, "its back");
    assert_eq!(lights.pdf_of_lamp(Vec3::Z, Vec3::NEG_Z, &no_lamp), 0.0, "no lamp");
    assert_eq!(lights.pdf_of_sky(Vec3::ZERO, Vec3::Y, Vec3::Y), 0.0, "a black sky");
}
