//! What is measured: a question, a scene, and the settings that are held against each other.

use crate::scene::Scene;

/// Settings that are run in turn on one scene, to answer one question.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// A word for the question: `density`, `branching`, …
    pub question: &'static str,
    /// What is rendered.
    pub scene: Scene,
    /// What is compared; the first is the one in whose terms the others are said.
    pub settings: Vec<Setting>,
    /// Seeds 0 to `seeds` − 1, each of them a round.
    pub seeds: u64,
}

/// A stage with its options.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// A short name, for tables and plots.
    pub name: String,
    /// The package of the stage.
    pub stage: &'static str,
    /// Options of the command line, separated by spaces.
    pub options: String,
    /// The numbers of samples a pixel.
    pub samples: Vec<u32>,
    /// About how many rays a sample; only the progress bar asks.
    pub price: f64,
}

/// One render of an experiment.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The experiment that it belongs to.
    pub experiment: &'a Experiment,
    /// The setting that it runs with.
    pub setting: &'a Setting,
    /// Samples a pixel.
    pub samples: u32,
    /// The seed, which is also the number of the round.
    pub seed: u64,
}

impl Experiment {
    /// All renders, in the order in which they are run.
    ///
    /// A round is every setting at every number of samples. What slows the machine down for a while
    /// slows all settings down, because they alternate: A B A B, not A A B B. And a run that is
    /// interrupted has whole curves, of fewer seeds.
    pub fn jobs(&self) -> impl Iterator<Item = Job<'_>> {
        let steps = self.settings.iter().map(|s| s.samples.len()).max().unwrap_or(0);
        (0..self.seeds).flat_map(move |seed| {
            (0..steps).flat_map(move |step| {
                self.settings.iter().filter_map(move |setting| {
                    let samples = *setting.samples.get(step)?;
                    Some(Job { experiment: self, setting, samples, seed })
                })
            })
        })
    }
}

impl Job<'_> {
    /// About how many rays it follows.
    #[must_use]
    pub fn price(&self) -> f64 {
        let [width, height] = self.experiment.scene.size;
        f64::from(width * height) * f64::from(self.samples) * self.setting.price
    }
}

#[cfg(test)]
mod tests {
    use super::{Experiment, Setting};
    use crate::scene::{Answer, Scene};

    fn setting(name: &str, samples: &[u32]) -> Setting {
        Setting {
            name: name.into(),
            stage: "path-tracing",
            options: String::new(),
            samples: samples.to_vec(),
            price: 1.0,
        }
    }

    #[test]
    fn settings_alternate_within_a_round() {
        let experiment = Experiment {
            question: "order",
            scene: Scene::stored("cornell-box", [8, 8], Answer::None),
            settings: vec![setting("A", &[1, 4]), setting("B", &[1, 4, 16])],
            seeds: 2,
        };
        let order: Vec<String> = experiment
            .jobs()
            .map(|job| format!("{}{}/{}", job.setting.name, job.samples, job.seed))
            .collect();
        let round = |seed| ["A1", "B1", "A4", "B4", "B16"].map(|job| format!("{job}/{seed}"));
        assert_eq!(order, [round(0), round(1)].concat(), "the order of the renders");
    }
}
