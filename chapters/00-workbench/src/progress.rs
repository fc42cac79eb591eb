//! The progress bar.

use std::fmt::Write;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

/// What the bar shows; its length is the number of samples.
const TEMPLATE: &str = "{wide_bar} {tiles}, {rays} camera rays/s, {left} left";

/// A bar on standard error, hidden when that is no terminal or when it is not wanted.
///
/// A tile that gets several samples a pixel is done in parts, hence the tiles "× samples".
pub(crate) fn bar(samples: u64, samples_per_pixel: u32, tiles: u64, quiet: bool) -> ProgressBar {
    let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(samples), target);
    let samples_per_tile = (samples / tiles.max(1)).max(1);
    let each = match samples_per_pixel {
        1 => String::new(),
        several => format!(" × {several}"),
    };
    if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
        // Writing to the bar's text cannot fail.
        let style = style
            .with_key("tiles", move |state: &ProgressState, text: &mut dyn Write| {
                let _ = write!(text, "{}/{tiles} tiles{each}", state.pos() / samples_per_tile);
            })
            .with_key("rays", |state: &ProgressState, text: &mut dyn Write| {
                let _ = write!(text, "{}", with_prefix(rate(state)));
            })
            .with_key("left", |state: &ProgressState, text: &mut dyn Write| {
                let left = state.len().unwrap_or(0).saturating_sub(state.pos());
                let left = Duration::try_from_secs_f64(left as f64 / rate(state));
                let _ = write!(text, "{:#}", HumanDuration(left.unwrap_or_default()));
            });
        bar.set_style(style);
    }
    bar
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
    use super::{TEMPLATE, with_prefix};
    use indicatif::ProgressStyle;

    #[test]
    fn the_template_is_one() {
        assert!(ProgressStyle::with_template(TEMPLATE).is_ok(), "{TEMPLATE}");
    }

    #[test]
    fn large_numbers_are_shortened() {
        let texts = [950.0, 12_345.0, 4.5e6, 2e9].map(with_prefix);
        assert_eq!(texts, ["950", "12.3 k", "4.5 M", "2.0 G"], "the texts");
    }
}
