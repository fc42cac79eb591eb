//! Mistakes of chapter 1: hits, and how to leave them.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "ray-casting";
const SPHERE: &str = "chapters/01-ray-casting/src/sphere.rs";
const SURFACE: &str = "chapters/01-ray-casting/src/surface_point.rs";

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "the picture is upside down",
        lesson: "rows are counted from the top, y of the scene grows upwards",
        file: "chapters/01-ray-casting/src/camera.rs",
        old: "(height - 2.0 * point.y) / height",
        new: "(2.0 * point.y - height) / height",
        test: Test::of(
            PACKAGE,
            "scenes",
            "the_corners_of_the_picture_are_where_the_angle_of_view_says",
        ),
    },
    Mutant {
        name: "the sphere's school formula",
        lesson: "b² − ac loses all its digits for a sphere that is small and far away",
        file: SPHERE,
        old: "let d = ray.direction.as_dvec3();",
        new: "if true {\n            return intersect_naive(self, ray);\n        }\n        \
              let d = ray.direction.as_dvec3();",
        test: Test::lib(
            PACKAGE,
            "a_distant_sphere_is_hit_to_the_last_place_and_the_school_formula_is_not",
        ),
    },
    Mutant {
        name: "from inside a sphere only the near root is tried",
        lesson: "the near root lies behind an eye inside the sphere; the far one is what it sees",
        file: SPHERE,
        old: "[near, far].into_iter().find(",
        new: "let _ = far;\n        [near].into_iter().find(",
        test: Test::lib(PACKAGE, "rays_from_inside_and_from_the_surface_find_the_other_side"),
    },
    Mutant {
        name: "an edge belongs to neither triangle",
        lesson: "a closed mesh has holes exactly where its triangles meet",
        file: "chapters/01-ray-casting/src/triangle.rs",
        old: "least * most < 0.0",
        new: "least * most <= 0.0",
        test: Test::of(PACKAGE, "kernels", "no_ray_slips_through_the_diagonal_of_a_square"),
    },
    Mutant {
        name: "rounded edges decide",
        lesson: "single precision calls an edge zero that is not: both sides claim or deny the ray",
        file: "chapters/01-ray-casting/src/triangle.rs",
        old: "double(sheared[2])];\n    let u = c[0] * b[1] - c[1] * b[0];",
        new: "double(sheared[2])];\n    \
              let u = f64::from((c[0] * b[1]) as f32 - (c[1] * b[0]) as f32);",
        test: Test::of(PACKAGE, "kernels", "neither_winding_nor_first_corner_changes_the_answer"),
    },
    Mutant {
        name: "a hit at the near end counts",
        lesson: "a ray that goes on from a hit at t finds the same hit again",
        file: "chapters/01-ray-casting/src/ray.rs",
        old: "self.extent.min < t && t <= self.extent.max",
        new: "self.extent.min <= t && t <= self.extent.max",
        test: Test::lib(PACKAGE, "rays_from_inside_and_from_the_surface_find_the_other_side"),
    },
    Mutant {
        name: "no offset at all",
        lesson: "a rounded point lies on either side of its surface: every second ray meets it again",
        file: SURFACE,
        old: "position + distance.copysign(direction.dot(n)) * n",
        new: "position + 0.0 * distance.copysign(direction.dot(n)) * n",
        test: Test::of(PACKAGE, "kernels", "no_ray_hits_the_sphere_that_it_leaves"),
    },
    Mutant {
        name: "t from 0.001 on instead of an offset",
        lesson: "a constant is too little for a large scene and jumps over the details of a small one",
        file: SURFACE,
        old: "self.ray(self.offset_origin(direction), direction, f32::INFINITY)",
        new: "Ray {\n            extent: Interval::new(0.001, f32::INFINITY),\n            \
              ..Ray::new(self.position, direction)\n        }",
        test: Test::of(PACKAGE, "kernels", "a_ray_does_not_jump_over_what_lies_close_by"),
    },
    Mutant {
        name: "the offset ignores the error of the point",
        lesson: "the step must cover what the point may be off, not only its last place",
        file: SURFACE,
        old: "n.abs().dot(error + gamma(2) * position.abs())",
        new: "n.abs().dot(0.0 * error + gamma(1) * position.abs())",
        test: Test::of(PACKAGE, "kernels", "no_ray_hits_the_sphere_that_it_leaves"),
    },
    Mutant {
        name: "the offset always goes outward",
        lesson: "a refracted ray then starts outside the sphere that it should be in",
        file: SURFACE,
        old: "distance.copysign(direction.dot(n))",
        new: "distance.copysign(direction.dot(n).abs())",
        test: Test::of(PACKAGE, "kernels", "a_ray_that_enters_a_sphere_meets_its_other_side"),
    },
    Mutant {
        name: "the normal of a back face is not flipped",
        lesson: "a wall that is seen from behind is black",
        file: SURFACE,
        old: "if self.is_front() { self.geometric_normal } else { -self.geometric_normal }",
        new: "self.geometric_normal",
        test: Test::of(PACKAGE, "scenes", "without_normals_the_geometric_one_shades"),
    },
    Mutant {
        name: "what lies behind the light throws a shadow",
        lesson: "a shadow ray ends at its light",
        file: SURFACE,
        old: "self.ray(origin, path / distance, distance)",
        new: "self.ray(origin, path / distance, f32::INFINITY)",
        test: Test::of(
            PACKAGE,
            "scenes",
            "a_shadow_is_cast_by_what_lies_before_a_light_and_not_behind",
        ),
    },
];
