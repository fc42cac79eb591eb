//! The command line, the same for every stage.

use std::convert::Infallible;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use clap::builder::{TypedValueParser, ValueParser};
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, FromArgMatches, Parser};

use crate::exposure::{LARGEST_PICTURE, check_size};
use crate::no_skip::NoSkip;
use crate::picture_file::PictureFormat;

/// What a stage is called, and what it does when the command line says nothing.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// The name of the package.
    pub name: &'static str,
    /// One sentence for `--help`.
    pub about: &'static str,
    /// The bare name of the chapter's own scene.
    pub scene: &'static str,
    /// Samples a pixel when neither command line nor scene say so.
    pub samples: u32,
    /// Most scattering events on a path; `None`: unlimited, or the stage follows no path.
    pub depth: Option<u32>,
    /// Whether the stage estimates by random samples, so that `--time` and `--error` make sense.
    /// The stages before 05 do not.
    pub estimates: bool,
}

/// The options of a stage that adds none.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct NoExtra {}

/// The command line; `E` is what one stage adds.
#[derive(Clone, Debug, Parser)]
#[command(next_line_help = false)]
pub struct Options<E: Args> {
    /// A scene file, or the bare name of one in assets/scenes/
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,

    /// Write the picture to FILE: .png (8-bit sRGB) or .exr (linear 32-bit float)
    /// [default: STAGE-SCENE.png]
    #[arg(short, long, value_name = "FILE", value_parser = picture_path())]
    pub output: Option<PathBuf>,

    /// Width and height of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<[u32; 2]>,

    /// Samples a pixel [default: the scene's, else the stage's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub samples: Option<u32>,

    /// Most scattering events on a path; 0 = only what the camera sees directly
    #[arg(long, value_name = "D")]
    pub depth: Option<u32>,

    /// Render until this time is used up, for example 10s, 500ms or 2m; with --samples or --error,
    /// until whichever comes first
    #[arg(long, value_name = "TIME", value_parser = parse_time)]
    pub time: Option<Duration>,

    /// Render until the estimated relative error of the picture is at most this, for example 1%:
    /// the root of the mean over pixels and channels of (error of the mean)² / (mean² + 0.01), so
    /// large that the true one is below it in 95 of 100 renders
    #[arg(long, value_name = "PERCENT", value_parser = parse_error)]
    pub error: Option<f64>,

    /// Another seed, another picture
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,

    /// Threads to render with; never changes the picture [default: all cores]
    #[arg(long, value_name = "T", value_parser = parse_threads)]
    pub threads: Option<usize>,

    /// Render only this pixel, and print every ray, hit and weight of its first path
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pub pixel: Option<[u32; 2]>,

    /// Write counters and times as JSON (- = standard output)
    #[arg(long, value_name = "FILE")]
    pub stats: Option<StatsTarget>,

    /// Do work that the picture does not need, and throw the result away: keys under `skipped` of
    /// --stats, with commas between, or `all`. (Of samples_not_needed nothing is thrown away: under
    /// --error, all pixels get as many samples)
    #[arg(long, value_name = "WHAT")]
    pub no_skip: Option<NoSkip>,

    /// Show the picture in the terminal when done
    #[arg(long)]
    pub preview: bool,

    /// No progress bar, no summary
    #[arg(long)]
    pub quiet: bool,

    /// What the stage adds.
    #[command(flatten)]
    pub stage: E,
}

/// Where the statistics go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StatsTarget {
    /// `-`
    StandardOutput,
    /// A file.
    File(PathBuf),
}

impl FromStr for StatsTarget {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(if text == "-" { Self::StandardOutput } else { Self::File(PathBuf::from(text)) })
    }
}

impl<E: Args> Options<E> {
    /// Reads a command line, the first argument being the program's name.
    pub(crate) fn parse_for(
        stage: &'static Stage,
        arguments: impl IntoIterator<Item = std::ffi::OsString>,
    ) -> Result<Self, clap::Error> {
        let mut command = Self::command()
            .name(stage.name)
            .bin_name(stage.name)
            .about(stage.about)
            .mut_arg("scene", |argument| argument.required(false).default_value(stage.scene))
            .mut_arg("time", |argument| argument.hide(!stage.estimates))
            .mut_arg("error", |argument| argument.hide(!stage.estimates));
        let matches = command.try_get_matches_from_mut(arguments)?;
        let options = Self::from_arg_matches(&matches).map_err(|e| e.format(&mut command))?;
        match options.contradiction(stage) {
            Some(sentence) => Err(command.error(ErrorKind::ArgumentConflict, sentence)),
            None => Ok(options),
        }
    }

    /// Why the options, each right by itself, are wrong together or for this stage.
    fn contradiction(&self, stage: &Stage) -> Option<String> {
        let name = stage.name;
        if self.time.is_some() && !stage.estimates {
            return Some(format!("{name} does not take `--time`; it ends after `--samples`"));
        }
        if self.error.is_some() && !stage.estimates {
            return Some(format!("{name} does not take `--error`; it ends after `--samples`"));
        }
        match (&self.output, &self.stats) {
            (Some(output), Some(StatsTarget::File(stats))) if output == stats => {
                Some("`--output` and `--stats` name the same file; give them two".to_owned())
            }
            _ => None,
        }
    }
}

