//! What a tree is made of.

/// A volume and what lies inside. With an AABB it has 32 bytes: two of them fill a cache line.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Node<V> {
    /// Encloses everything below.
    pub(crate) volume: V,
    /// An inner node's pair of children, or the first of a leaf's primitives in its own array.
    pub(crate) first: u32,
    /// How many primitives a leaf has.
    pub(crate) count: u16,
    /// What `first` counts.
    pub(crate) content: Content,
}

/// A leaf holds primitives of one kind, so that the loop over them has no branch on the kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Content {
    /// Two more nodes.
    Children,
    /// `count` triangles.
    Triangles,
    /// `count` spheres.
    Spheres,
}

/// Both children of a node, side by side: they are always tested together.
pub(crate) type Pair<V> = [Node<V>; 2];

#[cfg(test)]
mod tests {
    use super::{Node, Pair};
    use crate::aabb::Aabb;

    #[test]
    fn a_node_with_a_box_has_32_bytes_and_a_pair_fills_a_cache_line() {
        let sizes = (size_of::<Node<Aabb>>(), size_of::<Pair<Aabb>>());
        assert_eq!(sizes, (32, 64), "sizes of a node and a pair");
    }
}
