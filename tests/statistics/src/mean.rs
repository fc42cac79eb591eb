//! Means against closed forms and against each other.

use crate::beta::{student_critical_t, student_two_sided};
use crate::gamma::chi_squared_upper_tail;
use crate::moments::Moments;
use crate::suite::{POWER_Z, TEST_ALPHA};

/// What rounding to f32 may add to a mean, relative to it: 16 units of 2⁻²⁴.
///
/// Statistics see any bias, if only there are samples enough, and a sum of rounded products *is*
/// biased. Samples that are all equal have no standard error at all: only this is left for them.
pub const ROUNDING: f64 = 16.0 / 16_777_216.0;

/// Asserts that the mean of `samples` is `expected`, within the limits of a single test.
///
/// ```
/// let samples = (0..1000).map(|i| f64::from(i % 10));
/// let bias = statistics::assert_mean("digits", &samples.collect(), 4.5);
/// assert!(bias < 0.15, "a bias of {bias} would be seen");
/// ```
///
/// Returns the smallest bias, relative to `expected`, that this test would have noticed with a
/// probability of 99 %: (critical t + 2.33) standard errors. A test that must see 1 % asserts that
/// this is at most 0.01. Relative to an expectation of 0 it is infinite.
///
/// # Panics
/// If [`check_mean`] fails.
#[expect(clippy::must_use_candidate, reason = "that it passed may be all that matters")]
#[track_caller]
pub fn assert_mean(name: &str, samples: &Moments, expected: f64) -> f64 {
    check_mean(name, samples, expected).unwrap_or_else(|sentence| panic!("{sentence}"))
}

/// Whether the mean of `samples` is `expected`: the sentence of a failure, or the smallest bias
/// that would have been one, as in [`assert_mean`].
///
/// Student's test: t = (|mean − expected| − rounding) / standard error, with n − 1 degrees of
/// freedom, may not be less likely than [`TEST_ALPHA`]. For thousands of samples that is
/// [`crate::CRITICAL_Z`]. The means must be nearly normal: where a few samples carry most of the
/// variance (caustics, roulette with a small probability), average them in batches first.
///
/// # Errors
/// If the mean is too far off, if a sample is not finite, or if there are fewer than two.
pub fn check_mean(name: &str, samples: &Moments, expected: f64) -> Result<f64, String> {
    samples.sound(name)?;
    if !expected.is_finite() {
        return Err(format!("{name}: {expected} cannot be expected"));
    }
    let test = Student {
        difference: samples.mean() - expected,
        rounding: ROUNDING * expected.abs(),
        standard_error: samples.standard_error(),
        degrees: (samples.count() - 1) as f64,
    };
    let bias = test.visible_bias() / expected.abs();
    if test.passes() {
        return Ok(bias);
    }
    let (mean, n) = (samples.mean(), samples.count());
    Err(format!(
        "{name}: mean {mean:.8}, expected {expected:.8} ({:+.3} %); {test}; n = {n}; the smallest \
         bias seen at 99 % power is {:.3} %",
        100.0 * (mean / expected - 1.0),
        100.0 * bias
    ))
}

/// Asserts that two estimators have the same mean.
///
/// Returns the smallest difference, relative to the second mean, that would have been noticed with
/// a probability of 99 %.
///
/// # Panics
/// If [`check_same_mean`] fails.
#[expect(clippy::must_use_candidate, reason = "that it passed may be all that matters")]
#[track_caller]
pub fn assert_same_mean(name: &str, a: &Moments, b: &Moments) -> f64 {
    check_same_mean(name, a, b).unwrap_or_else(|sentence| panic!("{sentence}"))
}

/// Whether two estimators have the same mean, whatever their variances: Welch's test.
///
/// # Errors
/// If the means differ too much, if a sample is not finite, or if a side has fewer than two.
pub fn check_same_mean(name: &str, a: &Moments, b: &Moments) -> Result<f64, String> {
    a.sound(name)?;
    b.sound(name)?;
    let part = |moments: &Moments| (moments.variance_of_mean(), (moments.count() - 1) as f64);
    let test = Student::welch(a.mean() - b.mean(), b.mean(), [part(a), part(b)]);
    let difference = test.visible_bias() / b.mean().abs();
    if test.passes() {
        return Ok(difference);
    }
    Err(format!(
        "{name}: means {:.8} ± {:.2e} and {:.8} ± {:.2e}; {test}; n = {} and {}; the smallest \
         difference seen at 99 % power is {:.3} %",
        a.mean(),
        a.standard_error(),
        b.mean(),
        b.standard_error(),
        a.count(),
        b.count(),
        100.0 * difference
    ))
}

