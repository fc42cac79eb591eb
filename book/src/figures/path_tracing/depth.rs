//! What a limit of the depth loses.

use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::LinearSearch;
use rendering_equation::{Density, Opaque};
use workbench::{Sampler, Unwatched};

use super::rooms::{down, furnace};
use super::stage::{draw, scene, settings};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::picture::Picture;
use crate::plot::{Plot, Series, Style};
use crate::table::Table;

const fn limit(depth: u32) -> Ending {
    Ending { depth, roulette: Roulette::Off }
}

/// Depths 1, 2, 3 and 16.
pub(super) fn pictures() -> Drawing {
    let scene = scene("cornell-box");
    let panels = [1, 2, 3, 16].map(|depth| {
        Picture::from(&draw(&scene, limit(depth), &settings([56, 56], 144))).enlarged(2)
    });
    Picture::side_by_side(&panels, 8).into()
}

/// The share of a furnace's light that one path of at most this many events does not find. They all
/// find the same.
fn lost(albedo: f32, depth: u32) -> f64 {
    let scene = furnace(albedo);
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let cosine = Density::Cosine;
    let tracer: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(&scene, &[], &geometry, &Unwatched, cosine, limit(depth));
    let found = tracer.incident_radiance(down(), &mut Sampler::new(0, 0, 0)).x;
    1.0 - f64::from(found) * (1.0 - f64::from(albedo))
}

/// Measured, and a^(D+1).
pub(super) fn loss() -> Drawing {
    let mut series = Vec::new();
    for albedo in [0.5_f32, 0.8, 0.95] {
        let formula = (0..=30).map(|d| [f64::from(d), libm::pow(albedo.into(), f64::from(d + 1))]);
        let points = formula.filter(|p| p[1] > 1e-4).collect();
        series.push(Series { name: format!("a = {albedo}"), points, style: Style::Line });
        let points =
            [0, 1, 2, 3, 5, 7, 10, 15, 20, 25, 30].map(|d| [f64::from(d), lost(albedo, d)]);
        let points = points.into_iter().filter(|p| p[1] > 1e-4).collect();
        series.push(Series { name: String::new(), points, style: Style::Marks });
    }
    Plot {
        description: "The share of light lost falls exponentially with the depth; at albedo 0.95 \
                      it is still a fifth at depth 30"
            .to_owned(),
        x: Axis::linear("D").within(0.0, 30.0),
        y: Axis::log("share of the light that is lost").within(1e-4, 1.0),
        series,
    }
    .into()
}

/// The rows of the errata.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&["a", "D", "lost, measured", "a^(D+1)"]);
    for (albedo, depth) in [(0.5_f32, 5), (0.8, 5), (0.8, 10), (0.8, 20), (0.95, 20), (0.95, 100)] {
        let formula = 100.0 * libm::pow(albedo.into(), f64::from(depth + 1));
        table.row([
            albedo.to_string(),
            depth.to_string(),
            format!("{:.2} %", 100.0 * lost(albedo, depth)),
            format!("{formula:.2} %"),
        ]);
    }
    table.into()
}
