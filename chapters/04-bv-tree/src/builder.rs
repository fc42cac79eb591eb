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
use crate::joining::{FEW, split_by_joining};
use crate::layout::lay_out;
use crate::node::{Child, Link, Node};
use crate::split::{Builder, Split, split};

/// Below this many primitives a task costs more than it brings.
const PARALLEL: usize = 4096;

/// Behind this many splits ranges are halved by count, so that no tree is deeper than
/// `HALVING_DEPTH` + 32 and the traversal's stack always suffices.
const HALVING_DEPTH: u32 = 31;

/// The most splits on a way to a leaf: 2³² items halve 32 times, mixed leaves split once more.
pub(crate) const MAX_DEPTH: usize = HALVING_DEPTH as usize + 33;

/// A tree before its leaves have been turned into primitives.
pub(crate) struct Topology<V: BoundingVolume> {
    /// The root, or the only leaf.
    pub(crate) root: Link,
    /// Ordered by [`lay_out`].
    pub(crate) nodes: Vec<Node<V>>,
    /// Leaves name ranges of these.
    pub(crate) items: Vec<Item>,
}

/// Builds a tree of `V` over these primitives of `geometry`.
pub(crate) fn build<V: BoundingVolume>(
    geometry: &Geometry,
    mut items: Vec<Item>,
    builder: Builder,
) -> Topology<V> {
    if items.is_empty() {
        return Topology { root: Link::NOTHING, nodes: Vec::new(), items };
    }
    let whole = Part { bounds: bounds(&items), count: items.len(), splits: 0, is_leaf: false };
    // n primitives have at most n − 1 nodes, since each divides some of them.
    let mut slots: Vec<Option<[Child<V>; 4]>> = vec![None; items.len() - 1];
    let task = Task { geometry, builder, joins: builder == Builder::Sah && items.len() <= FEW };
    let mut root = task.child(&whole, Place { item: 0, slot: 0 }, &mut items, &mut slots).link;
    let nodes = lay_out(&mut root, &slots);
    Topology { root, nodes, items }
}

/// Some items that follow each other, and that become one child.
#[derive(Clone, Copy)]
struct Part {
    bounds: Aabb,
    /// How many items.
    count: usize,
    /// How many splits have led to it.
    splits: u32,
    /// Whether it is known not to be split any more.
    is_leaf: bool,
}

/// Where a child belongs.
#[derive(Clone, Copy)]
struct Place {
    /// Index of its first item among all.
    item: u32,
    /// Index of its first slot for a node.
    slot: u32,
}

struct Task<'a> {
    geometry: &'a Geometry,
    builder: Builder,
    /// Whether the surface area heuristic works from below, since there are few primitives in all.
    joins: bool,
}

