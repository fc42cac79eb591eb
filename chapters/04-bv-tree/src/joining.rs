//! Where to divide a few primitives: found from below, by joining what fits together.

use crate::aabb::Aabb;
use crate::item::Item;
use crate::split::{Split, is_leaf_better};

/// As many primitives at most make a tree from below: each split takes time as the cube of its own.
pub(crate) const FEW: usize = 64;

// ANCHOR: joining
/// Divides `items`, whose box is `whole`, or says that they should be one leaf.
///
/// Each primitive begins as a group of its own. Again and again the two groups are joined whose
/// common box adds least surface to theirs,
///
/// ```text
/// A(a ∪ b) − A(a) − A(b)
/// ```
///
/// until two are left: these are the split. What lies in the other's box, as a lamp in that of the
/// ceiling, or beside it in one plane adds least; a wall and a table add most of a room, so that
/// walls stay alone until all the rest has been joined. After Walter and others \[Walter08], who take
/// A(a ∪ b) alone, which rather joins two small things that are far apart than a small one and a
/// large one that touch.
///
/// Of pairs that add equally much the one with fewer primitives is joined, so that equal boxes make a
/// balanced tree; of those, the first.
pub(crate) fn split_by_joining(whole: &Aabb, items: &mut [Item]) -> Option<Split> {
    if items.len() < 2 {
        return None;
    }
    items.sort_unstable_by_key(|item| item.primitive);
    let mut groups: Vec<Group> = items.iter().map(Group::of).collect();
    while groups.len() > 2 {
        let (i, j) = closest(&groups);
        let other = groups.remove(j);
        groups[i].join(other);
    }
    let [left, right] = groups.as_slice() else { return None };
    for (into, from) in items.iter_mut().zip(left.members.iter().chain(&right.members)) {
        *into = *from;
    }
    let left_count = left.members.len();
    let split = Split { left_count, left: left.bounds, right: right.bounds };
    (!is_leaf_better(whole, &split, items.len())).then_some(split)
}

