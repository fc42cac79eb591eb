//! What the stage draws.

use blinn_phong::Picture as Texture;
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{LinearSearch, Scene};
use workbench::{FilmSettings, Image, Probe, Unwatched, expose};

use crate::figures::{Drawing, scene_file};
use crate::picture::Picture;

/// One of several pictures in a row.
pub(super) const PANEL: FilmSettings =
    FilmSettings { size: [240, 160], samples: 4, seed: 0, threads: None };

/// What the stage does when the command line says nothing.
pub(super) fn limits() -> Limits {
    Limits::new(mirror_refraction::STAGE.depth, Limits::CUTOFF)
}

/// One of the course's scenes.
pub(super) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The stage's picture of a scene.
pub(super) fn draw<P: Probe>(
    scene: &Scene,
    limits: Limits,
    settings: &FilmSettings,
    probe: &P,
) -> Image {
    let textures = Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = LinearSearch::new(&scene.geometry, probe);
    let tracer = RayTracer::new(scene, &textures, &geometry, probe, limits);
    expose(settings, |point, _| tracer.incident_radiance(scene.camera.ray(point)))
}

fn draw_as_is(name: &str, size: [u32; 2], samples: u32) -> Drawing {
    let settings = FilmSettings { size, samples, ..PANEL };
    Picture::from(&draw(&scene(name), limits(), &settings, &Unwatched)).into()
}

pub(super) fn whitted() -> Drawing {
    draw_as_is("whitted", scene("whitted").exposure.size, 16)
}

pub(super) fn nested_glass() -> Drawing {
    draw_as_is("nested-glass", [320, 200], 4)
}

pub(super) fn touching_glass() -> Drawing {
    draw_as_is("touching-glass", [320, 200], 4)
}

pub(super) fn glass_slab() -> Drawing {
    draw_as_is("glass-slab", [320, 240], 4)
}

pub(super) fn two_mirrors() -> Drawing {
    draw_as_is("two-mirrors", [320, 240], 16)
}

/// Three rows of three: the depths 0 to 8.
pub(super) fn depths() -> Drawing {
    let scene = scene("whitted");
    let at = |depth: u32| {
        let limits = Limits::new(Some(depth), Limits::CUTOFF);
        Picture::from(&draw(&scene, limits, &PANEL, &Unwatched))
    };
    let rows: [Picture; 3] =
        [0, 3, 6].map(|first| Picture::side_by_side(&[first, first + 1, first + 2].map(at), 8));
    Picture::stacked(&rows, 8).into()
}
