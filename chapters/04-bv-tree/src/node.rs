//! What a tree is made of.

use std::ops::Range;

use crate::bounding_volume::BoundingVolume;

// ANCHOR: link
/// What lies inside a volume.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Link {
    /// Where it is: a node, a leaf's group of triangles, or the first of a leaf's spheres, each in
    /// the array of its kind.
    pub(crate) first: u32,
    /// How many primitives: n triangles, [`Link::FLAT`] more if they lie in one plane, −n spheres; 0
    /// for nothing, [`Link::INNER`] for a node.
    ///
    /// A leaf holds primitives of one kind, so that the loop over them has no branch on the kind.
    pub(crate) count: i32,
}
// ANCHOR_END: link

impl Link {
    /// The count of a link that leads to a node.
    const INNER: i32 = i32::MAX;

    /// What is added to the count of triangles that lie in one plane: more than a leaf holds.
    pub(crate) const FLAT: i32 = 8;

    /// Leads nowhere.
    pub(crate) const NOTHING: Self = Self { first: 0, count: 0 };

    /// Leads to the node at `place`.
    pub(crate) const fn node(place: u32) -> Self {
        Self { first: place, count: Self::INNER }
    }

    /// Whether it leads to a node.
    #[inline]
    pub(crate) const fn is_inner(self) -> bool {
        self.count == Self::INNER
    }

    /// Whether anything is there.
    #[inline]
    pub(crate) const fn is_something(self) -> bool {
        self.count != 0
    }

    /// How many primitives a leaf holds.
    #[inline]
    pub(crate) const fn primitives(self) -> u32 {
        self.count.unsigned_abs() % Self::FLAT as u32
    }

    /// Whether all primitives of a leaf are triangles that lie in one plane.
    #[inline]
    pub(crate) const fn is_flat(self) -> bool {
        self.count > Self::FLAT
    }

    /// The places of a leaf's primitives, if they lie one by one.
    #[inline]
    pub(crate) const fn range(self) -> Range<usize> {
        let first = self.first as usize;
        first..first + self.primitives() as usize
    }
}

/// One of a node's children, as the builder makes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Child<V> {
    /// Encloses everything below.
    pub(crate) volume: V,
    /// What is below.
    pub(crate) link: Link,
}

impl<V: BoundingVolume> Child<V> {
    /// An empty place.
    pub(crate) const NONE: Self = Self { volume: V::EMPTY, link: Link::NOTHING };
}

// ANCHOR: node
/// A node: its children, of which there are two to four. They are always tested together, so their
/// volumes lie side by side; the boxes of four children and their links fill two cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node<V: BoundingVolume> {
    /// The volumes of the children; a place without a child has one that no ray enters.
    pub(crate) volumes: V::Four,
    /// What they hold.
    pub(crate) links: [Link; 4],
}
// ANCHOR_END: node

impl<V: BoundingVolume> From<&[Child<V>; 4]> for Node<V> {
    fn from(children: &[Child<V>; 4]) -> Self {
        let volumes = V::four(&children.map(|child| child.volume));
        Self { volumes, links: children.map(|child| child.link) }
    }
}

impl<V: BoundingVolume> Node<V> {
    /// The places that have a child.
    pub(crate) fn children(&self) -> impl Iterator<Item = Link> {
        self.links.into_iter().filter(|link| link.is_something())
    }
}

#[cfg(test)]
mod tests {
    use super::Node;
    use crate::aabb::Aabb;

    #[test]
    fn a_child_with_a_box_has_32_bytes_and_four_fill_two_cache_lines() {
        assert_eq!(size_of::<Node<Aabb>>(), 128, "bytes of four children");
    }
}
