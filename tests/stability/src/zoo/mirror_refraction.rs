//! Mistakes of chapter 3: mirrors and glass.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "mirror-refraction";
const FRESNEL: &str = "chapters/03-mirror-refraction/src/fresnel.rs";

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "the ratio of the indices is upside down",
        lesson: "light that enters glass bends toward the normal, not away from it",
        file: FRESNEL,
        old: "(wo.as_dvec3(), normal.as_dvec3(), f64::from(eta))",
        new: "(wo.as_dvec3(), normal.as_dvec3(), 1.0 / f64::from(eta))",
        test: Test::lib(PACKAGE, "a_million_refracted_directions_obey_snell"),
    },
    Mutant {
        name: "no light is totally reflected",
        lesson: "beyond the critical angle there is no refracted ray",
        file: FRESNEL,
        old: "let cos2_theta_t = 1.0 - eta * eta * s.length_squared();",
        new: "let cos2_theta_t = (1.0 - eta * eta * s.length_squared()).max(f64::EPSILON);",
        test: Test::lib(
            PACKAGE,
            "total_internal_reflection_begins_at_the_critical_angle_to_the_last_place",
        ),
    },
    Mutant {
        name: "total reflection loses its light",
        lesson: "where nothing is refracted, all is reflected",
        file: FRESNEL,
        old: "refracted: None, reflectance: 1.0 }",
        new: "refracted: None, reflectance: 0.0 }",
        test: Test::lib(PACKAGE, "grazing_light_is_reflected_as_a_whole"),
    },
    Mutant {
        name: "one polarisation stands for both",
        lesson: "unpolarised light is half of each; at Brewster's angle one of them vanishes",
        file: FRESNEL,
        old: "0.5 * (r_s * r_s + r_p * r_p)",
        new: "r_s * r_s",
        test: Test::lib(PACKAGE, "glass_reflects_as_tables_say"),
    },
    Mutant {
        name: "the cosine of the other side in Fresnel's formula",
        lesson: "each index goes with one of the cosines, s and p swap them",
        file: FRESNEL,
        old: "(cos_theta_i - eta * cos_theta_t) / (cos_theta_i + eta * cos_theta_t)",
        new: "(cos_theta_t - eta * cos_theta_i) / (cos_theta_t + eta * cos_theta_i)",
        test: Test::lib(PACKAGE, "what_is_not_reflected_is_transmitted"),
    },
    Mutant {
        name: "Schlick's formula with the cosine inside the glass",
        lesson: "it is made for the larger of the two angles; with the other it is off by 0.96",
        file: FRESNEL,
        old: "if eta > 1.0 { cos_theta_t } else { cos_theta_i }",
        new: "cos_theta_i + 0.0 * cos_theta_t",
        test: Test::lib(PACKAGE, "schlick_is_off_by_0_0357_and_with_the_inner_cosine_by_0_96"),
    },
    Mutant {
        name: "glass within glass is glass in air",
        lesson: "the medium is the last one entered, not the first",
        file: "chapters/03-mirror-refraction/src/media.rs",
        old: "self.entered[..self.len].last()",
        new: "self.entered[..self.len].first()",
        test: Test::lib(PACKAGE, "the_medium_is_the_last_one_entered_that_has_not_been_left"),
    },
    Mutant {
        name: "the recursion is one level short",
        lesson: "depth D means D events, and the ray after the last of them",
        file: "chapters/03-mirror-refraction/src/limits.rs",
        old: "events <= self.depth",
        new: "events < self.depth",
        test: Test::of(
            PACKAGE,
            "recursion",
            "facing_mirrors_dim_by_a_tenth_each_time_until_the_depth_ends",
        ),
    },
    Mutant {
        name: "leaving glass is entering it",
        lesson: "which side the ray comes from decides which index comes first",
        file: "chapters/03-mirror-refraction/src/boundaries.rs",
        old: "crossing.eta /= crossing.beyond.ior();",
        new: "crossing.eta = crossing.beyond.ior() / crossing.eta;",
        test: Test::of(PACKAGE, "recursion", "a_glass_ball_focuses_where_the_lens_formula_says"),
    },
];
