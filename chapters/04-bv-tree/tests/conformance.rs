//! Every volume and builder answers like linear search, bit for bit.

use bv_tree::{Aabb, BoundingVolume, Builder, BvTree, KDop, Obb};
use ray_casting::{Geometry, conformance};
use workbench::Unwatched;

fn tree<V: BoundingVolume>(
    builder: Builder,
) -> impl Fn(&Geometry) -> BvTree<'static, V, Unwatched> {
    move |geometry| BvTree::build(geometry, builder, &Unwatched)
}

#[test]
fn boxes_agree_with_linear_search() {
    conformance::check(tree::<Aabb>(Builder::Sah));
    conformance::check(tree::<Aabb>(Builder::Median));
}

#[test]
fn oriented_boxes_agree_with_linear_search() {
    conformance::check(tree::<Obb>(Builder::Sah));
    conformance::check(tree::<Obb>(Builder::Median));
}

#[test]
fn polytopes_agree_with_linear_search() {
    conformance::check(tree::<KDop<3>>(Builder::Sah));
    conformance::check(tree::<KDop<7>>(Builder::Sah));
    conformance::check(tree::<KDop<9>>(Builder::Median));
    conformance::check(tree::<KDop<13>>(Builder::Sah));
}
