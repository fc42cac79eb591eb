//! The tree of bounding volumes, and how a ray descends it.

use std::hint::black_box;

use glam::Vec4;
use ray_casting::{
    ExactPoint, Geometry, Hit, Intersect, Ray, ShearedRay, Sphere, intersect_sphere, triangle,
};
use workbench::{Counter, Probe};

use crate::aabb::Aabb;
use crate::bounding_volume::BoundingVolume;
use crate::builder;
use crate::four::pop_bit;
use crate::four_triangles::FourTriangles;
use crate::item::Item;
use crate::node::{Link, Node};
use crate::split::Builder;
use crate::stack::{Stack, Waiting};

/// A tree whose nodes have up to four children, each enclosed by a volume of the kind `V`.
///
/// It keeps its own copy of the primitives, in the order of its leaves: what is tested together
/// lies together in memory.
pub struct BvTree<'p, V: BoundingVolume, P> {
    root: Link,
    nodes: Vec<Node<V>>,
    triangles: Vec<FourTriangles>,
    spheres: Vec<Sphere>,
    sphere_names: Vec<u32>,
    bounds: Aabb,
    probe: &'p P,
}

impl<'p, V: BoundingVolume, P: Probe> BvTree<'p, V, P> {
    /// Builds a tree over all primitives of `geometry`; `probe` counts what its rays test.
    #[must_use]
    pub fn build(geometry: &Geometry, builder: Builder, probe: &'p P) -> Self {
        Self::build_over(geometry, |_| true, builder, probe)
    }

    /// Builds a tree over those primitives alone that `is_in` lets in. They keep their names.
    #[must_use]
    pub fn build_over(
        geometry: &Geometry,
        is_in: impl Fn(u32) -> bool,
        builder: Builder,
        probe: &'p P,
    ) -> Self {
        let mut items = Item::all(geometry);
        items.retain(|item| is_in(item.primitive));
        let topology = builder::build::<V>(geometry, items, builder);
        let mut tree = Self {
            root: topology.root,
            nodes: topology.nodes,
            triangles: Vec::new(),
            spheres: Vec::with_capacity(geometry.spheres.len()),
            sphere_names: Vec::with_capacity(geometry.spheres.len()),
            bounds: builder::bounds(&topology.items),
            probe,
        };
        // Leaves named ranges of items until now: from here on they name their primitives.
        let links = tree.nodes.iter_mut().flat_map(|node| &mut node.links);
        for link in links.chain([&mut tree.root]).filter(|link| !link.is_inner()) {
            let items = &topology.items[link.range()];
            if link.count > 0 {
                link.first = tree.triangles.len() as u32;
                let mut four = FourTriangles::NONE;
                for (i, item) in items.iter().enumerate() {
                    four.set(i, &geometry.corners(item.primitive), item.primitive);
                }
                four.names[items.len()..].fill(items[0].primitive);
                link.count += if four.are_flat(items.len()) { Link::FLAT } else { 0 };
                tree.triangles.push(four);
            } else {
                link.first = tree.spheres.len() as u32;
                let primitives = items.iter().map(|item| item.primitive);
                tree.spheres.extend(primitives.clone().filter_map(|name| geometry.sphere(name)));
                tree.sphere_names.extend(primitives);
            }
        }
        tree
    }

    /// How large the tree has become.
    #[must_use]
    pub fn shape(&self) -> Shape {
        let mut shape = Shape { bytes: self.bytes(), ..Shape::default() };
        let mut waiting = vec![(self.root, 1)];
        while let Some((link, depth)) = waiting.pop() {
            if link.is_inner() {
                shape.inner_nodes += 1;
                let children = self.nodes[link.first as usize].children();
                waiting.extend(children.map(|link| (link, depth + 1)));
            } else if link.is_something() {
                shape.leaves += 1;
            } else {
                continue;
            }
            shape.depth = shape.depth.max(depth);
        }
        shape
    }

    /// The memory that a search reads.
    fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..])
            + size_of_val(&self.triangles[..])
            + size_of_val(&self.spheres[..])
            + size_of_val(&self.sphere_names[..])
    }
}

/// The size of a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shape {
    /// Nodes with children.
    pub inner_nodes: usize,
    /// Nodes with primitives.
    pub leaves: usize,
    /// Nodes on the longest way from the root to a leaf, both included.
    pub depth: usize,
    /// Memory of nodes and primitives, in bytes.
    pub bytes: usize,
}

/// A scene of fewer primitives gets no tree: to search through all of them takes about as long.
pub const TINY: u32 = 8;

