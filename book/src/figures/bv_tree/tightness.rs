//! How much empty space a volume encloses, told by the lines that enter it for nothing.

use bv_tree::{Aabb, BoundingVolume, Item, KDop, Obb};
use ray_casting::{Geometry, Ray, ShearedRay};
use workbench::Sampler;

use super::probability::line;
use super::workload::{VOLUMES, rods, scene, terrain};
use crate::figures::Drawing;
use crate::table::Table;

/// Lines in all for one row; each group gets an equal share.
const LINES: usize = 120_000;

/// A part of the primitives, and lines through the ball around it.
struct Group {
    items: Vec<Item>,
    bounds: Aabb,
    lines: Vec<Ray>,
    /// How many of the lines hit any of the primitives.
    hits: usize,
}

/// Halves the items, along the axis on which they spread most, until at most `size` are together.
fn halve(mut items: Vec<Item>, size: usize, groups: &mut Vec<Vec<Item>>) {
    if items.len() <= size {
        groups.push(items);
        return;
    }
    let bounds = around(&items);
    let spread = bounds.max - bounds.min;
    let axis = spread.max_position();
    items.sort_by(|a, b| {
        let order = a.doubled_center()[axis].total_cmp(&b.doubled_center()[axis]);
        order.then(a.primitive.cmp(&b.primitive))
    });
    let right = items.split_off(items.len() / 2);
    halve(items, size, groups);
    halve(right, size, groups);
}

fn around(items: &[Item]) -> Aabb {
    items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds))
}

fn groups(geometry: &Geometry, size: usize) -> Vec<Group> {
    let mut parts = Vec::new();
    halve(Item::all(geometry), size, &mut parts);
    let each = LINES.div_ceil(parts.len()) as u64;
    let group = |(i, items): (u64, Vec<Item>)| {
        let bounds = around(&items);
        let center = bounds.min.midpoint(bounds.max);
        let radius = bounds.max.distance(center);
        let lines: Vec<_> =
            (0..each).map(|k| line(&mut Sampler::new(8, i, k), center, radius)).collect();
        let is_hit = |ray: &&Ray| {
            let ray = ShearedRay::new(ray);
            items.iter().any(|item| geometry.intersect_primitive(&ray, item.primitive).is_some())
        };
        let hits = lines.iter().filter(is_hit).count();
        Group { items, bounds, lines, hits }
    };
    (0..).zip(parts).map(group).collect()
}

/// How many lines enter the volumes around the groups.
fn entered<V: BoundingVolume>(groups: &[Group], geometry: &Geometry) -> usize {
    let of = |group: &Group| {
        let volume = V::enclosing(&group.bounds, &group.items, geometry);
        let enters =
            |ray: &&Ray| !volume.clip(&V::query(ray, group.bounds.reach(ray.origin))).is_empty();
        group.lines.iter().filter(enters).count()
    };
    groups.iter().map(of).sum()
}

/// The share of lines that enter a volume and hit nothing inside.
pub(super) fn table() -> Drawing {
    let names = VOLUMES.iter().map(|volume| volume.name);
    let header = ["scene", "in groups of up to"].into_iter().chain(names).collect::<Vec<_>>();
    let mut table = Table::new(&header);
    for (name, geometry) in [
        ("`whitted-teapot`", scene("whitted-teapot").geometry),
        ("`sphereflake`", scene("sphereflake").geometry),
        ("terrain", terrain(71).geometry),
        ("slanted rods", rods().geometry),
    ] {
        for size in [4, 128] {
            let groups = groups(&geometry, size);
            let hits: usize = groups.iter().map(|group| group.hits).sum();
            let counts = [
                entered::<Aabb>(&groups, &geometry),
                entered::<Obb>(&groups, &geometry),
                entered::<KDop<3>>(&groups, &geometry),
                entered::<KDop<7>>(&groups, &geometry),
                entered::<KDop<9>>(&groups, &geometry),
                entered::<KDop<13>>(&groups, &geometry),
            ];
            let shares =
                counts.map(|n| format!("{:.0}\u{a0}%", 100.0 * (n - hits) as f64 / n as f64));
            table.row([name.to_owned(), size.to_string()].into_iter().chain(shares));
        }
    }
    table.into()
}
