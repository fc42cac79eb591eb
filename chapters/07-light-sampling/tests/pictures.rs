//! What the scenes look like.

use std::path::Path;

use blinn_phong::Picture;
use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{Estimator, LightTracer, Settings};
use path_tracing::{Ending, Roulette};
use ray_casting::Scene;
use rendering_equation::Anything;
use workbench::{FilmSettings, Unwatched, expose};

fn check(snapshot: &str, scene: &str, size: [u32; 2], estimator: Estimator) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    let scene = Scene::load(&folder.join(scene).with_extension("toml"));
    let scene = scene.unwrap_or_else(|error| panic!("{error}"));
    let pictures = Picture::load_all(&scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = BvTree::<Aabb, _>::build(&scene.geometry, Builder::Sah, &Unwatched);
    let ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };
    let settings = Settings { estimator, ..Settings::new(ending) };
    let tracer: LightTracer<'_, _, _, Anything> =
        LightTracer::new(&scene, &pictures, &geometry, &Unwatched, settings);
    let film = FilmSettings { size, samples: 16, seed: 0, threads: None };
    let image =
        expose(&film, |point, sampler| tracer.incident_radiance(scene.camera.ray(point), sampler));
    picture_snapshots::assert_picture!(snapshot, &image);
}

#[test]
fn cornell_box_by_chance() {
    check("cornell-box-scatter", "cornell-box", [64, 64], Estimator::Scatter);
}

#[test]
fn cornell_box_by_light() {
    check("cornell-box-light", "cornell-box", [64, 64], Estimator::Light);
}

#[test]
fn cornell_box_by_both() {
    check("cornell-box-mis", "cornell-box", [64, 64], Estimator::Mis);
}

#[test]
fn cornell_spheres() {
    check("cornell-spheres", "cornell-spheres", [64, 64], Estimator::Mis);
}

#[test]
fn veach_plates() {
    check("veach-plates", "veach-plates", [64, 48], Estimator::Mis);
}

#[test]
fn many_lights() {
    check("many-lights", "many-lights", [64, 64], Estimator::Mis);
}

/// Point lights and a sky.
#[test]
fn whitted() {
    check("whitted", "whitted", [60, 40], Estimator::Mis);
}

#[test]
fn nested_glass() {
    check("nested-glass", "nested-glass", [60, 40], Estimator::Mis);
}

/// A mesh with interpolated normals.
#[test]
fn teapot() {
    check("teapot", "teapot", [60, 40], Estimator::Mis);
}
