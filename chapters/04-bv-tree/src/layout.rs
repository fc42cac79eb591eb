//! Where in memory the nodes of a tree lie.
//!
//! A ray goes down some ten levels and touches one node on each. In the order in which the tree was
//! built, nearly every step lands in another page of memory, and on large scenes waiting for memory
//! is most of the time. Here nodes that follow each other on a likely way down share a page: each
//! page is filled from its top node by always adding the node with the largest area, the one that a
//! ray most likely visits next.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::bounding_volume::BoundingVolume;
use crate::node::{Child, Link, Node};

/// Nodes to a page of 4 KiB, for those with an AABB.
const PAGE: usize = 32;

/// Orders the nodes in `slots` by pages, drops empty slots and renumbers the links.
pub(crate) fn lay_out<V: BoundingVolume>(
    root: &mut Link,
    slots: &[Option<[Child<V>; 4]>],
) -> Vec<Node<V>> {
    let order = page_order(*root, slots);
    let mut place = vec![0; slots.len()];
    for (position, &slot) in order.iter().enumerate() {
        place[slot as usize] = position as u32;
    }
    let renumbered =
        |link: Link| if link.is_inner() { Link::node(place[link.first as usize]) } else { link };
    *root = renumbered(*root);
    let children = order.iter().filter_map(|&slot| slots[slot as usize].as_ref());
    let node = |children: &[Child<V>; 4]| {
        Node::from(&children.map(|child| Child { link: renumbered(child.link), ..child }))
    };
    children.map(node).collect()
}

/// The slots in the order in which they shall lie in memory.
fn page_order<V: BoundingVolume>(root: Link, slots: &[Option<[Child<V>; 4]>]) -> Vec<u32> {
    let mut order = Vec::new();
    let mut tops: Vec<Candidate> = Candidate::below(f32::INFINITY, root).into_iter().collect();
    while let Some(top) = tops.pop() {
        let mut candidates = BinaryHeap::from([top]);
        for _ in 0..PAGE {
            let Some(Candidate { slot, .. }) = candidates.pop() else { break };
            order.push(slot);
            let children = slots[slot as usize].iter().flatten();
            candidates
                .extend(children.filter_map(|c| Candidate::below(c.volume.surface_area(), c.link)));
        }
        tops.extend(candidates.into_sorted_vec());
    }
    order
}

/// A node that could come next, and the area of the volume around it.
#[derive(PartialEq)]
struct Candidate {
    area: f32,
    slot: u32,
}

impl Candidate {
    /// The node that `link` leads to, if it does.
    fn below(area: f32, link: Link) -> Option<Self> {
        link.is_inner().then_some(Self { area, slot: link.first })
    }
}

impl Eq for Candidate {}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Candidate {
    /// By area; of equal ones the first slot is the larger.
    fn cmp(&self, other: &Self) -> Ordering {
        self.area.total_cmp(&other.area).then(other.slot.cmp(&self.slot))
    }
}
