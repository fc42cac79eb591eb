//! What a smooth boundary does to light: the directions of reflection and refraction, and how much
//! goes which way.
//!
//! All directions point away from the surface, and η = ηᵢ/ηₜ is the index of refraction on the side
//! of `wo` divided by the one on the other side. Light is taken for unpolarised, and stays so.

use glam::Vec3;

// ANCHOR: reflect
/// The mirror direction of `wo`.
///
/// ```text
/// ωᵢ = 2 (n·ωₒ)/(n·n) n − ωₒ
/// ```
///
/// The part of ωₒ along **n** stays, the part across it turns round. **n** may lie on either side.
/// Its n·n = 1 holds but for rounding; divided by it, in double precision, the length of ωₒ is kept
/// to its last place however often it is reflected.
#[inline]
#[must_use]
pub fn reflect(wo: Vec3, normal: Vec3) -> Vec3 {
    let (wo, n) = (wo.as_dvec3(), normal.as_dvec3());
    (2.0 * n.dot(wo) / n.length_squared() * n - wo).as_vec3()
}
// ANCHOR_END: reflect

/// Where a refracted ray goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refracted {
    /// Unit vector on the other side of the boundary.
    pub direction: Vec3,
    /// cos θₜ, between `direction` and −**n**; above 0.
    pub cos_theta_t: f32,
}

// ANCHOR: refract
/// Snell's law: ηᵢ sin θᵢ = ηₜ sin θₜ, in the plane of ωₒ and **n**. `None` under total internal
/// reflection.
///
/// ```text
/// s = ωₒ − (n·ωₒ) n              |s| = sin θᵢ
/// sin²θₜ = η² s·s                ≥ 1: total internal reflection
/// ωₜ = −η s − √(1 − sin²θₜ) n
/// ```
///
/// Two differences lose digits in single precision, each where it matters. sin²θᵢ = 1 − cos²θᵢ is
/// wrong in all its digits near the normal, hence **s**, whose length is accurate for every angle.
/// And 1 − sin²θₜ, near the critical angle, decides whether there is a ray at all: hence double
/// precision inside.
///
/// `normal` (unit length) is on the side of `wo`.
#[inline]
#[must_use]
pub fn refract(wo: Vec3, normal: Vec3, eta: f32) -> Option<Refracted> {
    let (wo, n, eta) = (wo.as_dvec3(), normal.as_dvec3(), f64::from(eta));
    let s = wo - n.dot(wo) * n;
    let cos2_theta_t = 1.0 - eta * eta * s.length_squared();
    if cos2_theta_t <= 0.0 {
        return None;
    }
    let cos_theta_t = cos2_theta_t.sqrt();
    let direction = (-eta * s - cos_theta_t * n).normalize();
    Some(Refracted { direction: direction.as_vec3(), cos_theta_t: cos_theta_t as f32 })
}
// ANCHOR_END: refract

// ANCHOR: fresnel
/// Fresnel's equations: the share of unpolarised light that a boundary reflects, 0 to 1.
///
/// ```text
/// r_s = (η cos θᵢ − cos θₜ) / (η cos θᵢ + cos θₜ)
/// r_p = (cos θᵢ − η cos θₜ) / (cos θᵢ + η cos θₜ)
/// F = (r_s² + r_p²) / 2
/// ```
///
/// Exact for two transparent media \[PBR4] §9.3.5. The rest, 1 − F, is refracted. Both cosines are
/// of unit vectors and at least 0, and not both 0.
#[inline]
#[must_use]
pub fn fresnel(cos_theta_i: f32, cos_theta_t: f32, eta: f32) -> f32 {
    let r_s = (eta * cos_theta_i - cos_theta_t) / (eta * cos_theta_i + cos_theta_t);
    let r_p = (cos_theta_i - eta * cos_theta_t) / (cos_theta_i + eta * cos_theta_t);
    0.5 * (r_s * r_s + r_p * r_p)
}
// ANCHOR_END: fresnel

// ANCHOR: schlick
/// Schlick's approximation of [`fresnel`] \[Schlick94].
///
/// ```text
/// F ≈ F₀ + (1 − F₀) (1 − cos θ)⁵,   F₀ = ((η − 1) / (η + 1))²
/// ```
///
/// θ is the angle on the side of the *smaller* index: for light that leaves glass, θₜ. With θᵢ
/// there, total internal reflection would never be approached, and F be wrong by up to 0.96. For a
/// ratio of 1.5 it is off by up to 0.036, at grazing angles.
#[inline]
#[must_use]
pub fn schlick(cos_theta_i: f32, cos_theta_t: f32, eta: f32) -> f32 {
    let root = (eta - 1.0) / (eta + 1.0);
    let f0 = root * root;
    let cos_theta = if eta > 1.0 { cos_theta_t } else { cos_theta_i };
    let x = 1.0 - cos_theta;
    f0 + (1.0 - f0) * (x * x) * (x * x) * x
}
// ANCHOR_END: schlick