// ANCHOR: traversal
impl<V: BoundingVolume, P: Probe> Intersect for BvTree<'_, V, P> {
    /// Descends into the nearest child first and keeps the others for later; with every hit the ray
    /// becomes shorter, and what it then no longer reaches is dropped.
    #[inline(always)]
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = None;
        self.search(ray, &mut nearest);
        nearest
    }

    /// As above, but any hit will do: the first one ends the search.
    fn occluded(&self, ray: &Ray) -> bool {
        if !self.probe.skips(Counter::AnyHitExits) {
            return self.intersect(ray).is_some();
        }
        let mut next = self.enter(ray);
        let query = V::query(ray, self.bounds.reach(ray.origin));
        let ray = ShearedRay::new(ray);
        let mut tests = Tests::default();
        let mut stack = Stack::new();
        let mut is_hit = false;
        while let Some(link) = next {
            if link.is_inner() {
                next = self.descend(link, &query, ray.ray.extent.max, &mut stack, &mut tests);
            } else if self.is_leaf_hit(link, &ray, &mut tests) {
                is_hit = true;
                self.probe.count(Counter::AnyHitExits, u64::from(!stack.is_empty()));
                break;
            } else {
                next = stack.pop(ray.ray.extent.max);
            }
        }
        tests.report(self.probe);
        is_hit
    }
}

