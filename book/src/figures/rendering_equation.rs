//! The figures of chapter 5.

mod convergence;
mod diagrams;
mod directions;
pub(crate) mod explosion;
mod glass;
mod highlight;
mod measures;
mod mistakes;
mod printed;
mod scenes;
pub(crate) mod stage;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "05-rendering-equation/cornell-box.png", draw: stage::cornell_box },
    Figure { file: "05-rendering-equation/radiance.svg", draw: diagrams::radiance },
    Figure { file: "05-rendering-equation/three-points.svg", draw: diagrams::three_points },
    Figure { file: "05-rendering-equation/lamp-numbers.md", draw: measures::lamp },
    Figure { file: "05-rendering-equation/literally.png", draw: measures::literally },
    Figure { file: "05-rendering-equation/albedo.svg", draw: highlight::curves },
    Figure { file: "05-rendering-equation/albedo-numbers.md", draw: highlight::numbers },
    Figure { file: "05-rendering-equation/highlight.png", draw: highlight::furnace },
    Figure { file: "05-rendering-equation/glass.png", draw: glass::picture },
    Figure { file: "05-rendering-equation/glass-numbers.md", draw: glass::numbers },
    Figure { file: "05-rendering-equation/errors.svg", draw: convergence::errors },
    Figure { file: "05-rendering-equation/slopes.md", draw: convergence::slopes },
    Figure { file: "05-rendering-equation/estimate.md", draw: convergence::printed },
    Figure { file: "05-rendering-equation/directions.svg", draw: directions::densities },
    Figure { file: "05-rendering-equation/frames.svg", draw: directions::frames },
    Figure { file: "05-rendering-equation/ways.md", draw: measures::ways },
    Figure { file: "05-rendering-equation/mixed.png", draw: measures::mixed },
    Figure { file: "05-rendering-equation/densities.png", draw: stage::densities },
    Figure { file: "05-rendering-equation/noise.md", draw: stage::noise },
    Figure { file: "05-rendering-equation/counts.md", draw: explosion::counts },
    Figure { file: "05-rendering-equation/gains.md", draw: explosion::gains },
    Figure { file: "05-rendering-equation/errors-rays.svg", draw: explosion::errors },
    Figure { file: "05-rendering-equation/mistakes.png", draw: mistakes::pictures },
    Figure { file: "05-rendering-equation/mistakes.md", draw: mistakes::table },
    Figure { file: "05-rendering-equation/pole.png", draw: mistakes::pole },
    Figure { file: "05-rendering-equation/printed.png", draw: printed::pictures },
    Figure { file: "05-rendering-equation/growth.md", draw: printed::growth },
];
