//! What the scenes look like, whatever finds the hits.

use std::path::Path;

use blinn_phong::Picture;
use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use mirror_refraction::{Limits, RayTracer};
use ray_casting::{Intersect, LinearSearch, Scene};
use workbench::{FilmSettings, Image, Unwatched, expose};

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    Scene::load(&folder.join(name).with_extension("toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// The scene as the stage draws it.
fn picture(scene: &Scene, settings: &FilmSettings, geometry: &impl Intersect) -> Image {
    let pictures = Picture::load_all(scene).unwrap_or_else(|e| panic!("{e}"));
    let limits = Limits::new(Some(8), Limits::CUTOFF);
    let tracer = RayTracer::new(scene, &pictures, geometry, &Unwatched, limits);
    expose(settings, |point, _| tracer.incident_radiance(scene.camera.ray(point)))
}

const fn settings(size: [u32; 2], samples: u32) -> FilmSettings {
    FilmSettings { size, samples, seed: 0, threads: None }
}

fn tree<V: BoundingVolume>(scene: &Scene, builder: Builder) -> BvTree<'static, V, Unwatched> {
    BvTree::build(&scene.geometry, builder, &Unwatched)
}

fn check(name: &str) {
    let scene = load(name);
    let geometry = tree::<Aabb>(&scene, Builder::Sah);
    let image = picture(&scene, &settings([80, 50], 4), &geometry);
    picture_snapshots::assert_picture!(name, &image);
}

#[test]
fn whitted_with_a_teapot() {
    check("whitted-teapot");
}

#[test]
fn teapot() {
    check("teapot");
}

#[test]
fn sphereflake() {
    check("sphereflake");
}

#[test]
fn cornell_box() {
    check("cornell-box");
}

/// accuracy V14.
#[test]
fn every_volume_and_builder_gives_the_same_bytes_as_linear_search() {
    for (name, size) in [("whitted-teapot", [24, 15]), ("sphereflake", [20, 20])] {
        let (scene, settings) = (load(name), settings(size, 1));
        let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
        let expected = picture(&scene, &settings, &geometry).hash();
        for builder in [Builder::Median, Builder::Sah] {
            let hashes = [
                picture(&scene, &settings, &tree::<Aabb>(&scene, builder)).hash(),
                picture(&scene, &settings, &tree::<Obb>(&scene, builder)).hash(),
                picture(&scene, &settings, &tree::<KDop<3>>(&scene, builder)).hash(),
                picture(&scene, &settings, &tree::<KDop<7>>(&scene, builder)).hash(),
                picture(&scene, &settings, &tree::<KDop<9>>(&scene, builder)).hash(),
                picture(&scene, &settings, &tree::<KDop<13>>(&scene, builder)).hash(),
            ];
            assert_eq!(hashes, [expected; 6], "{name}, {builder:?}: one hash a volume");
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let scene = load("whitted-teapot");
    let geometry = tree::<Aabb>(&scene, Builder::Sah);
    let hash = |threads| {
        let settings = FilmSettings { threads: Some(threads), ..settings([40, 25], 2) };
        picture(&scene, &settings, &geometry).hash()
    };
    assert_eq!([hash(1), hash(2), hash(5)], [hash(1); 3], "hashes for 1, 2 and 5 threads");
}
