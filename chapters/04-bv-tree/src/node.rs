//! What a tree is made of.

use std::ops::Range;

use crate::bounding_volume::BoundingVolume;

// ANCHOR: link
/// What lies inside a volume.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Link {
    /// An inner node's pair of children, or the first of a leaf's primitives in its own array.
    pub(crate) first: u32,
    /// 0 for an inner node, n for a leaf of n triangles, −n for a leaf of n spheres.
    ///
    /// A leaf holds primitives of one kind, so that the loop over them has no branch on the kind.
    pub(crate) count: i32,
}
// ANCHOR_END: link

impl Link {
    /// Links to a pair of children.
    pub(crate) const fn children(pair: u32) -> Self {
        Self { first: pair, count: 0 }
    }

    /// Whether it leads to two more nodes.
    #[inline]
    pub(crate) const fn is_inner(self) -> bool {
        self.count == 0
    }

    /// The places of a leaf's primitives in the array of their kind.
    #[inline]
    pub(crate) const fn range(self) -> Range<usize> {
        let first = self.first as usize;
        first..first + self.count.unsigned_abs() as usize
    }
}

/// A node as the builder makes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node<V> {
    /// Encloses everything below.
    pub(crate) volume: V,
    /// What is below.
    pub(crate) link: Link,
}

// ANCHOR: pair
/// Both children of a node as the traversal wants them: they are always tested together, so their
/// volumes are interleaved, and no pair of boxes lies across two cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Pair<V: BoundingVolume> {
    /// The volumes of the left and the right child.
    pub(crate) volumes: V::Pair,
    /// What they hold.
    pub(crate) links: [Link; 2],
}
// ANCHOR_END: pair

#[cfg(test)]
mod tests {
    use super::Pair;
    use crate::aabb::Aabb;

    #[test]
    fn a_node_with_a_box_has_32_bytes_and_a_pair_fills_a_cache_line() {
        assert_eq!(size_of::<Pair<Aabb>>(), 64, "bytes of two nodes");
    }
}
