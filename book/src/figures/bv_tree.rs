//! The figures of chapter 4.

mod builders;
mod diagrams;
pub(crate) mod fours;
mod growth;
mod heat;
pub(crate) mod naive;
mod order;
pub(crate) mod plain;
mod probability;
pub(crate) mod rounding;
mod savings;
mod stage;
mod tightness;
mod volumes;
pub(crate) mod workload;

use super::Figure;

pub(super) const FIGURES: &[Figure] = &[
    Figure { file: "04-bv-tree/showpiece.png", draw: stage::showpiece },
    Figure { file: "04-bv-tree/rods.png", draw: stage::rods },
    Figure { file: "04-bv-tree/slabs.svg", draw: diagrams::slabs },
    Figure { file: "04-bv-tree/volumes.svg", draw: diagrams::volumes },
    Figure { file: "04-bv-tree/tree.svg", draw: diagrams::tree },
    Figure { file: "04-bv-tree/city.png", draw: rounding::city },
    Figure { file: "04-bv-tree/lost.md", draw: rounding::lost },
    Figure { file: "04-bv-tree/probability.md", draw: probability::table },
    Figure { file: "04-bv-tree/savings.md", draw: savings::table },
    Figure { file: "04-bv-tree/savings-numbers.md", draw: savings::numbers },
    Figure { file: "04-bv-tree/heat.png", draw: heat::maps },
    Figure { file: "04-bv-tree/heat-numbers.md", draw: heat::numbers },
    Figure { file: "04-bv-tree/order.md", draw: order::table },
    Figure { file: "04-bv-tree/fours.md", draw: fours::table },
    Figure { file: "04-bv-tree/builders.md", draw: builders::table },
    Figure { file: "04-bv-tree/growth.md", draw: growth::table },
    Figure { file: "04-bv-tree/growth.svg", draw: growth::plot },
    Figure { file: "04-bv-tree/growth-search.svg", draw: growth::search_plot },
    Figure { file: "04-bv-tree/tightness.md", draw: tightness::table },
    Figure { file: "04-bv-tree/volumes-tests.md", draw: volumes::tests },
    Figure { file: "04-bv-tree/volumes-slabs.md", draw: volumes::slabs },
    Figure { file: "04-bv-tree/volumes-bytes.md", draw: volumes::bytes },
];
