//! Where to divide a range of primitives: at the median, or where a ray would pay least.

use clap::ValueEnum;
use ray_casting::Interval;
use rayon::prelude::{ParallelIterator, ParallelSlice};

use crate::aabb::Aabb;
use crate::bounding_volume::BoundingVolume;
use crate::builder::bounds;
use crate::item::Item;

/// How a tree is divided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Builder {
    /// In halves of equal count, along the axis on which the centres spread most.
    Median,
    /// By the surface area heuristic: over bins, and from below where there are at most 64 primitives.
    #[default]
    Sah,
}

/// Two halves of a range whose items have been put in order.
pub(crate) struct Split {
    /// How many of the items belong to the left half.
    pub(crate) left_count: usize,
    /// The box around them.
    pub(crate) left: Aabb,
    /// The box around the others.
    pub(crate) right: Aabb,
}

impl Split {
    /// Divides `items`, already in order, behind the first `left_count`.
    pub(crate) fn at(left_count: usize, items: &[Item]) -> Self {
        let (left, right) = items.split_at(left_count);
        Self { left_count, left: bounds(left), right: bounds(right) }
    }
}

/// Divides `items`, whose box is `whole`, or says that they should be one leaf.
pub(crate) fn split(builder: Builder, whole: &Aabb, items: &mut [Item]) -> Option<Split> {
    match builder {
        Builder::Median => split_at_median(items),
        Builder::Sah => split_by_area(whole, items),
    }
}

fn split_at_median(items: &mut [Item]) -> Option<Split> {
    if items.len() <= LEAF {
        return None;
    }
    let [x, y, z, _] = spreads(items).map(|spread| spread.max - spread.min);
    let axis = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        let order = a.doubled_center()[axis].total_cmp(&b.doubled_center()[axis]);
        order.then(a.primitive.cmp(&b.primitive))
    });
    Some(Split::at(middle, items))
}

/// By what items are told apart: twice the middle of their box, along axis `i`, and as the fourth
/// mark how large it is, the square root of its surface.
#[inline]
fn mark(item: &Item, i: usize) -> f32 {
    if i < 3 { item.doubled_center()[i] } else { item.bounds.surface_area().sqrt() }
}

/// From the smallest to the largest of each mark.
fn spreads(items: &[Item]) -> [Interval; 4] {
    let none = [Interval::new(f32::INFINITY, f32::NEG_INFINITY); 4];
    let add = |a: Interval, b: Interval| Interval::new(a.min.min(b.min), a.max.max(b.max));
    let add_item = |mut all: [Interval; 4], item: &Item| {
        for (i, all) in all.iter_mut().enumerate() {
            let mark = mark(item, i);
            *all = add(*all, Interval::new(mark, mark));
        }
        all
    };
    if items.len() < PARALLEL {
        return items.iter().fold(none, add_item);
    }
    let chunks = items.par_chunks(PARALLEL).map(|chunk| chunk.iter().fold(none, add_item));
    chunks.reduce(|| none, |a, b| [0, 1, 2, 3].map(|i| add(a[i], b[i])))
}

/// Into how many equal parts the spread of each mark is divided.
const BINS: usize = 32;

/// Items to a task.
const PARALLEL: usize = 1 << 14;

/// The most primitives that a leaf holds: as many triangles as are tested together.
pub(crate) const LEAF: usize = 4;

/// What testing the primitives of a leaf costs beside testing the boxes of a node.
const LEAF_COST: f32 = 4.0;

/// One part of the spread: what lies in it.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Aabb,
    count: u32,
}

type Bins = [[Bin; BINS]; 4];

const NO_BINS: Bins = [[Bin { bounds: Aabb::EMPTY, count: 0 }; BINS]; 4];

// ANCHOR: split_by_area
/// The surface area heuristic \[GoldsmithSalmon87], over bins \[Wald07].
///
/// A line that meets a convex body of area A meets a convex part of area a with probability a / A.
/// A ray that has entered the whole therefore pays on average, in units of one node's box tests,
///
/// ```text
/// 1 + C (a_left g_left + a_right g_right) / A      for a split,
/// C                                                for a leaf
/// ```
///
/// where g = ⌈n/4⌉ is how many leaves n primitives fill at least. Only splits between bins are
/// tried: along all three axes, and between small primitives and large ones. What stands in a room
/// cannot be told from its walls by where it is: the box around one wall and a table is that of the
/// room.
fn split_by_area(whole: &Aabb, items: &mut [Item]) -> Option<Split> {
    let n = items.len();
    if n < 2 {
        return None;
    }
    let binning = Binning::new(spreads(items));
    let bins = binning.fill(items);
    let best = best_border(&bins);
    let Some(border) = best else { return split_at_median(items) };
    if n <= LEAF && is_leaf_cheaper(border.cost, whole) {
        return None;
    }
    let left_count = partition(items, |item| binning.bin(item, border.mark) < border.bin);
    Some(Split { left_count, left: border.left, right: border.right })
}

