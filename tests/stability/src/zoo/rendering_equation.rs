//! Mistakes of chapter 5: densities and the factors of the integrand.

use crate::zoo::mutant::{Mutant, Test};

const PACKAGE: &str = "rendering-equation";
const BRDF: &str = "chapters/05-rendering-equation/src/brdf.rs";
const DIRECTIONS: &str = "chapters/05-rendering-equation/src/directions.rs";
const LOBE: &str = "chapters/05-rendering-equation/src/lobe.rs";
const RADIANCE: &str = "chapters/05-rendering-equation/src/radiance.rs";

/// A furnace with uniform directions: all of f, cos θ and p are in the weight.
const FURNACE: Test =
    Test::of(PACKAGE, "branching", "a_furnace_is_as_bright_with_uniform_directions");

pub(super) const MUTANTS: &[Mutant] = &[
    Mutant {
        name: "the cosine of the rendering equation is forgotten",
        lesson: "f Lᵢ without cos θ is no radiance: a furnace is too bright",
        file: BRDF,
        old: "self.eval(wi) * (self.cos_theta(wi) / pdf_solid_angle)",
        new: "self.eval(wi) * (1.0 / pdf_solid_angle)",
        test: FURNACE,
    },
    Mutant {
        name: "nothing is divided by the density",
        lesson: "a mean of f cos θ is no integral of it",
        file: BRDF,
        old: "self.eval(wi) * (self.cos_theta(wi) / pdf_solid_angle)",
        new: "self.eval(wi) * self.cos_theta(wi)",
        test: FURNACE,
    },
    Mutant {
        name: "π instead of 2π",
        lesson: "the hemisphere has 2π steradians, its projection the area π",
        file: DIRECTIONS,
        old: "if cos_theta > 0.0 { 0.5 * FRAC_1_PI } else { 0.0 }",
        new: "if cos_theta > 0.0 { FRAC_1_PI } else { 0.0 }",
        test: Test::of(
            PACKAGE,
            "surfaces",
            "uniform_directions_of_a_hemisphere_follow_their_density",
        ),
    },
    Mutant {
        name: "directions by the cosine, their density uniform",
        lesson: "a sampler and its density are one thing in two functions",
        file: DIRECTIONS,
        old: "cos_theta.max(0.0) * FRAC_1_PI",
        new: "cos_theta.max(0.0).ceil() * 0.5 * FRAC_1_PI",
        test: Test::of(PACKAGE, "surfaces", "cosine_directions_follow_their_density"),
    },
    Mutant {
        name: "the 1/π of Lambert is missing",
        lesson: "a white wall reflects all light: f = 1/π, because ∫ cos θ dω = π",
        file: "chapters/05-rendering-equation/src/lambert.rs",
        old: "self.albedo * FRAC_1_PI",
        new: "self.albedo",
        test: FURNACE,
    },
    Mutant {
        name: "the sum over N directions is not divided by N",
        lesson: "more directions are a better estimate, not more light",
        file: RADIANCE,
        old: "passed * reflected / n as f32",
        new: "passed * reflected * (n as f32 / n as f32)",
        test: Test::of(PACKAGE, "branching", "more_directions_do_not_change_the_mean"),
    },
    Mutant {
        name: "radiance is not scaled by η²",
        lesson: "glass crowds rays together: in it radiance is n² times as large",
        file: RADIANCE,
        old: "crossing.kt * (crossing.eta * crossing.eta)",
        new: "crossing.kt",
        test: Test::of(PACKAGE, "branching", "light_is_n_squared_times_as_bright_in_glass"),
    },
    Mutant {
        name: "a lamp shines backwards",
        lesson: "only the front of a lamp emits",
        file: "chapters/05-rendering-equation/src/material.rs",
        old: "if emitted == Rgb::ZERO || !surface.is_front() { Rgb::ZERO } else { emitted }",
        new: "if emitted == Rgb::ZERO || surface.is_front() { emitted } else { emitted }",
        test: Test::of(PACKAGE, "branching", "a_lamp_is_dark_from_behind"),
    },
    Mutant {
        name: "light comes through the surface",
        lesson: "below the true surface there is no reflection, whatever an interpolated normal says",
        file: BRDF,
        old: "self.facing.dot(wi) > 0.0 && self.normal.dot(wi) > 0.0",
        new: "self.normal.dot(wi) > 0.0",
        test: Test::of(PACKAGE, "surfaces", "nothing_is_reflected_below_the_surface"),
    },
    Mutant {
        name: "the highlight is not normalised",
        lesson: "without its factor a highlight grows darker the sharper it is",
        file: LOBE,
        old: "self.ks * (self.normalisation * self.power(normal, wo, wi))",
        new: "self.ks * self.power(normal, wo, wi)",
        test: Test::of(PACKAGE, "surfaces", "the_highlight_reflects_its_ks_head_on"),
    },
    Mutant {
        name: "the Jacobian of the half vector is missing",
        lesson: "dωₕ is not dωᵢ: a turned mirror turns its reflection twice as far",
        file: LOBE,
        old: "self.power(normal, wo, wi) / (4.0 * cos)",
        new: "self.power(normal, wo, wi)",
        test: Test::of(PACKAGE, "surfaces", "directions_of_a_broad_highlight_follow_their_density"),
    },
    Mutant {
        name: "the frame around a normal is singular at one pole",
        lesson: "1 + n_z vanishes for a normal along −z",
        file: "chapters/05-rendering-equation/src/frame.rs",
        old: "1.0_f32.copysign(n.z)",
        new: "1.0_f32",
        test: Test::lib(PACKAGE, "every_normal_gets_three_unit_vectors_at_right_angles"),
    },
    Mutant {
        name: "a density per area is taken for one per solid angle",
        lesson: "the same lamp covers a smaller angle from farther away",
        file: "chapters/05-rendering-equation/src/measures.rs",
        old: "pdf_area * distance_squared / cos_theta.abs()",
        new: "pdf_area * (distance_squared / distance_squared) / cos_theta.abs()",
        test: Test::lib(PACKAGE, "a_far_patch_is_denser_in_solid_angle"),
    },
];
