//! Mistakes of chapter 2: equations 1 to 3.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "blinn-phong";
const REFLECTION: &str = "chapters/02-blinn-phong/src/reflection.rs";

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "the cosine of the light is forgotten",
        lesson: "a slanting beam spreads over more of the surface",
        file: REFLECTION,
        old: "kd * light.strength * normal.dot(light.direction).max(0.0)",
        new: "kd * light.strength * normal.dot(light.direction).max(0.0).ceil()",
        test: Test::lib(PACKAGE, "oblique_light_follows_both_cosines"),
    },
    Mutant {
        name: "light falls off with 1/r",
        lesson: "the same light passes through spheres whose area grows with r²",
        file: REFLECTION,
        old: "light.intensity_toward(point) / r_squared",
        new: "light.intensity_toward(point) / r_squared.sqrt()",
        test: Test::lib(PACKAGE, "a_floor_falls_off_with_the_fifth_power_of_the_slant"),
    },
    Mutant {
        name: "the half vector is not a unit vector",
        lesson: "the sum of two unit vectors has any length from 0 to 2",
        file: REFLECTION,
        old: "(light.direction + wo).normalize_or_zero()",
        new: "(light.direction + wo)",
        test: Test::lib(PACKAGE, "oblique_light_follows_both_cosines"),
    },
    Mutant {
        name: "a light behind the surface makes a highlight",
        lesson: "n·h may be positive where n·l is not",
        file: REFLECTION,
        old: "if normal.dot(light.direction) <= 0.0 || cos_alpha <= 0.0 {",
        new: "if cos_alpha <= 0.0 {",
        test: Test::lib(PACKAGE, "no_highlight_faces_away_from_the_light_or_from_its_half_vector"),
    },
    Mutant {
        name: "the interpolated normal says which side is lit",
        lesson: "only the geometric normal knows on which side of a triangle the light is",
        file: "chapters/02-blinn-phong/src/radiance.rs",
        old: "surface.facing_normal().dot(arriving.direction) <= 0.0",
        new: "self.scene.shading_normal(surface).dot(arriving.direction) <= 0.0",
        test: Test::of(
            PACKAGE,
            "radiance",
            "interpolated_normals_shade_and_geometric_ones_decide_visibility",
        ),
    },
];
