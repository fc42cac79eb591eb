//! The figures of chapter 2.

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[];
