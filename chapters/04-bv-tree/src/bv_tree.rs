//! The tree of bounding volumes, and how a ray descends it.

use std::hint::black_box;

use glam::Vec3;
use ray_casting::{
    Geometry, Hit, Intersect, Interval, PreparedRay, Ray, Sphere, intersect_sphere, triangle,
};
use workbench::{Counter, Probe};

use crate::aabb::Aabb;
use crate::bounding_volume::BoundingVolume;
use crate::builder::{self, MAX_DEPTH};
use crate::node::{Link, Node, Pair};
use crate::split::Builder;

/// A binary tree whose nodes are enclosed by volumes of the kind `V`.
///
/// It keeps its own copy of the primitives, in the order of its leaves: what is tested together
/// lies together in memory.
pub struct BvTree<'p, V: BoundingVolume, P> {
    root: Option<Node<V>>,
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
        // Items of one leaf are of one kind: counting the kinds apart keeps a leaf's primitives
        // together.
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
        let links = tree.pairs.iter_mut().flat_map(|pair| &mut pair.links);
        for link in links.chain(tree.root.as_mut().map(|root| &mut root.link)) {
            if !link.is_inner() {
                link.first = place[link.first as usize];
            }
        }
        tree
    }

    /// How large the tree has become.
    #[must_use]
    pub fn shape(&self) -> Shape {
        let mut shape = Shape { bytes: self.bytes(), ..Shape::default() };
        let mut waiting: Vec<_> = self.root.iter().map(|root| (root.link, 1)).collect();
        while let Some((link, depth)) = waiting.pop() {
            shape.depth = shape.depth.max(depth);
            if link.is_inner() {
                shape.inner_nodes += 1;
                let Pair { links, .. } = &self.pairs[link.first as usize];
                waiting.extend(links.map(|link| (link, depth + 1)));
            } else {
                shape.leaves += 1;
            }
        }
        shape
    }

    /// The memory that a search reads.
    fn bytes(&self) -> usize {
        size_of_val(&self.pairs[..])
            + size_of_val(&self.triangles[..])
            + size_of_val(&self.triangle_names[..])
            + size_of_val(&self.spheres[..])
            + size_of_val(&self.sphere_names[..])
    }
}

/// The size of a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shape {
    /// Nodes with two children.
    pub inner_nodes: usize,
    /// Nodes with primitives.
    pub leaves: usize,
    /// Nodes on the longest way from the root to a leaf, both included.
    pub depth: usize,
    /// Memory of nodes and primitives, in bytes.
    pub bytes: usize,
}

/// A scene of fewer primitives is searched faster without a tree.
pub const TINY: u32 = 8;

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
        while let Some(link) = next {
            if link.is_inner() {
                tests.volume += 2;
                next = self.descend(link, &query, ray.ray.extent.max, &mut stack);
            } else {
                tests.primitive += u64::from(link.count.unsigned_abs());
                self.intersect_leaf(link, &mut ray, &mut nearest);
                next = stack.pop(ray.ray.extent.max);
            }
        }
        tests.report(self.probe);
        nearest
    }

    /// As above, but any hit will do: the first one ends the search.
    fn occluded(&self, ray: &Ray) -> bool {
        let ray = PreparedRay::new(ray);
        let mut tests = Tests::default();
        let mut stack = Stack::new();
        let (query, mut next) = self.enter(&ray.ray, &mut tests);
        while let Some(link) = next {
            if link.is_inner() {
                tests.volume += 2;
                next = self.descend(link, &query, ray.ray.extent.max, &mut stack);
            } else {
                if self.is_leaf_hit(link, &ray, &mut tests) {
                    tests.report(self.probe);
                    return true;
                }
                next = stack.pop(ray.ray.extent.max);
            }
        }
        tests.report(self.probe);
        false
    }
}

