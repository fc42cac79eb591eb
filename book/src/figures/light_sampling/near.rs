//! A lamp that is near: points of equal area against directions of equal solid angle.

use glam::{Vec3, vec3};
use light_sampling::{Estimator, FlatLamp, Measure, Settings};
use ray_casting::{Rgb, Scene};
use workbench::{FilmSettings, Sampler, Unwatched};

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

/// The standard deviation of cos θ / p over its mean, for the floor before the middle of a square
/// lamp that stands on it, as far away as `distance` sides of the square.
fn deviation(measure: Measure, distance: f32) -> f64 {
    const SAMPLES: u32 = 20_000;
    let corners =
        [vec3(-0.5, 0.0, 0.0), vec3(0.5, 0.0, 0.0), vec3(0.5, 1.0, 0.0), vec3(-0.5, 1.0, 0.0)];
    let lamp = FlatLamp::parallelogram(corners, Rgb::ONE, measure).expect("a square");
    let mut sampler = Sampler::new(0, 0, 0);
    let [mut sum, mut squares] = [0.0, 0.0];
    for _ in 0..SAMPLES {
        let light = lamp.sample(vec3(0.0, 0.0, distance), sampler.next_2d());
        let value = light.map_or(0.0, |light| f64::from(light.wi.y / light.pdf_solid_angle));
        sum += value;
        squares += value * value;
    }
    let mean = sum / f64::from(SAMPLES);
    (squares / f64::from(SAMPLES) - mean * mean).max(0.0).sqrt() / mean
}

/// Both measures against the distance.
pub(super) fn plot() -> Drawing {
    let curve = |name: &str, measure: Measure| {
        let points = (-12..=4).map(|i| {
            let distance = libm::pow(10.0, f64::from(i) / 4.0);
            [distance, deviation(measure, distance as f32)]
        });
        Series { name: name.to_owned(), points: points.collect(), style: Style::LineAndMarks }
    };
    Plot {
        description: "Near the lamp the deviation by area grows without a bound, that by solid \
                      angle stays below one; from a distance of one side on, both are the same."
            .to_owned(),
        x: Axis::log("distance / side of the lamp"),
        y: Axis::log("standard deviation / mean"),
        series: vec![curve("area", Measure::Area), curve("solid angle", Measure::SolidAngle)],
    }
    .into()
}
