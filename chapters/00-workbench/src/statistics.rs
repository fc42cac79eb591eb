//! The statistics file.

use serde::{Serialize, Serializer};

use crate::run::write_stdout;
use crate::{Counter, Error, Recorder, StatsTarget, atomic_file};

/// The statistics of one run, key for key as in the file.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Statistics<'a> {
    pub(crate) stage: &'a str,
    pub(crate) scene: &'a str,
    pub(crate) size: [u32; 2],
    pub(crate) samples: u32,
    pub(crate) threads: usize,
    pub(crate) seed: u64,
    pub(crate) seconds: Seconds,
    pub(crate) rays: Group,
    pub(crate) tests: Group,
    pub(crate) skipped: Group,
    pub(crate) non_finite_samples: u64,
    /// The relative error that the picture states, a fraction of 1; `null` when it is not known.
    pub(crate) estimated_error: Option<f64>,
}

/// How long the parts of a run took.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Seconds {
    pub(crate) load: f64,
    pub(crate) build: f64,
    pub(crate) render: f64,
}

/// Counts by name, in the order of [`Counter::ALL`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Group(Vec<(&'static str, u64)>);

impl Serialize for Group {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// The counts of one group, `rays`, `tests` or `skipped`.
pub(crate) fn group(recorder: &Recorder, group: &str) -> Group {
    let counters = Counter::ALL.into_iter().filter(|counter| counter.name().0 == group);
    Group(counters.map(|counter| (counter.name().1, recorder.get(counter))).collect())
}

/// Writes the statistics, a file completely or not at all.
pub(crate) fn write(statistics: &Statistics<'_>, target: &StatsTarget) -> Result<(), Error> {
    // Strings, numbers and maps with string keys: none of them can fail.
    let mut text = serde_json::to_string_pretty(statistics).unwrap_or_default();
    text.push('\n');
    match target {
        StatsTarget::StandardOutput => write_stdout(&text),
        StatsTarget::File(path) => {
            atomic_file::write_file(path, |file| file.write_all(text.as_bytes()))
        }
    }
}
