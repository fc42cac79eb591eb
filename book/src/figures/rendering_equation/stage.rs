//! What the stage draws.

use blinn_phong::Picture as Texture;
use bv_tree::{Aabb, Builder, BvTree};
use ray_casting::{Camera, Scene};
use rendering_equation::{Anything, Branching, Density, DistributedTracer};
use workbench::{CameraRecord, Estimate, FilmSettings, Image, Probe, Unwatched, expose_estimate};

use crate::figures::path_tracing::rooms::closed_box;
use crate::figures::{Drawing, scene_file};
use crate::picture::Picture;
use crate::table::Table;

pub(crate) const fn branching(directions: u32, depth: u32, density: Density) -> Branching {
    Branching { directions, depth, density }
}

/// One of the course's scenes.
pub(crate) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

pub(super) const fn settings(size: [u32; 2], samples: u32) -> FilmSettings {
    FilmSettings { size, samples, seed: 0, threads: None }
}

/// The stage's picture of a scene, with what it knows of its error.
pub(super) fn estimate<P: Probe>(
    scene: &Scene,
    branching: Branching,
    settings: &FilmSettings,
    probe: &P,
) -> Estimate {
    let textures = Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = BvTree::<Aabb, P>::build(&scene.geometry, Builder::Sah, probe);
    let tracer: DistributedTracer<'_, _, _, Anything> =
        DistributedTracer::new(scene, &textures, &geometry, probe, branching);
    expose_estimate(settings, |point, s| tracer.incident_radiance(scene.camera.ray(point), s))
}

/// The stage's picture of a scene.
pub(super) fn draw(scene: &Scene, branching: Branching, settings: &FilmSettings) -> Image {
    estimate(scene, branching, settings, &Unwatched).image
}

/// The stage's own scene, with many samples and one direction for each.
pub(super) fn cornell_box() -> Drawing {
    let film = settings([128, 128], 100);
    let image = draw(&scene("cornell-box"), branching(1, 6, Density::Cosine), &film);
    Picture::from(&image).enlarged(2).into()
}

/// Uniform and cosine directions, in the furnace and in a closed box, with equal samples.
pub(super) fn densities() -> Drawing {
    let row = |scene: &Scene, depth: u32, samples: u32| {
        let panels = [Density::Uniform, Density::Cosine].map(|density| {
            let film = settings([72, 72], samples);
            Picture::from(&draw(scene, branching(1, depth, density), &film)).enlarged(2)
        });
        Picture::side_by_side(&panels, 8)
    };
    let furnace = row(&scene("furnace"), 1, 4);
    let closed = row(&closed_box(), 8, 16);
    Picture::side_by_side(&[furnace, closed], 24).into()
}

/// The disk of the furnace without its outline: the camera comes closer.
fn inside_of_furnace() -> Scene {
    let mut scene = scene("furnace");
    let camera = CameraRecord {
        eye: scene.camera.eye.to_array(),
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 16.0,
        size: [32, 32],
    };
    scene.camera = Camera::from(&camera);
    scene
}

/// The relMSE of one sample a pixel with either density.
pub(super) fn noise() -> Drawing {
    let mut table = Table::new(&["scene", "uniform", "cosine", "uniform / cosine"]);
    for (name, scene, samples) in [
        ("`furnace`, inside the outline", inside_of_furnace(), 256),
        ("`whitted`", scene("whitted"), 64),
        ("`cornell-box`", scene("cornell-box"), 160),
        ("`cornell-spheres`", scene("cornell-spheres"), 160),
    ] {
        let film = settings([32, 32], samples);
        let [uniform, cosine] = [Density::Uniform, Density::Cosine].map(|density| {
            let estimate = estimate(&scene, branching(1, 4, density), &film, &Unwatched);
            estimate.rel_mse() * f64::from(samples)
        });
        let ratio =
            if cosine > 0.0 { format!("{:.1}", uniform / cosine) } else { "–".to_owned() };
        let digits = |x: f64| match x {
            0.0 => "0".to_owned(),
            10.0.. => format!("{x:.0}"),
            _ => format!("{x:.2}"),
        };
        table.row([name.to_owned(), digits(uniform), digits(cosine), ratio]);
    }
    table.into()
}
