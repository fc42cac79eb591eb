//! Measurements: tables and plots of run times, which no check can expect to come out the same
//! twice.
//!
//! They are taken by hand, on an idle machine, and committed. They show ratios, which carry over to
//! other machines better than seconds do. A table names the processor that it was taken on; a plot
//! stands beside such a table.

mod bv_tree;
mod rendering_equation;
mod stability;

use std::fs;
use std::path::Path;
use std::thread;
use std::time::Instant;

use crate::figures::Drawing;
use crate::{Error, Result, folder};

/// Where the measurements stand, seen from the book's folder.
pub const FOLDER: &str = "pages/measurements";

/// A table or a plot of the book that a stopwatch had a part in.
#[derive(Clone, Copy, Debug)]
pub struct Measurement {
    /// Its path under `pages/measurements/`: `04-bv-tree/run-time.md` for a table, `.svg` for a
    /// plot.
    pub file: &'static str,
    /// Takes it: seconds to a few minutes.
    pub take: fn() -> Drawing,
}

/// Every measurement of the book, chapter by chapter.
#[must_use]
pub fn all() -> Vec<Measurement> {
    [bv_tree::MEASUREMENTS, rendering_equation::MEASUREMENTS, stability::MEASUREMENTS].concat()
}

/// Takes the measurements whose file name contains `only`, and writes them into the book at `root`.
///
/// # Errors
///
/// The builder was compiled without optimisation, no measurement fits `only`, or a file cannot be
/// written.
pub fn take(root: &Path, only: &str) -> Result<()> {
    if cfg!(debug_assertions) {
        return Err(Error::msg(
            "measure what users run: cargo run --release -p book -- measurements",
        ));
    }
    let chosen: Vec<_> = all().into_iter().filter(|m| m.file.contains(only)).collect();
    if chosen.is_empty() {
        return Err(Error::msg(format!("no measurement's file name contains `{only}`")));
    }
    let cores = thread::available_parallelism()?;
    let machine = format!("Measured on: {}, {cores} threads.", processor());
    for measurement in chosen {
        eprintln!("{} …", measurement.file);
        let Drawing::Text(mut text) = (measurement.take)() else {
            return Err(Error::msg(format!("{} is a picture", measurement.file)));
        };
        if measurement.file.ends_with(".md") {
            text = format!("{text}\n{machine}\n");
        }
        folder::write(&root.join(FOLDER).join(measurement.file), text)?;
    }
    Ok(())
}

/// The median of the seconds that `work` takes, over `runs` runs after one that does not count.
///
/// # Panics
///
/// If `runs` is 0.
pub fn median_seconds<T>(runs: usize, mut work: impl FnMut() -> T) -> f64 {
    assert!(runs > 0, "{runs} runs have no median");
    let mut once = || {
        let start = Instant::now();
        std::hint::black_box(work());
        start.elapsed().as_secs_f64()
    };
    once();
    let mut seconds: Vec<f64> = (0..runs).map(|_| once()).collect();
    seconds.sort_by(f64::total_cmp);
    seconds[runs / 2]
}

/// The processor's name as the operating system gives it, else its architecture.
fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_owned())
    });
    name.unwrap_or_else(|| format!("an unnamed {} processor", std::env::consts::ARCH))
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use super::median_seconds;

    #[test]
    fn one_slow_run_does_not_move_the_median() {
        let mut pauses = [1, 1, 60, 1].into_iter();
        let median = median_seconds(3, || {
            sleep(Duration::from_millis(pauses.next().expect("one pause for each run")));
        });
        assert!((0.001..0.06).contains(&median), "the median is {median} s");
    }
}
