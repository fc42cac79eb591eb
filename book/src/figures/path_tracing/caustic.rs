//! A caustic that is found by chance, and the paths that find it.

use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::PathTracer;
use ray_casting::Scene;
use rendering_equation::{Anything, Density};
use workbench::{Sampler, Unwatched};

use super::stage::{ROULETTE, draw, scene, settings};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;

const SIZE: [u32; 2] = [160, 160];

/// The box with two spheres, and the floor below the glass one, enlarged.
pub(super) fn picture() -> Drawing {
    let image = Picture::from(&draw(&scene("cornell-spheres"), ROULETTE, &settings(SIZE, 96)));
    let part = image.crop([84, 118], [56, 40]).enlarged(4);
    Picture::side_by_side(&[image, part], 8).into()
}

/// What paths find that start toward the film point (x, y) of a picture of unit size, sorted.
fn found(scene: &Scene, x: f32, y: f32, paths: u64) -> Vec<f64> {
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &[], &geometry, &Unwatched, Density::Cosine, ROULETTE);
    let [width, height] = scene.exposure.size;
    let point =
        workbench::FilmPoint { x: x * width as f32, y: y * height as f32, size: [width, height] };
    let one = |i| {
        let sampler = &mut Sampler::new(0, 0, i);
        tracer.incident_radiance(scene.camera.ray(point), sampler).y.into()
    };
    let mut values: Vec<f64> = (0..paths).map(one).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// One point of the caustic, one of the back wall.
pub(super) fn numbers() -> Drawing {
    let scene = scene("cornell-spheres");
    let paths = 100_000;
    let mut numbers = Numbers::new();
    numbers.add("paths", crate::table::count(paths));
    let names = [
        ["caustic-hits", "caustic-mean", "caustic-largest", "caustic-noise", "caustic-firefly"],
        ["wall-hits", "wall-mean", "wall-largest", "wall-noise", "wall-firefly"],
    ];
    for (names, [x, y]) in names.into_iter().zip([[0.68, 0.89], [0.5, 0.4]]) {
        let values = found(&scene, x, y, paths);
        let n = paths as f64;
        let mean = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n;
        let hits = values.iter().filter(|v| **v > 0.0).count();
        numbers.add(names[0], format!("{:.1}", 100.0 * hits as f64 / n));
        numbers.add(names[1], format!("{mean:.2}"));
        numbers.add(names[2], format!("{:.0}", values[values.len() - 1]));
        numbers.add(names[3], format!("{:.1}", variance.sqrt() / mean));
        numbers.add(names[4], format!("{:.1}", values[values.len() - 1] / 16.0 / mean));
    }
    numbers.into()
}
