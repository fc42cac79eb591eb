//! What it brings to visit the nearer child first and to drop what lies behind the nearest hit.

use bv_tree::{Aabb, AabbQuery, BoundingVolume, Builder, FourBoxes, FourIntervals, Item};
use ray_casting::{Geometry, Interval, Ray};

use super::workload::{AABB, Volume, Workload, balls, comparison, volume};
use crate::figures::Drawing;
use crate::table::Table;

/// A box that tells whether a ray enters it, and not where: the tree can then neither choose the
/// nearer child nor drop one that lies behind the nearest hit.
#[derive(Clone, Copy)]
struct SilentBox(Aabb);

/// The same yes or no, but always "from the origin on".
const fn silent(inside: Interval) -> Interval {
    if inside.min <= inside.max { Interval::FORWARD } else { Interval::EMPTY }
}

impl BoundingVolume for SilentBox {
    type Query = AabbQuery;
    type Four = FourBoxes;

    const EMPTY: Self = Self(Aabb::EMPTY);

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        Self(*bounds)
    }

    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        Aabb::query(ray, reach)
    }

    fn clip(&self, query: &AabbQuery) -> Interval {
        silent(self.0.clip(query))
    }

    fn four(volumes: &[Self; 4]) -> FourBoxes {
        Aabb::four(&volumes.map(|volume| volume.0))
    }

    fn clip_four(four: &FourBoxes, query: &AabbQuery) -> FourIntervals {
        let FourIntervals { min, max } = Aabb::clip_four(four, query);
        let inside = [0, 1, 2, 3].map(|i| silent(Interval::new(min[i], max[i])));
        FourIntervals { min: inside.map(|i| i.min), max: inside.map(|i| i.max) }
    }

    fn surface_area(&self) -> f32 {
        self.0.surface_area()
    }
}

/// Tests a ray by trees that differ in this alone.
pub(super) fn table() -> Drawing {
    const SILENT: Volume = volume::<SilentBox>("", 3);
    let mut table = Table::new(&[
        "scene",
        "skip only: boxes",
        "primitives",
        "near first, ray cut: boxes",
        "primitives",
    ]);
    let balls = Workload::record("a cube full of balls", balls(), 120);
    for workload in comparison(120).into_iter().chain([balls]) {
        let costs = [SILENT, AABB].map(|volume| workload.cost(&volume, Builder::Sah));
        let [silent, full] = &costs;
        assert_eq!(silent.answers, full.answers, "{}: same hits", workload.name);
        let tests = [silent.volume, silent.primitive, full.volume, full.primitive];
        let tests = tests.map(|tests| format!("{tests:.1}"));
        table.row([workload.name.to_owned()].into_iter().chain(tests));
    }
    table.into()
}