/// Asserts that the variance of `samples` is `expected`.
///
/// # Panics
/// If [`check_variance`] fails.
#[track_caller]
pub fn assert_variance(name: &str, samples: &Moments, expected: f64) {
    if let Err(sentence) = check_variance(name, samples, expected) {
        panic!("{sentence}");
    }
}

/// Whether the variance of **normal** samples is `expected`.
///
/// (n − 1) s² / σ² follows χ² with n − 1 degrees of freedom. Meant for means of many numbers, which
/// are normal: if 64 renders with different seeds scatter less than one of them says, their seeds
/// are no different; if they scatter more, the samples within one are not independent.
///
/// # Errors
/// If it is not, if a sample is not finite, or if there are fewer than two.
pub fn check_variance(name: &str, samples: &Moments, expected: f64) -> Result<(), String> {
    samples.sound(name)?;
    if !(expected > 0.0 && expected.is_finite()) {
        return Err(format!("{name}: a variance of {expected} cannot be expected"));
    }
    let degrees = (samples.count() - 1) as f64;
    let above = chi_squared_upper_tail(degrees * samples.variance() / expected, degrees);
    let p = 2.0 * above.min(1.0 - above);
    if p >= TEST_ALPHA {
        return Ok(());
    }
    Err(format!(
        "{name}: variance {:.4e}, expected {expected:.4e}; p = {p:.1e} is below {TEST_ALPHA:.1e}; \
         n = {}",
        samples.variance(),
        samples.count()
    ))
}

/// A difference that should be 0, and how well it is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) difference: f64,
    /// What the difference may be without any chance.
    pub(crate) rounding: f64,
    pub(crate) standard_error: f64,
    /// Degrees of freedom of the standard error.
    pub(crate) degrees: f64,
}

impl Student {
    /// The difference of two independent means: (variance of the mean, degrees of freedom) of each.
    ///
    /// Degrees of freedom after Welch and Satterthwaite, (Σ v)² / Σ (v² / ν).
    pub(crate) fn welch(
        difference: f64,
        scale: f64,
        parts: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let (mut variance, mut uncertainty) = (0.0, 0.0);
        for (part, degrees) in parts {
            variance += part;
            uncertainty += part * part / degrees;
        }
        let degrees = if uncertainty > 0.0 { variance * variance / uncertainty } else { 1.0 };
        let rounding = ROUNDING * scale.abs();
        Self { difference, rounding, standard_error: variance.sqrt(), degrees }
    }

    /// The difference that rounding leaves unexplained, in standard errors.
    pub(crate) fn t(&self) -> f64 {
        let excess = self.difference.abs() - self.rounding;
        if excess <= 0.0 { 0.0 } else { excess / self.standard_error }
    }

    /// The probability of a larger difference by chance.
    pub(crate) fn p(&self) -> f64 {
        student_two_sided(self.t(), self.degrees)
    }

    fn passes(&self) -> bool {
        self.p() >= TEST_ALPHA
    }

    /// The smallest bias that a single test notices with a probability of 99 %.
    fn visible_bias(&self) -> f64 {
        let critical = student_critical_t(TEST_ALPHA, self.degrees);
        (critical + POWER_Z) * self.standard_error + self.rounding
    }
}