/// What becomes of light at a smooth boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// The mirror direction.
    pub reflected: Vec3,
    /// The direction of the refracted ray; `None` under total internal reflection.
    pub refracted: Option<Vec3>,
    /// F: the share that is reflected; 1 − F is refracted.
    pub reflectance: f32,
}

impl Split {
    /// For a viewer toward `wo`, where η = ηᵢ/ηₜ. `normal` is on the side of `wo`, all but for the
    /// rounding of a grazing direction.
    #[must_use]
    pub fn new(wo: Vec3, normal: Vec3, eta: f32) -> Self {
        let reflected = reflect(wo, normal);
        let cos_theta_i = normal.dot(wo).clamp(0.0, 1.0);
        match refract(wo, normal, eta) {
            Some(refracted) => Self {
                reflected,
                refracted: Some(refracted.direction),
                reflectance: fresnel(cos_theta_i, refracted.cos_theta_t, eta),
            },
            None => Self { reflected, refracted: None, reflectance: 1.0 },
        }
    }

    /// Whether both directions lie on the sides of the surface on which they should.
    ///
    /// An interpolated normal can bend the one through the surface, or the other back out of it.
    /// `facing` is the geometric normal on the viewer's side.
    #[must_use]
    pub fn respects(&self, facing: Vec3) -> bool {
        self.reflected.dot(facing) > 0.0
            && self.refracted.is_none_or(|refracted| refracted.dot(facing) < 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Refracted, Split, fresnel, reflect, refract, schlick};
    use glam::{DVec3, Vec3, dvec3, vec3};
    use ray_casting::math::{UNIT_ROUNDOFF, sin_cos_f64};
    use workbench::Sampler;

    const U: f64 = UNIT_ROUNDOFF as f64;

    /// A direction, uniform on the sphere, rounded once.
    fn direction(sampler: &mut Sampler) -> Vec3 {
        let [a, b] = sampler.next_2d().map(f64::from);
        let z = 2.0 * a - 1.0;
        let (sin, cos) = sin_cos_f64(std::f64::consts::TAU * b);
        let r = (1.0 - z * z).sqrt();
        dvec3(r * cos, r * sin, z).as_vec3()
    }

    /// Two directions on the same side.
    fn wo_and_normal(sampler: &mut Sampler) -> (Vec3, Vec3) {
        let (wo, normal) = (direction(sampler), direction(sampler));
        (wo, if wo.dot(normal) < 0.0 { -normal } else { normal })
    }

    /// cos θₜ, and what [`fresnel`] makes of it; total reflection is 1.
    fn reflectance(cos_theta_i: f64, eta: f64) -> f64 {
        let cos2 = 1.0 - eta * eta * (1.0 - cos_theta_i * cos_theta_i);
        if cos2 <= 0.0 {
            return 1.0;
        }
        f64::from(fresnel(cos_theta_i as f32, cos2.sqrt() as f32, eta as f32))
    }

    /// accuracy F1.
    #[test]
    fn a_mirror_turns_head_on_light_round_and_lets_grazing_light_pass() {
        let mut sampler = Sampler::new(0, 0, 0);
        for _ in 0..1000 {
            let n = direction(&mut sampler);
            let back = (reflect(n, n) - n).as_dvec3().length();
            assert!(back <= 2.0 * U, "head on: {:.2} u", back / U);
        }
        assert_eq!(reflect(Vec3::X, Vec3::Y), Vec3::NEG_X, "along the surface");
    }

    /// accuracy F2.
    #[test]
    fn reflecting_twice_is_the_identity_and_keeps_the_length() {
        let mut sampler = Sampler::new(0, 1, 0);
        let (mut worst, mut worst_length) = (0.0_f64, 0.0_f64);
        for _ in 0..100_000 {
            let (wo, n) = wo_and_normal(&mut sampler);
            let once = reflect(wo, n);
            let twice = (reflect(once, n) - wo).as_dvec3().abs().max_element();
            worst = worst.max(twice / U);
            worst_length = worst_length.max((once.as_dvec3().length() - 1.0).abs() / U);
        }
        assert!(worst <= 8.0, "twice: {worst:.2} u");
        assert!(worst_length <= 4.0, "length: {worst_length:.2} u");
    }

    /// accuracy F3: out of glass, sin θᵢ = 2/3 and its neighbours.
    #[test]
    fn total_internal_reflection_begins_at_the_critical_angle_to_the_last_place() {
        let critical = 2.0_f32 / 3.0;
        for k in -200_i32..=200 {
            let sin = f32::from_bits(critical.to_bits().wrapping_add_signed(k));
            let cos = (1.0 - f64::from(sin) * f64::from(sin)).sqrt() as f32;
            let exact = 1.5 * f64::from(sin) / dvec3(sin.into(), 0.0, cos.into()).length();
            let refracted = refract(vec3(sin, 0.0, cos), Vec3::Z, 1.5);
            if (exact - 1.0).abs() > 4.0 * U {
                assert_eq!(refracted.is_none(), exact > 1.0, "{k} steps off: sin θₜ = {exact}");
            }
            let Some(Refracted { direction, cos_theta_t }) = refracted else { continue };
            assert!(direction.is_finite() && cos_theta_t > 0.0, "{direction}, cos {cos_theta_t}");
            assert!(cos_theta_t < 0.01, "{k} steps off: cos θₜ = {cos_theta_t}");
        }
    }

    /// accuracy F4.
    #[test]
    fn a_million_refracted_directions_obey_snell() {
        let mut sampler = Sampler::new(0, 2, 0);
        let sin = |a: DVec3, b: DVec3| a.cross(b).length() / (a.length() * b.length());
        let mut worst = [0.0_f64; 3];
        for i in 0..1_000_000 {
            let eta = [1.5_f32, 1.0 / 1.5, 2.4, 1.0 / 2.4, 1.0003][i % 5];
            let (wo, n) = wo_and_normal(&mut sampler);
            let Some(refracted) = refract(wo, n, eta) else { continue };
            let (wo, n, wt) = (wo.as_dvec3(), n.as_dvec3(), refracted.direction.as_dvec3());
            let expected = f64::from(eta) * sin(wo, n);
            let cos = (1.0 - expected * expected).max(0.0).sqrt();
            // With the larger index first, as η₁ sin θ₁ − η₂ sin θ₂.
            let larger = f64::from(eta.max(1.0 / eta)) / f64::from(eta.max(1.0));
            let found = [
                larger * (expected - sin(wt, n)).abs() / U,
                wo.cross(n).dot(wt).abs() / U,
                (f64::from(refracted.cos_theta_t) - cos).abs() * cos / U,
            ];
            worst = [0, 1, 2].map(|k| worst[k].max(found[k]));
        }
        let [snell, plane, cosine] = worst;
        assert!(snell <= 8.0, "Snell's law: {snell:.2} u");
        assert!(plane <= 8.0, "out of the plane: {plane:.2} u");
        assert!(cosine <= 4.0, "cos θₜ: {cosine:.2} u / cos θₜ");
    }

    /// accuracy F5.
    #[test]
    fn what_leaves_a_slab_is_parallel_to_what_entered() {
        let mut sampler = Sampler::new(0, 3, 0);
        for _ in 0..100_000 {
            let (wo, n) = wo_and_normal(&mut sampler);
            let inside = refract(wo, n, 1.0 / 1.5).map(|inside| -inside.direction);
            let outside = inside.and_then(|wo| refract(wo, n, 1.5));
            // What grazes may be lost to rounding: cos θ is then of the order of √u.
            let Some(outside) = outside else {
                assert!(wo.dot(n) < 1e-3, "total reflection at cos θ = {}", wo.dot(n));
                continue;
            };
            let error = (outside.direction + wo).as_dvec3().length() * f64::from(wo.dot(n)) / U;
            assert!(error <= 16.0, "cos θ = {}: {error:.2} u / cos θ", wo.dot(n));
        }
    }

    /// accuracy F6, F7.
    #[test]
    fn glass_reflects_as_tables_say() {
        let table = [
            (0.0, 0.04),
            (45.0, 0.050_239_91),
            (60.0, 0.089_186_71),
            (85.0, 0.612_799_65),
            (89.99, 0.998_985_90),
            (56.309_932, 0.073_964_50), // Brewster's angle: the part r_p vanishes.
        ];
        for (degrees, expected) in table {
            let f = reflectance(sin_cos_f64(f64::to_radians(degrees)).1, 1.0 / 1.5);
            assert!((f - expected).abs() <= 1e-6, "{degrees}°: {f}, expected {expected}");
        }
        let brewster = reflectance(1.0 / 3.25_f64.sqrt(), 1.0 / 1.5);
        let r_s = 1.25 / 3.25;
        let r_p = brewster - 0.5 * r_s * r_s;
        assert!(r_p.abs() <= 4.0 * U, "r_p² / 2 at Brewster's angle: {:.2} u", r_p / U);
    }

    /// accuracy F8, with the transmission computed from its own amplitudes.
    #[test]
    fn what_is_not_reflected_is_transmitted() {
        let mut worst = 0.0_f64;
        for i in 1..=100_000 {
            let eta = [1.5, 1.0 / 1.5, 2.4, 1.0 / 2.4, 1.01][i % 5];
            let cos_i = f64::from((i as f64 / 1e5) as f32);
            let cos2 = 1.0 - eta * eta * (1.0 - cos_i * cos_i);
            if cos2 <= 0.0 {
                continue;
            }
            let cos_t = f64::from(cos2.sqrt() as f32);
            let t_s = 2.0 * eta * cos_i / (eta * cos_i + cos_t);
            let t_p = 2.0 * eta * cos_i / (cos_i + eta * cos_t);
            let transmitted = cos_t / (eta * cos_i) * 0.5 * (t_s * t_s + t_p * t_p);
            let reflected = f64::from(fresnel(cos_i as f32, cos_t as f32, eta as f32));
            worst = worst.max((reflected + transmitted - 1.0).abs() / U);
        }
        assert!(worst <= 4.0, "R + T = 1 ± {worst:.2} u");
    }

    /// accuracy F9: 2 ∫ F(μ) μ dμ over cos θ from 0 to 1.
    #[test]
    fn the_mean_reflectance_agrees_with_its_quadrature() {
        let n = 100_000;
        for (eta, expected) in [(1.0 / 1.5, 0.091_778_0), (1.5, 0.596_345_8)] {
            let cosines = (0..n).map(|i| (f64::from(i) + 0.5) / f64::from(n));
            let sum: f64 = cosines.map(|mu| 2.0 * mu * reflectance(mu, eta)).sum();
            let mean = sum / f64::from(n);
            assert!((mean - expected).abs() <= 1e-6, "η = {eta}: {mean}");
        }
    }

    /// accuracy F10, on both sides of the boundary.
    #[test]
    fn schlick_is_off_by_0_0357_and_with_the_inner_cosine_by_0_96() {
        let (mut entering, mut leaving, mut naive) = ((0.0, 0.0), (0.0_f64, 0.0), 0.0_f64);
        for i in 1..=100_000 {
            let outer = f64::from(i) / 1e5;
            let inner = (1.0 - (1.0 - outer * outer) / 2.25).sqrt();
            let (o, i) = (outer as f32, inner as f32);
            let error = |f: f32, eta: f32, a: f32, b: f32| f64::from(f - fresnel(a, b, eta)).abs();
            let larger = |a: (f64, f64), b: (f64, f64)| if b.0 > a.0 { b } else { a };
            entering = larger(entering, (error(schlick(o, i, 1.0 / 1.5), 1.0 / 1.5, o, i), outer));
            leaving = larger(leaving, (error(schlick(i, o, 1.5), 1.5, i, o), outer));
            naive = naive.max(error(schlick(i, i, 1.5), 1.5, i, o));
        }
        for (worst, cos) in [entering, leaving] {
            assert!((worst - 0.035_69).abs() <= 5e-6, "error {worst} at cos θ = {cos}");
            assert!((cos - 0.0876).abs() <= 5e-5, "error {worst} at cos θ = {cos}");
        }
        assert!((naive - 0.959).abs() <= 1e-3, "with the inner cosine the error is {naive}");
    }

    /// accuracy F13.
    #[test]
    fn grazing_light_is_reflected_as_a_whole() {
        let graze = |cos: f64| vec3((1.0 - cos * cos).sqrt() as f32, 0.0, cos as f32);
        let cosines = (1..=30).map(|k| 10.0_f64.powi(-k)).chain([0.0]);
        for eta in [1.5_f32, 1.0 / 1.5, 2.4, 1.0 / 2.4, 1.0_f32.next_up(), 1.0_f32.next_down()] {
            let mut last = 0.0;
            for cos in cosines.clone() {
                let split = Split::new(graze(cos), Vec3::Z, eta);
                let f = split.reflectance;
                assert!(
                    f.is_finite() && f >= last && f <= 1.0,
                    "η = {eta}, cos θ = {cos}: F = {f}"
                );
                assert!(split.refracted.is_none_or(Vec3::is_finite), "η = {eta}, cos θ = {cos}");
                last = f;
            }
            assert_eq!(last, 1.0, "F along the surface, η = {eta}");
        }
    }

    /// accuracy F14.
    #[test]
    fn vectors_that_are_a_little_too_long_or_too_short_do_no_harm() {
        for length in [1.0 - f32::EPSILON, 1.0, 1.0 + f32::EPSILON] {
            for sign in [1.0, -1.0] {
                let split = Split::new(Vec3::Z * length, Vec3::Z * sign, 1.0 / 1.5);
                let f = split.reflectance;
                assert!(f.is_finite() && f <= 1.0, "n·d = {length}: F = {f}");
                assert!(split.refracted.is_some_and(Vec3::is_finite), "n·d = {length}: {split:?}");
            }
            let f = Split::new(Vec3::Z * length, Vec3::Z, 1.0 / 1.5).reflectance;
            assert!((f64::from(f) - 0.04).abs() <= 4.0 * U, "n·d = {length}: F = {f}");
        }
    }
}