/// A path whose extension names a format that we write.
fn picture_path() -> ValueParser {
    clap::builder::PathBufValueParser::new()
        .try_map(|path: PathBuf| PictureFormat::of(&path).map(|_| path))
        .into()
}

fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let size = pair(text, &['x', 'X', '×'])
        .ok_or("write width and height as two whole numbers, for example 640x480")?;
    check_size(size, LARGEST_PICTURE).map(|()| size)
}

fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    pair(text, &[','])
        .ok_or_else(|| "write column and row as two whole numbers, for example 12,34".to_owned())
}

fn pair(text: &str, separators: &[char]) -> Option<[u32; 2]> {
    let (first, second) = text.split_once(separators)?;
    Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
}

fn parse_threads(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|threads| (1..=1024).contains(threads))
        .ok_or_else(|| "the number of threads must be from 1 to 1024".to_owned())
}

fn parse_time(text: &str) -> Result<Duration, String> {
    let units = [("ms", 0.001), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let seconds = units.iter().find_map(|(unit, seconds)| {
        let number: f64 = text.strip_suffix(unit)?.trim().parse().ok()?;
        Some(number * seconds)
    });
    seconds
        .filter(|&seconds| seconds > 0.0)
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or_else(|| "write a number above 0 and a unit, for example 10s, 500ms or 2m".to_owned())
}

/// A relative error as a fraction of 1: a percentage above 0, with its sign. `5` could mean 5 or
/// 500 %, `0.05` likewise, and no picture of random samples reaches 0.
fn parse_error(text: &str) -> Result<f64, String> {
    text.strip_suffix('%')
        .and_then(|number| number.trim().parse::<f64>().ok())
        .filter(|percent| percent.is_finite() && *percent > 0.0)
        .map(|percent| percent / 100.0)
        .ok_or_else(|| "write a percentage above 0, for example 1%".to_owned())
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::time::Duration;

    use super::{NoExtra, Options, Stage, StatsTarget, parse_error, parse_time};
    use crate::Counter;

    const STAGE: Stage = Stage {
        name: "stage",
        about: "",
        scene: "teapot",
        samples: 1,
        depth: None,
        estimates: true,
    };

    fn parse(line: &'static str) -> Options<NoExtra> {
        let arguments = line.split_whitespace().map(Into::into);
        Options::parse_for(&STAGE, arguments).unwrap_or_else(|error| panic!("{line}: {error}"))
    }

    #[test]
    fn nothing_is_needed() {
        let options = parse("stage");
        assert_eq!(options.scene, PathBuf::from("teapot"), "the scene");
        assert_eq!((options.seed, options.threads, options.size), (0, None, None), "the defaults");
    }

    #[test]
    fn every_option_is_read() {
        let options = parse(
            "stage a.toml -o b.exr --size 64x48 --samples 9 --depth 0 --time 2m --seed 7 \
             --error 3% --threads 3 --pixel 1,2 --stats - --preview --quiet \
             --no-skip any_hit_exits,fresnel_splits",
        );
        assert_eq!(options.scene, PathBuf::from("a.toml"), "the scene");
        assert_eq!(options.output, Some(PathBuf::from("b.exr")), "the output");
        assert_eq!((options.size, options.pixel), (Some([64, 48]), Some([1, 2])), "the pairs");
        assert_eq!((options.samples, options.depth), (Some(9), Some(0)), "the numbers");
        assert_eq!((options.seed, options.threads), (7, Some(3)), "the numbers");
        assert_eq!(options.stats, Some(StatsTarget::StandardOutput), "the statistics");
        assert_eq!(options.time, Some(Duration::from_secs(120)), "the time");
        assert_eq!(options.error, Some(0.03), "the error");
        let kinds = options.no_skip.map(|no_skip| no_skip.0);
        assert_eq!(kinds, Some(vec![Counter::AnyHitExits, Counter::FresnelSplits]), "no skip");
        assert!(options.preview && options.quiet, "the switches");
    }

    #[test]
    fn times_and_errors_have_units() {
        let times = ["10s", "0.5 s", "250ms", "2m", "1h"].map(|text| parse_time(text).ok());
        let expected = [10_000, 500, 250, 120_000, 3_600_000].map(Duration::from_millis).map(Some);
        assert_eq!(times, expected, "the times");
        for wrong in ["10", "s", "-1s", "0s", "nans", "infs", "1e300h", "10 min"] {
            assert!(parse_time(wrong).is_err(), "`{wrong}` was accepted as a time");
        }
        assert_eq!(parse_error("2%"), Ok(0.02), "two per cent");
        assert_eq!(parse_error("0.5 %"), Ok(0.005), "half a per cent");
        for wrong in ["1", "0.05", "0", "%", "-1%", "0%", "-0%", "nan%", "inf%", "1%%", "1e-999%"] {
            assert!(parse_error(wrong).is_err(), "`{wrong}` was accepted as an error");
        }
    }
}
