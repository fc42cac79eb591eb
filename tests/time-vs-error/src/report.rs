//! What is written beside the file of all renders: summary, plots, tables, answers.

use std::path::Path;

use crate::curve::{Curve, Point};
use crate::error::Result;
use crate::experiment::Experiment;
use crate::folder;
use crate::foreign::Foreign;
use crate::plot::{Line, Mark, Plot};
use crate::results::Results;
use crate::summary;

/// An experiment with what came out of it.
#[derive(Clone, Debug)]
pub struct Outcome<'a> {
    /// What was asked.
    pub experiment: &'a Experiment,
    /// A curve for each setting.
    pub curves: Vec<Curve>,
}

/// Writes everything into `folder`.
///
/// # Errors
/// If a file cannot be written.
pub fn write(
    folder: &Path,
    experiments: &[Experiment],
    results: &Results,
    foreign: &[Foreign],
) -> Result<()> {
    let outcome = |experiment| Outcome { experiment, curves: Curve::all(experiment, results) };
    let outcomes: Vec<_> = experiments.iter().map(outcome).collect();
    folder::write(&folder.join("summary.csv"), summary::csv(&outcomes))?;
    for outcome in &outcomes {
        outcome.write(folder, foreign)?;
    }
    Ok(())
}

impl Outcome<'_> {
    /// `question-scene`, the stem of its files.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}-{}", self.experiment.question, self.experiment.scene.name)
    }

    fn write(&self, folder: &Path, foreign: &[Foreign]) -> Result<()> {
        if let Some(svg) = self.error_against_time(foreign).and_then(|plot| plot.svg()) {
            folder::write(&folder.join(self.name()).with_extension("svg"), svg)?;
        }
        Ok(())
    }

    /// Seconds of one sample a pixel of the first setting: the unit of time of the plots.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.curves.first().map_or(f64::NAN, Curve::seconds_a_sample)
    }

    /// relMSE against time; `None` if nobody asked for errors.
    fn error_against_time(&self, foreign: &[Foreign]) -> Option<Plot> {
        let unit = self.unit();
        let mark = |point: &Point| Mark {
            x: point.render.median / unit,
            y: point.rel_mse.value,
            interval: point.rel_mse.interval,
        };
        let line = |curve: &Curve| Line {
            name: curve.setting.name.clone(),
            points: curve.points.iter().map(mark).collect(),
        };
        let scene = &self.experiment.scene.name;
        let others = foreign.iter().filter(|other| other.scene == *scene);
        let curves = self.curves.iter().map(line).chain(others.map(|other| other.line(unit)));
        let first = &self.experiment.settings.first()?.name;
        Some(Plot {
            title: format!("{scene}: {}", title(self.experiment.question)?),
            x: format!("time / one sample a pixel with {first}"),
            y: "relMSE".to_owned(),
            curves: curves.collect(),
        })
    }
}

/// The question that a plot answers; `None` for those that are not about errors.
fn title(question: &str) -> Option<&'static str> {
    Some(match question {
        "density" => "directions by the cosine, or uniform?",
        "branching" => "how many directions from a hit?",
        "ending" => "roulette, or a limit to the depth?",
        "estimators" => "lamps by chance, by sampling them, or both?",
        "lights" => "which of many lamps should be asked?",
        _ => return None,
    })
}
