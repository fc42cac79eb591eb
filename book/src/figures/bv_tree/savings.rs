//! What a tree saves.

use std::sync::OnceLock;

use bv_tree::{Builder, TINY};

use super::workload::{AABB, Cost, Workload, scene};
use crate::figures::Drawing;
use crate::numbers::Numbers;
use crate::table::{Table, count};

const SCENES: [(&str, &str); 4] = [
    ("`cornell-box`", "cornell-box"),
    ("`sphereflake`", "sphereflake"),
    ("`teapot`", "teapot"),
    ("`whitted-teapot`", "whitted-teapot"),
];

struct Row {
    workload: Workload,
    linear: Cost,
    tree: Cost,
}

impl Row {
    fn tree_tests(&self) -> f64 {
        self.tree.volume + self.tree.primitive
    }
}

/// Every ray of every scene, asked of both searches; they have to agree.
fn rows() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let row = |(name, file)| {
            let workload = Workload::record(name, scene(file), 60);
            let (linear, tree) = (workload.linear_cost(), workload.cost(&AABB, Builder::Sah));
            assert_eq!(linear.answers, tree.answers, "{name}: both searches find the same hits");
            Row { workload, linear, tree }
        };
        SCENES.map(row).into()
    })
}

/// Tests a ray, by linear search and with a tree.
pub(super) fn table() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "primitives",
        "rays",
        "linear: primitives",
        "tree: boxes",
        "tree: primitives",
        "tests saved",
    ]);
    for row in rows() {
        let saved = 100.0 * (1.0 - row.tree_tests() / row.linear.primitive);
        table.row([
            row.workload.name.to_owned(),
            count(u64::from(row.workload.geometry.primitives())),
            count(row.workload.questions.len() as u64),
            count(row.linear.primitive.round() as u64),
            format!("{:.1}", row.tree.volume),
            format!("{:.1}", row.tree.primitive),
            format!("{saved:.1}\u{a0}%"),
        ]);
    }
    table.into()
}

/// How many tests the showpiece needs, and from how many primitives on there is a tree.
pub(super) fn numbers() -> Drawing {
    let row = rows().last().expect("there are four scenes");
    let mut numbers = Numbers::new();
    numbers.add("primitives", count(u64::from(row.workload.geometry.primitives())));
    numbers.add("linear", count(row.linear.primitive.round() as u64));
    numbers.add("tree", format!("{:.0}", row.tree_tests()));
    numbers.add("tiny", TINY);
    numbers.into()
}
