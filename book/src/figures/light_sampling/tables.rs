//! Errors and rays, in numbers.

use light_sampling::{Estimator, Heuristic, Settings};
use ray_casting::Scene;
use workbench::{Counter, Estimate, FilmSettings, Image, Recorder, Unwatched};

use super::near::floor_lamp;
use super::stage::{CHOICES, ESTIMATORS, MEASURES, draw, scene, settings};
use crate::figures::Drawing;
use crate::table::{Table, count};

/// Width and height of the pictures whose errors are told.
const SIZE: [u32; 2] = [48, 48];

/// Samples a pixel, of a picture whose error is told, and of the one that it is told relative to.
const SAMPLES: u32 = 48;
const SAMPLES_OF_MEAN: u32 = 192;

/// A scene with what it looks like, by the way that has the least noise.
struct Judge {
    scene: Scene,
    mean: Image,
}

impl Judge {
    fn new(scene: Scene) -> Self {
        Self { mean: estimate(&scene, settings(Estimator::Mis), SAMPLES_OF_MEAN).image, scene }
    }

    fn of(name: &str) -> Self {
        Self::new(scene(name))
    }

    /// The same for what comes straight from the lamps.
    fn of_direct_light(name: &str) -> Self {
        let scene = scene(name);
        let mean = estimate(&scene, direct(settings(Estimator::Mis)), SAMPLES_OF_MEAN).image;
        Self { scene, mean }
    }

    /// The expected squared relative error of a picture, times its samples a pixel: that of one
    /// sample. Relative to the mean of many samples, since of few it may be nearly 0 by chance.
    fn error(&self, settings: Settings) -> f64 {
        let estimate = estimate(&self.scene, settings, SAMPLES);
        let variances = estimate.variance_of_mean.pixels.iter().flatten();
        let ratios = variances.zip(self.mean.pixels.iter().flatten()).map(|(variance, mean)| {
            let mean = f64::from(*mean);
            f64::from(*variance) * f64::from(SAMPLES) / (mean * mean + 0.01)
        });
        ratios.sum::<f64>() / f64::from(3 * SIZE[0] * SIZE[1])
    }
}

fn estimate(scene: &Scene, settings: Settings, samples: u32) -> Estimate {
    draw(scene, settings, &FilmSettings { size: SIZE, samples, seed: 0, threads: None }, &Unwatched)
}

/// Only what comes straight from the lamps.
fn direct(mut settings: Settings) -> Settings {
    settings.ending.depth = 1;
    settings
}

fn cells(errors: impl IntoIterator<Item = f64>) -> impl Iterator<Item = String> {
    errors.into_iter().map(|error| format!("{error:.2}"))
}

/// The error of one sample, by all ways to find a lamp.
pub(super) fn errors() -> Drawing {
    let mut table = Table::new(&["scene", "by chance", "lights", "both"]);
    for name in ["cornell-box", "many-lights", "cornell-spheres", "furnace"] {
        let judge = Judge::of(name);
        let errors = ESTIMATORS.map(|estimator| judge.error(settings(estimator)));
        table.row([format!("`{name}`")].into_iter().chain(cells(errors)));
    }
    table.into()
}

/// The error of one sample, by how the light is chosen.
pub(super) fn choices() -> Drawing {
    let columns = ["scene", "lights", "uniform", "power", "nearby", "power / nearby"];
    let mut table = Table::new(&columns);
    for (name, lights) in
        [("many-lights", "64"), ("teapot", "2"), ("whitted", "3"), ("nested-glass", "3")]
    {
        let judge = Judge::of(name);
        let error = |choice| judge.error(Settings { choice, ..settings(Estimator::Mis) });
        let [uniform, power, nearby] = CHOICES.map(error);
        let errors = cells([uniform, power, nearby, power / nearby]);
        table.row([format!("`{name}`"), lights.to_owned()].into_iter().chain(errors));
    }
    table.into()
}

/// The error of one sample, by how points of flat lamps are drawn.
pub(super) fn measures() -> Drawing {
    let columns = ["scene", "found by", "area", "solid angle", "area / solid angle"];
    let mut table = Table::new(&columns);
    for (name, judge) in [
        ("the lamp on the floor", Judge::new(floor_lamp())),
        ("`cornell-box`", Judge::of("cornell-box")),
        ("`many-lights`", Judge::of("many-lights")),
    ] {
        for (way, estimator) in [("lights", Estimator::Light), ("both", Estimator::Mis)] {
            let error = |measure| judge.error(Settings { measure, ..settings(estimator) });
            let [area, solid_angle] = MEASURES.map(error);
            let errors = cells([area, solid_angle, area / solid_angle]);
            table.row([name.to_owned(), way.to_owned()].into_iter().chain(errors));
        }
    }
    table.into()
}

/// The error of one sample, by how both ways are weighed.
pub(super) fn heuristics() -> Drawing {
    let mut table = Table::new(&["scene", "balance", "power", "balance / power"]);
    let whole: fn(Settings) -> Settings = |settings| settings;
    for (name, judge, part) in [
        ("`veach-plates`, lamps only", Judge::of_direct_light("veach-plates"), direct as _),
        ("the lamp on the floor", Judge::new(floor_lamp()), whole),
        ("`cornell-box`", Judge::of("cornell-box"), whole),
        ("`many-lights`", Judge::of("many-lights"), whole),
    ] {
        let both = part(settings(Estimator::Mis));
        let [balance, power] = [Heuristic::Balance, Heuristic::Power]
            .map(|heuristic| judge.error(Settings { heuristic, ..both }));
        table.row([name.to_owned()].into_iter().chain(cells([balance, power, balance / power])));
    }
    table.into()
}

/// Shadow rays that were traced, and those that were not.
pub(super) fn rays() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "traced",
        "facing away",
        "nothing to reflect",
        "at mirrors and glass",
        "scattered",
    ]);
    for name in ["cornell-box", "many-lights", "veach-plates", "cornell-spheres", "whitted"] {
        let recorder = Recorder::new();
        let film = FilmSettings { size: [64, 64], samples: 4, seed: 0, threads: None };
        draw(&scene(name), settings(Estimator::Mis), &film, &recorder);
        let counters = [
            Counter::ShadowRays,
            Counter::ShadowRaysFacingAway,
            Counter::ShadowRaysNothingToReflect,
            Counter::ShadowRaysDelta,
            Counter::ScatterRays,
        ];
        let cells = counters.map(|counter| count(recorder.get(counter)));
        table.row([format!("`{name}`")].into_iter().chain(cells));
    }
    table.into()
}
