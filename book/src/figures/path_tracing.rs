//! The figures of chapter 6.

#[path = "../../../chapters/06-path-tracing/tests/paths/as_printed.rs"]
pub(super) mod as_printed;
mod caustic;
mod depth;
mod policies;
mod printed;
pub(super) mod rooms;
mod roulette;
mod stage;
mod stopping;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "06-path-tracing/cornell-box.png", draw: stage::cornell_box },
    Figure { file: "06-path-tracing/samples.png", draw: stage::samples },
    Figure { file: "06-path-tracing/whitted.png", draw: stage::whitted },
    Figure { file: "06-path-tracing/ends.md", draw: stage::ends },
    Figure { file: "06-path-tracing/caustic.png", draw: caustic::picture },
    Figure { file: "06-path-tracing/caustic-numbers.md", draw: caustic::numbers },
    Figure { file: "06-path-tracing/depths.png", draw: depth::pictures },
    Figure { file: "06-path-tracing/depth-loss.svg", draw: depth::loss },
    Figure { file: "06-path-tracing/depth-loss.md", draw: depth::table },
    Figure { file: "06-path-tracing/roulette-variance.svg", draw: roulette::variance },
    Figure { file: "06-path-tracing/roulette-variance.md", draw: roulette::table },
    Figure { file: "06-path-tracing/policies.md", draw: policies::table },
    Figure { file: "06-path-tracing/growth.svg", draw: printed::growth },
    Figure { file: "06-path-tracing/constant.png", draw: printed::constant },
    Figure { file: "06-path-tracing/lamps.png", draw: printed::lamps },
    Figure { file: "06-path-tracing/printed-numbers.md", draw: printed::numbers },
    Figure { file: "06-path-tracing/errors.md", draw: stopping::errors },
    Figure { file: "06-path-tracing/coverage-numbers.md", draw: stopping::coverage },
];
