//! The figures of chapter 3.

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[];
