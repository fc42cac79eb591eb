//! Mistakes of chapter 7: lamps that are asked, and lamps that are met.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "light-sampling";
const BETWEEN: &str = "chapters/07-light-sampling/src/between.rs";
const FLAT: &str = "chapters/07-light-sampling/src/flat_lamp.rs";
const HEURISTIC: &str = "chapters/07-light-sampling/src/heuristic.rs";
const LIGHTS: &str = "chapters/07-light-sampling/src/lights.rs";
const RADIANCE: &str = "chapters/07-light-sampling/src/radiance.rs";
const SPHERE: &str = "chapters/07-light-sampling/src/sphere_lamp.rs";

/// A lamp with a closed form, by light alone, by chance alone and by both.
const SPHERE_LIGHT: Test =
    Test::of(PACKAGE, "estimators", "a_sphere_light_above_the_horizon_obeys_the_inverse_square");
const FORM_FACTORS: Test =
    Test::of(PACKAGE, "estimators", "flat_lamps_have_the_form_factors_of_the_catalogue");

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "a lamp that is met counts again",
        lesson: "what the shadow ray has brought must not be added once more at the hit",
        file: RADIANCE,
        old: "(Estimator::Light, Some(_)) => 0.0,",
        new: "(Estimator::Light, Some(_)) => 1.0,",
        test: SPHERE_LIGHT,
    },
    Mutant {
        name: "a lamp that is met has no weight",
        lesson: "the weights of both ways add up to 1, or light is made",
        file: RADIANCE,
        old: "self.settings.heuristic.weight(last.pdf_solid_angle, pdf(&last))",
        new: "self.settings.heuristic.weight(last.pdf_solid_angle, 0.0 * pdf(&last))",
        test: SPHERE_LIGHT,
    },
    Mutant {
        name: "the densities of a weight are swapped",
        lesson: "each way is trusted where the other one is better",
        file: RADIANCE,
        old: "self.settings.heuristic.weight(last.pdf_solid_angle, pdf(&last))",
        new: "self.settings.heuristic.weight(pdf(&last), last.pdf_solid_angle)",
        test: SPHERE_LIGHT,
    },
    Mutant {
        name: "every weight trusts the worse way",
        lesson: "swapped on both sides the weights still add up to 1: only a limit shows it",
        file: HEURISTIC,
        old: "let ratio = other / own;",
        new: "let ratio = own / other;",
        test: Test::lib(PACKAGE, "the_weights_of_both_strategies_add_up_to_one"),
    },
    Mutant {
        name: "a point light is weighted",
        lesson: "no path meets a point by chance, so the shadow ray has all of its light",
        file: RADIANCE,
        old: "(true, Estimator::Mis) if !light.is_delta => {",
        new: "(true, Estimator::Mis) => {",
        test: Test::of(PACKAGE, "estimators", "a_matte_floor_is_as_bright_as_in_chapter_2"),
    },
    Mutant {
        name: "a point light without its π",
        lesson: "chapter 2 folds the 1/π of Lambert's law into the intensity",
        file: LIGHTS,
        old: "std::f32::consts::PI * light.intensity",
        new: "light.intensity",
        test: Test::of(PACKAGE, "estimators", "a_matte_floor_is_as_bright_as_in_chapter_2"),
    },
    Mutant {
        name: "the cosine at the receiver is forgotten",
        lesson: "the light of a lamp falls in at an angle, too",
        file: RADIANCE,
        old: "brdf.eval(light.wi) * (brdf.cos_theta(light.wi) / light.pdf_solid_angle)",
        new: "brdf.eval(light.wi) * (1.0 / light.pdf_solid_angle)",
        test: FORM_FACTORS,
    },
    Mutant {
        name: "lamps throw no shadows",
        lesson: "a shadow ray has to be traced",
        file: RADIANCE,
        old: "let visible = is_visible();",
        new: "let visible = true;",
        test: Test::of(PACKAGE, "estimators", "a_black_sphere_takes_a_quarter_of_the_sky"),
    },
    Mutant {
        name: "rays toward the sky leave out the walls",
        lesson: "only between two points of the scene is a wall in nobody's way",
        file: RADIANCE,
        old: "Some(between) if ends && self",
        new: "Some(between) if (ends || true) && self",
        test: Test::of(PACKAGE, "estimators", "a_wall_hides_the_sky_behind_it"),
    },
    Mutant {
        name: "lights outside of the walls are forgotten",
        lesson: "a shadow ray ends at a light: it, too, has to lie within the walls",
        file: BETWEEN,
        old: "corners.chain(points).chain(spheres)",
        new: "corners.chain(points.take(0)).chain(spheres)",
        test: Test::of(PACKAGE, "lamps", "a_wall_with_something_on_either_side_stays"),
    },
    Mutant {
        name: "one lamp of many is left out",
        lesson: "a lamp may stand in the light of another one",
        file: BETWEEN,
        old: "[Light::Flat(_)])",
        new: "[Light::Flat(_), ..])",
        test: Test::of(PACKAGE, "lamps", "walls_and_the_only_lamp_are_left_out_and_nothing_else"),
    },
    Mutant {
        name: "the density of a lamp stays per area",
        lesson: "dω = cos θ'/r² dA: without it far lamps are as bright as near ones",
        file: FLAT,
        old: "measures::pdf_solid_angle(self.pdf_area, distance_squared, cos_theta)",
        new: "measures::pdf_solid_angle(self.pdf_area, 1.0 + 0.0 * distance_squared, 1.0)",
        test: FORM_FACTORS,
    },
    Mutant {
        name: "the tilt of a lamp is forgotten",
        lesson: "a lamp that is seen along its plane covers no angle",
        file: FLAT,
        old: "measures::pdf_solid_angle(self.pdf_area, distance_squared, cos_theta)",
        new: "measures::pdf_solid_angle(self.pdf_area, distance_squared, 1.0)",
        test: FORM_FACTORS,
    },
    Mutant {
        name: "triangles are sampled without the root",
        lesson: "two uniform numbers fill a square evenly, not a triangle",
        file: FLAT,
        old: "let root = u[0].sqrt();",
        new: "let root = u[0];",
        test: Test::of(PACKAGE, "lamps", "triangles_from_near_from_far_and_along_their_edge"),
    },
    Mutant {
        name: "a rounded product tells the back of a lamp",
        lesson: "whoever is just in front of a wide lamp would be left in the dark",
        file: FLAT,
        old: "self.normal.dot(way) < -doubt",
        new: "self.normal.dot(way) <= 0.0 * doubt",
        test: Test::of(PACKAGE, "lamps", "a_viewer_just_in_front_of_a_wide_lamp_is_lit"),
    },
    Mutant {
        name: "the choice of a lamp is not divided by its probability",
        lesson: "one lamp is asked for all: it must count for those that were not",
        file: LIGHTS,
        old: "sample.pdf_solid_angle *= pmf;",
        new: "sample.pdf_solid_angle *= pmf / pmf;",
        test: Test::of(PACKAGE, "estimators", "no_choice_and_no_measure_changes_the_mean"),
    },
    Mutant {
        name: "a lamp without light is chosen",
        lesson: "u = 0 belongs to the first entry that has a weight",
        file: "chapters/07-light-sampling/src/discrete.rs",
        old: "|&sum| sum <= u",
        new: "|&sum| sum < u",
        test: Test::lib(PACKAGE, "an_entry_without_weight_is_never_chosen"),
    },
    Mutant {
        name: "the density of a tiny cone by 1 − cos θ",
        lesson: "1 − cos θ cancels; sin²θ / (1 + cos θ) is the same and does not",
        file: SPHERE,
        old: "sin_max * sin_max / (1.0 + cos_max)",
        new: "1.0 - cos_max",
        test: Test::of(PACKAGE, "lamps", "the_density_of_a_tiny_cone_keeps_its_digits"),
    },
    Mutant {
        name: "sin θ of a tiny cone from cos θ",
        lesson: "a distant lamp collapses to its middle if its sine is √(1 − cos²θ) of a rounded cosine",
        file: SPHERE,
        old: "let (cos, sin) = (1.0 - x, (x * (2.0 - x)).sqrt());",
        new: "let cos = f64::from((1.0 - x) as f32);\n        let sin = (1.0 - cos * cos).sqrt();",
        test: Test::of(PACKAGE, "lamps", "tiny_cones_do_not_collapse"),
    },
    Mutant {
        name: "a lamp shades itself",
        lesson: "a shadow ray ends just before the point that it asks for",
        file: "chapters/01-ray-casting/src/surface_point.rs",
        old: "distance * (1.0 - gamma(8))",
        new: "distance * (1.0 + gamma(8))",
        test: Test::of(PACKAGE, "lamps", "a_lamp_never_stands_in_its_own_light"),
    },
];
