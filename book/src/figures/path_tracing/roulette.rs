//! The variance that roulette adds.

use path_tracing::{Ending, PathTracer, Roulette};
use ray_casting::{LinearSearch, Rgb};
use rendering_equation::{Density, Opaque};
use workbench::{Counter, Recorder, Sampler, Unwatched};

use super::rooms::{down, furnace};
use crate::axis::Axis;
use crate::figures::Drawing;
use crate::plot::{Plot, Series, Style};
use crate::table::Table;

const PATHS: u64 = 30_000;

/// Mean, standard deviation and rays of a path in the furnace.
fn measured(albedo: f32, ending: Ending) -> [f64; 3] {
    let scene = furnace(albedo);
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let recorder = Recorder::new();
    let tracer: PathTracer<'_, _, _, Opaque> =
        PathTracer::new(&scene, &[], &geometry, &recorder, Density::Cosine, ending);
    let path = |i| f64::from(tracer.incident_radiance(down(), &mut Sampler::new(0, 0, i)).x);
    let values: Vec<f64> = (0..PATHS).map(path).collect();
    let n = PATHS as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n;
    [mean, variance.sqrt(), 1.0 + recorder.get(Counter::ScatterRays) as f64 / n]
}

const fn constant(q: f32) -> Ending {
    Ending { depth: u32::MAX, roulette: Roulette::Constant(q) }
}

/// √((1 + 2ρm)/(1 − ρ²/q) − m²) / m.
fn law(albedo: f64, q: f64) -> f64 {
    let m = 1.0 / (1.0 - albedo);
    let second = (1.0 + 2.0 * albedo * m) / (1.0 - albedo * albedo / q);
    (second - m * m).max(0.0).sqrt() / m
}

/// The relative standard deviation of a path as a function of q.
pub(super) fn variance() -> Drawing {
    let mut series = Vec::new();
    for albedo in [0.5_f32, 0.8] {
        let a = f64::from(albedo);
        let from = 1.002 * a * a;
        let steps = (0..=200).map(|i| from + (0.995 - from) * libm::pow(f64::from(i) / 200.0, 2.0));
        let points =
            steps.map(|q| [q, law(a, q)]).filter(|p| (0.1..10.0).contains(&p[1])).collect();
        series.push(Series { name: format!("ρ = {albedo}"), points, style: Style::Line });
        // From ρ^(4/3) on the measured deviation can be trusted.
        let qs = [0.42_f32, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95];
        let points = qs
            .into_iter()
            .filter(|q| f64::from(*q) > libm::pow(a, 4.0 / 3.0))
            .map(|q| {
                let [mean, deviation, _] = measured(albedo, constant(q));
                [f64::from(q), deviation / mean]
            })
            .collect();
        series.push(Series { name: String::new(), points, style: Style::Marks });
    }
    Plot {
        description: "The noise of a path falls as q grows, and rises without limit where q comes \
                      near the square of the albedo"
            .to_owned(),
        x: Axis::linear("q").within(0.2, 1.0),
        y: Axis::log("standard deviation / mean").within(0.1, 10.0),
        series,
    }
    .into()
}

/// E[S²] for the roulette of the stage: (1 + 2ρm) Σ ρᵏ βₖ.
fn expected(albedo: f64, roulette: Roulette) -> f64 {
    let m = 1.0 / (1.0 - albedo);
    let (mut sum, mut power, mut throughput) = (0.0, 1.0, 1.0);
    for events in 1..20_000 {
        sum += power * throughput;
        power *= albedo;
        throughput *= albedo;
        throughput /= f64::from(roulette.survival(Rgb::splat(throughput as f32), events));
    }
    ((1.0 + 2.0 * albedo * m) * sum - m * m).sqrt() / m
}

/// Constant q against the stage's, in the furnace.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "albedo",
        "roulette",
        "rays a path",
        "deviation / mean, measured",
        "by the law",
        "rays for an error of 1 %",
    ]);
    for albedo in [0.5_f32, 0.8, 0.95, 0.99] {
        let games = [Roulette::Constant(albedo), Roulette::Throughput];
        for roulette in games {
            let name = match roulette {
                Roulette::Constant(q) => format!("q = {q}"),
                _ => "by throughput".to_owned(),
            };
            let ending = Ending { depth: u32::MAX, roulette };
            let [mean, deviation, rays] = measured(albedo, ending);
            let law = expected(albedo.into(), roulette);
            table.row([
                albedo.to_string(),
                name,
                format!("{rays:.1}"),
                format!("{:.3}", deviation / mean),
                format!("{law:.3}"),
                crate::table::count((1.0e4 * law * law * rays) as u64),
            ]);
        }
    }
    table.into()
}
