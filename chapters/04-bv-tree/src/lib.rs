//! Chapter 4: do not look at what a ray cannot hit.
//!
//! Brings [`BoundingVolume`] with its three kinds [`Aabb`], [`Obb`] and [`KDop`], and the
//! [`BvTree`] over any of them. Relies on chapter 1 alone; its binary runs the recursion of chapter
//! 3 over the tree.

mod aabb;
mod bounding_volume;
mod builder;
mod bv_tree;
mod four;
mod four_triangles;
mod frames;
mod item;
mod joining;
mod k_dop;
mod layout;
mod node;
mod obb;
mod plane;
mod slab;
mod split;
mod stack;

pub use aabb::{Aabb, AabbQuery, FourBoxes};
pub use bounding_volume::{BoundingVolume, FourIntervals};
pub use bv_tree::{BvTree, Shape, TINY};
pub use item::Item;
pub use k_dop::KDop;
pub use obb::{Obb, ObbQuery};
pub use plane::Plane;
pub use slab::SlabQuery;
pub use split::Builder;
