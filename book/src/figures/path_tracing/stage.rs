//! What the stage draws.

use blinn_phong::Picture as Texture;
use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::Scene;
use rendering_equation::{Anything, Density};
use workbench::{
    Counter, Estimate, FilmSettings, Image, Probe, Recorder, Unwatched, expose_estimate,
};

use crate::figures::{Drawing, scene_file};
use crate::picture::Picture;
use crate::table::{Table, count};

/// What the stage does when the command line says nothing.
pub(super) const ROULETTE: Ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };

/// One of the course's scenes.
pub(super) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

pub(super) fn settings(size: [u32; 2], samples: u32) -> FilmSettings {
    FilmSettings { size, samples, seed: 0, threads: None }
}

/// The stage's picture of a scene, with what it knows of its error.
pub(super) fn estimate<P: Probe>(
    scene: &Scene,
    ending: Ending,
    settings: &FilmSettings,
    probe: &P,
) -> Estimate {
    let textures = Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, probe);
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(scene, &textures, &geometry, probe, Density::Cosine, ending);
    expose_estimate(settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

/// The stage's picture of a scene.
pub(super) fn draw(scene: &Scene, ending: Ending, settings: &FilmSettings) -> Image {
    estimate(scene, ending, settings, &Unwatched).image
}

pub(super) fn cornell_box() -> Drawing {
    Picture::from(&draw(&scene("cornell-box"), ROULETTE, &settings([160, 160], 96))).into()
}

/// The same with 1, 16 and 256 paths a pixel.
pub(super) fn samples() -> Drawing {
    let scene = scene("cornell-box");
    let panels = [1, 16, 256].map(|samples| {
        Picture::from(&draw(&scene, ROULETTE, &settings([56, 56], samples))).enlarged(3)
    });
    Picture::side_by_side(&panels, 8).into()
}

/// A scene of chapter 3, in the light of its sky alone.
pub(super) fn whitted() -> Drawing {
    Picture::from(&draw(&scene("whitted"), ROULETTE, &settings([240, 160], 36))).into()
}

/// How paths end, and how long they are.
pub(super) fn ends() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "paths",
        "rays a path",
        "left the scene",
        "met a black surface",
        "ended by roulette",
    ]);
    for name in ["cornell-box", "cornell-spheres", "furnace", "whitted", "nested-glass", "teapot"] {
        let recorder = Recorder::new();
        let scene = scene(name);
        let [width, height] = scene.exposure.size;
        let size = [60, 60 * height / width];
        estimate(&scene, ROULETTE, &settings(size, 8), &recorder);
        let paths = u64::from(size[0] * size[1] * 8);
        let get = |counter| recorder.get(counter);
        let events =
            get(Counter::ScatterRays) + get(Counter::ReflectionRays) + get(Counter::RefractionRays);
        let [black, roulette] =
            [Counter::PathsEndedByBlack, Counter::PathsEndedByRoulette].map(get);
        let percent = |n: u64| format!("{:.1} %", 100.0 * n as f64 / paths as f64);
        table.row([
            format!("`{name}`"),
            count(paths),
            format!("{:.2}", 1.0 + events as f64 / paths as f64),
            percent(paths - black - roulette),
            percent(black),
            percent(roulette),
        ]);
    }
    table.into()
}
