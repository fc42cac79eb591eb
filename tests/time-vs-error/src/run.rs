//! Runs what is missing, and keeps what came out.

use workbench::Image;

use crate::error::Result;
use crate::experiment::{Experiment, Job};
use crate::flip::flip;
use crate::measures;
use crate::progress::Bar;
use crate::results::Results;
use crate::row::{Key, Measures, Row};
use crate::stages::{Rendered, Stages};
use crate::truth::Truth;

/// Stages whose converged picture is not the right one.
const WHITTED: [&str; 3] = ["blinn-phong", "mirror-refraction", "bv-tree"];
/// Samples a pixel of a Whitted stage's converged picture: only its edges are random.
const WHITTED_SAMPLES: u32 = 1024;

/// Runs all renders of `experiments` whose rows are not there yet, and returns their number.
///
/// # Errors
/// If a stage fails, or a file cannot be read or written.
pub fn run(experiments: &[Experiment], stages: &Stages, results: &mut Results) -> Result<usize> {
    let missing = |job: &Job<'_>, results: &Results| results.get(&key(job)).is_none();
    let price = |experiment: &Experiment, results: &Results| -> f64 {
        experiment.jobs().filter(|job| missing(job, results)).map(|job| job.price()).sum()
    };
    let prices = experiments.iter().map(|experiment| price(experiment, results));
    let bar = Bar::new(prices.sum());
    let mut rendered_now = 0;
    for experiment in experiments {
        let jobs: Vec<_> = experiment.jobs().filter(|job| missing(job, results)).collect();
        let Some(first) = jobs.first() else {
            continue;
        };
        bar.say(&format!(
            "{}: the right picture of {}",
            experiment.question, experiment.scene.name
        ));
        let answers = Answers::of(experiment, stages)?;
        // Once without a clock: files and programs are in memory from then on.
        render(first, stages)?;
        for job in &jobs {
            bar.say(&format!(
                "{}: {}/{}, {}, {} samples, seed {}",
                experiment.question,
                experiment.scene.name,
                job.setting.stage,
                job.setting.name,
                job.samples,
                job.seed
            ));
            let rendered = render(job, stages)?;
            results.add(answers.row(job, &rendered))?;
            rendered_now += 1;
            bar.add(job.price());
        }
    }
    bar.finish();
    Ok(rendered_now)
}

/// The key of a render's row.
#[must_use]
pub fn key(job: &Job<'_>) -> Key {
    let Experiment { question, scene, .. } = job.experiment;
    Key {
        question: (*question).to_owned(),
        scene: scene.name.clone(),
        size: scene.size,
        stage: job.setting.stage.to_owned(),
        options: job.setting.options.clone(),
        samples: job.samples,
        seed: job.seed,
    }
}

fn render(job: &Job<'_>, stages: &Stages) -> Result<Rendered> {
    let scene = &job.experiment.scene;
    let [width, height] = scene.size;
    let (options, samples, seed) = (&job.setting.options, job.samples, job.seed);
    let arguments = format!("{options} --size {width}x{height} --samples {samples} --seed {seed}");
    stages.render(job.setting.stage, &scene.file(&stages.folder)?, &arguments)
}

/// What the pictures of an experiment are held against.
struct Answers {
    right: Option<Truth>,
    /// What each setting converges to, if that is something else.
    own: Vec<Option<Truth>>,
}

impl Answers {
    fn of(experiment: &Experiment, stages: &Stages) -> Result<Self> {
        let right = Truth::of(&experiment.scene, stages)?;
        let own = experiment.settings.iter().map(|setting| {
            if right.is_none() || !WHITTED.contains(&setting.stage) {
                return Ok(None);
            }
            let (scene, stage) = (&experiment.scene, setting.stage);
            Truth::converged(scene, stages, stage, &setting.options, WHITTED_SAMPLES).map(Some)
        });
        let own = own.collect::<Result<_>>()?;
        Ok(Self { right, own })
    }

    fn row(&self, job: &Job<'_>, rendered: &Rendered) -> Row {
        let position = job.experiment.settings.iter().position(|s| s == job.setting);
        let own = position.and_then(|i| self.own[i].as_ref());
        Row {
            key: key(job),
            setting: job.setting.name.clone(),
            rays: rendered.rays(),
            seconds: rendered.seconds(),
            cpu: rendered.cpu,
            mean: measures::grey_mean(&rendered.image),
            errors: self.errors(&rendered.image, own),
            non_finite: rendered.number("/non_finite_samples") as u64,
            picture: rendered.image.hash(),
        }
    }

    /// In the order of [`Measure`](crate::row::Measure).
    fn errors(&self, picture: &Image, own: Option<&Truth>) -> Measures {
        let Some(right) = &self.right else {
            return [None; 9];
        };
        let found = measures::errors(picture, right);
        let shading = own.map(|own| measures::errors(&own.image, right).rel_mse);
        let sampling = own.map(|own| measures::errors(picture, own).rel_mse);
        [
            Some(found.rmse),
            Some(found.rel_mse),
            Some(found.trimmed),
            Some(right.own_rel_mse()),
            Some(found.bias),
            Some(right.mean_error()),
            Some(flip(picture, &right.image)),
            shading,
            sampling,
        ]
    }
}
