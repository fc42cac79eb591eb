//! The figures of chapter 1.

mod diagrams;
pub(crate) mod seams;
mod search;
mod spawning;
mod spheres;
mod stage;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "01-ray-casting/whitted.png", draw: stage::whitted },
    Figure { file: "01-ray-casting/shadows.png", draw: stage::shadows },
    Figure { file: "01-ray-casting/samples.png", draw: stage::samples },
    Figure { file: "01-ray-casting/show-facing.png", draw: stage::facing },
    Figure { file: "01-ray-casting/show-depth.png", draw: stage::depth },
    Figure { file: "01-ray-casting/show-normal.png", draw: stage::normal },
    Figure { file: "01-ray-casting/show-primitive.png", draw: stage::primitive },
    Figure { file: "01-ray-casting/show-uv.png", draw: stage::uv },
    Figure { file: "01-ray-casting/camera.svg", draw: diagrams::camera },
    Figure { file: "01-ray-casting/sphere.svg", draw: diagrams::sphere },
    Figure { file: "01-ray-casting/edges.svg", draw: diagrams::edges },
    Figure { file: "01-ray-casting/sphere-ulp.svg", draw: spheres::ulp },
    Figure { file: "01-ray-casting/sphere-numbers.md", draw: spheres::numbers },
    Figure { file: "01-ray-casting/distant-sphere.png", draw: spheres::distant },
    Figure { file: "01-ray-casting/ground.md", draw: spheres::ground_errors },
    Figure { file: "01-ray-casting/ground.png", draw: spheres::ground },
    Figure { file: "01-ray-casting/missed.md", draw: seams::missed },
    Figure { file: "01-ray-casting/seams.png", draw: seams::seams },
    Figure { file: "01-ray-casting/epsilon.png", draw: spawning::epsilon },
    Figure { file: "01-ray-casting/spawn.png", draw: spawning::spawn },
    Figure { file: "01-ray-casting/tests.md", draw: search::tests },
    Figure { file: "01-ray-casting/search-numbers.md", draw: search::numbers },
];
