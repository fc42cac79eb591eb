//! The figures of chapter 4.

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[];
