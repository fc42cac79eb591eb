//! The figures of chapter 2.

mod diagrams;
mod halfway;
mod lamps;
mod normals;
mod skipped;
mod stage;
mod still_life;
mod sunset;
mod textures;
mod values;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "02-blinn-phong/teapot.png", draw: stage::teapot },
    Figure { file: "02-blinn-phong/term-ambient.png", draw: stage::ambient },
    Figure { file: "02-blinn-phong/term-diffuse.png", draw: stage::diffuse_term },
    Figure { file: "02-blinn-phong/term-specular.png", draw: stage::specular_term },
    Figure { file: "02-blinn-phong/term-numbers.md", draw: stage::numbers },
    Figure { file: "02-blinn-phong/shadows.png", draw: stage::shadows },
    Figure { file: "02-blinn-phong/beam.svg", draw: diagrams::beam },
    Figure { file: "02-blinn-phong/halfway.svg", draw: diagrams::halfway },
    Figure { file: "02-blinn-phong/values.md", draw: values::by_hand },
    Figure { file: "02-blinn-phong/power.md", draw: values::power },
    Figure { file: "02-blinn-phong/lobes.svg", draw: values::lobes },
    Figure { file: "02-blinn-phong/lobe-sums.md", draw: values::lobe_sums },
    Figure { file: "02-blinn-phong/exponents.png", draw: halfway::exponents },
    Figure { file: "02-blinn-phong/halfway.png", draw: halfway::halfway },
    Figure { file: "02-blinn-phong/sunset.png", draw: sunset::sunset },
    Figure { file: "02-blinn-phong/normals.png", draw: normals::normals },
    Figure { file: "02-blinn-phong/rim.png", draw: normals::rim },
    Figure { file: "02-blinn-phong/card.png", draw: normals::card },
    Figure { file: "02-blinn-phong/texture-codes.png", draw: textures::codes },
    Figure { file: "02-blinn-phong/whitted.png", draw: textures::whitted },
    Figure { file: "02-blinn-phong/cornell-box.png", draw: lamps::cornell_box },
    Figure { file: "02-blinn-phong/lamps.png", draw: lamps::lamps },
    Figure { file: "02-blinn-phong/skipped.md", draw: skipped::skipped },
    Figure { file: "02-blinn-phong/skipped-numbers.md", draw: skipped::numbers },
];
