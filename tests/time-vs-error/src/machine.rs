//! Where the measurement was made, and how long it took.

use std::fs;

use crate::experiment::Experiment;
use crate::results::Results;
use crate::run::key;

/// A sentence for the page.
pub(crate) fn text(experiments: &[Experiment], results: &Results) -> String {
    let rows: Vec<_> = experiments
        .iter()
        .flat_map(Experiment::jobs)
        .filter_map(|job| results.get(&key(&job)))
        .collect();
    let clock: f64 = rows.iter().map(|row| row.seconds.iter().sum::<f64>()).sum();
    let processor: f64 = rows.iter().map(|row| row.cpu.unwrap_or(f64::NAN)).sum();
    let spent = if processor.is_finite() {
        format!(" and {} of the processor's time", minutes(processor))
    } else {
        String::new()
    };
    format!(
        "Measured on: {}, one thread. {} renders, which took {} by the clock{spent}.\n",
        processor_name(),
        rows.len(),
        minutes(clock)
    )
}

fn minutes(seconds: f64) -> String {
    if seconds < 90.0 { format!("{seconds:.0} s") } else { format!("{:.0} min", seconds / 60.0) }
}

fn processor_name() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split(':').nth(1)).unwrap_or("an unknown processor");
    name.trim().to_owned()
}
