//! Mistakes of chapter 4: slabs and trees.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "bv-tree";
const SLAB: &str = "chapters/04-bv-tree/src/slab.rs";
const STACK: &str = "chapters/04-bv-tree/src/stack.rs";
const TREE: &str = "chapters/04-bv-tree/src/bv_tree.rs";

/// Boxes against linear search, bit for bit.
const BOXES: Test = Test::of(PACKAGE, "conformance", "boxes_agree_with_linear_search");

/// Walks from surface to surface, against linear search.
const LEAVING: Test = Test::of(
    PACKAGE,
    "trees",
    "a_ray_that_leaves_a_triangle_meets_what_the_search_through_everything_meets",
);

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "of equally near triangles the last one wins",
        lesson: "without a rule for ties the picture depends on how primitives are searched",
        file: "chapters/01-ray-casting/src/intersect.rs",
        old: "prepared.shorten_below(hit.t);",
        new: "prepared.shorten_to(hit.t);",
        test: BOXES,
    },
    Mutant {
        name: "a ray leaves out the triangle beside its own as well",
        lesson: "only the triangle itself is flat: its neighbours may be met",
        file: "chapters/01-ray-casting/src/ray.rs",
        old: "(triangle == self.origin_primitive)",
        new: "(triangle | 1 == self.origin_primitive | 1)",
        test: LEAVING,
    },
    Mutant {
        name: "every leaf passes for flat",
        lesson: "in a leaf that is not flat, a ray may lead from one triangle to the next",
        file: "chapters/04-bv-tree/src/four_triangles.rs",
        old: "let mut corners = (0..n)",
        new: "let mut corners = (0..n.min(1))",
        test: LEAVING,
    },
    Mutant {
        name: "a needle's plane reaches as far as its roundings",
        lesson: "the less a plane is known, the less may be taken for a part of it",
        file: "chapters/04-bv-tree/src/plane.rs",
        old: "let beside = DOUBLE * n * (way.length() + r);",
        new: "let beside = DOUBLE * (way.length() + r);",
        test: Test::lib(PACKAGE, "what_lies_beside_a_needle_is_never_taken_for_a_part_of_it"),
    },
    Mutant {
        name: "the slab test with min and max",
        lesson: "0·∞ is NaN, min and max drop it, and a ray in a face misses its box",
        file: SLAB,
        old: "let enter = (near - self.origin_near) * self.inverse_near;\n        \
              let leave = (far - self.origin_far) * self.inverse_far;\n        \
              Interval::new(enter, leave)",
        new: "let origin = self.origin_near.midpoint(self.origin_far);\n        \
              let [t0, t1] = [near, far].map(|plane| (plane - origin) * self.inverse_far);\n        \
              Interval::new(t0.min(t1), t0.max(t1))",
        test: Test::of(PACKAGE, "volumes", "a_ray_along_a_slab_is_inside_or_not"),
    },
    Mutant {
        name: "slabs are not widened for the rounding of their ends",
        lesson: "a box that is rounded to be too short is missed at its corners",
        file: SLAB,
        old: "f32::MAX) * (1.0 - gamma(6)),\n            inverse_far: inverse * (1.0 + gamma(6)),",
        new: "f32::MAX),\n            inverse_far: inverse,",
        test: Test::of(PACKAGE, "volumes", "a_slab_contains_the_exact_interval_and_hardly_more"),
    },
    Mutant {
        name: "slabs are not widened by what their primitives may round",
        lesson: "a triangle may be hit a little outside of its own box",
        file: SLAB,
        old: "Vec4::splat(padding) + gamma(2) * origin.abs()",
        new: "Vec4::splat(0.0 * padding) + gamma(2) * origin.abs()",
        test: Test::of(PACKAGE, "volumes", "no_hit_lies_outside_of_a_box"),
    },
    Mutant {
        name: "an infinite reciprocal enters the slab test",
        lesson: "1/0 and 1/1e-39 are both infinite, and only one of them is a ray along the slab",
        file: SLAB,
        old: "smaller(larger(inverse, -f32::MAX), f32::MAX)",
        new: "inverse",
        test: Test::of(
            PACKAGE,
            "volumes",
            "a_direction_without_a_finite_reciprocal_is_entered_in_time",
        ),
    },
    Mutant {
        name: "three slabs together forget what a zero direction is",
        lesson: "−0 leads as little forward as 0, and 1/−0 is −∞: the fast way needs the plain one's care",
        file: SLAB,
        old: "let inverse = 1.0 / (direction + Vec4::ZERO);",
        new: "let inverse = 1.0 / direction;",
        test: Test::lib(PACKAGE, "three_slabs_together_are_three_slabs"),
    },
    Mutant {
        name: "the box of a sphere is rounded to nearest",
        lesson: "c − r rounded up leaves a cap of the sphere outside of its box",
        file: "chapters/04-bv-tree/src/item.rs",
        old: "min: Vec3::from_array(low.map(f32::next_down)),\n                \
              max: Vec3::from_array(high.map(f32::next_up)),",
        new: "min: Vec3::from_array(low),\n                max: Vec3::from_array(high),",
        test: Test::of(PACKAGE, "volumes", "a_sphere_lies_within_its_box"),
    },
    Mutant {
        name: "the tree drops a child",
        lesson: "most rays enter two children; the third is missed in few places of the picture",
        file: TREE,
        old: "while let Some(i) = pop_bit(&mut entered) {",
        new: "if let Some(i) = pop_bit(&mut entered) {",
        test: BOXES,
    },
    Mutant {
        name: "the tree takes whichever of equal hits it finds first",
        lesson: "the order of the search must not show in the picture",
        file: TREE,
        old: "hit.t < n.t || hit.primitive < n.primitive",
        new: "hit.t < n.t",
        test: BOXES,
    },
    Mutant {
        name: "a hit does not shorten the ray",
        lesson: "the first hit that is found need not be the nearest one",
        file: TREE,
        old: "*nearest = Some(hit);\n        ray.shorten_to(hit.t);",
        new: "*nearest = Some(hit);\n        let _ = &ray;",
        test: BOXES,
    },
    Mutant {
        name: "the far child comes first",
        lesson: "the answer stays the same, and the tree tests several times as many volumes",
        file: TREE,
        old: "if other.entry < near.entry {",
        new: "if other.entry > near.entry {",
        test: Test::of(PACKAGE, "trees", "near_children_first_save_tests"),
    },
    Mutant {
        name: "one waiting child that is too far ends the search",
        lesson: "below the far one a nearer one may be waiting",
        file: STACK,
        old: "while self.len > 0 {",
        new: "if self.len > 0 {",
        test: Test::lib(PACKAGE, "what_the_ray_no_longer_reaches_is_left_out"),
    },
    Mutant {
        name: "children behind the hit are visited all the same",
        lesson: "no pixel shows it, only a count: what is behind the hit need not be opened",
        file: STACK,
        old: "if waiting.entry <= max {",
        new: "if waiting.entry <= f32::INFINITY || waiting.entry <= max {",
        test: Test::lib(PACKAGE, "what_the_ray_no_longer_reaches_is_left_out"),
    },
];
