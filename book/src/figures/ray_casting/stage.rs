//! What the stage draws.

use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::{Intersect, LinearSearch, RayCaster, Scene, Show};
use workbench::{FilmSettings, Image, Unwatched, expose};

use crate::figures::{Drawing, scene_file};
use crate::picture::Picture;

/// One of the course's scenes.
pub(super) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

fn settings(size: [u32; 2], samples: u32) -> FilmSettings {
    FilmSettings { size, samples, seed: 0, threads: None }
}

fn draw(scene: &Scene, geometry: &impl Intersect, show: Show, settings: &FilmSettings) -> Image {
    let caster = RayCaster::new(scene, geometry, &Unwatched, show);
    expose(settings, |point, _| caster.incident_radiance(scene.camera.ray(point)))
}

/// The stage's own picture, as its command without options makes it.
pub(super) fn whitted() -> Drawing {
    let scene = scene("whitted");
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let settings = settings(scene.exposure.size, scene.exposure.samples.unwrap_or(16));
    Picture::from(&draw(&scene, &geometry, Show::Facing, &settings)).into()
}

/// The Cornell box without lights, and with its lamp's shadows.
pub(super) fn shadows() -> Drawing {
    let panels = [false, true].map(|lit| {
        let mut scene = scene("cornell-box");
        if !lit {
            scene.lights.clear();
        }
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        Picture::from(&draw(&scene, &geometry, Show::Facing, &settings([256, 256], 16)))
    });
    Picture::side_by_side(&panels, 16).into()
}

/// The outline of a sphere with 1 and with 16 samples a pixel.
pub(super) fn samples() -> Drawing {
    let scene = scene("whitted");
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let panels = [1, 16].map(|samples| {
        let image = draw(&scene, &geometry, Show::Facing, &settings([240, 160], samples));
        Picture::from(&image).crop([96, 28], [48, 32]).enlarged(6)
    });
    Picture::side_by_side(&panels, 16).into()
}

/// The teapot, found by the tree of chapter 4, which gives the same picture as a linear search.
fn teapot(show: Show) -> Drawing {
    let scene = scene("teapot");
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::default(), &Unwatched);
    Picture::from(&draw(&scene, &tree, show, &settings([240, 160], 16))).into()
}

pub(super) fn facing() -> Drawing {
    teapot(Show::Facing)
}

pub(super) fn depth() -> Drawing {
    teapot(Show::Depth)
}

pub(super) fn normal() -> Drawing {
    teapot(Show::Normal)
}

pub(super) fn primitive() -> Drawing {
    teapot(Show::Primitive)
}

pub(super) fn uv() -> Drawing {
    let scene = scene("whitted");
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    Picture::from(&draw(&scene, &geometry, Show::Uv, &settings([240, 160], 16))).into()
}
