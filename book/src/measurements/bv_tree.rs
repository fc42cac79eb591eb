//! What chapter 4 measures: run times of the trees.

use super::Measurement;

pub(super) const MEASUREMENTS: &[Measurement] = &[];
