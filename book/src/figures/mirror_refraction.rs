//! The figures of chapter 3.

mod closed_forms;
mod counts;
mod curves;
mod diagrams;
mod mistakes;
mod naive;
mod stage;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "03-mirror-refraction/whitted.png", draw: stage::whitted },
    Figure { file: "03-mirror-refraction/depths.png", draw: stage::depths },
    Figure { file: "03-mirror-refraction/nested-glass.png", draw: stage::nested_glass },
    Figure { file: "03-mirror-refraction/touching-glass.png", draw: stage::touching_glass },
    Figure { file: "03-mirror-refraction/glass-slab.png", draw: stage::glass_slab },
    Figure { file: "03-mirror-refraction/two-mirrors.png", draw: stage::two_mirrors },
    Figure { file: "03-mirror-refraction/directions.svg", draw: diagrams::directions },
    Figure { file: "03-mirror-refraction/fresnel-outside.svg", draw: curves::outside },
    Figure { file: "03-mirror-refraction/fresnel-inside.svg", draw: curves::inside },
    Figure { file: "03-mirror-refraction/fresnel-numbers.md", draw: curves::numbers },
    Figure { file: "03-mirror-refraction/flipped.png", draw: mistakes::flipped },
    Figure { file: "03-mirror-refraction/no-total.png", draw: mistakes::no_total_reflection },
    Figure { file: "03-mirror-refraction/shares.png", draw: mistakes::shares },
    Figure { file: "03-mirror-refraction/never-leaves.png", draw: mistakes::never_leaves },
    Figure { file: "03-mirror-refraction/in-the-open.png", draw: mistakes::in_the_open },
    Figure { file: "03-mirror-refraction/mistake-numbers.md", draw: mistakes::numbers },
    Figure { file: "03-mirror-refraction/rays.md", draw: counts::rays },
    Figure { file: "03-mirror-refraction/depths.md", draw: counts::depths },
    Figure { file: "03-mirror-refraction/cutoffs.md", draw: counts::cutoffs },
    Figure { file: "03-mirror-refraction/cutoff-numbers.md", draw: counts::numbers },
    Figure { file: "03-mirror-refraction/closed-forms.md", draw: closed_forms::table },
];
