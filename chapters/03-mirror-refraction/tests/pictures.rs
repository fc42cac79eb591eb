//! What the scenes look like.

use std::path::Path;

use blinn_phong::{Picture, Shader, Terms};
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{LinearSearch, Scene};
use workbench::{FilmSettings, Image, Unwatched, expose};

const SIZE: [u32; 2] = [60, 40];

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

const fn settings(threads: Option<usize>) -> FilmSettings {
    FilmSettings { size: SIZE, samples: 4, seed: 0, threads }
}

/// The scene as the stage draws it, but for the cutoff.
fn picture(scene: &Scene, cutoff: f32, threads: Option<usize>) -> Image {
    let pictures = Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let limits = Limits::new(Some(8), cutoff);
    let tracer = RayTracer::new(scene, &pictures, &geometry, &Unwatched, limits);
    expose(&settings(threads), |point, _| tracer.incident_radiance(scene.camera.ray(point)))
}

fn check(name: &str) {
    picture_snapshots::assert_picture!(name, &picture(&load(name), Limits::CUTOFF, None));
}

#[test]
fn whitted() {
    check("whitted");
}

#[test]
fn nested_glass() {
    check("nested-glass");
}

#[test]
fn touching_glass() {
    check("touching-glass");
}

#[test]
fn glass_slab() {
    check("glass-slab");
}

#[test]
fn two_mirrors() {
    check("two-mirrors");
}

#[test]
fn cornell_spheres() {
    check("cornell-spheres");
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let scene = load("whitted");
    let hashes = [1, 2, 5].map(|n| picture(&scene, Limits::CUTOFF, Some(n)).hash());
    assert!(hashes.iter().all(|&hash| hash == hashes[0]), "1, 2, 5 threads: {hashes:x?}");
}

/// The error of the cutoff, in steps of the 8-bit picture.
#[test]
fn the_cutoff_changes_no_pixel_by_more_than_a_step() {
    for name in ["whitted", "nested-glass", "two-mirrors", "glass-slab"] {
        let scene = load(name);
        let with = picture(&scene, Limits::CUTOFF, None).to_srgb8();
        let without = picture(&scene, 0.0, None).to_srgb8();
        let steps = with.iter().zip(&without).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(steps <= Some(1), "{name}: {steps:?} steps");
    }
}

/// Where nothing reflects or refracts, this chapter is the one before.
#[test]
fn a_diffuse_scene_looks_as_in_chapter_2_to_the_bit() {
    let scene = load("cornell-box");
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let shader = Shader::new(&scene, &[], &geometry, &Unwatched, Terms::All);
    let expected =
        expose(&settings(None), |point, _| shader.incident_radiance(scene.camera.ray(point)));
    let got = picture(&scene, Limits::CUTOFF, None);
    assert_eq!(got.hash(), expected.hash(), "mean {:?} for {:?}", got.mean(), expected.mean());
}
