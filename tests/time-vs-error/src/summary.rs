//! The seeds of each setting together, as a CSV file.

use crate::csv;
use crate::curve::{Curve, Point};
use crate::report::Outcome;

/// The columns of `summary.csv`, in order, with what they hold.
pub const COLUMNS: [(&str, &str); 29] = [
    ("question", "as in results.csv, so the next four"),
    ("scene", ""),
    ("stage", ""),
    ("setting", ""),
    ("samples", ""),
    ("seeds", "how many renders the line sums up"),
    ("render_seconds", "median"),
    ("render_seconds_low", "a quarter of the seeds took less"),
    ("render_seconds_high", "a quarter of the seeds took more"),
    ("build_seconds", "of the seed that was fastest"),
    ("rel_mse", "mean over the seeds"),
    ("rel_mse_error", "standard error of that mean"),
    ("rel_mse_median", "half of the seeds had less"),
    ("rel_mse_trimmed", "mean"),
    ("rel_mse_trimmed_error", "standard error of that mean"),
    ("rmse", "mean"),
    ("rmse_error", "standard error of that mean"),
    ("flip", "mean"),
    ("flip_error", "standard error of that mean"),
    ("bias", "mean"),
    (
        "bias_interval",
        "half the width of its 95 % confidence interval (Student's t over the seeds)",
    ),
    ("rel_mse_shading", "mean"),
    ("rel_mse_sampling", "mean"),
    ("rel_mse_sampling_error", "standard error of that mean"),
    ("rays", "of the first seed"),
    ("efficiency", "1 / (rel_mse * render_seconds)"),
    ("slope", "of log rel_mse against log samples, of the whole curve"),
    ("slope_error", "its standard error, by the jackknife over the seeds"),
    ("rel_mse_of_one", "the line's rel_mse at one sample"),
];

/// The file's text; a cell is empty where nothing was measured.
#[must_use]
pub fn csv(outcomes: &[Outcome<'_>]) -> String {
    let mut text = csv::line(&COLUMNS.map(|(name, _)| name.to_owned())) + "\n";
    for outcome in outcomes {
        for curve in &outcome.curves {
            for point in &curve.points {
                text += &csv::line(&cells(outcome, curve, point));
                text.push('\n');
            }
        }
    }
    text
}

fn cells(outcome: &Outcome<'_>, curve: &Curve, point: &Point) -> Vec<String> {
    let mut cells = vec![
        outcome.experiment.question.to_owned(),
        outcome.experiment.scene.name.clone(),
        curve.setting.stage.to_owned(),
        curve.setting.name.clone(),
        point.samples.to_string(),
        point.seeds.to_string(),
    ];
    let law = curve.law().ok();
    let of_law = |value: fn(&statistics::PowerLaw) -> f64| law.as_ref().map_or(f64::NAN, value);
    let numbers = [
        point.render.median,
        point.render.low,
        point.render.high,
        point.build,
        point.rel_mse.value,
        point.rel_mse.error,
        point.rel_mse_median,
        point.trimmed.value,
        point.trimmed.error,
        point.rmse.value,
        point.rmse.error,
        point.flip.value,
        point.flip.error,
        point.bias.value,
        point.bias.interval,
        point.shading.value,
        point.sampling.value,
        point.sampling.error,
        point.rays as f64,
        point.efficiency(),
        of_law(|law| law.exponent),
        of_law(|law| law.standard_error),
        of_law(|law| law.factor),
    ];
    let number = |v: f64| if v.is_finite() { format!("{v:.6e}") } else { String::new() };
    cells.extend(numbers.map(number));
    cells
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, cells};
    use crate::curve::Curve;
    use crate::experiment::{Experiment, Setting};
    use crate::report::Outcome;
    use crate::results::Results;
    use crate::row::tests::example;
    use crate::scene::{Answer, Scene};

    #[test]
    fn every_column_has_a_cell() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let mut results = Results::open(&folder.path().join("r.csv")).expect("a new file");
        for seed in 0..2 {
            results.add(example("cosine", 4, seed)).expect("the row is written");
        }
        let options = example("cosine", 4, 0).key.options;
        let (stage, samples) = ("rendering-equation", vec![1, 4]);
        let setting = Setting { name: "cosine".into(), stage, options, samples, price: 1.0 };
        let scene = Scene::stored("cornell-box", [64, 64], Answer::None);
        let experiment =
            Experiment { question: "density", scene, settings: vec![setting], seeds: 8 };
        let curves = Curve::all(&experiment, &results);
        assert_eq!(curves[0].points.len(), 1, "only what was rendered: {curves:?}");
        let outcome = Outcome { experiment: &experiment, curves: curves.clone() };
        let found = cells(&outcome, &curves[0], &curves[0].points[0]);
        assert_eq!(found.len(), COLUMNS.len(), "{found:?}");
        assert_eq!(found[5], "2", "seeds");
    }
}
