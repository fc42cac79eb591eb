//! The progress bar: what runs, and how long it will take.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on standard error; its unit is a thousand rays, roughly.
#[derive(Debug)]
pub(crate) struct Bar(ProgressBar);

impl Bar {
    /// A bar for work of this price.
    pub(crate) fn new(price: f64) -> Self {
        let bar = ProgressBar::new(units(price));
        // Without the style there is still a bar.
        if let Ok(style) = ProgressStyle::with_template("{wide_bar} {percent} %, {eta} left\n{msg}")
        {
            bar.set_style(style);
        }
        Self(bar)
    }

    /// What is being done.
    pub(crate) fn say(&self, text: &str) {
        self.0.set_message(text.to_owned());
        self.0.tick();
    }

    /// Work of this price is done.
    pub(crate) fn add(&self, price: f64) {
        self.0.inc(units(price));
    }

    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}

fn units(price: f64) -> u64 {
    (price / 1000.0).ceil() as u64
}
