//! The command line.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{Parser, Subcommand};

use crate::matrix::Extent;
use crate::row::COLUMNS;

/// Measures run time against error: scenes × stages × settings × samples.
///
/// Each render becomes a line of the CSV file; lines that are there are not rendered again, so an
/// interrupted run goes on where it was, and a file that is complete is only drawn anew.
#[derive(Parser, Debug)]
#[command(name = "time-vs-error", after_long_help = columns())]
pub struct Options {
    /// Fewer seeds and samples: a minute at most
    #[arg(long, global = true)]
    pub quick: bool,

    /// Only this scene, or only this stage of it
    #[arg(long, value_name = "SCENE/STAGE")]
    pub only: Option<Only>,

    /// The file of all renders; summary, plots, tables and pictures are written beside it. Without
    /// it, all of the matrix goes into the book, and a part of it (--quick, --only) into the target
    /// folder
    #[arg(short, long, global = true, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Curves of other renderers, drawn into the same plots: a CSV file with the columns
    /// scene,renderer,setting,seconds,rel_mse
    #[arg(long, value_name = "FILE")]
    pub rows: Option<PathBuf>,

    /// Something else than the curves
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Something else than the curves.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Count what each stage does and skips on each scene, and what each skip is worth
    Counts,
    /// Render to an error, with samples where they are needed and with as many for every pixel
    Stopping,
}

impl Options {
    /// How much of the matrix is run.
    #[must_use]
    pub fn extent(&self) -> Extent {
        if self.quick { Extent::Quick } else { Extent::Full }
    }

    /// The file of all renders.
    #[must_use]
    pub fn results(&self) -> PathBuf {
        let is_part = self.quick || self.only.is_some();
        let folder = if is_part {
            "target/time-vs-error/part"
        } else {
            "book/pages/measurements/time-vs-error"
        };
        self.output.clone().unwrap_or_else(|| Path::new(folder).join("results.csv"))
    }

    /// The folder of everything that is written.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        let results = self.results();
        let parent = results.parent().filter(|folder| !folder.as_os_str().is_empty());
        parent.unwrap_or(Path::new(".")).to_owned()
    }
}

/// A scene, or a stage of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Only {
    scene: String,
    stage: Option<String>,
}

impl FromStr for Only {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (scene, stage) = match text.split_once('/') {
            Some((scene, stage)) => (scene, Some(stage.to_owned())),
            None => (text, None),
        };
        if scene.is_empty() || stage.as_ref().is_some_and(String::is_empty) {
            return Err(
                "expected SCENE or SCENE/STAGE, for example cornell-box/path-tracing".into()
            );
        }
        Ok(Self { scene: scene.to_owned(), stage })
    }
}

impl Only {
    /// Whether a stage of a scene is meant.
    #[must_use]
    pub fn means(&self, scene: &str, stage: &str) -> bool {
        self.scene == scene && self.stage.as_ref().is_none_or(|only| only == stage)
    }
}

/// The columns of the CSV file, for `--help`.
fn columns() -> String {
    let mut text = "Columns of the CSV file:\n".to_owned();
    for (name, meaning) in COLUMNS {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {name:<18} {meaning}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Only, Options};
    use clap::{CommandFactory, Parser};

    #[test]
    fn the_command_line_is_sound() {
        Options::command().debug_assert();
    }

    /// Tables of a part would stand in the book as if they were of all.
    #[test]
    fn only_the_whole_matrix_goes_into_the_book() {
        let file = |arguments: &str| {
            let arguments = ["time-vs-error"].into_iter().chain(arguments.split_whitespace());
            Options::try_parse_from(arguments).expect("a valid command line").results()
        };
        assert!(file("").starts_with("book"), "all: {:?}", file(""));
        for part in ["--quick", "--only cornell-box/path-tracing"] {
            assert!(file(part).starts_with("target"), "{part}: {:?}", file(part));
        }
        assert_eq!(file("--quick -o a.csv").to_str(), Some("a.csv"), "where one asks for it");
    }

    #[test]
    fn only_means_a_scene_or_a_stage_of_it() {
        let scene: Only = "furnace".parse().expect("a scene");
        assert!(scene.means("furnace", "path-tracing"), "{scene:?}");
        let stage: Only = "furnace/path-tracing".parse().expect("a stage");
        assert!(stage.means("furnace", "path-tracing"), "{stage:?}");
        assert!(!stage.means("furnace", "light-sampling"), "{stage:?}");
        assert!(!stage.means("cornell-box", "path-tracing"), "{stage:?}");
        for text in ["", "/path-tracing", "furnace/"] {
            assert!(text.parse::<Only>().is_err(), "`{text}`");
        }
    }
}
