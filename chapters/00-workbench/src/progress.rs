//! The progress bar.

use std::fmt::Write;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

/// What the bar shows; its length is the number of samples.
const TEMPLATE: &str = "{wide_bar} {tiles}, {rays} camera rays/s, {eta} left";

/// A bar on standard error, hidden when that is no terminal or when it is not wanted.
///
/// Tiles are counted once per pass over the film: `tiles` of them.
pub(crate) fn bar(samples: u64, samples_per_pixel: u32, tiles: u64, quiet: bool) -> ProgressBar {
    let target = if quiet {
        ProgressDrawTarget::hidden()
    } else {
        ProgressDrawTarget::stderr()
    };
    let bar = ProgressBar::with_draw_target(Some(samples), target);
    let samples_per_tile = (samples / tiles.max(1)).max(1);
    let style = ProgressStyle::with_template(TEMPLATE).map(|style| {
        style
            .with_key(
                "tiles",
                move |state: &ProgressState, text: &mut dyn Write| {
                    // With several samples a pixel, a tile is done in parts.
                    let done = state.pos() / samples_per_tile;
                    let each = if samples_per_pixel > 1 {
                        format!(" × {samples_per_pixel}")
                    } else {
                        String::new()
                    };
                    let _ = write!(text, "{done}/{tiles} tiles{each}");
                },
            )
            .with_key("rays", |state: &ProgressState, text: &mut dyn Write| {
                let _ = write!(text, "{}", with_prefix(state.per_sec()));
            })
    });
    if let Ok(style) = style {
        bar.set_style(style);
    }
    bar
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
