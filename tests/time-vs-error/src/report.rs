//! What is written beside the file of all renders: summary, plots, tables, answers.

use std::path::Path;

use crate::answers::{self, Answers};
use crate::curve::{Curve, Mean, Point};
use crate::error::Result;
use crate::experiment::Experiment;
use crate::folder;
use crate::foreign::Foreign;
use crate::plot::{Line, Mark, Plot};
use crate::results::Results;
use crate::summary;
use crate::tables::{self, Gain};

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
pub fn write(folder: &Path, outcomes: &[Outcome<'_>], foreign: &[Foreign]) -> Result<()> {
    folder::write(&folder.join("summary.csv"), summary::csv(outcomes))?;
    let mut answers = Answers::default();
    for outcome in outcomes {
        outcome.write(folder, foreign, &mut answers)?;
    }
    write_gains(folder, outcomes, &mut answers)?;
    folder::write(&folder.join("answers.md"), answers.text())
}

/// The files about the tree, which every terrain has a part in.
fn write_gains(folder: &Path, outcomes: &[Outcome<'_>], answers: &mut Answers) -> Result<()> {
    let terrains = outcomes.iter().filter(|outcome| outcome.experiment.question == "tree");
    let gains: Vec<Gain> = terrains.filter_map(Gain::of).collect();
    answers.add("tree", answers::trees(&gains));
    if let Some(svg) = gain_against_triangles(&gains).svg() {
        folder::write(&folder.join("tree.svg"), svg)?;
        folder::write(&folder.join("tree.md"), tables::trees(&gains))?;
    }
    Ok(())
}

fn gain_against_triangles(gains: &[Gain]) -> Plot {
    let line = |name: &str, gain: fn(&Gain) -> f64| {
        let mark = |g: &Gain| Mark { x: f64::from(g.triangles), y: gain(g), interval: 0.0 };
        Line { name: name.to_owned(), points: gains.iter().map(mark).collect() }
    };
    Plot {
        title: "From which triangle on does the tree pay, and how much?".to_owned(),
        x: "triangles".to_owned(),
        y: "time without / with tree".to_owned(),
        curves: vec![
            line("rendering", |gain| gain.render),
            line("and building", |gain| gain.with_building),
        ],
    }
}

impl<'a> Outcome<'a> {
    /// What came out of an experiment so far.
    #[must_use]
    pub fn of(experiment: &'a Experiment, results: &Results) -> Self {
        Self { experiment, curves: Curve::all(experiment, results) }
    }

    /// `question-scene`, the stem of its files.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}-{}", self.experiment.question, self.experiment.scene.name)
    }

    fn write(&self, folder: &Path, foreign: &[Foreign], answers: &mut Answers) -> Result<()> {
        let name = self.name();
        let (plot, table) = match self.experiment.question {
            "tree" => return Ok(()),
            "volumes" => (None, tables::times(self)),
            "whitted" => {
                answers.add(&name, answers::whitted(self));
                (Some(self.parts_against_samples()), tables::whitted(self))
            }
            _ => {
                // Where paths are cut, an equal error need not be within reach.
                if self.experiment.question != "ending" {
                    answers.add(&name, answers::efficiency(self));
                }
                answers.add(&format!("{name}-bias"), answers::bias(self));
                answers.add(&format!("{name}-slopes"), answers::slopes(self));
                (self.error_against_time(foreign), tables::errors(self))
            }
        };
        folder::write(&folder.join(format!("{name}.md")), table)?;
        match plot.and_then(|plot| plot.svg()) {
            Some(svg) => folder::write(&folder.join(format!("{name}.svg")), svg),
            None => Ok(()),
        }
    }

    /// The error of a Whitted picture, and the part of it that samples mend.
    fn parts_against_samples(&self) -> Plot {
        let line = |curve: &Curve, part: &str, error: fn(&Point) -> Mean| {
            let mark = |point: &Point| {
                let Mean { value, interval, .. } = error(point);
                Mark { x: f64::from(point.samples), y: value, interval }
            };
            let name = format!("{}, {part}", curve.setting.name);
            Line { name, points: curve.points.iter().map(mark).collect() }
        };
        let curves = self.curves.iter().flat_map(|curve| {
            [line(curve, "all", |p| p.rel_mse), line(curve, "by sampling", |p| p.sampling)]
        });
        Plot {
            title: format!("{}: what do more samples mend?", self.experiment.scene.name),
            x: "samples a pixel".to_owned(),
            y: "relMSE".to_owned(),
            curves: curves.collect(),
        }
    }

    /// Seconds of one sample a pixel of the first setting: the unit of time of the plots.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.curves.first().map_or(f64::NAN, Curve::seconds_a_sample)
    }

    /// relMSE against time; `None` if nobody asked for errors.
    fn error_against_time(&self, foreign: &[Foreign]) -> Option<Plot> {
        let unit = self.unit();
        let line = |curve: &Curve| {
            let time = curve.seconds_a_sample() / unit;
            let mark = |point: &Point| {
                let Mean { value, interval, .. } = point.rel_mse;
                Mark { x: time * f64::from(point.samples), y: value, interval }
            };
            Line {
                name: curve.setting.name.clone(),
                points: curve.points.iter().map(mark).collect(),
            }
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
