//! The progress bar.

use std::fmt::Write;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::Film;
use crate::goal::{Goal, predicted_total};
use crate::summary::percent;

/// What the bar shows when the number of samples is known; its length is their number.
const TEMPLATE: &str = "{wide_bar} {tiles}, {rays} camera rays/s, {left} left";

/// What it shows when time or error will tell; its length is what is expected.
const OPEN_TEMPLATE: &str =
    "{wide_bar} {samples} samples a pixel{msg}, {rays} camera rays/s, {left} left";

/// The progress bar of a render.
#[derive(Debug)]
pub(crate) struct Bar {
    bar: ProgressBar,
    pixels: u64,
    /// The most samples a pixel.
    samples: u32,
    /// As many as the error is expected to need.
    for_error: u32,
    /// Whether time or error may end the render before.
    is_open: bool,
}

impl Bar {
    /// A bar on standard error, hidden when that is no terminal or when it is not wanted.
    pub(crate) fn new(goal: &Goal, is_timed: bool, film: &Film, hidden: bool) -> Self {
        let target =
            if hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let (pixels, samples) = (film.pixel_count(), goal.samples);
        let is_open = is_timed || goal.error.is_some();
        let length = if is_open { pixels } else { pixels * u64::from(samples) };
        let bar = ProgressBar::with_draw_target(Some(length), target);
        let style = if is_open { open_style(pixels) } else { closed_style(pixels, samples, film) };
        if let Some(style) = style {
            bar.set_style(style);
        }
        Self { bar, pixels, samples, for_error: u32::MAX, is_open }
    }

    /// So many samples more.
    pub(crate) fn add(&self, samples: u64) {
        self.bar.inc(samples);
    }

    /// Shows the error of the film, if one was asked for, and expects what it tells.
    pub(crate) fn show_error(&mut self, film: &Film, goal: &Goal) {
        if let (Some(wanted), false) = (goal.error, self.bar.is_hidden())
            && let Some(error) = film.estimated_error()
        {
            let taken = film.average_samples();
            self.for_error = predicted_total(taken, error, wanted).max(taken);
            self.bar.set_message(format!(", error {}", percent(error)));
        }
    }

    /// Expects as many samples a pixel as there is time for.
    pub(crate) fn show_time(&self, for_time: Option<u32>) {
        if self.is_open {
            let expected = for_time.unwrap_or(u32::MAX).min(self.for_error).min(self.samples);
            self.bar.set_length(u64::from(expected) * self.pixels);
        }
    }

    /// Removes the bar.
    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A tile that gets several samples a pixel is done in parts, hence the tiles "× samples".
fn closed_style(pixels: u64, samples: u32, film: &Film) -> Option<ProgressStyle> {
    let tiles = film.tile_count();
    let samples_per_tile = (pixels * u64::from(samples) / tiles.max(1)).max(1);
    let each = match samples {
        1 => String::new(),
        several => format!(" × {several}"),
    };
    let style = ProgressStyle::with_template(TEMPLATE).ok()?;
    // Writing to the bar's text cannot fail.
    let style = style.with_key("tiles", move |state: &ProgressState, text: &mut dyn Write| {
        let _ = write!(text, "{}/{tiles} tiles{each}", state.pos() / samples_per_tile);
    });
    Some(with_rates(style))
}

fn open_style(pixels: u64) -> Option<ProgressStyle> {
    let style = ProgressStyle::with_template(OPEN_TEMPLATE).ok()?;
    let style = style.with_key("samples", move |state: &ProgressState, text: &mut dyn Write| {
        let _ = write!(text, "{}", state.pos() / pixels.max(1));
    });
    Some(with_rates(style))
}

fn with_rates(style: ProgressStyle) -> ProgressStyle {
    style
        .with_key("rays", |state: &ProgressState, text: &mut dyn Write| {
            let _ = write!(text, "{}", with_prefix(rate(state)));
        })
        .with_key("left", |state: &ProgressState, text: &mut dyn Write| {
            let left = state.len().unwrap_or(0).saturating_sub(state.pos());
            let left = Duration::try_from_secs_f64(left as f64 / rate(state));
            let _ = write!(text, "{:#}", HumanDuration(left.unwrap_or_default()));
        })
}

/// Samples a second since the beginning; the bar's own rate takes a quarter of a minute to settle.
fn rate(state: &ProgressState) -> f64 {
    state.pos() as f64 / state.elapsed().as_secs_f64()
}

/// A number with three digits or so: 950, 12.3 k, 4.5 M.
fn with_prefix(number: f64) -> String {
    match number {
        n if n >= 1e9 => format!("{:.1} G", n / 1e9),
        n if n >= 1e6 => format!("{:.1} M", n / 1e6),
        n if n >= 1e3 => format!("{:.1} k", n / 1e3),
        n => format!("{n:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{OPEN_TEMPLATE, TEMPLATE, with_prefix};
    use indicatif::ProgressStyle;

    #[test]
    fn the_templates_are_some() {
        for template in [TEMPLATE, OPEN_TEMPLATE] {
            assert!(ProgressStyle::with_template(template).is_ok(), "{template}");
        }
    }

    #[test]
    fn large_numbers_are_shortened() {
        let texts = [950.0, 12_345.0, 4.5e6, 2e9].map(with_prefix);
        assert_eq!(texts, ["950", "12.3 k", "4.5 M", "2.0 G"], "the texts");
    }
}
