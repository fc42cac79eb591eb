//! What chapter 4 measures: run times of the trees.

use std::hint::black_box;
use std::time::Instant;

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use ray_casting::{Geometry, LinearSearch};
use workbench::Unwatched;

use super::Measurement;
use crate::figures::Drawing;
use crate::figures::bv_tree::fours::{SingleBox, workloads};
use crate::figures::bv_tree::naive::UnpaddedBox;
use crate::figures::bv_tree::plain::PlainTree;
use crate::figures::bv_tree::workload::{
    AABB, Workload, blob, comparison, scene, stopwatch, terrain,
};
use crate::table::{Table, count};

pub(super) const MEASUREMENTS: &[Measurement] = &[
    Measurement { file: "04-bv-tree/linear.md", take: linear },
    Measurement { file: "04-bv-tree/fours.md", take: fours },
    Measurement { file: "04-bv-tree/volumes.md", take: volumes },
    Measurement { file: "04-bv-tree/build.md", take: build },
    Measurement { file: "04-bv-tree/growth.md", take: growth },
];

/// How often each variant runs; a median counts.
const ROUNDS: usize = 9;

/// The medians of the seconds of each piece of work, run in turn, so that what slows the machine
/// down for a while slows all of them.
pub(super) fn alternating(work: &[Box<dyn Fn() -> u64 + '_>]) -> Vec<f64> {
    let mut seconds = vec![Vec::new(); work.len()];
    for _ in 0..ROUNDS {
        for (work, seconds) in work.iter().zip(&mut seconds) {
            let start = Instant::now();
            black_box(work());
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    let median = |mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        seconds[ROUNDS / 2]
    };
    seconds.into_iter().map(median).collect()
}

/// How many times faster a tree is than a linear search, beside how many times fewer it tests.
fn linear() -> Drawing {
    let mut table = Table::new(&["scene", "primitives", "times fewer tests", "times faster"]);
    for name in ["cornell-box", "sphereflake", "teapot", "whitted-teapot"] {
        let workload = Workload::record(name, scene(name), 60);
        let (all, tree) = (workload.linear_cost(), workload.cost(&AABB, Builder::Sah));
        let tree_search = stopwatch::<Aabb>(&workload);
        let seconds = alternating(&[
            Box::new(|| workload.ask(&LinearSearch::new(&workload.geometry, &Unwatched))),
            Box::new(tree_search),
        ]);
        table.row([
            format!("`{name}`"),
            count(u64::from(workload.geometry.primitives())),
            format!("{:.1}", all.primitive / (tree.volume + tree.primitive)),
            format!("{:.1}", seconds[0] / seconds[1]),
        ]);
    }
    table.into()
}

/// Times relative to that of the first.
fn relative(name: &str, seconds: &[f64]) -> Vec<String> {
    let ratios = seconds.iter().map(|s| format!("{:.2}", s / seconds[0]));
    [name.to_owned()].into_iter().chain(ratios).collect()
}

/// The time to ask all rays of a scene, relative to the tree of the chapter. All three trees halve
/// by count and so have the same leaves.
fn fours() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "four children, four at a time",
        "four children, boxes one at a time",
        "two children, all one at a time",
    ]);
    for workload in workloads(240) {
        let geometry = &workload.geometry;
        let four = BvTree::<Aabb, _>::build(geometry, Builder::Median, &Unwatched);
        let single = BvTree::<SingleBox<false>, _>::build(geometry, Builder::Median, &Unwatched);
        let plain = PlainTree::build(geometry, &Unwatched);
        let seconds = alternating(&[
            Box::new(|| workload.ask(&four)),
            Box::new(|| workload.ask(&single)),
            Box::new(|| workload.ask(&plain)),
        ]);
        table.row(relative(workload.name, &seconds));
    }
    table.into()
}

/// The time to ask all rays of a scene, relative to AABB.
fn volumes() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "AABB",
        "OBB",
        "6-DOP",
        "14-DOP",
        "18-DOP",
        "26-DOP",
        "AABB singly",
        "unpadded",
    ]);
    for workload in comparison(240) {
        let seconds = alternating(&[
            Box::new(stopwatch::<Aabb>(&workload)),
            Box::new(stopwatch::<Obb>(&workload)),
            Box::new(stopwatch::<KDop<3>>(&workload)),
            Box::new(stopwatch::<KDop<7>>(&workload)),
            Box::new(stopwatch::<KDop<9>>(&workload)),
            Box::new(stopwatch::<KDop<13>>(&workload)),
            Box::new(stopwatch::<SingleBox<false>>(&workload)),
            Box::new(stopwatch::<UnpaddedBox>(&workload)),
        ]);
        table.row(relative(workload.name, &seconds));
    }
    table.into()
}

/// The time to build each tree, relative to AABB with SAH.
fn build() -> Drawing {
    let mut table = Table::new(&[
        "scene",
        "AABB",
        "AABB, median",
        "OBB",
        "6-DOP",
        "14-DOP",
        "18-DOP",
        "26-DOP",
    ]);
    for workload in comparison(60) {
        let geometry = &workload.geometry;
        let seconds = alternating(&[
            building::<Aabb>(geometry, Builder::Sah),
            building::<Aabb>(geometry, Builder::Median),
            building::<Obb>(geometry, Builder::Sah),
            building::<KDop<3>>(geometry, Builder::Sah),
            building::<KDop<7>>(geometry, Builder::Sah),
            building::<KDop<9>>(geometry, Builder::Sah),
            building::<KDop<13>>(geometry, Builder::Sah),
        ]);
        table.row(relative(workload.name, &seconds));
    }
    table.into()
}

fn building<V: BoundingVolume>(geometry: &Geometry, builder: Builder) -> Box<dyn Fn() -> u64 + '_> {
    Box::new(move || BvTree::<V, _>::build(geometry, builder, &Unwatched).shape().bytes as u64)
}

/// The time a ray and the time to build, relative to those of the smallest mesh.
fn growth() -> Drawing {
    let mut table = Table::new(&["mesh", "triangles", "time a ray", "build time a triangle"]);
    let blobs = [23, 71, 224, 708].map(|n| Workload::record("blob", blob(n), 200));
    let terrains = [22, 71, 224, 707].map(|side| Workload::record("terrain", terrain(side), 200));
    for workloads in [blobs, terrains] {
        let each = |work: Vec<Box<dyn Fn() -> u64 + '_>>, per: fn(&Workload) -> usize| {
            let seconds = alternating(&work);
            let pairs = seconds.iter().zip(&workloads);
            pairs.map(|(seconds, w)| seconds / per(w) as f64).collect::<Vec<_>>()
        };
        let rays = each(
            workloads.iter().map(|w| Box::new(stopwatch::<Aabb>(w)) as Box<_>).collect(),
            |w| w.questions.len(),
        );
        let builds = each(
            workloads.iter().map(|w| building::<Aabb>(&w.geometry, Builder::Sah)).collect(),
            |w| w.geometry.triangles.len(),
        );
        for ((workload, ray), build) in workloads.iter().zip(&rays).zip(&builds) {
            table.row([
                workload.name.to_owned(),
                count(workload.geometry.triangles.len() as u64),
                format!("{:.2}", ray / rays[0]),
                format!("{:.2}", build / builds[0]),
            ]);
        }
    }
    table.into()
}
