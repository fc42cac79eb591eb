//! What it saves to send samples where they are needed: renders to an error, with and without.

use crate::answers::{Answers, enumerated};
use crate::comparison::Ratio;
use crate::curve::{Mean, Spread};
use crate::error::{Error, Result};
use crate::markdown::{factor, percent, scientific, table};
use crate::matrix::Extent;
use crate::measures;
use crate::row::spent;
use crate::scene::stored;
use crate::stages::{Rendered, Stages};
use crate::truth::Truth;

/// A scene that a stage renders until its error is small enough.
#[derive(Clone, Copy, Debug)]
pub struct Stop {
    /// The scene.
    pub scene: &'static str,
    /// The stage.
    pub stage: &'static str,
    /// Its right picture, in `assets/reference`.
    pub reference: &'static str,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// `--error`, in percent.
    pub percent: u32,
}

/// What is rendered: noise that has its places, noise of rare bright paths, noise that is even.
pub const STOPS: [Stop; 4] = [
    stop("cornell-box", "light-sampling", "cornell", 128, 5),
    stop("many-lights", "light-sampling", "many-lights", 128, 7),
    stop("cornell-spheres", "light-sampling", "cornell-spheres", 128, 25),
    stop("cornell-box", "path-tracing", "cornell", 64, 25),
];

const fn stop(
    scene: &'static str,
    stage: &'static str,
    reference: &'static str,
    side: u32,
    percent: u32,
) -> Stop {
    Stop { scene, stage, reference, size: [side; 2], percent }
}

/// Half of the samples where they are needed; as many for every pixel.
const OPTIONS: [&str; 2] = ["", "--no-skip samples_not_needed"];

/// A scene with what came out in both ways.
#[derive(Clone, Debug)]
pub struct Stopped {
    /// What was rendered.
    pub stop: Stop,
    /// How many seeds.
    pub seeds: usize,
    /// With samples where they are needed, and with as many for every pixel.
    pub ways: [Way; 2],
}

/// The renders of one way, over all seeds.
#[derive(Clone, Debug)]
pub struct Way {
    /// Samples a pixel, on average.
    pub samples: Mean,
    /// Seconds of the render.
    pub seconds: Spread,
    /// relMSE, less the reference's own.
    pub rel_mse: Mean,
    /// Relative error of the picture's mean; its error has the reference's in it.
    pub bias: Mean,
    /// In how many renders the true error is below the stated one.
    pub kept: usize,
}

/// One render.
struct Sample {
    samples: f64,
    seconds: f64,
    errors: measures::Errors,
    stated: f64,
}

/// Renders every scene in both ways, in turn.
///
/// # Errors
/// If a stage fails, or a reference cannot be read.
pub fn stop_all(stages: &Stages, extent: Extent) -> Result<Vec<Stopped>> {
    let (seeds, coarser) = match extent {
        Extent::Full => (12, 1),
        Extent::Quick => (2, 3),
    };
    STOPS
        .into_iter()
        .map(|stop| Stop { percent: coarser * stop.percent, ..stop }.measure(stages, seeds))
        .collect()
}

impl Stop {
    fn measure(self, stages: &Stages, seeds: u64) -> Result<Stopped> {
        let right = Truth::reference(self.reference, self.size)?;
        let mut samples = OPTIONS.map(|_| Vec::new());
        for seed in 0..seeds {
            for (options, samples) in OPTIONS.iter().zip(&mut samples) {
                samples.push(self.sample(stages, options, seed, &right)?);
            }
        }
        let ways = samples.map(|samples| Way::of(&samples, &right));
        Ok(Stopped { stop: self, seeds: seeds as usize, ways })
    }

    fn sample(self, stages: &Stages, options: &str, seed: u64, right: &Truth) -> Result<Sample> {
        let Self { scene, stage, size: [width, height], percent, .. } = self;
        let file = stored(scene);
        let arguments = format!(
            "--size {width}x{height} --depth 16 --error {percent}% --seed {seed} {options}"
        );
        let rendered: Rendered = stages.render(stage, &file, &arguments)?;
        let camera = rendered.number("/rays/camera");
        let stated = rendered.number("/estimated_error");
        if !(camera > 0.0 && stated > 0.0) {
            return Err(Error::new(format!("`{stage} {scene} {arguments}` states no error")));
        }
        Ok(Sample {
            samples: camera / f64::from(width * height),
            seconds: spent(rendered.seconds(), rendered.cpu)[2],
            errors: measures::errors(&rendered.image, right),
            stated,
        })
    }
}

impl Way {
    fn of(samples: &[Sample], right: &Truth) -> Self {
        let mean = |of: fn(&Sample) -> f64, shared| Mean::of(samples.iter().map(of), shared);
        let is_kept = |s: &&Sample| s.errors.rel_mse <= s.stated * s.stated;
        Self {
            samples: mean(|s| s.samples, 0.0),
            seconds: Spread::of(samples.iter().map(|s| s.seconds)),
            rel_mse: mean(|s| s.errors.rel_mse, 0.0),
            bias: mean(|s| s.errors.bias, right.mean_error()),
            kept: samples.iter().filter(is_kept).count(),
        }
    }
}

