//! A tree with two children a node, searched by recursion, one box and one triangle at a time: what
//! one would write first.

use bv_tree::{Aabb, AabbQuery, BoundingVolume, Item};
use ray_casting::{Geometry, Hit, Intersect, Ray, ShearedRay};
use workbench::{Counter, Probe};

/// The most primitives of a leaf, as in the tree of the chapter.
const LEAF: usize = 4;

/// A tree that halves by count.
pub(crate) struct PlainTree<'a, P> {
    geometry: &'a Geometry,
    root: Part,
    bounds: Aabb,
    probe: &'a P,
}

// ANCHOR: part
/// A few primitives, or two parts with a box around each.
enum Part {
    Leaf(Vec<u32>),
    Node(Box<[(Aabb, Self); 2]>),
}
// ANCHOR_END: part

impl<'a, P: Probe> PlainTree<'a, P> {
    /// Builds the tree; `probe` counts what its rays test.
    pub(crate) fn build(geometry: &'a Geometry, probe: &'a P) -> Self {
        let mut items = Item::all(geometry);
        Self { geometry, root: halve(&mut items), bounds: around(&items), probe }
    }

    /// How many leaves there are.
    pub(crate) fn leaves(&self) -> usize {
        fn leaves(part: &Part) -> usize {
            match part {
                Part::Leaf(_) => 1,
                Part::Node(children) => children.iter().map(|(_, child)| leaves(child)).sum(),
            }
        }
        leaves(&self.root)
    }

    // ANCHOR: search
    /// Looks for a nearer hit in `part`, which the ray may meet.
    fn search(
        &self,
        part: &Part,
        query: &AabbQuery,
        ray: &mut ShearedRay,
        nearest: &mut Option<Hit>,
    ) {
        match part {
            Part::Leaf(primitives) => {
                for &primitive in primitives {
                    self.probe.count(Counter::PrimitiveTests, 1);
                    match self.geometry.intersect_primitive(ray, primitive) {
                        Some(hit) if is_better(&hit, nearest) => {
                            *nearest = Some(hit);
                            ray.shorten_to(hit.t);
                        }
                        _ => {}
                    }
                }
            }
            Part::Node(children) => {
                self.probe.count(Counter::VolumeTests, 2);
                let inside = children.each_ref().map(|(volume, _)| volume.clip(query));
                let near = usize::from(inside[1].min < inside[0].min);
                for i in [near, 1 - near] {
                    // What was found in the near child may have made the ray shorter.
                    if inside[i].min <= inside[i].max.min(ray.ray.extent.max) {
                        self.search(&children[i].1, query, ray, nearest);
                    }
                }
            }
        }
    }
    // ANCHOR_END: search

    /// Whether anything in `part` is hit.
    fn any(&self, part: &Part, query: &AabbQuery, ray: &ShearedRay) -> bool {
        match part {
            Part::Leaf(primitives) => primitives.iter().any(|&primitive| {
                self.probe.count(Counter::PrimitiveTests, 1);
                self.geometry.intersect_primitive(ray, primitive).is_some()
            }),
            Part::Node(children) => {
                self.probe.count(Counter::VolumeTests, 2);
                let inside = children.each_ref().map(|(volume, _)| volume.clip(query));
                let near = usize::from(inside[1].min < inside[0].min);
                [near, 1 - near].into_iter().any(|i| {
                    inside[i].min <= inside[i].max.min(ray.ray.extent.max)
                        && self.any(&children[i].1, query, ray)
                })
            }
        }
    }
}

/// Of equally near hits the one with the lowest name wins.
fn is_better(hit: &Hit, nearest: &Option<Hit>) -> bool {
    nearest.is_none_or(|n| hit.t < n.t || hit.primitive < n.primitive)
}

impl<P: Probe> Intersect for PlainTree<'_, P> {
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let query = Aabb::query(ray, self.bounds.reach(ray.origin));
        let mut nearest = None;
        self.search(&self.root, &query, &mut ShearedRay::new(ray), &mut nearest);
        nearest
    }

    fn occluded(&self, ray: &Ray) -> bool {
        let query = Aabb::query(ray, self.bounds.reach(ray.origin));
        self.any(&self.root, &query, &ShearedRay::new(ray))
    }
}

/// The box around all items.
fn around(items: &[Item]) -> Aabb {
    items.iter().fold(Aabb::EMPTY, |all, item| all.union(&item.bounds))
}

/// Half of the items to the left, half to the right, along the axis on which the centres spread most.
fn halve(items: &mut [Item]) -> Part {
    if items.len() <= LEAF {
        return Part::Leaf(items.iter().map(|item| item.primitive).collect());
    }
    let centers: Vec<_> = items.iter().map(Item::doubled_center).collect();
    let Aabb { min, max } = Aabb::around(&centers);
    let axis = (max - min).max_position();
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        let order = a.doubled_center()[axis].total_cmp(&b.doubled_center()[axis]);
        order.then(a.primitive.cmp(&b.primitive))
    });
    let (left, right) = items.split_at_mut(middle);
    Part::Node(Box::new([left, right].map(|half| (around(half), halve(half)))))
}
