//! What it brings to visit the nearer child first and to drop what lies behind the nearest hit.

use bv_tree::{Aabb, AabbPair, AabbQuery, BoundingVolume, Builder, Item};
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
    type Pair = AabbPair;

    fn enclosing(bounds: &Aabb, _: &[Item], _: &Geometry) -> Self {
        Self(*bounds)
    }

    fn query(ray: &Ray, reach: f32) -> AabbQuery {
        Aabb::query(ray, reach)
    }

    fn clip(&self, query: &AabbQuery) -> Interval {
        silent(self.0.clip(query))
    }

    fn pair(left: &Self, right: &Self) -> AabbPair {
        Aabb::pair(&left.0, &right.0)
    }

    fn clip_pair(pair: &AabbPair, query: &AabbQuery) -> [Interval; 2] {
        Aabb::clip_pair(pair, query).map(silent)
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
