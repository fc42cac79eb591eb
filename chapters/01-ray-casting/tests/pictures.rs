//! What the stage draws, in each of its ways.

use std::path::Path;

use ray_casting::{LinearSearch, RayCaster, Scene, Show};
use workbench::{FilmSettings, Image, Unwatched, expose};

/// A scene and the size at which linear search is done with it in a moment.
const PICTURES: [(&str, [u32; 2], u32); 3] =
    [("whitted", [96, 64], 4), ("teapot", [60, 40], 1), ("cornell-box", [64, 64], 4)];

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    let path = folder.join(name).with_extension("toml");
    Scene::load(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(scene: &Scene, show: Show, size: [u32; 2], samples: u32) -> Image {
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let caster = RayCaster::new(scene, &geometry, &Unwatched, show);
    let settings = FilmSettings { size, samples, seed: 0, threads: None };
    expose(&settings, |point, _| caster.incident_radiance(scene.camera.ray(point)))
}

fn check(show: Show, way: &str) {
    for (name, size, samples) in PICTURES {
        let image = picture(&load(name), show, size, samples);
        picture_snapshots::assert_picture!(&format!("{name}-{way}"), &image);
    }
}

#[test]
fn facing() {
    check(Show::Facing, "facing");
}

#[test]
fn depth() {
    check(Show::Depth, "depth");
}

#[test]
fn normal() {
    check(Show::Normal, "normal");
}

#[test]
fn primitive() {
    check(Show::Primitive, "primitive");
}

#[test]
fn uv() {
    check(Show::Uv, "uv");
}

#[test]
fn sphereflake() {
    let image = picture(&load("sphereflake"), Show::Facing, [40, 40], 1);
    picture_snapshots::assert_picture!("sphereflake-facing", &image);
}

#[test]
fn nothing_but_background_where_there_is_nothing() {
    let mut scene = load("whitted");
    scene.geometry = ray_casting::Geometry::default();
    let image = picture(&scene, Show::Facing, [3, 2], 1);
    assert_eq!(image.pixels, [scene.background.to_array(); 6], "the pixels");
}
