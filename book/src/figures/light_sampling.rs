//! The figures of chapter 7.

mod cones;
mod near;
mod needs;
mod plates;
pub(crate) mod stage;
mod tables;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "07-light-sampling/cornell.png", draw: stage::cornell },
    Figure { file: "07-light-sampling/veach-plates.png", draw: stage::veach_plates },
    Figure { file: "07-light-sampling/many-lights.png", draw: stage::many_lights },
    Figure { file: "07-light-sampling/whitted.png", draw: stage::whitted },
    Figure { file: "07-light-sampling/cones.svg", draw: cones::plot },
    Figure { file: "07-light-sampling/floor-lamp.png", draw: near::pictures },
    Figure { file: "07-light-sampling/near.svg", draw: near::plot },
    Figure { file: "07-light-sampling/measures.md", draw: tables::measures },
    Figure { file: "07-light-sampling/choices.md", draw: tables::choices },
    Figure { file: "07-light-sampling/heuristics.md", draw: tables::heuristics },
    Figure { file: "07-light-sampling/plates.md", draw: plates::table },
    Figure { file: "07-light-sampling/errors.md", draw: tables::errors },
    Figure { file: "07-light-sampling/rays.md", draw: tables::rays },
    Figure { file: "07-light-sampling/needs.png", draw: needs::pictures },
    Figure { file: "07-light-sampling/needs-numbers.md", draw: needs::numbers },
];
