//! The normal distribution with mean 0 and variance 1.

use libm::{erfc, exp, log};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// Φ(z), the probability of a value of at most `z`.
#[must_use]
pub fn normal_cdf(z: f64) -> f64 {
    normal_upper_tail(-z)
}

/// Q(z) = 1 − Φ(z), the probability of a value above `z`, also where Φ rounds to 1.
#[must_use]
pub fn normal_upper_tail(z: f64) -> f64 {
    0.5 * erfc(z * FRAC_1_SQRT_2)
}

/// Φ⁻¹(p), for p strictly between 0 and 1, and not below 10⁻³⁰⁰.
///
/// # Panics
/// If `p` is not.
#[must_use]
pub fn normal_quantile(p: f64) -> f64 {
    if p < 0.5 { -upper_quantile(p) } else { upper_quantile(1.0 - p) }
}

/// The z that a value exceeds on either side with probability `alpha`.
///
/// # Panics
/// If `alpha` is not strictly between 0 and 1, or below 10⁻³⁰⁰.
#[must_use]
pub fn two_sided_critical_z(alpha: f64) -> f64 {
    upper_quantile(0.5 * alpha)
}

/// The z with Q(z) = `p`, for 10⁻³⁰⁰ ≤ `p` ≤ ½.
///
/// ```text
/// z₀ = √(−2 ln 2p),   zₖ₊₁ = zₖ + (ln Q(zₖ) − ln p) Q(zₖ) / φ(zₖ)
/// ```
///
/// Newton's method for ln Q. It starts too high, for Q(z) ≤ ½ exp(−z²/2), and because ln Q is
/// concave it comes down to the root without ever passing it.
fn upper_quantile(p: f64) -> f64 {
    assert!((1e-300..=0.5).contains(&p), "a tail of probability {p} has no quantile here");
    let mut z = (-2.0 * log(2.0 * p)).sqrt();
    for _ in 0..100 {
        let tail = normal_upper_tail(z);
        let density = exp(-0.5 * z * z) / TAU.sqrt();
        let step = log(tail / p) * tail / density;
        z += step;
        if step.abs() <= 1e-15 * z.abs() {
            break;
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, table 26.1 and 26.2; more digits from the same integral.
    const PUBLISHED: [(f64, f64); 5] = [
        (0.0, 0.5),
        (1.0, 0.158_655_253_931_457_05),
        (3.0, 1.349_898_031_630_094_5e-3),
        (6.0, 9.865_876_450_376_98e-10),
        (10.0, 7.619_853_024_160_525e-24),
    ];

    #[test]
    fn tails_are_as_published() {
        for (z, expected) in PUBLISHED {
            let tail = normal_upper_tail(z);
            assert!((tail / expected - 1.0).abs() < 1e-12, "Q({z}) = {tail:e}, not {expected:e}");
            assert!((normal_cdf(-z) - tail).abs() < 1e-16, "Φ(−{z}) = {}", normal_cdf(-z));
        }
    }

    #[test]
    fn quantiles_are_as_published() {
        let table = [
            (0.95, 1.644_853_626_951_472_2),
            (0.975, 1.959_963_984_540_054),
            (0.99, 2.326_347_874_040_841),
            (0.995, 2.575_829_303_548_900_4),
            (0.5, 0.0),
        ];
        for (p, expected) in table {
            let z = normal_quantile(p);
            assert!((z - expected).abs() < 1e-13, "Φ⁻¹({p}) = {z}, not {expected}");
            let mirrored = normal_quantile(1.0 - p);
            assert!((mirrored + expected).abs() < 1e-13, "Φ⁻¹(1 − {p}) = {mirrored}");
        }
    }

    #[test]
    fn quantiles_invert_tails_down_to_the_smallest() {
        for exponent in 1..300 {
            let alpha = libm::pow(10.0, -f64::from(exponent));
            let back = 2.0 * normal_upper_tail(two_sided_critical_z(alpha));
            assert!((back / alpha - 1.0).abs() < 1e-11, "{alpha:e} became {back:e}");
        }
    }
}
