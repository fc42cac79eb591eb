//! The incomplete beta function, and with it Student's t and the binomial distribution.

use crate::gamma::not_zero;
use crate::normal::{normal_upper_tail, two_sided_critical_z};
use libm::{exp, lgamma, log, log1p};

/// Above this number of degrees of freedom, Student's t is taken for normal.
///
/// At t = 4.4 its tail is then right to t⁴/4ν, one part in ten thousand.
const NORMAL_ABOVE: f64 = 1e6;

/// The probability that Student's t with `degrees` degrees of freedom is at least |`t`| on either
/// side.
///
/// # Panics
/// If `degrees` is not above 0, or `t` is NaN.
#[must_use]
pub fn student_two_sided(t: f64, degrees: f64) -> f64 {
    if degrees > NORMAL_ABOVE {
        return 2.0 * normal_upper_tail(t.abs());
    }
    if t.is_infinite() {
        return 0.0;
    }
    beta_lower(degrees / (degrees + t * t), 0.5 * degrees, 0.5)
}

/// The |t| that Student's t exceeds on either side with probability `alpha`.
///
/// # Panics
/// If `alpha` is not strictly between 0 and 1, or `degrees` is not above 0.
#[must_use]
pub fn student_critical_t(alpha: f64, degrees: f64) -> f64 {
    let (mut low, mut high) = (0.0, 2.0 * two_sided_critical_z(alpha));
    while student_two_sided(high, degrees) > alpha && high < 1e300 {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if student_two_sided(middle, degrees) > alpha {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The probability of at least `successes` in `trials` that succeed with probability `p` each.
///
/// # Panics
/// If `p` is not between 0 and 1.
#[must_use]
pub fn binomial_at_least(successes: u64, trials: u64, p: f64) -> f64 {
    assert!((0.0..=1.0).contains(&p), "{p} is no probability");
    if successes == 0 {
        return 1.0;
    }
    if successes > trials {
        return 0.0;
    }
    beta_lower(p, successes as f64, (trials - successes + 1) as f64)
}

/// The probability of at most `successes` in `trials` that succeed with probability `p` each.
///
/// # Panics
/// If `p` is not between 0 and 1, or there are more successes than trials.
#[must_use]
pub fn binomial_at_most(successes: u64, trials: u64, p: f64) -> f64 {
    assert!(successes <= trials, "{successes} successes in {trials} trials");
    // Counting failures instead keeps small results exact, where 1 − (a large one) would not.
    binomial_at_least(trials - successes, trials, 1.0 - p)
}

/// Iₓ(a, b), the regularised incomplete beta function, for 0 ≤ x ≤ 1 and a, b > 0.
///
/// ```text
/// Iₓ(a, b) = ∫₀ˣ tᵃ⁻¹ (1 − t)ᵇ⁻¹ dt / B(a, b)
/// ```
///
/// A continued fraction (Abramowitz and Stegun 26.5.8) that converges fast below the mean; above
/// it, Iₓ(a, b) = 1 − I₁₋ₓ(b, a).
///
/// # Panics
/// If an argument is outside these ranges.
#[must_use]
pub fn beta_lower(x: f64, a: f64, b: f64) -> f64 {
    assert!(a > 0.0 && b > 0.0 && (0.0..=1.0).contains(&x), "I({x}; {a}, {b}) is not defined");
    if x == 0.0 || x == 1.0 {
        return x;
    }
    let log_scale = lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log1p(-x);
    let scale = exp(log_scale);
    if x < (a + 1.0) / (a + b + 2.0) {
        scale * fraction(x, a, b) / a
    } else {
        1.0 - scale * fraction(1.0 - x, b, a) / b
    }
}

/// 1/(1 + d₁/(1 + d₂/(1 + …))) by the method of Lentz, as in [`crate::gamma`].
fn fraction(x: f64, a: f64, b: f64) -> f64 {
    let tiny = f64::MIN_POSITIVE;
    let (mut c, mut d) = (1.0, 1.0 / not_zero(1.0 - (a + b) * x / (a + 1.0), tiny));
    let mut fraction = d;
    for m in 1..1_000_000 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let before = fraction;
        for coefficient in [even, odd] {
            d = 1.0 / not_zero(1.0 + coefficient * d, tiny);
            c = not_zero(1.0 + coefficient / c, tiny);
            fraction *= c * d;
        }
        if (fraction / before - 1.0).abs() < 1e-16 {
            break;
        }
    }
    fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Student's table, two-sided, to three decimals (NIST handbook, 1.3.6.7.2).
    #[test]
    fn student_is_as_published() {
        let table = [
            (1.0, 12.706, 0.05),
            (2.0, 9.925, 0.01),
            (5.0, 4.032, 0.01),
            (10.0, 2.228, 0.05),
            (20.0, 3.552, 0.002),
            (100.0, 1.984, 0.05),
        ];
        for (degrees, t, alpha) in table {
            let p = student_two_sided(t, degrees);
            assert!((p / alpha - 1.0).abs() < 2e-3, "P(|t({degrees})| ≥ {t}) = {p}, not {alpha}");
            let critical = student_critical_t(alpha, degrees);
            assert!((critical - t).abs() < 6e-4, "t({degrees}, {alpha}) = {critical}, not {t}");
        }
    }

    /// One degree of freedom is Cauchy's distribution: P(|t| ≥ 1) = ½.
    #[test]
    fn one_degree_of_freedom_has_a_closed_form() {
        let p = student_two_sided(1.0, 1.0);
        assert!((p - 0.5).abs() < 1e-14, "P(|t| ≥ 1) = {p}");
    }

    #[test]
    fn many_degrees_of_freedom_are_normal() {
        let (below, above) = (student_two_sided(4.4, 9.9e5), student_two_sided(4.4, 1.01e6));
        assert!((below / above - 1.0).abs() < 3e-4, "{below:e} and {above:e}");
    }

    /// (45 + 10 + 1)/1024, (1 + 10)/1024, and a sum that a person can check.
    #[test]
    fn binomial_tails_are_exact_sums() {
        let at_least = binomial_at_least(8, 10, 0.5);
        assert!((at_least - 56.0 / 1024.0).abs() < 1e-15, "P(X ≥ 8) = {at_least}");
        let at_most = binomial_at_most(1, 10, 0.5);
        assert!((at_most - 11.0 / 1024.0).abs() < 1e-15, "P(X ≤ 1) = {at_most}");
        let rare = binomial_at_least(2, 3, 1e-5);
        assert!((rare / (3e-10 - 2e-15) - 1.0).abs() < 1e-12, "P(X ≥ 2) = {rare:e}");
    }

    #[test]
    fn binomial_tails_reach_from_all_to_nothing() {
        let ends = [binomial_at_least(0, 10, 0.3), binomial_at_least(11, 10, 0.3)];
        assert_eq!(ends, [1.0, 0.0], "at least 0 and at least 11 of 10");
        let whole = binomial_at_least(400, 1000, 0.41) + binomial_at_most(399, 1000, 0.41);
        assert!((whole - 1.0).abs() < 1e-12, "both tails together are {whole}");
    }

    /// Iₓ(1, b) = 1 − (1 − x)ᵇ.
    #[test]
    fn beta_has_a_closed_form_for_a_power() {
        for (x, b) in [(0.1, 3.0_f64), (0.9, 7.0), (0.5, 40.0)] {
            let expected = 1.0 - libm::pow(1.0 - x, b);
            let got = beta_lower(x, 1.0, b);
            assert!((got - expected).abs() < 1e-14, "I({x}; 1, {b}) = {got}, not {expected}");
        }
    }
}