/// Whether a leaf costs less than a split whose a_left g_left + a_right g_right is `parts`. Areas may
/// overflow: a cost of ∞ / ∞ is no reason for a leaf.
fn is_leaf_cheaper(parts: f32, whole: &Aabb) -> bool {
    1.0 + LEAF_COST * parts / whole.surface_area() >= LEAF_COST
}
// ANCHOR_END: split_by_area

/// Whether all `n` items fit into a leaf that costs less than this split of them.
pub(crate) fn is_leaf_better(whole: &Aabb, split: &Split, n: usize) -> bool {
    let part = |bounds: &Aabb, n: usize| bounds.surface_area() * leaves(n as u32);
    let left = part(&split.left, split.left_count);
    let right = part(&split.right, n - split.left_count);
    n <= LEAF && is_leaf_cheaper(left + right, whole)
}

/// Maps marks to bins.
struct Binning {
    min: [f32; 4],
    scale: [f32; 4],
}

impl Binning {
    /// A mark in which no two items differ has the scale 0: all of them fall into its first bin.
    fn new(spreads: [Interval; 4]) -> Self {
        Self {
            min: spreads.map(|spread| spread.min),
            scale: spreads.map(|spread| {
                let scale = BINS as f32 / (spread.max - spread.min);
                if scale.is_finite() { scale } else { 0.0 }
            }),
        }
    }

    /// The bin of an item by mark `i`.
    #[inline]
    fn bin(&self, item: &Item, i: usize) -> usize {
        (((mark(item, i) - self.min[i]) * self.scale[i]) as usize).min(BINS - 1)
    }

    fn fill(&self, items: &[Item]) -> Bins {
        if items.len() < PARALLEL {
            return self.fill_one(items);
        }
        let chunks = items.par_chunks(PARALLEL).map(|chunk| self.fill_one(chunk));
        chunks.reduce(
            || NO_BINS,
            |mut sum, more| {
                for (into, from) in sum.iter_mut().flatten().zip(more.iter().flatten()) {
                    into.bounds = into.bounds.union(&from.bounds);
                    into.count += from.count;
                }
                sum
            },
        )
    }

    fn fill_one(&self, items: &[Item]) -> Bins {
        let mut bins = NO_BINS;
        for item in items {
            for (i, bins) in bins.iter_mut().enumerate() {
                let bin = &mut bins[self.bin(item, i)];
                bin.bounds = bin.bounds.union(&item.bounds);
                bin.count += 1;
            }
        }
        bins
    }
}

/// A border between two bins.
struct Border {
    /// Of which mark.
    mark: usize,
    /// The first bin on its right.
    bin: usize,
    /// a_left g_left + a_right g_right.
    cost: f32,
    left: Aabb,
    right: Aabb,
}

/// The cheapest border with items on both sides, the first of equally cheap ones.
fn best_border(bins: &Bins) -> Option<Border> {
    let mut best: Option<Border> = None;
    for (mark, bins) in bins.iter().enumerate() {
        let mut right = [(Aabb::EMPTY, 0); BINS];
        let mut sum = (Aabb::EMPTY, 0);
        for (bin, right) in bins.iter().zip(&mut right).rev() {
            sum = (sum.0.union(&bin.bounds), sum.1 + bin.count);
            *right = sum;
        }
        let mut left = (Aabb::EMPTY, 0);
        for bin in 1..BINS {
            left = (left.0.union(&bins[bin - 1].bounds), left.1 + bins[bin - 1].count);
            let right = right[bin];
            if left.1 == 0 || right.1 == 0 {
                continue;
            }
            let cost =
                left.0.surface_area() * leaves(left.1) + right.0.surface_area() * leaves(right.1);
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Border { mark, bin, cost, left: left.0, right: right.0 });
            }
        }
    }
    best
}

/// How many leaves `n` primitives fill at least.
#[inline]
fn leaves(n: u32) -> f32 {
    n.div_ceil(LEAF as u32) as f32
}

/// Moves the items for which `is_left` holds to the front and counts them.
fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> usize {
    let mut left = 0;
    for i in 0..items.len() {
        if is_left(&items[i]) {
            items.swap(i, left);
            left += 1;
        }
    }
    left
}
