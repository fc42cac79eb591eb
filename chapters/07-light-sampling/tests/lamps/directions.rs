//! χ² tests of every light's directions against its density (accuracy.md M2).

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec3, Vec3, vec3};
use light_sampling::Lights;
use ray_casting::Scene;
use statistics::{Grid, Rejected, assert_directions, seed};
use workbench::Sampler;

use crate::scenes::{LAMP, add_quad, add_sphere, add_triangle, empty, seen, viewer};

/// By how much rounding may put a drawn direction outside the lamp.
const EDGE: f64 = 1e-7;

/// The density of `wi` at the origin as the sum over all lamps that lie in that direction, hidden
/// by each other or not, and the sky.
///
/// Where a lamp lies is decided in double precision and generously; the density is what `lights`
/// says.
fn density(scene: &Scene, lights: &Lights, facing: Vec3, wi: Vec3) -> f64 {
    let d = wi.as_dvec3();
    let mut sum = f64::from(lights.pdf_of_sky(Vec3::ZERO, facing, wi));
    for primitive in 0..scene.geometry.primitives() {
        let point = match scene.geometry.sphere(primitive) {
            Some(sphere) => on_sphere(sphere.center.as_dvec3(), f64::from(sphere.radius), d),
            None => on_triangle(scene.geometry.corners(primitive).map(|v| v.as_dvec3()), d),
        };
        if let Some((point, normal)) = point {
            let lamp = seen(primitive, point.as_vec3(), normal.as_vec3(), wi);
            sum += f64::from(lights.pdf_of_lamp(Vec3::ZERO, facing, &lamp));
        }
    }
    sum
}

fn on_sphere(center: DVec3, radius: f64, d: DVec3) -> Option<(DVec3, DVec3)> {
    let along = center.dot(d);
    let beside = (center - along * d).length();
    let angle = libm::atan2(beside, along);
    let rim = libm::asin((radius / center.length()).min(1.0));
    (angle <= rim + EDGE).then(|| {
        let t = along - (radius * radius - beside * beside).max(0.0).sqrt();
        (t * d, (t * d - center).normalize())
    })
}

fn on_triangle([a, b, c]: [DVec3; 3], d: DVec3) -> Option<(DVec3, DVec3)> {
    let normal = (b - a).cross(c - a);
    let point = (a.dot(normal) / d.dot(normal)) * d;
    let share = |from: DVec3, to: DVec3| (to - from).cross(point - from).dot(normal);
    let least = -EDGE * normal.length_squared();
    let inside = [share(a, b), share(b, c), share(c, a)].into_iter().all(|s| s >= least);
    (inside && point.dot(d) > 0.0 && normal.dot(d) < 0.0).then(|| (point, normal.normalize()))
}

/// Tests all lights of a scene from the origin, on a surface with the normal `facing`.
fn test(name: &str, scene: &Scene, facing: Vec3, grid: Grid, samples: u32) {
    let lights = Lights::new(scene);
    let mut sampler = Sampler::new(seed(0x0207), 0, 0);
    let surface = viewer(Vec3::ZERO, facing);
    let sample = || Some(lights.sample(&surface, &mut sampler)?.wi.to_array());
    let pdf = |wi: [f32; 3]| density(scene, &lights, facing, Vec3::from_array(wi));
    assert_directions(name, &grid, samples, Rejected::Remainder, sample, pdf);
}

const SAMPLES: u32 = 200_000;

#[test]
fn triangles_from_near_from_far_and_along_their_edge() {
    let triangle = [vec3(-1.0, -0.5, 0.0), vec3(0.2, 1.1, 0.3), vec3(0.9, -0.4, 0.2)];
    for (name, away, size, angle) in [
        ("near", vec3(0.1, 0.0, -0.2), 1.0, FRAC_PI_2 * 1.2),
        ("ahead", vec3(0.3, 0.2, -1.5), 1.0, 1.3),
        ("far", vec3(30.0, 20.0, -80.0), 1.0, 0.02),
        ("large and far", vec3(3e4, 2e4, -8e4), 1e3, 0.02),
        ("grazing", vec3(2.5, -0.3, 0.4), 1.0, 0.45),
    ] {
        let mut scene = empty();
        // Turned so that the front, where the corners run counter-clockwise, faces the origin.
        let corners = triangle.map(|corner| away + size * corner);
        let front = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(-corners[0]) > 0.0;
        let [a, b, c] = corners;
        add_triangle(&mut scene, if front { [a, b, c] } else { [a, c, b] }, LAMP);
        let middle = (a + b + c) / 3.0;
        // Fine cells: at the rim, where a corner is cut off, a cell's integral is not exact.
        let fine = Grid { rows: 300, columns: 300, ..Grid::SPHERE };
        let grid = fine.around(middle.to_array()).within(angle);
        test(&format!("triangle, {name}"), &scene, middle.normalize(), grid, SAMPLES);
    }
}