impl Stopped {
    /// The time for the same error without sharing, in terms of the time with it.
    ///
    /// ```text
    /// (relMSE · seconds) of alike / (relMSE · seconds) of shared
    /// ```
    #[must_use]
    pub fn saved(&self) -> Ratio {
        let [shared, alike] = self.ways.each_ref();
        let cost = |way: &Way| way.rel_mse.value * way.seconds.median;
        let value = cost(alike) / cost(shared);
        Ratio::of_means(value, [alike.rel_mse, shared.rel_mse], self.seeds)
    }
}

/// A row for each scene.
#[must_use]
pub fn markdown(stopped: &[Stopped]) -> String {
    let header = [
        "scene",
        "stage",
        "`--error`",
        "samples a pixel, needed / alike",
        "relMSE, needed / alike",
        "time for the same error, alike / needed",
        "mean of the picture, needed",
        "as good as stated, needed",
    ];
    let row = |stopped: &Stopped| {
        let Stopped { stop, seeds, ways } = stopped;
        let both = |text: fn(&Way) -> String| {
            let [shared, alike] = ways.each_ref().map(text);
            format!("{shared} / {alike}")
        };
        let saved = stopped.saved();
        let [low, high] = [saved.low, saved.high].map(factor);
        vec![
            stop.scene.to_owned(),
            stop.stage.to_owned(),
            format!("{} %", stop.percent),
            both(|way| format!("{:.0}", way.samples.value)),
            both(|way| scientific(way.rel_mse.value)),
            format!("{} ({low} to {high})", factor(saved.value)),
            percent(ways[0].bias),
            format!("{} of {seeds}", ways[0].kept),
        ]
    };
    table(&header, &stopped.iter().map(row).collect::<Vec<_>>())
}

/// What the table says, in a sentence.
#[must_use]
pub fn answers(stopped: &[Stopped]) -> Answers {
    let scenes: Vec<String> = stopped
        .iter()
        .map(|stopped| {
            let Stop { scene, stage, .. } = stopped.stop;
            let saved = stopped.saved();
            let open = if saved.is_open() { ", which is no clear difference" } else { "" };
            format!("{} on `{scene}` with `{stage}`{open}", factor(saved.value))
        })
        .collect();
    let biased = stopped.iter().filter(|stopped| {
        let bias = stopped.ways[0].bias;
        bias.value.abs() > bias.interval
    });
    let biased: Vec<String> = biased.map(|s| format!("`{}`", s.stop.scene)).collect();
    let mean = match biased.len() {
        0 => "No mean is certainly off.".to_owned(),
        _ => format!("The mean is certainly off on {}.", enumerated(&biased)),
    };
    let mut answers = Answers::default();
    answers.add(
        "stopping",
        Some(format!(
            "As many samples for every pixel take so many times as long for the same error: {}. {mean}",
            enumerated(&scenes)
        )),
    );
    answers
}

#[cfg(test)]
mod tests {
    use super::{STOPS, Stopped, Way, answers, markdown};
    use crate::curve::{Mean, Spread};

    fn way(samples: f64, rel_mse: f64, bias: f64) -> Way {
        let mean = |value: f64| Mean { value, error: 0.01 * value.abs(), interval: 0.002 };
        Way {
            samples: mean(samples),
            seconds: Spread::of([0.01 * samples]),
            rel_mse: mean(rel_mse),
            bias: mean(bias),
            kept: 8,
        }
    }

    fn stopped(bias: f64) -> Stopped {
        let ways = [way(100.0, 1e-3, bias), way(160.0, 1e-3, 0.0)];
        Stopped { stop: STOPS[0], seeds: 8, ways }
    }

    #[test]
    fn what_is_saved_is_time_for_the_same_error() {
        let saved = stopped(0.0).saved();
        assert!((saved.value - 1.6).abs() < 1e-12, "{saved:?}");
        assert!(saved.low > 1.5 && saved.high < 1.7, "{saved:?}");
    }

    #[test]
    fn a_row_shows_both_ways_and_the_sentence_names_a_wrong_mean() {
        let table = markdown(&[stopped(0.0)]);
        assert!(table.contains("| 5 % | 100 / 160 |"), "{table}");
        assert!(table.contains("| 8 of 8 |"), "{table}");
        let fine = answers(&[stopped(0.001)]);
        assert!(fine.text().contains("No mean is certainly off"), "{}", fine.text());
        let wrong = answers(&[stopped(0.003)]);
        assert!(wrong.text().contains("off on `cornell-box`"), "{}", wrong.text());
    }
}
