//! What it brings to have four children in a node instead of two.

use std::cell::Cell;

use bv_tree::{Aabb, AabbQuery, BoundingVolume, Builder, FourIntervals, Item};
use ray_casting::{Geometry, Interval, Ray};
use workbench::{Counter, Recorder};

use super::plain::PlainTree;
use super::workload::{Volume, Workload, balls, rods, scene, terrain, volume};
use crate::figures::Drawing;
use crate::table::Table;

thread_local! {
    /// How many nodes this thread has visited.
    static NODES: Cell<u64> = const { Cell::new(0) };
}

/// A box that is tested alone, even where four could be tested together; `COUNT` counts the nodes.
#[derive(Clone, Copy)]
pub(crate) struct SingleBox<const COUNT: bool>(Aabb);

impl<const COUNT: bool> BoundingVolume for SingleBox<COUNT> {
    type Query = AabbQuery;
    type Four = [Self; 4];

    const EMPTY: Self = Self(Aabb::EMPTY);

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        Self(*bounds)
    }

    #[inline(always)]
    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        Aabb::query(ray, reach)
    }

    #[inline]
    fn clip(&self, query: &AabbQuery) -> Interval {
        self.0.clip(query)
    }

    fn four(volumes: &[Self; 4]) -> [Self; 4] {
        *volumes
    }

    #[inline]
    fn clip_four(four: &[Self; 4], query: &AabbQuery) -> FourIntervals {
        if COUNT {
            NODES.set(NODES.get() + 1);
        }
        FourIntervals::one_by_one(four, query)
    }

    fn surface_area(&self) -> f32 {
        self.0.surface_area()
    }
}

/// Scenes with one kind of primitives each: there both trees have the same leaves.
pub(crate) fn workloads(width: u32) -> Vec<Workload> {
    vec![
        Workload::record("`cornell-box`", scene("cornell-box"), width),
        Workload::record("`teapot`", scene("teapot"), width),
        Workload::record("terrain", terrain(71), width),
        Workload::record("slanted rods", rods(), width),
        Workload::record("a cube full of balls", balls(), width),
    ]
}

/// Nodes, boxes and primitives a ray, of two trees with the same leaves.
pub(super) fn table() -> Drawing {
    const COUNTED: Volume = volume::<SingleBox<true>>("", 3);
    let mut table = Table::new(&[
        "scene",
        "two: nodes",
        "boxes",
        "primitives",
        "four: nodes",
        "boxes",
        "primitives",
    ]);
    for workload in workloads(120) {
        let recorder = Recorder::new();
        let plain = PlainTree::build(&workload.geometry, &recorder);
        let answers = workload.ask(&plain);
        NODES.set(0);
        let four = workload.cost(&COUNTED, Builder::Median);
        let nodes = NODES.get();
        assert_eq!(answers, four.answers, "{}: same hits", workload.name);
        assert_eq!(plain.leaves(), four.shape.leaves, "{}: same leaves", workload.name);
        let each = |count: u64| count as f64 / workload.questions.len() as f64;
        let boxes = recorder.get(Counter::VolumeTests);
        let costs = [
            each(boxes / 2),
            each(boxes),
            each(recorder.get(Counter::PrimitiveTests)),
            each(nodes),
            four.volume,
            four.primitive,
        ];
        let cells = costs.map(|cost| format!("{cost:.1}"));
        table.row([workload.name.to_owned()].into_iter().chain(cells));
    }
    table.into()
}
