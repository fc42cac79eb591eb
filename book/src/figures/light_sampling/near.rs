//! A lamp that is near: points of equal area against directions of equal solid angle.

use glam::{Vec3, vec3};
use light_sampling::{Estimator, FlatLamp, Measure, Settings};
use ray_casting::{Rgb, Scene};
use workbench::{FilmSettings, Unwatched};

use super::stage::{MEASURES, draw, scene, settings};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};

/// The Cornell box, its lamp upright on the floor, before the left wall.
pub(super) fn floor_lamp() -> Scene {
    let mut scene = scene("cornell-box");
    let is_lamp = |material: &u32| scene.materials[*material as usize].ke != [0.0; 3];
    let first = scene.attributes.materials.iter().position(is_lamp).expect("the lamp");
    let corners = [[4.9, 0.0, 0.9], [4.0, 0.0, 1.9], [4.0, 1.05, 1.9], [4.9, 1.05, 0.9]];
    let halves = [scene.geometry.triangles[first], scene.geometry.triangles[first + 1]];
    let vertices = [halves[0][0], halves[0][1], halves[0][2], halves[1][2]];
    for (vertex, corner) in vertices.into_iter().zip(corners) {
        scene.geometry.vertices[vertex as usize] = Vec3::from_array(corner);
    }
    scene
}

/// Both measures, with the lamp found by sampling alone, and nothing but its own light, dimmed so
/// that the floor is not white: the lamp's corner of the picture.
pub(super) fn pictures() -> Drawing {
    let mut scene = floor_lamp();
    for material in &mut scene.materials {
        material.ke = material.ke.map(|ke| 0.25 * ke);
    }
    let film = FilmSettings { size: [480, 480], samples: 4, seed: 0, threads: None };
    let pictures = MEASURES.map(|measure| {
        let mut settings = Settings { measure, ..settings(Estimator::Light) };
        settings.ending.depth = 1;
        let image = draw(&scene, settings, &film, &Unwatched).image;
        Picture::from(&image).crop([30, 330], [300, 140])
    });
    Picture::side_by_side(&pictures, 8).into()
}

/// A square lamp that stands on the floor.
fn square(measure: Measure) -> FlatLamp {
    let corners = [[-0.5, 0.0], [0.5, 0.0], [0.5, 1.0], [-0.5, 1.0]].map(|[x, y]| vec3(x, y, 0.0));
    FlatLamp::parallelogram(corners, Rgb::ONE, measure).expect("a square")
}

/// The standard deviation of cos θ / p over its mean, for the floor before the middle of the
/// [`square`], as far away as `distance` of its sides.
///
/// The squares have the mean ∫ cos² θ / p dω, whichever way the directions are drawn to take it. By
/// solid angle and in even steps it is a smooth integral; points of equal area would miss the few
/// that count.
fn deviation(measure: Measure, distance: f32) -> f64 {
    const STEPS: u16 = 300;
    let viewer = vec3(0.0, 0.0, distance);
    let (drawn, asked) = (square(Measure::SolidAngle), square(measure));
    let step = |i: u16| (f32::from(i) + 0.5) / f32::from(STEPS);
    let [mut mean, mut squares] = [0.0, 0.0];
    for (i, k) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |k| (i, k))) {
        let Some(light) = drawn.sample(viewer, [step(i), step(k)]) else { continue };
        let end = light.end.expect("a lamp has a place").position;
        let pdf = asked.pdf(viewer, light.wi, viewer.distance_squared(end));
        let share = f64::from(STEPS).powi(-2) / f64::from(light.pdf_solid_angle);
        let cos = f64::from(light.wi.y);
        mean += share * cos;
        squares += share * cos * cos / f64::from(pdf.expect("it shines there"));
    }
    (squares - mean * mean).sqrt() / mean
}

/// Both measures against the distance.
pub(super) fn plot() -> Drawing {
    let curve = |name: &str, measure: Measure| {
        let points = (-24..=8).map(|i| {
            let distance = libm::pow(10.0, f64::from(i) / 8.0);
            [distance, deviation(measure, distance as f32)]
        });
        Series { name: name.to_owned(), points: points.collect(), style: Style::Line }
    };
    Plot {
        description: "Toward the lamp the deviation by area grows and grows, that by solid angle \
                      stays at 0.6; from a distance of one side on, both are the same."
            .to_owned(),
        x: Axis::log("distance / side of the lamp"),
        y: Axis::log("standard deviation / mean"),
        series: vec![curve("area", Measure::Area), curve("solid angle", Measure::SolidAngle)],
    }
    .into()
}
