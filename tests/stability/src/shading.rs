//! Blinn-Phong: BP1 to BP12.

use ray_casting::math;

use crate::bits::{self, ulp};
use crate::trial::Trial;

crate::catalogue! {
    BP1 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        the_three_terms_head_on_are_a_tenth_a_half_and_a_half;
    BP2 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        no_highlight_faces_away_from_the_light_or_from_its_half_vector;
    BP3 random/1 a_power_of_a_cosine_is_right_to_the_last_place_for_every_exponent;
    BP4 elsewhere "chapters/02-blinn-phong/src/reflection.rs" extreme_exponents_keep_their_accuracy;
    BP5 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        no_highlight_faces_away_from_the_light_or_from_its_half_vector;
    BP6 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        no_highlight_faces_away_from_the_light_or_from_its_half_vector;
    BP7 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        no_highlight_faces_away_from_the_light_or_from_its_half_vector;
    BP8 elsewhere "chapters/02-blinn-phong/tests/radiance.rs" a_light_on_the_surface_leaves_no_trace;
    BP9 elsewhere "chapters/02-blinn-phong/src/reflection.rs"
        a_light_at_the_point_or_immensely_far_contributes_nothing;
    BP10 elsewhere "chapters/05-rendering-equation/tests/surfaces/albedo.rs"
        the_highlight_has_the_integral_of_the_closed_form;
    BP11 elsewhere "chapters/02-blinn-phong/tests/radiance.rs"
        a_floor_falls_off_with_the_fifth_power_of_the_slant;
    BP12 elsewhere "chapters/02-blinn-phong/tests/radiance.rs"
        a_light_below_the_floor_casts_no_shadow_ray;
}

/// (n·h)ᵖ for n·h close to 1 and far from it, whole and broken p up to 2³⁰, against exp(p ln x) in
/// double precision, which is off by p |ln x| ulps of its own: below 2⁻⁴⁴ where the power is not 0.
/// Within 1 ULP; below the smallest normal float, within one step.
fn a_power_of_a_cosine_is_right_to_the_last_place_for_every_exponent(trial: &mut Trial) {
    for _ in 0..trial.rays {
        let random = &mut trial.random;
        let x = match random.below(3) {
            0 => random.unit() as f32,
            1 => (1.0 - random.magnitude(-7.2, 0.0)) as f32,
            _ => f32::from_bits(1.0_f32.to_bits() - random.below(64) as u32),
        };
        let p = match random.below(3) {
            0 => random.magnitude(0.0, 9.0).floor() as f32,
            1 => random.below(256) as f32,
            _ => random.magnitude(-3.0, 9.0) as f32,
        };
        let exact = if p == 0.0 { 1.0 } else { libm::exp(f64::from(p) * ln(x)) };
        let error = (f64::from(math::power(x, p)) - exact).abs() / ulp(exact as f32);
        trial.within(error, 1.0, || {
            format!("{} to the power of {}", bits::float(x), bits::float(p))
        });
    }
}

/// ln x, from 1 − x where that is exact and x close to 1.
fn ln(x: f32) -> f64 {
    if x > 0.5 { libm::log1p(-f64::from(1.0 - x)) } else { libm::log(f64::from(x)) }
}
