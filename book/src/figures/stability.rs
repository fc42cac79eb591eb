//! The figures of "When numbers break".

pub(crate) mod leaks;
mod places;
pub(crate) mod stage;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "stability/acne.png", draw: places::acne },
    Figure { file: "stability/floating.png", draw: places::floating },
    Figure { file: "stability/leaks.png", draw: leaks::leaks },
    Figure { file: "stability/leak-numbers.md", draw: leaks::numbers },
    Figure { file: "stability/scales.png", draw: places::scales },
    Figure { file: "stability/scales.md", draw: places::scale_counts },
    Figure { file: "stability/offsets.png", draw: places::offsets },
    Figure { file: "stability/offsets.md", draw: places::offset_counts },
];
