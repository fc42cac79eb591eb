//! The incomplete gamma function, and with it the distribution of χ².

use libm::{exp, lgamma, log};

/// More terms than any sum of this module takes: they grow like 9√a.
const MOST_TERMS: u32 = 1_000_000;

/// The probability that χ² with `degrees` degrees of freedom is at least `chi_squared`.
///
/// # Panics
/// If `degrees` is not above 0, or `chi_squared` is below 0 or NaN.
#[must_use]
pub fn chi_squared_upper_tail(chi_squared: f64, degrees: f64) -> f64 {
    gamma_upper_tail(0.5 * degrees, 0.5 * chi_squared)
}

/// The χ² with `degrees` degrees of freedom that is exceeded with probability `alpha`.
///
/// # Panics
/// If `degrees` is not above 0, or `alpha` is not strictly between 0 and 1.
#[must_use]
pub fn chi_squared_critical(alpha: f64, degrees: f64) -> f64 {
    assert!(alpha > 0.0 && alpha < 1.0, "χ² has no limit for α = {alpha}");
    let (mut low, mut high) = (0.0, 2.0 * degrees + 10.0);
    while chi_squared_upper_tail(high, degrees) > alpha {
        (low, high) = (high, 2.0 * high);
    }
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if chi_squared_upper_tail(middle, degrees) > alpha {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Q(a, x), the regularised upper incomplete gamma function, for a > 0 and x ≥ 0.
///
/// ```text
/// Q(a, x) = ∫ₓ^∞ tᵃ⁻¹ e⁻ᵗ dt / Γ(a)
/// ```
///
/// Below the mean its complement is summed, P(a, x) = xᵃ e⁻ˣ Σₖ xᵏ / Γ(a + k + 1), all terms being
/// positive; above it a continued fraction converges (Abramowitz and Stegun 6.5.29 and 6.5.31).
/// About 10 digits are right for a up to 10⁶.
///
/// # Panics
/// If `a` is not above 0, or `x` is below 0 or NaN.
#[must_use]
pub fn gamma_upper_tail(a: f64, x: f64) -> f64 {
    assert!(a > 0.0 && x >= 0.0, "Q({a}, {x}) is not defined");
    if x == 0.0 {
        return 1.0;
    }
    if x.is_infinite() {
        return 0.0;
    }
    let scale = exp(a * log(x) - x - lgamma(a)); // xᵃ e⁻ˣ / Γ(a)
    if x < a + 1.0 { 1.0 - scale * lower_series(a, x) } else { scale * upper_fraction(a, x) }
}

/// Σₖ xᵏ / (a (a + 1) … (a + k)).
fn lower_series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum) = (1.0 / a, 1.0 / a);
    for k in 1..MOST_TERMS {
        term *= x / (a + f64::from(k));
        sum += term;
        if term < 1e-17 * sum {
            break;
        }
    }
    sum
}

/// 1/(x + 1 − a − 1(1 − a)/(x + 3 − a − 2(2 − a)/(x + 5 − a − …))), from the front.
///
/// The method of Lentz: numerator and denominator of the growing fraction are known only as ratios
/// to those before, which stay near 1 where the numbers themselves would overflow.
fn upper_fraction(a: f64, x: f64) -> f64 {
    let tiny = f64::MIN_POSITIVE;
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1.0 / tiny, 1.0 / b);
    let mut fraction = d;
    for k in 1..MOST_TERMS {
        let k = f64::from(k);
        let numerator = k * (a - k);
        b += 2.0;
        d = 1.0 / not_zero(numerator * d + b, tiny);
        c = not_zero(b + numerator / c, tiny);
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    fraction
}

/// `x`, or `tiny` in the place of 0.
pub(crate) fn not_zero(x: f64, tiny: f64) -> f64 {
    if x.abs() < tiny { tiny } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Critical values of the table in the NIST handbook of statistics, 1.3.6.7.4, to 3 decimals.
    #[test]
    fn chi_squared_is_as_published() {
        let table = [
            (1.0, 3.841, 0.05),
            (1.0, 10.828, 0.001),
            (2.0, 9.210, 0.01),
            (10.0, 18.307, 0.05),
            (10.0, 29.588, 0.001),
            (50.0, 76.154, 0.01),
            (100.0, 124.342, 0.05),
            (100.0, 149.449, 0.001),
            (100.0, 77.929, 0.95),
            (10.0, 2.558, 0.99),
        ];
        for (degrees, critical, expected) in table {
            let p = chi_squared_upper_tail(critical, degrees);
            assert!((p / expected - 1.0).abs() < 1e-3, "P(χ²({degrees}) ≥ {critical}) = {p}");
            let limit = chi_squared_critical(expected, degrees);
            assert!((limit - critical).abs() < 6e-4, "{limit} for α = {expected}, not {critical}");
        }
    }

    /// Two degrees of freedom: Q = e^(−χ²/2). Four: e^(−χ²/2)(1 + χ²/2).
    #[test]
    fn few_degrees_of_freedom_have_a_closed_form() {
        for tenth in 1..1000 {
            let half = f64::from(tenth) / 10.0;
            let (two, four) = (exp(-half), exp(-half) * (1.0 + half));
            let got = [2.0, 4.0].map(|degrees| chi_squared_upper_tail(2.0 * half, degrees));
            assert!((got[0] / two - 1.0).abs() < 1e-12, "{} instead of {two}", got[0]);
            assert!((got[1] / four - 1.0).abs() < 1e-12, "{} instead of {four}", got[1]);
        }
    }

    /// √(2χ²) − √(2ν − 1) is nearly normal for many degrees of freedom ν (Fisher), to 1/√ν.
    #[test]
    fn many_degrees_of_freedom_are_nearly_normal() {
        let degrees: f64 = 20_000.0;
        for z in [-4.0, -2.0, 0.0, 2.0, 4.0_f64] {
            let chi_squared =
                0.5 * (z + (2.0 * degrees - 1.0).sqrt()) * (z + (2.0 * degrees - 1.0).sqrt());
            let p = chi_squared_upper_tail(chi_squared, degrees);
            let expected = crate::normal::normal_upper_tail(z);
            assert!((p / expected - 1.0).abs() < 0.15, "{p} instead of {expected} at z = {z}");
        }
    }

    #[test]
    fn the_two_methods_meet_where_one_takes_over() {
        for a in [0.5, 3.0, 40.0, 6400.0, 100_000.0] {
            let below = gamma_upper_tail(a, (a + 1.0) * (1.0 - 1e-12));
            let above = gamma_upper_tail(a, a + 1.0);
            assert!((below - above).abs() < 1e-8, "Q jumps from {below} to {above} at a = {a}");
        }
    }

    #[test]
    fn nothing_is_below_zero_and_nothing_above_infinity() {
        let ends = [gamma_upper_tail(3.0, 0.0), gamma_upper_tail(3.0, f64::INFINITY)];
        assert_eq!(ends, [1.0, 0.0], "Q(3, 0) and Q(3, ∞)");
    }
}
