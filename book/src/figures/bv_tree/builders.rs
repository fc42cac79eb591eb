//! Where to divide: the median against the surface area heuristic.

use bv_tree::Builder;

use super::workload::{AABB, comparison};
use crate::figures::Drawing;
use crate::table::{Table, count};

/// Tests a ray and the size of the tree, for both builders.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "builder",
        "boxes a ray",
        "primitives a ray",
        "leaves",
        "primitives a leaf",
        "depth",
    ]);
    for workload in comparison(120) {
        let costs = [("median", Builder::Median), ("SAH", Builder::Sah)]
            .map(|(name, builder)| (name, workload.cost(&AABB, builder)));
        assert_eq!(costs[0].1.answers, costs[1].1.answers, "{}: same hits", workload.name);
        for (name, cost) in costs {
            let leaves = cost.shape.leaves;
            let each = f64::from(workload.geometry.primitives()) / leaves as f64;
            table.row([
                workload.name.to_owned(),
                name.to_owned(),
                format!("{:.1}", cost.volume),
                format!("{:.1}", cost.primitive),
                count(leaves as u64),
                format!("{each:.2}"),
                cost.shape.depth.to_string(),
            ]);
        }
    }
    table.into()
}
