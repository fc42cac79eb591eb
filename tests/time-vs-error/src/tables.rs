//! The tables beside the plots.

use statistics::grouped;

use crate::curve::{Curve, Point};
use crate::experiment::Setting;
use crate::markdown::{factor, percent, scientific, table};
use crate::report::Outcome;

/// The table of an outcome's curves at their most samples.
#[must_use]
pub fn errors(outcome: &Outcome<'_>) -> String {
    let header = [
        "setting",
        "samples",
        "time a sample",
        "relMSE",
        "slope",
        "trimmed",
        "RMSE",
        "FLIP",
        "bias",
        "efficiency",
    ];
    let unit = outcome.unit();
    let best = outcome.curves.first().and_then(Curve::last).map_or(f64::NAN, Point::efficiency);
    let row = |curve: &Curve| {
        let point = curve.last()?;
        let slope = curve.law().map_or_else(
            |_| "–".to_owned(),
            |law| format!("{:.3} ± {:.3}", law.exponent, law.standard_error).replace('-', "−"),
        );
        Some(vec![
            curve.setting.name.clone(),
            grouped(u64::from(point.samples)),
            factor(curve.seconds_a_sample() / unit),
            scientific(point.rel_mse.value),
            slope,
            scientific(point.trimmed.value),
            scientific(point.rmse.value),
            format!("{:.3}", point.flip.value),
            percent(point.bias),
            factor(point.efficiency() / best),
        ])
    };
    table(&header, &outcome.curves.iter().filter_map(row).collect::<Vec<_>>())
}

/// Times, and whether the pictures are the same bytes, relative to the first setting.
#[must_use]
pub fn times(outcome: &Outcome<'_>) -> String {
    let header = ["setting", "time", "quartiles", "time to build", "same picture"];
    let Some(first) = outcome.curves.first().and_then(Curve::last) else {
        return table(&header, &[]);
    };
    let row = |curve: &Curve| {
        let point = curve.last()?;
        let relative = |seconds: f64| factor(seconds / first.render.median);
        let same = point.pictures == first.pictures;
        Some(vec![
            curve.setting.name.clone(),
            relative(point.render.median),
            format!("{} to {}", relative(point.render.low), relative(point.render.high)),
            factor(point.build / first.build),
            if same { "yes" } else { "no" }.to_owned(),
        ])
    };
    table(&header, &outcome.curves.iter().filter_map(row).collect::<Vec<_>>())
}

/// What the tree is worth on one terrain.
#[derive(Clone, Copy, Debug)]
pub struct Gain {
    /// Triangles of the terrain.
    pub triangles: u32,
    /// Time without tree in terms of the time with it, rendering alone.
    pub render: f64,
    /// The same with the time of building, for one sample a pixel.
    pub with_building: f64,
    /// Whether the pictures are the same bytes.
    pub same_picture: bool,
}

impl Gain {
    /// The gain of an experiment whose settings are `tree` and `none`.
    #[must_use]
    pub fn of(outcome: &Outcome<'_>) -> Option<Self> {
        let [tree, none] = [0, 1].map(|i| outcome.curves.get(i).and_then(Curve::last));
        let (tree, none) = (tree?, none?);
        let sample = |point: &Point| point.render.median / f64::from(point.samples);
        let common = outcome.curves[0].points.iter().find(|p| p.samples == none.samples)?;
        Some(Self {
            triangles: outcome.experiment.scene.triangles()?,
            render: sample(none) / sample(tree),
            with_building: (sample(none) + none.build) / (sample(tree) + tree.build),
            same_picture: common.pictures == none.pictures,
        })
    }
}

/// What the tree is worth as the terrain grows.
#[must_use]
pub fn trees(gains: &[Gain]) -> String {
    let row = |gain: &Gain| {
        vec![
            grouped(u64::from(gain.triangles)),
            factor(gain.render),
            factor(gain.with_building),
            if gain.same_picture { "yes" } else { "no" }.to_owned(),
        ]
    };
    let rows: Vec<_> = gains.iter().map(row).collect();
    table(&["triangles", "time without / with tree", "building included", "same picture"], &rows)
}

/// What shading ignores and what sampling adds.
#[must_use]
pub fn whitted(outcome: &Outcome<'_>) -> String {
    let header = ["stage", "samples", "relMSE", "converged", "by sampling"];
    let row = |setting: &Setting, point: &Point| {
        vec![
            setting.name.clone(),
            grouped(u64::from(point.samples)),
            scientific(point.rel_mse.value),
            scientific(point.shading.value),
            scientific(point.sampling.value),
        ]
    };
    let rows = outcome
        .curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(move |point| row(&curve.setting, point)));
    table(&header, &rows.collect::<Vec<_>>())
}
