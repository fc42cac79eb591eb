//! The reflection model: what a surface sends to the viewer of the light that a point source sends
//! it.
//!
//! The model is Blinn's \[Blinn77], the equations and their letters are the review's 1 and 2.

use glam::Vec3;
use ray_casting::{PointLight, Rgb, math};

/// Light that arrives at a point.
#[derive(Clone, Copy, Debug)]
pub struct Arriving {
    /// **l**: unit vector toward the light.
    pub direction: Vec3,
    /// I / r², with I the intensity toward the point and r the distance.
    pub strength: Rgb,
}

impl Arriving {
    // ANCHOR: arriving
    /// What arrives at `point` from `light`, if nothing stands between them.
    ///
    /// Zero where I / r² is not a finite number: at the light itself, where it grows beyond all
    /// bounds, and so far away that r² overflows.
    #[must_use]
    pub fn new(light: &PointLight, point: Vec3) -> Self {
        let path = light.position - point;
        let r_squared = path.length_squared();
        let strength = light.intensity_toward(point) / r_squared;
        let strength = if strength.is_finite() { strength } else { Rgb::ZERO };
        Self { direction: path.normalize_or_zero(), strength }
    }
    // ANCHOR_END: arriving
}

// ANCHOR: diffuse
/// Diffuse reflection, equation 1: a matte surface looks equally bright from everywhere.
///
/// ```text
/// I_d = k_d (I / r²) max(0, n·l)
/// ```
///
/// The cosine spreads a beam over the area it meets; Lambert's law. The 1/π of the Lambertian BRDF
/// is folded into I (errata 8), so that the physical chapters give this light the intensity π I.
#[inline]
#[must_use]
pub fn diffuse(kd: Rgb, light: &Arriving, normal: Vec3) -> Rgb {
    kd * light.strength * normal.dot(light.direction).max(0.0)
}
// ANCHOR_END: diffuse

// ANCHOR: specular
/// Specular reflection, equation 2: a highlight around the mirror direction.
///
/// ```text
/// I_s = k_s (I / r²) max(0, n·h)ᵖ   where n·l > 0, else 0;   h = (l + v) / |l + v|
/// ```
///
/// **h** is the normal that a mirror would need to send **l** to **v**; the larger p, the less a
/// surface's tiny mirrors stray from **n**. The review omits the condition, and then shows
/// highlights on surfaces that the light does not reach (errata 8). With **l** = −**v** there is no
/// **h** and no highlight; for p = 0 it is constant, and still zero where n·h ≤ 0.
#[inline]
#[must_use]
pub fn specular(ks: Rgb, p: f32, light: &Arriving, normal: Vec3, wo: Vec3) -> Rgb {
    let half = (light.direction + wo).normalize_or_zero();
    let cos_alpha = normal.dot(half);
    if normal.dot(light.direction) <= 0.0 || cos_alpha <= 0.0 {
        return Rgb::ZERO;
    }
    ks * light.strength * math::power(cos_alpha.min(1.0), p)
}
// ANCHOR_END: specular

#[cfg(test)]
mod tests {
    use super::{Arriving, diffuse, specular};
    use glam::{Vec3, vec3};
    use ray_casting::{PointLight, Rgb};

    fn head_on(strength: f32) -> Arriving {
        Arriving { direction: Vec3::Z, strength: Rgb::splat(strength) }
    }

    /// accuracy BP1, computed by hand: I = 4 at r = 2 has the strength 1.
    #[test]
    fn the_three_terms_head_on_are_a_tenth_a_half_and_a_half() {
        let light = PointLight::new(vec3(0.0, 0.0, 2.0), Rgb::splat(4.0));
        let arriving = Arriving::new(&light, Vec3::ZERO);
        let half = Rgb::splat(0.5);
        for p in [0.0, 1.0, 50.0, 1e6] {
            let sum = 0.1
                + diffuse(half, &arriving, Vec3::Z).x
                + specular(half, p, &arriving, Vec3::Z, Vec3::Z).x;
            assert!((sum - 1.1).abs() <= f32::EPSILON, "p = {p}: {sum}");
        }
    }

    /// Light from 60° on the one side, the viewer straight above: n·l = ½, n·h = cos 30°.
    #[test]
    fn oblique_light_follows_both_cosines() {
        let direction = vec3(0.75_f32.sqrt(), 0.0, 0.5);
        let arriving = Arriving { direction, strength: Rgb::ONE };
        let diffuse = diffuse(Rgb::ONE, &arriving, Vec3::Z).x;
        assert!((diffuse - 0.5).abs() <= f32::EPSILON, "n·l = {diffuse}");
        for (p, expected) in [(2.0, 0.75), (4.0, 0.5625), (6.0, 0.421_875)] {
            let specular = specular(Rgb::ONE, p, &arriving, Vec3::Z, Vec3::Z).x;
            assert!((specular - expected).abs() <= 1e-6, "(n·h)^{p} = {specular}");
        }
    }

    /// accuracy BP2, BP5, BP6, BP7.
    #[test]
    fn no_highlight_faces_away_from_the_light_or_from_its_half_vector() {
        let from = |direction: Vec3| Arriving { direction, strength: Rgb::ONE };
        let cases = [
            ("n·l < 0 < n·h", vec3(0.8, 0.0, -0.6), Vec3::Z),
            ("n·h < 0", vec3(0.6, 0.0, -0.8), vec3(0.8, 0.0, -0.6)),
            ("l = −v", Vec3::Z, Vec3::NEG_Z),
        ];
        for (case, light, wo) in cases {
            for p in [0.0, 1.0, 10.0] {
                let highlight = specular(Rgb::ONE, p, &from(light), Vec3::Z, wo);
                assert_eq!(highlight, Rgb::ZERO, "{case}, p = {p}");
            }
        }
    }

    /// accuracy BP3, BP4: e⁻¹ to 4 units in the last place, and a vanishing highlight without NaN.
    #[test]
    fn extreme_exponents_keep_their_accuracy() {
        let tilted = |cos: f32| ray_casting::math::power(cos, 16_777_216.0);
        let value = tilted(1.0 - f32::EPSILON / 2.0);
        let expected = (-1.0_f64).exp() as f32;
        assert!((value - expected).abs() <= 4.0 * 2.98e-8, "{value} for {expected}");
        assert_eq!(ray_casting::math::power(0.99, 1e9), 0.0, "0.99 to the power of 10⁹");
    }

    /// accuracy BP8, BP9.
    #[test]
    fn a_light_at_the_point_or_immensely_far_contributes_nothing() {
        for distance in [0.0, 1e-30, 1e20] {
            let light = PointLight::new(vec3(0.0, 0.0, distance), Rgb::ONE);
            let arriving = Arriving::new(&light, Vec3::ZERO);
            let light = diffuse(Rgb::ONE, &arriving, Vec3::Z);
            assert_eq!(light, Rgb::ZERO, "at distance {distance}");
        }
        assert_eq!(diffuse(Rgb::ONE, &head_on(1.0), Vec3::Z), Rgb::ONE, "at distance 1");
    }

    /// accuracy BP11: a floor seen from above, lit from height 1.
    #[test]
    fn a_floor_falls_off_with_the_fifth_power_of_the_slant() {
        let light = PointLight::new(Vec3::Y, Rgb::splat(1.0));
        let arriving = Arriving::new(&light, vec3(2.0, 0.0, 0.0));
        let radiance = diffuse(Rgb::splat(0.5), &arriving, Vec3::Y).x;
        assert!((radiance - 0.044_721_36).abs() <= 1e-8, "0.5 / 5^1.5 = {radiance}");
    }
}
