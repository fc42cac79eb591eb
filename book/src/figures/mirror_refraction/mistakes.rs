//! Wrong pictures, each beside the right one.

use workbench::{FilmSettings, Image};

use super::naive::{Mistake, draw};
use super::stage::{PANEL, scene};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::picture::Picture;

const WIDE: FilmSettings = FilmSettings { size: [320, 200], ..PANEL };

fn panels<const N: usize>(name: &str, mistakes: [Mistake; N], settings: &FilmSettings) -> Drawing {
    let scene = scene(name);
    let pictures = mistakes.map(|mistake| Picture::from(&draw(&scene, mistake, settings)));
    Picture::side_by_side(&pictures, 12).into()
}

/// The ratio of the indices upside down.
pub(super) fn flipped() -> Drawing {
    let settings = FilmSettings { size: [300, 200], ..PANEL };
    panels("whitted", [Mistake::FlippedRatio, Mistake::Nothing], &settings)
}

/// Roots of negative numbers in red; lost rays; the right picture.
pub(super) fn no_total_reflection() -> Drawing {
    let mistakes = [Mistake::NoTotalReflection, Mistake::LostTotalReflection, Mistake::Nothing];
    panels("nested-glass", mistakes, &FilmSettings { size: [240, 150], ..PANEL })
}

/// Sums without weights, with the same weights at any angle, and with Fresnel's.
pub(super) fn shares() -> Drawing {
    let mistakes = [Mistake::NoShares, Mistake::ConstantShare, Mistake::Nothing];
    panels("whitted", mistakes, &PANEL)
}

/// The glass goes on behind the pane.
pub(super) fn never_leaves() -> Drawing {
    let settings = FilmSettings { size: [300, 225], ..PANEL };
    panels("glass-slab", [Mistake::NeverLeaves, Mistake::Nothing], &settings)
}

/// Bubble and core as if they lay in the open.
pub(super) fn in_the_open() -> Drawing {
    panels("nested-glass", [Mistake::InTheOpen, Mistake::Nothing], &WIDE)
}

/// How many of the pixels of a picture are marked, and how bright sums get.
pub(super) fn numbers() -> Drawing {
    let settings = FilmSettings { size: [240, 150], ..PANEL };
    let nested = scene("nested-glass");
    let marked = draw(&nested, Mistake::NoTotalReflection, &settings);
    let red = marked.pixels.iter().filter(|pixel| pixel[0] > 1e4).count();
    let share = 100.0 * red as f64 / marked.pixels.len() as f64;

    let whitted = scene("whitted");
    let [summed, right] =
        [Mistake::NoShares, Mistake::Nothing].map(|mistake| draw(&whitted, mistake, &PANEL));
    let brightest = |image: &Image| image.pixels.iter().flatten().copied().fold(0.0, f32::max);

    let mut numbers = Numbers::new();
    numbers.add("nan-percent", format!("{share:.1}"));
    numbers.add("brightest-sum", format!("{:.1}", brightest(&summed)));
    numbers.add("brightest-right", format!("{:.1}", brightest(&right)));
    numbers.into()
}
