//! Building a tree from the top: split the primitives in two until few are left.
//!
//! The result is the same for any number of threads: a split depends on the items of its own range
//! alone, ties are broken by primitive index, and the only sums over several threads are of whole
//! numbers, minima and maxima.

use ray_casting::Geometry;
use rayon::join;

use crate::aabb::Aabb;
use crate::bounding_volume::BoundingVolume;
use crate::item::Item;
use crate::layout::lay_out;
use crate::node::{Link, Node, Pair};
use crate::split::{Builder, Split, split};

/// Below this many primitives a task costs more than it brings.
const PARALLEL: usize = 4096;

/// From this depth on ranges are halved by count, so that no tree is deeper than
/// `HALVING_DEPTH` + 32 and the traversal's stack always suffices.
const HALVING_DEPTH: u32 = 31;

/// The deepest that a tree can be: 2³² items halve 32 times, mixed leaves split once more.
pub(crate) const MAX_DEPTH: usize = HALVING_DEPTH as usize + 33;

/// A tree before its leaves have been turned into primitives.
pub(crate) struct Topology<V: BoundingVolume> {
    /// The whole tree; `None` if there is nothing to enclose.
    pub(crate) root: Option<Node<V>>,
    /// Children, ordered by [`lay_out`].
    pub(crate) pairs: Vec<Pair<V>>,
    /// Leaves name ranges of these.
    pub(crate) items: Vec<Item>,
}

/// Builds a tree of `V` over all primitives of `geometry`.
pub(crate) fn build<V: BoundingVolume>(geometry: &Geometry, builder: Builder) -> Topology<V> {
    let mut items = Item::all(geometry);
    if items.is_empty() {
        return Topology { root: None, pairs: Vec::new(), items };
    }
    let bounds = bounds(&items);
    // n primitives have at most n − 1 inner nodes, hence pairs of children.
    let mut slots: Vec<Option<[Node<V>; 2]>> = vec![None; items.len() - 1];
    let task = Task { geometry, builder };
    let mut root =
        task.node(&bounds, Range { first: 0, pair: 0, depth: 0 }, &mut items, &mut slots);
    let pairs = lay_out(&mut root, &slots);
    Topology { root: Some(root), pairs, items }
}

/// Where a part of the tree belongs.
#[derive(Clone, Copy)]
struct Range {
    /// Index of its first item among all.
    first: u32,
    /// Index of its first slot for a pair of children.
    pair: u32,
    depth: u32,
}

struct Task<'a> {
    geometry: &'a Geometry,
    builder: Builder,
}

impl Task<'_> {
    /// Makes the node over `items`, and in `slots` all that is below it.
    fn node<V: BoundingVolume>(
        &self,
        bounds: &Aabb,
        range: Range,
        items: &mut [Item],
        slots: &mut [Option<[Node<V>; 2]>],
    ) -> Node<V> {
        let volume = V::enclosing(bounds, items, self.geometry);
        let builder = if range.depth < HALVING_DEPTH { self.builder } else { Builder::Median };
        let Some(Split { left_count, left, right }) = self.split(builder, bounds, items) else {
            let count = items.len() as i32;
            let count = if self.is_sphere(items.first()) { -count } else { count };
            let link = Link { first: range.first, count };
            return Node { volume, link };
        };

        let (left_items, right_items) = items.split_at_mut(left_count);
        let (own, below) = slots.split_first_mut().expect("an inner node has a slot");
        let (left_slots, right_slots) = below.split_at_mut(left_count - 1);
        let left_range = Range { pair: range.pair + 1, depth: range.depth + 1, ..range };
        let right_range = Range {
            first: range.first + left_count as u32,
            pair: range.pair + left_count as u32,
            depth: range.depth + 1,
        };
        let parallel = left_items.len() + right_items.len() >= PARALLEL;
        let mut build_left = || self.node(&left, left_range, left_items, left_slots);
        let mut build_right = || self.node(&right, right_range, right_items, right_slots);
        let (left, right) =
            if parallel { join(build_left, build_right) } else { (build_left(), build_right()) };
        *own = Some([left, right]);
        Node { volume, link: Link::children(range.pair) }
    }

    /// Splits as the builder says; a leaf of two kinds of primitives is split by kind.
    fn split(&self, builder: Builder, bounds: &Aabb, items: &mut [Item]) -> Option<Split> {
        if let Some(split) = split(builder, bounds, items) {
            return Some(split);
        }
        let triangles = items.iter().filter(|item| !self.is_sphere(Some(item))).count();
        if triangles == 0 || triangles == items.len() {
            return None;
        }
        items.sort_unstable_by_key(|item| item.primitive);
        Some(Split::at(triangles, items))
    }

    fn is_sphere(&self, item: Option<&Item>) -> bool {
        item.is_some_and(|item| self.geometry.sphere(item.primitive).is_some())
    }
}

/// The box around all items.
pub(crate) fn bounds(items: &[Item]) -> Aabb {
    items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds))
}
