//! Where in memory the nodes of a tree lie.
//!
//! A ray goes down some twenty levels and touches one pair of children on each. In the order in
//! which the tree was built, nearly every step lands in another page of memory, and on large scenes
//! waiting for memory is most of the time. Here pairs that follow each other on a likely way down
//! share a page: each page is filled from its top pair by always adding the child pair whose parent
//! has the largest area, the one that a ray most likely visits next.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::bounding_volume::BoundingVolume;
use crate::node::{Link, Node, Pair};

/// Pairs to a page of 4 KiB, for nodes with an AABB.
const PAGE: usize = 64;

/// Orders the children in `slots` by pages, drops empty slots and renumbers the links.
pub(crate) fn lay_out<V: BoundingVolume>(
    root: &mut Node<V>,
    slots: &[Option<[Node<V>; 2]>],
) -> Vec<Pair<V>> {
    let order = page_order(root, slots);
    let mut place = vec![0; slots.len()];
    for (position, &slot) in order.iter().enumerate() {
        place[slot as usize] = position as u32;
    }
    let renumbered = |link: Link| {
        if link.is_inner() { Link::children(place[link.first as usize]) } else { link }
    };
    root.link = renumbered(root.link);
    let mut pairs = Vec::with_capacity(order.len());
    for children in order.iter().filter_map(|&slot| slots[slot as usize].as_ref()) {
        let volumes = V::pair(&children[0].volume, &children[1].volume);
        pairs.push(Pair { volumes, links: [0, 1].map(|i| renumbered(children[i].link)) });
    }
    pairs
}

/// The slots in the order in which they shall lie in memory.
fn page_order<V: BoundingVolume>(root: &Node<V>, slots: &[Option<[Node<V>; 2]>]) -> Vec<u32> {
    let mut order = Vec::new();
    let mut tops: Vec<Candidate> = Candidate::below(root).into_iter().collect();
    while let Some(top) = tops.pop() {
        let mut candidates = BinaryHeap::from([top]);
        for _ in 0..PAGE {
            let Some(Candidate { slot, .. }) = candidates.pop() else { break };
            order.push(slot);
            let children = slots[slot as usize].iter().flatten();
            candidates.extend(children.filter_map(Candidate::below));
        }
        tops.extend(candidates.into_sorted_vec());
    }
    order
}

/// A pair that could come next, and the area of its parent.
#[derive(PartialEq)]
struct Candidate {
    area: f32,
    slot: u32,
}

impl Candidate {
    /// The pair of children of an inner node.
    fn below<V: BoundingVolume>(node: &Node<V>) -> Option<Self> {
        let candidate = Self { area: node.volume.surface_area(), slot: node.link.first };
        node.link.is_inner().then_some(candidate)
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
