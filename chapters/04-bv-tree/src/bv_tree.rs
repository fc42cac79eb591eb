//! The tree of bounding volumes, and how a ray descends it.

use glam::Vec3;
use ray_casting::{
    Geometry, Hit, Intersect, Interval, PreparedRay, Ray, Sphere, intersect_sphere, triangle,
};
use workbench::{Counter, Probe};

use crate::aabb::Aabb;
use crate::bounding_volume::BoundingVolume;
use crate::builder::{self, MAX_DEPTH};
use crate::node::{Content, Node, Pair};
use crate::split::Builder;

/// A binary tree whose nodes are enclosed by volumes of the kind `V`.
///
/// It keeps its own copy of the primitives, in the order of its leaves: what is tested together lies
/// together in memory.
pub struct BvTree<'p, V, P> {
    root: Node<V>,
    pairs: Vec<Pair<V>>,
    triangles: Vec<[Vec3; 3]>,
    triangle_names: Vec<u32>,
    spheres: Vec<Sphere>,
    sphere_names: Vec<u32>,
    bounds: Aabb,
    probe: &'p P,
}

impl<'p, V: BoundingVolume, P: Probe> BvTree<'p, V, P> {
    /// Builds a tree over all primitives of `geometry`; `probe` counts what its rays test.
    #[must_use]
    pub fn build(geometry: &Geometry, builder: Builder, probe: &'p P) -> Self {
        let topology = builder::build::<V>(geometry, builder);
        let mut tree = Self {
            root: topology.root,
            pairs: topology.pairs,
            triangles: Vec::with_capacity(geometry.triangles.len()),
            triangle_names: Vec::with_capacity(geometry.triangles.len()),
            spheres: Vec::with_capacity(geometry.spheres.len()),
            sphere_names: Vec::with_capacity(geometry.spheres.len()),
            bounds: builder::bounds(&topology.items),
            probe,
        };
        // Items of one leaf are of one kind: counting the kinds apart keeps a leaf's primitives together.
        let mut place = Vec::with_capacity(topology.items.len());
        for item in &topology.items {
            match geometry.sphere(item.primitive) {
                None => {
                    place.push(tree.triangles.len() as u32);
                    tree.triangles.push(geometry.corners(item.primitive));
                    tree.triangle_names.push(item.primitive);
                }
                Some(&sphere) => {
                    place.push(tree.spheres.len() as u32);
                    tree.spheres.push(sphere);
                    tree.sphere_names.push(item.primitive);
                }
            }
        }
        for node in tree.pairs.iter_mut().flatten().chain([&mut tree.root]) {
            if node.content != Content::Children && node.count > 0 {
                node.first = place[node.first as usize];
            }
        }
        tree
    }

    /// Whether there is nothing in it that a ray could hit.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty() && self.spheres.is_empty()
    }
}

/// A volume is worth entering if the ray is inside it before `max`, the nearest hit so far.
#[inline]
fn is_entered(inside: Interval, max: f32) -> bool {
    inside.min <= inside.max && inside.min <= max
}

// ANCHOR: traversal
impl<V: BoundingVolume, P: Probe> Intersect for BvTree<'_, V, P> {
    /// Descends into the nearer child first and keeps the other for later; with every hit the ray
    /// becomes shorter, and what it then no longer reaches is dropped.
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        let mut ray = PreparedRay::new(ray);
        let mut tests = Tests::default();
        let mut stack = Stack::new();
        let (query, mut next) = self.enter(&ray.ray, &mut tests);
        while let Some(node) = next {
            match node.content {
                Content::Children => {
                    let [left, right] = &self.pairs[node.first as usize];
                    let (in_left, in_right) = (left.volume.clip(&query), right.volume.clip(&query));
                    tests.volume += 2;
                    let max = ray.ray.extent.max;
                    next = match (is_entered(in_left, max), is_entered(in_right, max)) {
                        (true, true) if in_left.min <= in_right.min => {
                            stack.push(2 * node.first + 1, in_right.min);
                            Some(left)
                        }
                        (true, true) => {
                            stack.push(2 * node.first, in_left.min);
                            Some(right)
                        }
                        (true, false) => Some(left),
                        (false, true) => Some(right),
                        (false, false) => self.pop(&mut stack, max),
                    };
                }
                Content::Triangles | Content::Spheres => {
                    tests.primitive += u64::from(node.count);
                    self.intersect_leaf(node, &mut ray, &mut nearest);
                    next = self.pop(&mut stack, ray.ray.extent.max);
                }
            }
        }
        tests.report(self.probe);
        nearest
    }

    /// As above, but any hit will do, so the first one ends the search and no order is better than
    /// another that is not known beforehand: nearer first still finds one sooner.
    fn occluded(&self, ray: &Ray) -> bool {
        let ray = PreparedRay::new(ray);
        let max = ray.ray.extent.max;
        let mut tests = Tests::default();
        let mut stack = Stack::new();
        let (query, mut next) = self.enter(&ray.ray, &mut tests);
        while let Some(node) = next {
            match node.content {
                Content::Children => {
                    let [left, right] = &self.pairs[node.first as usize];
                    let (in_left, in_right) = (left.volume.clip(&query), right.volume.clip(&query));
                    tests.volume += 2;
                    next = match (is_entered(in_left, max), is_entered(in_right, max)) {
                        (true, true) if in_left.min <= in_right.min => {
                            stack.push(2 * node.first + 1, in_right.min);
                            Some(left)
                        }
                        (true, true) => {
                            stack.push(2 * node.first, in_left.min);
                            Some(right)
                        }
                        (true, false) => Some(left),
                        (false, true) => Some(right),
                        (false, false) => self.pop(&mut stack, max),
                    };
                }
                Content::Triangles | Content::Spheres => {
                    if self.is_leaf_hit(node, &ray, &mut tests) {
                        tests.report(self.probe);
                        return true;
                    }
                    next = self.pop(&mut stack, max);
                }
            }
        }
        tests.report(self.probe);
        false
    }
}
// ANCHOR_END: traversal