impl<V: BoundingVolume, P: Probe> BvTree<'_, V, P> {
    /// The child that the ray enters first; if it enters both before `max`, the other waits. If it
    /// enters none, whatever waits on top.
    #[inline(always)]
    fn descend(&self, parent: Link, query: &V::Query, max: f32, stack: &mut Stack) -> Option<Link> {
        let Pair { volumes, links: [left, right] } = &self.pairs[parent.first as usize];
        self.look_ahead(*left);
        self.look_ahead(*right);
        let [in_left, in_right] = V::clip_pair(volumes, query);
        match (is_entered(in_left, max), is_entered(in_right, max)) {
            (true, true) if in_left.min <= in_right.min => {
                stack.push(*right, in_right.min);
                Some(*left)
            }
            (true, true) => {
                stack.push(*left, in_left.min);
                Some(*right)
            }
            (true, false) => Some(*left),
            (false, true) => Some(*right),
            (false, false) => stack.pop(max),
        }
    }
}
// ANCHOR_END: traversal

impl<V: BoundingVolume, P: Probe> BvTree<'_, V, P> {
    /// Reads the beginning of what `link` leads to, and does nothing with it.
    ///
    /// In a large tree a step waits for memory longer than it computes. This asks for what the next
    /// step may want while the current one still computes: the processor does not wait for a value
    /// that nobody uses.
    #[inline(always)]
    fn look_ahead(&self, link: Link) {
        let (pair, triangle) = if link.is_inner() { (link.first, 0) } else { (0, link.first) };
        black_box(self.pairs[pair as usize].links[0].first);
        black_box(self.triangles.get(triangle as usize).map(|corners| corners[0].x));
    }
}

impl<V: BoundingVolume, P: Probe> BvTree<'_, V, P> {
    /// The ray as the volumes want it, and the root if the ray enters it.
    ///
    /// A ray of no direction, or with a coordinate that is not a number, meets nothing.
    #[inline(always)]
    fn enter(&self, ray: &Ray, tests: &mut Tests) -> (V::Query, Option<Link>) {
        let query = V::query(ray, self.bounds.reach(ray.origin));
        let traceable =
            ray.origin.is_finite() && ray.direction.is_finite() && ray.direction != Vec3::ZERO;
        let Some(root) = self.root.as_ref().filter(|_| traceable) else { return (query, None) };
        tests.volume += 1;
        let entered = is_entered(root.volume.clip(&query), ray.extent.max);
        (query, entered.then_some(root.link))
    }

    /// Looks for nearer hits among the primitives of a leaf; of equally near ones the one with the
    /// lowest name wins.
    #[inline]
    fn intersect_leaf(&self, leaf: Link, ray: &mut PreparedRay, nearest: &mut Option<Hit>) {
        let range = leaf.range();
        if leaf.count > 0 {
            for (i, corners) in range.clone().zip(&self.triangles[range]) {
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
    fn is_leaf_hit(&self, leaf: Link, ray: &PreparedRay, tests: &mut Tests) -> bool {
        let range = leaf.range();
        let count = |test: &mut Tests| test.primitive += 1;
        if leaf.count > 0 {
            self.triangles[range].iter().any(|corners| {
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
    waiting: [(Link, f32); MAX_DEPTH],
    len: usize,
}

impl Stack {
    const NOTHING: (Link, f32) = (Link::children(0), 0.0);

    #[inline]
    const fn new() -> Self {
        Self { waiting: [Self::NOTHING; MAX_DEPTH], len: 0 }
    }

    #[inline]
    const fn push(&mut self, link: Link, entry: f32) {
        self.waiting[self.len] = (link, entry);
        self.len += 1;
    }

    /// What waits on top, leaving out what the ray enters only behind `max`.
    #[inline(always)]
    fn pop(&mut self, max: f32) -> Option<Link> {
        while self.len > 0 {
            self.len -= 1;
            let (link, entry) = self.waiting[self.len];
            if entry <= max {
                return Some(link);
            }
        }
        None
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
