//! Run time against error: what a second of rendering brings, and what was not worth its time.
//!
//! | module | noun |
//! |---|---|
//! | [`options`] | the command line |
//! | [`matrix`], [`experiment`], [`scene`] | what is rendered, with which settings |
//! | [`stages`], [`run`] | the stages' binaries, and every render of the matrix |
//! | [`truth`], `furnace` | the right pictures |
//! | [`measures`], [`flip()`](flip::flip) | the error of a picture |
//! | [`row`], [`csv`], [`results`] | the file of all renders |
//! | [`curve`], [`summary`] | what the seeds say together |
//! | [`comparison`], [`answers`], [`tables`], [`markdown`] | what that means |
//! | [`report`], [`plot`], [`foreign`] | the files beside it, also with other renderers' curves |
//! | [`pictures`] | two settings at equal time and at equal error |
//! | [`stopping`] | what it saves to send samples where they are needed |
//! | [`counts`] | what each stage does and skips |
//! | [`skips`] | what each skip is worth |
//! | `machine`, `progress` | where it ran, and how long it will run |
//! | [`folder`], [`error`] | whole files; what can go wrong |

pub mod answers;
pub mod comparison;
pub mod counts;
pub mod csv;
pub mod curve;
pub mod error;
pub mod experiment;
pub mod flip;
pub mod folder;
pub mod foreign;
mod furnace;
mod machine;
pub mod markdown;
pub mod matrix;
pub mod measures;
pub mod options;
pub mod pictures;
pub mod plot;
mod progress;
pub mod report;
pub mod results;
pub mod row;
pub mod run;
pub mod scene;
pub mod skips;
pub mod stages;
pub mod stopping;
pub mod summary;
pub mod tables;
pub mod truth;

use error::{Error, Result};
use experiment::Experiment;
use options::{Command, Options};
use pictures::PAIRS;
use report::Outcome;
use results::Results;
use stages::Stages;

/// Does what the command line asks for.
///
/// # Errors
/// If a stage cannot be built or fails, a file cannot be read or written, or nothing is left to do.
pub fn measure(options: &Options) -> Result<()> {
    match options.command {
        None => draw_curves(options),
        Some(Command::Counts) => write_counts(options),
        Some(Command::Stopping) => write_stopping(options),
    }
}

/// The size of the pictures whose rays are counted.
const COUNTED: [u32; 2] = [64, 64];

fn write_counts(options: &Options) -> Result<()> {
    let stages = Stages::build()?;
    let folder = options.folder();
    std::fs::create_dir_all(&folder).map_err(|error| Error::file(&folder, error))?;
    let counted = counts::count_all(&stages, COUNTED)?;
    folder::write(&folder.join("counts.md"), counts::markdown(&counted))?;
    let rounds = if options.quick { 1 } else { 5 };
    let worths = skips::weigh_all(&stages, COUNTED, rounds)?;
    folder::write(&folder.join("skips.md"), skips::worth_markdown(&worths))
}

fn write_stopping(options: &Options) -> Result<()> {
    let stages = Stages::build()?;
    let folder = options.folder();
    std::fs::create_dir_all(&folder).map_err(|error| Error::file(&folder, error))?;
    let stopped = stopping::stop_all(&stages, options.extent())?;
    folder::write(&folder.join("stopping.md"), stopping::markdown(&stopped))?;
    folder::write(&folder.join("stopping-answers.md"), stopping::answers(&stopped).text())
}

fn draw_curves(options: &Options) -> Result<()> {
    let experiments = chosen(options)?;
    let foreign = options.rows.as_deref().map_or(Ok(Vec::new()), foreign::read)?;
    let stages = Stages::build()?;
    let mut results = Results::open(&options.results())?;
    let rendered = run::run(&experiments, &stages, &mut results)?;
    let outcomes: Vec<_> = experiments.iter().map(|e| Outcome::of(e, &results)).collect();
    report::write(&options.folder(), &outcomes, &foreign)?;
    folder::write(&options.folder().join("machine.md"), machine::text(&experiments, &results))?;
    if options.quick || options.only.is_some() {
        return Ok(());
    }
    for pair in PAIRS {
        for outcome in outcomes.iter().filter(|outcome| pair.is_of(outcome)) {
            if rendered > 0 || !options.folder().join(pair.file(outcome)).is_file() {
                pair.write(outcome, &stages, &options.folder())?;
            }
        }
    }
    Ok(())
}

/// The experiments that `--only` leaves.
fn chosen(options: &Options) -> Result<Vec<Experiment>> {
    let mut experiments = matrix::experiments(options.extent());
    if let Some(only) = &options.only {
        for experiment in &mut experiments {
            let scene = &experiment.scene.name;
            experiment.settings.retain(|setting| only.means(scene, setting.stage));
        }
        experiments.retain(|experiment| !experiment.settings.is_empty());
    }
    if experiments.is_empty() {
        return Err(Error::new("`--only` leaves nothing: no such scene, or no such stage of it"));
    }
    Ok(experiments)
}