impl<V: BoundingVolume, P: Probe> BvTree<'_, V, P> {
    /// The ray as the volumes want it, and the root if the ray enters it.
    ///
    /// A ray of no direction, or with a coordinate that is not a number, meets nothing.
    #[inline]
    fn enter(&self, ray: &Ray, tests: &mut Tests) -> (V::Query, Option<&Node<V>>) {
        let query = V::query(ray, self.bounds.reach(ray.origin));
        let traceable =
            ray.origin.is_finite() && ray.direction.is_finite() && ray.direction != Vec3::ZERO;
        if !traceable || self.is_empty() {
            return (query, None);
        }
        tests.volume += 1;
        let entered = is_entered(self.root.volume.clip(&query), ray.extent.max);
        (query, entered.then_some(&self.root))
    }

    /// The node that waits on top of the stack, leaving out those that the ray no longer reaches.
    #[inline]
    fn pop(&self, stack: &mut Stack, max: f32) -> Option<&Node<V>> {
        loop {
            let (index, entry) = stack.pop()?;
            if entry <= max {
                let [left, right] = &self.pairs[index as usize / 2];
                return Some(if index % 2 == 0 { left } else { right });
            }
        }
    }

    /// Looks for nearer hits among the primitives of a leaf; of equally near ones the one with the
    /// lowest name wins.
    #[inline]
    fn intersect_leaf(&self, leaf: &Node<V>, ray: &mut PreparedRay, nearest: &mut Option<Hit>) {
        let range = leaf.first as usize..leaf.first as usize + usize::from(leaf.count);
        if leaf.content == Content::Triangles {
            for (i, &corners) in range.clone().zip(&self.triangles[range]) {
                if let Some(hit) = triangle::intersect(&ray.sheared, corners, i as u32) {
                    consider(Hit { primitive: self.triangle_names[i], ..hit }, ray, nearest);
                }
            }
        } else {
            for (i, sphere) in range.clone().zip(&self.spheres[range]) {
                if let Some(hit) = intersect_sphere(sphere, &ray.ray, self.sphere_names[i]) {
                    consider(hit, ray, nearest);
                }
            }
        }
    }

    /// Whether any primitive of the leaf is hit.
    #[inline]
    fn is_leaf_hit(&self, leaf: &Node<V>, ray: &PreparedRay, tests: &mut Tests) -> bool {
        let range = leaf.first as usize..leaf.first as usize + usize::from(leaf.count);
        let count = |test: &mut Tests| test.primitive += 1;
        if leaf.content == Content::Triangles {
            self.triangles[range].iter().any(|&corners| {
                count(tests);
                triangle::intersect(&ray.sheared, corners, 0).is_some()
            })
        } else {
            self.spheres[range].iter().any(|sphere| {
                count(tests);
                sphere.intersect(&ray.ray).is_some()
            })
        }
    }
}

/// Takes `hit`, which the ray admits and which is therefore at most as far as the nearest so far.
#[inline]
fn consider(hit: Hit, ray: &mut PreparedRay, nearest: &mut Option<Hit>) {
    if nearest.is_none_or(|n| hit.t < n.t || hit.primitive < n.primitive) {
        *nearest = Some(hit);
        ray.shorten_to(hit.t);
    }
}

/// The nodes that wait, and where the ray enters each. At most one a level.
struct Stack {
    waiting: [(u32, f32); MAX_DEPTH],
    len: usize,
}

impl Stack {
    #[inline]
    const fn new() -> Self {
        Self { waiting: [(0, 0.0); MAX_DEPTH], len: 0 }
    }

    #[inline]
    const fn push(&mut self, node: u32, entry: f32) {
        self.waiting[self.len] = (node, entry);
        self.len += 1;
    }

    #[inline]
    const fn pop(&mut self) -> Option<(u32, f32)> {
        if self.len == 0 {
            return None;
        }
        self.len -= 1;
        Some(self.waiting[self.len])
    }
}

/// What one ray has tested. Without a probe nobody reads it, and the compiler drops it.
#[derive(Default)]
struct Tests {
    volume: u64,
    primitive: u64,
}

impl Tests {
    #[inline]
    fn report<P: Probe>(&self, probe: &P) {
        if P::ACTIVE {
            probe.count(Counter::VolumeTests, self.volume);
            probe.count(Counter::PrimitiveTests, self.primitive);
        }
    }
}