/// Both halves of a parallelogram, from where they are sampled by area and by solid angle.
#[test]
fn parallelograms_from_near_from_far_and_nearly_touching() {
    let (x, y) = (vec3(1.0, 0.25, 0.0), vec3(-0.25, 0.75, 0.5));
    for (name, away, size, angle) in [
        // Off the diagonal, where both halves count; a row of the grid ends at the horizon, where the
        // lamp does.
        ("touching", vec3(0.2 + 1e-6, 0.05 - 4e-6, 6.5e-6), 1.0, FRAC_PI_2 * 10.0 / 9.0),
        ("near", vec3(0.125, -0.5, 0.75), 1.0, FRAC_PI_2),
        ("just far", vec3(0.0, 1.0, -2.0), 1.0, 1.0),
        ("narrow", vec3(0.0, -0.125, 0.25), 0.125, FRAC_PI_2),
    ] {
        let mut scene = empty();
        let (x, y) = (x, size * y);
        let front = x.cross(y).dot(-away) > 0.0;
        let corners = [away - x - y, away + x - y, away + x + y, away - x + y].map(|v| 0.5 * v);
        let [a, b, c, d] = corners;
        add_quad(&mut scene, if front { [a, b, c, d] } else { [a, d, c, b] }, LAMP);
        let lights = Lights::new(&scene);
        assert_eq!(lights.all().len(), 1, "{name}: {corners:?}");
        let normal = if front { x.cross(y) } else { y.cross(x) }.normalize();
        let axis = if angle > 1.0 { -normal } else { away.normalize() };
        let fine = Grid { rows: 160, columns: 160, ..Grid::SPHERE };
        let grid = fine.around(axis.to_array()).within(angle);
        test(&format!("parallelogram, {name}"), &scene, axis, grid, SAMPLES);
    }
}

#[test]
fn spheres_from_far_from_near_and_nearly_touching() {
    for distance in [1.000_01_f32, 1.01, 1.2, 3.0, 30.0, 300.0] {
        let mut scene = empty();
        let axis = vec3(0.36, 0.48, -0.8);
        add_sphere(&mut scene, 2.0 * distance * axis, 2.0, LAMP);
        let cone = libm::asin(1.0 / f64::from(distance));
        let grid = Grid::SPHERE.around(axis.to_array()).within((1.05 * cone).min(PI));
        test(&format!("sphere at {distance} r"), &scene, axis, grid, SAMPLES);
    }
}

#[test]
fn the_sky_from_surfaces_of_all_kinds() {
    for facing in [Vec3::Y, Vec3::NEG_Z, vec3(0.36, 0.48, -0.8)] {
        let mut scene = empty();
        scene.background = Vec3::ONE;
        test(&format!("sky above {facing}"), &scene, facing, Grid::ODD, SAMPLES);
    }
}

/// All at once: the choice among the lights is part of the density.
#[test]
fn a_sky_with_lamps_in_it() {
    let mut scene = empty();
    let corners = [vec3(-2.0, 1.0, -1.0), vec3(-1.0, 2.0, -2.0), vec3(-2.0, 3.0, 0.5)];
    let [a, b, c] = corners;
    let front = (b - a).cross(c - a).dot(-a) > 0.0;
    add_triangle(&mut scene, if front { [a, b, c] } else { [a, c, b] }, LAMP);
    add_sphere(&mut scene, vec3(1.0, 2.0, 1.0), 1.0, LAMP);
    add_sphere(&mut scene, vec3(2.0, 5.0, 2.0), 2.0, LAMP);
    scene.background = Vec3::splat(0.05);
    test("sky and lamps", &scene, Vec3::Y, Grid::SPHERE, 2 * SAMPLES);
}