impl Task<'_> {
    /// Makes the child over `items`, which are the part, and in `slots` all nodes below it.
    fn child<V: BoundingVolume>(
        &self,
        part: &Part,
        place: Place,
        items: &mut [Item],
        slots: &mut [Option<[Child<V>; 4]>],
    ) -> Child<V> {
        let volume = V::enclosing(&part.bounds, items, self.geometry);
        let mut parts = [*part; 4];
        let n = self.divide(&mut parts, items);
        if n == 1 {
            let count = items.len() as i32;
            let count = if self.is_sphere(items.first()) { -count } else { count };
            return Child { volume, link: Link { first: place.item, count } };
        }
        let (own, below) = slots.split_first_mut().expect("a node has a slot");
        let mut children = [Child::NONE; 4];
        let first = Place { slot: place.slot + 1, ..place };
        self.children(&parts[..n], first, items, below, &mut children);
        *own = Some(children);
        Child { volume, link: Link::node(place.slot) }
    }

    /// Makes a child of each part, large ones on all cores.
    fn children<V: BoundingVolume>(
        &self,
        parts: &[Part],
        place: Place,
        items: &mut [Item],
        slots: &mut [Option<[Child<V>; 4]>],
        children: &mut [Child<V>],
    ) {
        let (Some((part, parts)), Some((child, children))) =
            (parts.split_first(), children.split_first_mut())
        else {
            return;
        };
        let parallel = items.len() >= PARALLEL;
        let (items, other_items) = items.split_at_mut(part.count);
        let (slots, other_slots) = slots.split_at_mut(part.count - 1);
        let (item, slot) = (place.item + part.count as u32, place.slot + slots.len() as u32);
        let mut make = || *child = self.child(part, place, items, slots);
        let mut make_others =
            || self.children(parts, Place { item, slot }, other_items, other_slots, children);
        if parallel {
            join(make, make_others);
        } else {
            make();
            make_others();
        }
    }

    // ANCHOR: divide
    /// Divides the first of `parts` into two to four and returns how many there are now; if it
    /// should be a leaf, one.
    ///
    /// A split makes two. As long as there is room, the part with the largest surface, which a ray
    /// most likely enters, is split again.
    fn divide(&self, parts: &mut [Part; 4], items: &mut [Item]) -> usize {
        let mut n = 1;
        while n < 4 {
            let candidates = (0..n).filter(|&i| !parts[i].is_leaf);
            let area = |i: usize| parts[i].bounds.surface_area();
            let Some(i) = candidates.max_by(|&i, &j| area(i).total_cmp(&area(j)).then(j.cmp(&i)))
            else {
                break;
            };
            let Part { bounds, count, splits, .. } = parts[i];
            let first: usize = parts[..i].iter().map(|part| part.count).sum();
            let builder = if splits < HALVING_DEPTH { self.builder } else { Builder::Median };
            match self.split(builder, &bounds, &mut items[first..first + count]) {
                None => parts[i].is_leaf = true,
                Some(Split { left_count, left, right }) => {
                    let part =
                        |bounds, count| Part { bounds, count, splits: splits + 1, is_leaf: false };
                    parts.copy_within(i..3, i + 1);
                    parts[i] = part(left, left_count);
                    parts[i + 1] = part(right, count - left_count);
                    n += 1;
                }
            }
        }
        n
    }
    // ANCHOR_END: divide

    /// Splits as the builder says; a leaf of two kinds of primitives is split by kind.
    fn split(&self, builder: Builder, bounds: &Aabb, items: &mut [Item]) -> Option<Split> {
        let split = match builder {
            Builder::Sah if self.joins => split_by_joining(bounds, items),
            _ => split(builder, bounds, items),
        };
        if split.is_some() {
            return split;
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

#[cfg(test)]
mod tests {
    use ray_casting::Geometry;

    use super::{Part, Task, bounds};
    use crate::bounding_volume::BoundingVolume;
    use crate::item::Item;
    use crate::joining::tests::room;
    use crate::split::Builder;

    /// What a random line that meets the box around `items` pays for them, times the surface of that
    /// box: 1 for each node that it enters, 4 for each leaf.
    fn cost(task: &Task, part: Part, items: &mut [Item]) -> f32 {
        let mut parts = [part; 4];
        let n = task.divide(&mut parts, items);
        let area = part.bounds.surface_area();
        if n == 1 {
            return 4.0 * area;
        }
        let mut rest = items;
        parts[..n].iter().fold(area, |sum, part| {
            let (own, others) = std::mem::take(&mut rest).split_at_mut(part.count);
            rest = others;
            sum + cost(task, *part, own)
        })
    }

    #[test]
    fn in_a_room_joining_makes_a_cheaper_tree_than_bins() {
        let [joined, binned] = [true, false].map(|joins| {
            let (mut items, geometry) = (room(), Geometry::default());
            let task = Task { geometry: &geometry, builder: Builder::Sah, joins };
            let (bounds, count) = (bounds(&items), items.len());
            cost(&task, Part { bounds, count, splits: 0, is_leaf: false }, &mut items)
        });
        assert!(joined < 0.95 * binned, "{joined} joined, {binned} with bins");
    }
}
