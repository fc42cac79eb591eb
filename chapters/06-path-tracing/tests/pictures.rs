//! What the scenes look like, by chance and with few paths: noise is part of these snapshots.

use std::path::Path;

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::Scene;
use rendering_equation::{Anything, Density};
use workbench::{FilmSettings, Unwatched, expose};

/// The scene as the stage draws it.
fn check(name: &str, size: [u32; 2], samples: u32) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    let scene =
        Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"));
    let pictures = Picture::load_all(&scene).unwrap_or_else(|e| panic!("{e}"));
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };
    let tracer: PathTracer<'_, _, _, Anything> =
        PathTracer::new(&scene, &pictures, &geometry, &Unwatched, Density::Cosine, ending);
    let settings = FilmSettings { size, samples, seed: 0, threads: None };
    let image = expose(&settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s));
    picture_snapshots::assert_picture!(name, &image);
}

#[test]
fn cornell_box() {
    check("cornell-box", [48, 48], 64);
}

/// With the caustic below the glass sphere, as far as chance has found it.
#[test]
fn cornell_spheres() {
    check("cornell-spheres", [48, 48], 64);
}

#[test]
fn furnace() {
    check("furnace", [32, 32], 4);
}

/// By the light of the sky alone: the point lights are dark (errata 22).
#[test]
fn whitted() {
    check("whitted", [60, 40], 16);
}

#[test]
fn nested_glass() {
    check("nested-glass", [60, 38], 16);
}

#[test]
fn touching_glass() {
    check("touching-glass", [60, 38], 16);
}

#[test]
fn two_mirrors() {
    check("two-mirrors", [60, 40], 4);
}

#[test]
fn teapot() {
    check("teapot", [48, 36], 4);
}
