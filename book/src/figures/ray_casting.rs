//! The figures of chapter 1.

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[];