impl<V: BoundingVolume, P: Probe> BvTree<'_, V, P> {
    /// Puts the nearest hit, if there is one, into `nearest`, which holds none yet.
    ///
    /// Not returned: it is put together piece by piece, and a result would be copied as a whole. A
    /// processor that reads as a whole what has just been written in pieces waits for the last of them.
    #[inline(never)]
    fn search(&self, ray: &Ray, nearest: &mut Option<Hit>) {
        let mut next = self.enter(ray);
        let query = V::query(ray, self.bounds.reach(ray.origin));
        let mut ray = ShearedRay::new(ray);
        let mut tests = Tests::default();
        let mut stack = Stack::new();
        while let Some(link) = next {
            if link.is_inner() {
                next = self.descend(link, &query, ray.ray.extent.max, &mut stack, &mut tests);
            } else {
                self.intersect_leaf(link, &mut ray, nearest, &mut tests);
                next = stack.pop(ray.ray.extent.max);
            }
        }
        tests.report(self.probe);
    }

    /// The child that the ray enters first; the others that it enters before `max` wait. If it
    /// enters none, whatever waits on top.
    #[inline(always)]
    fn descend(
        &self,
        parent: Link,
        query: &V::Query,
        max: f32,
        stack: &mut Stack,
        tests: &mut Tests,
    ) -> Option<Link> {
        let node = &self.nodes[parent.first as usize];
        if P::ACTIVE {
            tests.volume += node.children().count() as u64;
        }
        let inside = V::clip_four(&node.volumes, query);
        let mut entered = inside.begin_before(max);
        let Some(first) = pop_bit(&mut entered) else { return stack.pop(max) };
        let child = |i: usize| Waiting { link: node.links[i], entry: inside.min[i] };
        let mut near = child(first);
        while let Some(i) = pop_bit(&mut entered) {
            let mut other = child(i);
            if other.entry < near.entry {
                (near, other) = (other, near);
            }
            self.look_ahead(other.link);
            stack.push(other);
        }
        Some(near.link)
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
        let (node, triangles) = if link.is_inner() { (link.first, 0) } else { (0, link.first) };
        black_box(self.nodes[node as usize].links[0].first);
        black_box(self.triangles.get(triangles as usize).map(|four| four.names[0]));
    }

    /// Where the search begins.
    ///
    /// A ray of no direction, or with a coordinate that is not a number, meets nothing.
    #[inline(always)]
    fn enter(&self, ray: &Ray) -> Option<Link> {
        let (o, d) = (ray.origin.extend(0.0), ray.direction.extend(0.0));
        // Zero times a number is zero; times anything else it is NaN.
        let numbers = (0.0 * o + 0.0 * d).cmpeq(Vec4::ZERO).all();
        (numbers && d != Vec4::ZERO).then_some(self.root)
    }

    /// Looks for nearer hits among the primitives of a leaf; of equally near ones the one with the
    /// lowest name wins.
    #[inline(always)]
    fn intersect_leaf(
        &self,
        leaf: Link,
        ray: &mut ShearedRay,
        nearest: &mut Option<Hit>,
        tests: &mut Tests,
    ) {
        if leaf.count > 0 {
            let four = &self.triangles[leaf.first as usize];
            if self.is_own_leaf(leaf, four, &ray.ray) {
                return;
            }
            tests.primitive += u64::from(leaf.primitives());
            let sheared = four.sheared(ray);
            let mut possible = sheared.possible(leaf.primitives());
            while let Some(i) = pop_bit(&mut possible) {
                let vertices = || four.corners(i);
                let decide = || triangle::decide(ray, sheared.corners(i), vertices, four.names[i]);
                if self.is_own(&ray.ray, four.names[i], decide) {
                    continue;
                }
                if let Some(hit) = decide() {
                    let point = || ExactPoint::of_triangle(vertices(), hit.barycentric);
                    self.skip_point_beside(nearest, point);
                    consider(hit, ray, nearest);
                }
            }
        } else {
            tests.primitive += u64::from(leaf.primitives());
            self.intersect_spheres(leaf, ray, nearest);
        }
    }

    /// Out of line, so that a scene of triangles pays nothing for what spheres want to know of a ray.
    #[inline(never)]
    fn intersect_spheres(&self, leaf: Link, ray: &mut ShearedRay, nearest: &mut Option<Hit>) {
        let range = leaf.range();
        for (sphere, &name) in self.spheres[range.clone()].iter().zip(&self.sphere_names[range]) {
            if let Some(hit) = intersect_sphere(sphere, &ray.ray, name) {
                let point = || ExactPoint::of_sphere(sphere, &ray.ray, hit.t);
                self.skip_point_beside(nearest, point);
                consider(hit, ray, nearest);
            }
        }
    }

    /// Whether the ray starts or ends on this triangle. It is flat, and what `decide` would find is
    /// nothing.
    #[inline(always)]
    fn is_own(&self, ray: &Ray, triangle: u32, decide: impl FnOnce() -> Option<Hit>) -> bool {
        let is_own = ray.starts_or_ends_on(triangle);
        if is_own {
            self.probe.skip(Counter::OwnTriangles, decide);
        }
        is_own
    }

    /// Whether the ray starts or ends on a triangle of this leaf, and all of them lie in one plane:
    /// it then starts or ends on that plane, and meets none of them.
    #[inline(always)]
    fn is_own_leaf(&self, leaf: Link, four: &FourTriangles, ray: &Ray) -> bool {
        let is_own =
            (leaf.is_flat() & four.are_ends_of(ray)) && self.probe.skips(Counter::OwnTriangles);
        if is_own {
            self.probe.count(Counter::OwnTriangles, u64::from(leaf.primitives()));
        }
        is_own
    }

    /// Of two hits, the point of one is not needed. Which one will be known later: the work is that
    /// of the hit that has just been found, when there is another one already.
    #[inline(always)]
    fn skip_point_beside(&self, other: &Option<Hit>, point: impl FnOnce() -> ExactPoint) {
        if other.is_some() {
            self.probe.skip(Counter::SurfacePoints, point);
        }
    }

    /// Whether any primitive of the leaf is hit.
    #[inline(always)]
    fn is_leaf_hit(&self, leaf: Link, ray: &ShearedRay, tests: &mut Tests) -> bool {
        if leaf.count > 0 {
            let four = &self.triangles[leaf.first as usize];
            if self.is_own_leaf(leaf, four, &ray.ray) {
                return false;
            }
            tests.primitive += u64::from(leaf.primitives());
            let sheared = four.sheared(ray);
            let mut possible = sheared.possible(leaf.primitives());
            while let Some(i) = pop_bit(&mut possible) {
                let vertices = || four.corners(i);
                let decide = || triangle::decide(ray, sheared.corners(i), vertices, four.names[i]);
                if self.is_own(&ray.ray, four.names[i], decide) {
                    continue;
                }
                if let Some(hit) = decide() {
                    let point = || ExactPoint::of_triangle(vertices(), hit.barycentric);
                    self.probe.skip(Counter::SurfacePoints, point);
                    return true;
                }
            }
            false
        } else {
            self.is_sphere_hit(leaf, &ray.ray, tests)
        }
    }

    #[inline(never)]
    fn is_sphere_hit(&self, leaf: Link, ray: &Ray, tests: &mut Tests) -> bool {
        self.spheres[leaf.range()].iter().any(|sphere| {
            tests.primitive += 1;
            let t = sphere.intersect(ray);
            if let Some(t) = t {
                let point = || ExactPoint::of_sphere(sphere, ray, t);
                self.probe.skip(Counter::SurfacePoints, point);
            }
            t.is_some()
        })
    }
}

/// Takes `hit`, which the ray admits and which is therefore at most as far as the nearest so far.
#[inline]
fn consider(hit: Hit, ray: &mut ShearedRay, nearest: &mut Option<Hit>) {
    if nearest.is_none_or(|n| hit.t < n.t || hit.primitive < n.primitive) {
        *nearest = Some(hit);
        ray.shorten_to(hit.t);
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