/// The two groups that fit together best, i < j.
fn closest(groups: &[Group]) -> (usize, usize) {
    let pairs = (1..groups.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let key = |&(i, j): &(usize, usize)| {
        let (a, b) = (&groups[i], &groups[j]);
        let added = surface_area(&a.bounds.union(&b.bounds)) - a.area - b.area;
        (added, a.members.len() + b.members.len())
    };
    let order = |p: &_, q: &_| {
        let ((added_p, n_p), (added_q, n_q)) = (key(p), key(q));
        added_p.total_cmp(&added_q).then(n_p.cmp(&n_q))
    };
    pairs.min_by(order).expect("two groups or more make a pair")
}

/// Some items that have been joined.
struct Group {
    bounds: Aabb,
    area: f64,
    members: Vec<Item>,
}

impl Group {
    fn of(item: &Item) -> Self {
        Self { bounds: item.bounds, area: surface_area(&item.bounds), members: vec![*item] }
    }

    fn join(&mut self, other: Self) {
        self.bounds = self.bounds.union(&other.bounds);
        self.area = surface_area(&self.bounds);
        self.members.extend(other.members);
    }
}

/// In double precision, where no box is so large that its surface would be ∞.
fn surface_area(bounds: &Aabb) -> f64 {
    let side = bounds.max.as_dvec3() - bounds.min.as_dvec3();
    2.0 * (side.x * side.y + side.y * side.z + side.z * side.x)
}
// ANCHOR_END: joining

#[cfg(test)]
pub(crate) mod tests {
    use glam::Vec3;
    use workbench::Sampler;

    use super::{FEW, split_by_joining};
    use crate::aabb::Aabb;
    use crate::builder::bounds;
    use crate::item::Item;
    use crate::split::Split;

    fn items(boxes: &[([f32; 3], [f32; 3])]) -> Vec<Item> {
        let item = |(primitive, &(min, max)): (usize, &([f32; 3], [f32; 3]))| Item {
            bounds: Aabb { min: min.into(), max: max.into() },
            primitive: primitive as u32,
        };
        boxes.iter().enumerate().map(item).collect()
    }

    /// Floor, ceiling, three walls, a lamp below the ceiling, and the faces of two blocks; each is two
    /// triangles with the same box.
    pub(crate) fn room() -> Vec<Item> {
        let mut boxes = vec![
            ([0.0, 0.0, 0.0], [5.0, 0.0, 5.0]),
            ([0.0, 5.0, 0.0], [5.0, 5.0, 5.0]),
            ([0.0, 0.0, 5.0], [5.0, 5.0, 5.0]),
            ([0.0, 0.0, 0.0], [0.0, 5.0, 5.0]),
            ([5.0, 0.0, 0.0], [5.0, 5.0, 5.0]),
            ([2.0, 4.9, 2.0], [3.0, 4.9, 3.0]),
        ];
        for ([x0, y0, z0], [x1, y1, z1]) in
            [([1.0, 0.0, 0.5], [2.0, 1.0, 1.5]), ([3.0, 0.0, 3.0], [4.0, 2.5, 4.0])]
        {
            boxes.extend([
                ([x0, y1, z0], [x1, y1, z1]),
                ([x0, y0, z0], [x0, y1, z1]),
                ([x1, y0, z0], [x1, y1, z1]),
                ([x0, y0, z0], [x1, y1, z0]),
                ([x0, y0, z1], [x1, y1, z1]),
            ]);
        }
        items(&boxes.iter().flat_map(|&face| [face; 2]).collect::<Vec<_>>())
    }

    /// All parts that `items` are divided into, as sorted names.
    fn parts(items: &mut [Item], all: &mut Vec<Vec<u32>>) {
        let mut names: Vec<u32> = items.iter().map(|item| item.primitive).collect();
        names.sort_unstable();
        all.push(names);
        if let Some(Split { left_count, left, right }) = split_by_joining(&bounds(items), items) {
            let (a, b) = items.split_at_mut(left_count);
            assert_eq!([left, right], [bounds(a), bounds(b)], "the boxes of the two parts");
            parts(a, all);
            parts(b, all);
        }
    }

    #[test]
    fn a_lamp_is_joined_with_its_ceiling_and_a_block_with_itself() {
        let mut all = Vec::new();
        parts(&mut room(), &mut all);
        let [ceiling_and_lamp, low, high] =
            [vec![2, 3, 10, 11], (12..22).collect(), (22..32).collect()];
        for expected in [ceiling_and_lamp, low, high] {
            assert!(all.contains(&expected), "{expected:?} is no part of the tree: {all:?}");
        }
    }

    #[test]
    fn equal_boxes_make_a_balanced_tree() {
        let mut equal = items(&[([1.0; 3], [2.0; 3]); FEW]);
        let whole = bounds(&equal);
        let split = split_by_joining(&whole, &mut equal).expect("more than a leaf holds");
        assert_eq!(split.left_count, FEW / 2, "of {FEW} equal boxes");
    }

    /// Whatever their order is to begin with.
    #[test]
    fn two_heaps_are_told_apart() {
        for seed in 0..100 {
            let mut sampler = Sampler::new(23, seed, 0);
            let mut heaps: Vec<Item> = (0..20)
                .map(|primitive: u32| {
                    let [x, y] = sampler.next_2d();
                    let aside = if primitive.is_multiple_of(2) { 0.0 } else { 5.0 };
                    let min = Vec3::new(x + aside, y, sampler.next_1d());
                    Item { bounds: Aabb { min, max: min + 0.1 }, primitive }
                })
                .collect();
            heaps.rotate_left((seed % 20) as usize);
            let split = split_by_joining(&bounds(&heaps), &mut heaps).expect("two parts");
            let is_even = |item: &Item| item.primitive.is_multiple_of(2);
            assert_eq!(split.left_count, 10, "seed {seed}");
            assert!(heaps[..10].iter().all(is_even), "seed {seed}: {:?}", &heaps[..10]);
        }
    }

    #[test]
    fn boxes_as_large_as_numbers_get_are_divided() {
        let far = 3e38;
        let mut huge = items(&[([-far; 3], [far; 3]), ([far; 3], [far; 3]), ([-far; 3], [far; 3])]);
        let whole = bounds(&huge);
        let split = split_by_joining(&whole, &mut huge);
        let counts = split.map(|split| (split.left_count, 3 - split.left_count));
        assert!(counts.is_none_or(|(a, b)| a > 0 && b > 0), "{counts:?}");
    }
}
