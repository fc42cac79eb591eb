//! The kinds of volumes, compared: tests, slabs and bytes.

use std::sync::OnceLock;

use bv_tree::Builder;

use super::workload::{Cost, VOLUMES, Volume, Workload, comparison};
use crate::figures::Drawing;
use crate::table::Table;

/// Each scene with what a ray costs in a tree of each volume; all trees give the same answers.
fn costs() -> &'static [(Workload, [Cost; 6])] {
    static COSTS: OnceLock<Vec<(Workload, [Cost; 6])>> = OnceLock::new();
    COSTS.get_or_init(|| {
        let row = |workload: Workload| {
            let costs = VOLUMES.map(|volume| workload.cost(&volume, Builder::Sah));
            for (cost, volume) in costs.iter().zip(&VOLUMES) {
                let same = cost.answers == costs[0].answers;
                assert!(same, "{}: {} finds other hits", workload.name, volume.name);
            }
            (workload, costs)
        };
        comparison(120).into_iter().map(row).collect()
    })
}

fn table(cell: impl Fn(&Workload, &Volume, &Cost) -> String) -> Drawing {
    let names = VOLUMES.iter().map(|volume| volume.name);
    let mut table = Table::new(&["scene"].into_iter().chain(names).collect::<Vec<_>>());
    for (workload, costs) in costs() {
        let cells = costs.iter().zip(&VOLUMES).map(|(cost, volume)| cell(workload, volume, cost));
        table.row([workload.name.to_owned()].into_iter().chain(cells));
    }
    table.into()
}

/// Volume tests and primitive tests a ray.
pub(super) fn tests() -> Drawing {
    table(|_, _, cost| format!("{:.1}\u{a0}+\u{a0}{:.1}", cost.volume, cost.primitive))
}

/// Slabs a ray: what the volume tests come to if each looks at all of its slabs.
pub(super) fn slabs() -> Drawing {
    table(|_, volume, cost| format!("{:.0}", f64::from(volume.slabs) * cost.volume))
}

/// Memory of nodes and primitives for each primitive.
pub(super) fn bytes() -> Drawing {
    table(|workload, _, cost| {
        let each = cost.shape.bytes as f64 / f64::from(workload.geometry.primitives());
        format!("{each:.0}")
    })
}