impl std::fmt::Display for Student {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let critical = student_critical_t(TEST_ALPHA, self.degrees);
        write!(
            f,
            "z = {:.2}, at most {critical:.2} are allowed (standard error {:.3e})",
            self.t(),
            self.standard_error
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::seed;
    use crate::uniform::Uniform;

    fn uniform(n: u32, factor: f64) -> Moments {
        let mut random = Uniform(seed(1));
        (0..n).map(|_| factor * random.next()).collect()
    }

    #[test]
    fn a_right_mean_passes_and_tells_what_it_would_have_seen() {
        let bias = assert_mean("uniform", &uniform(1_000_000, 1.0), 0.5);
        // (4.416 + 2.326) / √12 / √10⁶ / 0.5
        assert!((bias - 0.003_893).abs() < 2e-5, "a bias of {bias} would be seen");
    }

    /// The power of every test that is built on this one.
    #[test]
    fn a_planted_bias_of_one_percent_is_found() {
        for factor in [0.99, 1.01] {
            let found = check_mean("biased", &uniform(1_000_000, factor), 0.5);
            let sentence = found.expect_err("one percent is 8 standard errors");
            assert!(sentence.contains("n = 1000000") && sentence.contains("%"), "{sentence}");
        }
    }

    /// 99 % power: of 1000 runs with the smallest visible bias about 990 must find it.
    #[test]
    fn the_stated_power_is_the_power() {
        let mut random = Uniform(seed(2));
        let found = (0..1000).filter(|_| {
            let mut samples: Moments = (0..300).map(|_| random.next()).collect();
            let bias = check_mean("uniform", &samples, 0.5).unwrap_or(0.15) * 0.5;
            samples = (0..300).map(|_| random.next() + bias).collect();
            check_mean("biased", &samples, 0.5).is_err()
        });
        let found = found.count();
        assert!((970..=999).contains(&found), "{found} of 1000 biased runs are found");
    }

    #[test]
    fn what_is_not_finite_never_passes() {
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut samples = uniform(1000, 1.0);
            samples.push(broken);
            let sentence = check_mean("broken", &samples, 0.5).expect_err("1 sample is broken");
            assert!(sentence.contains("1 of 1001"), "{sentence}");
            assert!(check_same_mean("broken", &samples, &uniform(9, 1.0)).is_err(), "{broken}");
            assert!(check_same_mean("broken", &uniform(9, 1.0), &samples).is_err(), "{broken}");
            assert!(check_variance("broken", &samples, 1.0).is_err(), "{broken}");
            assert!(check_mean("expectation", &uniform(9, 1.0), broken).is_err(), "{broken}");
        }
    }

    #[test]
    fn nothing_never_passes() {
        let (none, one) = (Moments::new(), [0.5].into_iter().collect());
        for samples in [none, one] {
            assert!(check_mean("few", &samples, 0.5).is_err(), "{samples:?} passes");
            assert!(check_same_mean("few", &samples, &samples).is_err(), "{samples:?} passes");
            assert!(check_variance("few", &samples, 0.5).is_err(), "{samples:?} passes");
        }
    }

    /// E9 of the catalogue: cosine sampling under a constant sky has no variance.
    #[test]
    fn equal_samples_may_be_off_by_rounding_and_no_more() {
        let equal = |value: f64| (0..100).map(|_| value).collect::<Moments>();
        let bias = assert_mean("furnace", &equal(0.5 + 1e-7), 0.5);
        assert!((bias - ROUNDING).abs() < 1e-12, "a bias of {bias} would be seen");
        assert!(check_mean("furnace", &equal(0.500_001), 0.5).is_err(), "2e-6 is no rounding");
        assert!(check_mean("black", &equal(1e-30), 0.0).is_err(), "0 has no rounding");
        assert_eq!(check_mean("black", &equal(0.0), 0.0).map(f64::is_nan), Ok(true), "0 is 0");
    }

    #[test]
    fn two_estimators_with_different_variances_are_compared() {
        let mut random = Uniform(seed(3));
        let narrow: Moments = (0..10_000).map(|_| 0.45 + 0.1 * random.next()).collect();
        let wide: Moments = (0..400_000).map(|_| random.next()).collect();
        let visible = assert_same_mean("estimators", &narrow, &wide);
        assert!(visible < 0.01, "a difference of {visible} would be seen");
        let biased: Moments = (0..400_000).map(|_| 1.01 * random.next()).collect();
        let found = check_same_mean("biased", &narrow, &biased);
        assert!(found.is_err(), "a difference of one percent is not found");
    }

    /// Few samples have a heavy tail: at the normal limit, 8 samples would fail 3 in 1000 times.
    #[test]
    fn few_samples_raise_no_more_alarms_than_many() {
        let mut random = Uniform(seed(4));
        let alarms = (0..20_000).filter(|_| {
            let samples: Moments = (0..8).map(|_| 1.0 + random.normal()).collect();
            check_mean("few", &samples, 1.0).is_err()
        });
        let alarms = alarms.count(); // 0.2 are expected; 5 would be seen once in 10⁵ runs.
        assert!(alarms < 5, "{alarms} of 20000 right means raise an alarm");
    }

    #[test]
    fn a_variance_is_recognised() {
        let mut random = Uniform(seed(5));
        let means: Moments = (0..64).map(|_| 3.0 + 0.1 * random.normal()).collect();
        assert_variance("means", &means, 0.01);
        for wrong in [0.01 / 4.0, 0.01 * 4.0] {
            assert!(check_variance("seeds", &means, wrong).is_err(), "{wrong} passes");
        }
    }
}
