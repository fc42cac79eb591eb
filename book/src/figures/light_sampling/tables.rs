//! Errors and rays, in numbers.

use light_sampling::Estimator;
use workbench::{Counter, FilmSettings, Recorder, Unwatched};

use super::stage::{ESTIMATORS, draw, scene, settings};
use crate::figures::Drawing;
use crate::table::{Table, count};

/// Samples a pixel of the table of errors.
const SAMPLES: u32 = 256;

/// The expected squared relative error of a picture, times its samples: that of one sample.
pub(super) fn errors() -> Drawing {
    let mut table = Table::new(&["scene", "by chance", "lights", "both"]);
    for name in ["cornell-box", "many-lights", "veach-plates", "cornell-spheres", "furnace"] {
        let scene = scene(name);
        let film = FilmSettings { size: [64, 64], samples: SAMPLES, seed: 0, threads: None };
        let cells = ESTIMATORS.map(|estimator| {
            let rel_mse = draw(&scene, settings(estimator), &film, &Unwatched).rel_mse();
            format!("{:.2}", rel_mse * f64::from(SAMPLES))
        });
        table.row([format!("`{name}`")].into_iter().chain(cells));
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
