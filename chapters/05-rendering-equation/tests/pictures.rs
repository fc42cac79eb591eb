//! What the scenes look like.

use std::path::Path;

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::Scene;
use rendering_equation::{Anything, Branching, Density, DistributedTracer};
use workbench::{FilmSettings, Image, Unwatched, expose};

const BRANCHING: Branching = Branching { directions: 2, depth: 4, density: Density::Cosine };

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

fn picture(scene: &Scene, branching: Branching, size: [u32; 2], threads: Option<usize>) -> Image {
    let pictures = Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let tree = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let tracer: DistributedTracer<'_, _, _, Anything> =
        DistributedTracer::new(scene, &pictures, &tree, &Unwatched, branching);
    let settings = FilmSettings { size, samples: 4, seed: 0, threads };
    expose(&settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

fn check(name: &str, branching: Branching, size: [u32; 2]) {
    picture_snapshots::assert_picture!(name, &picture(&load(name), branching, size, None));
}

#[test]
fn cornell_box() {
    check("cornell-box", BRANCHING, [48, 48]);
}

#[test]
fn cornell_box_with_uniform_directions() {
    let branching = Branching { density: Density::Uniform, ..BRANCHING };
    let image = picture(&load("cornell-box"), branching, [48, 48], None);
    picture_snapshots::assert_picture!("cornell-box-uniform", &image);
}

#[test]
fn cornell_spheres() {
    check("cornell-spheres", BRANCHING, [48, 48]);
}

/// Every pixel inside the outline is 0.5 to the bit.
#[test]
fn furnace() {
    check("furnace", BRANCHING, [48, 48]);
}

/// A textured floor under a sky, mirrors and glass.
#[test]
fn whitted() {
    check("whitted", BRANCHING, [60, 40]);
}

/// Highlights and interpolated normals.
#[test]
fn teapot() {
    let mut scene = load("teapot");
    scene.background = glam::Vec3::new(0.6, 0.8, 1.0);
    let image = picture(&scene, BRANCHING, [60, 45], None);
    picture_snapshots::assert_picture!("teapot", &image);
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let scene = load("cornell-spheres");
    let hashes = [1, 2, 5].map(|n| picture(&scene, BRANCHING, [24, 24], Some(n)).hash());
    assert!(hashes.iter().all(|&hash| hash == hashes[0]), "1, 2, 5 threads: {hashes:x?}");
}
