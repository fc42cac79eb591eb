//! What the stage draws.

use blinn_phong::Picture as Texture;
use bv_tree::{Aabb, Builder, BvTree};
use light_sampling::{Choice, Estimator, LightTracer, Measure, Settings};
use path_tracing::{Ending, Roulette};
use ray_casting::Scene;
use rendering_equation::Anything;
use workbench::{Estimate, FilmSettings, Probe, Unwatched, expose_estimate};

use crate::figures::{Drawing, scene_file};
use crate::picture::Picture;

/// By chance, by sampling the lights, by both.
pub(super) const ESTIMATORS: [Estimator; 3] =
    [Estimator::Scatter, Estimator::Light, Estimator::Mis];

/// All lights alike, by power, by what each can send to the point.
pub(super) const CHOICES: [Choice; 3] = [Choice::Uniform, Choice::Power, Choice::Nearby];

/// By area, and by solid angle from near.
pub(super) const MEASURES: [Measure; 2] = [Measure::Area, Measure::SolidAngle];

/// One of the course's scenes.
pub(super) fn scene(name: &str) -> Scene {
    Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// Paths that only roulette ends, as the stage's are when the command line says nothing.
pub(crate) fn settings(estimator: Estimator) -> Settings {
    let ending = Ending { depth: u32::MAX, roulette: Roulette::Throughput };
    Settings { estimator, ..Settings::new(ending) }
}

/// The stage's picture of a scene, with its noise.
pub(super) fn draw<P: Probe>(
    scene: &Scene,
    settings: Settings,
    film: &FilmSettings,
    probe: &P,
) -> Estimate {
    let textures = Texture::load_all(scene).unwrap_or_else(|error| panic!("{error}"));
    let geometry = BvTree::<Aabb, P>::build(&scene.geometry, Builder::Sah, probe);
    let tracer: LightTracer<'_, _, _, Anything> =
        LightTracer::new(scene, &textures, &geometry, probe, settings);
    expose_estimate(film, |point, sampler| {
        tracer.incident_radiance(scene.camera.ray(point), sampler)
    })
}

/// The three estimators side by side.
fn compared(name: &str, size: [u32; 2], samples: u32) -> Drawing {
    let scene = scene(name);
    let film = FilmSettings { size, samples, seed: 0, threads: None };
    let pictures = ESTIMATORS.map(|estimator| {
        Picture::from(&draw(&scene, settings(estimator), &film, &Unwatched).image)
    });
    Picture::side_by_side(&pictures, 8).into()
}

pub(super) fn cornell() -> Drawing {
    compared("cornell-box", [200, 200], 16)
}

pub(super) fn veach_plates() -> Drawing {
    compared("veach-plates", [240, 180], 16)
}

/// One lamp a hit, chosen in each of the three ways.
pub(super) fn many_lights() -> Drawing {
    let scene = scene("many-lights");
    let film = FilmSettings { size: [200, 200], samples: 16, seed: 0, threads: None };
    let pictures = CHOICES.map(|choice| {
        let settings = Settings { choice, ..settings(Estimator::Mis) };
        Picture::from(&draw(&scene, settings, &film, &Unwatched).image)
    });
    Picture::side_by_side(&pictures, 8).into()
}

pub(super) fn whitted() -> Drawing {
    let film = FilmSettings { size: [360, 240], samples: 64, seed: 0, threads: None };
    let estimate = draw(&scene("whitted"), settings(Estimator::Mis), &film, &Unwatched);
    Picture::from(&estimate.image).into()
}
