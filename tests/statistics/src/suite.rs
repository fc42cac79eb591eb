//! The rate of false alarms of the whole suite, and what it leaves to each test.
//!
//! A test of a random quantity now and then fails although nothing is wrong. One such alarm in a
//! hundred tests is bearable for one test, but not for a suite of hundreds: some test would always
//! be red. So the rate is fixed for the **whole** suite, [`SUITE_ALPHA`], and shared by all tests
//! after Šidák: n independent tests that each raise a false alarm with probability
//!
//! ```text
//! α₁ = 1 − (1 − α)^(1/n)
//! ```
//!
//! raise at least one with probability α. Tests that depend on each other raise fewer.
//!
//! The number of tests is an upper bound, [`TESTS`], so that a new test does not move the limits of
//! the others. The price of generosity is small: twice as many tests would move the critical
//! number of standard errors from 4.42 to 4.57.
//!
//! Seeds are fixed, so a test that passes once passes always, and the rate says how likely it is
//! that *choosing* a seed, or changing the order of random numbers, finds a false alarm. Nobody
//! then needs to try seeds until one suits. [`seed`] makes the same suite run with fresh ones.

use libm::{expm1, log1p};

/// The probability that at least one statistical test of the workspace fails by chance.
pub const SUITE_ALPHA: f64 = 0.01;

/// An upper bound of the number of statistical tests in the workspace.
///
/// A test that makes many comparisons (the blocks of a picture, the two grids of a histogram)
/// counts as one, and shares its [`TEST_ALPHA`] among them.
pub const TESTS: u32 = 1000;

/// The probability that a single test fails by chance: `per_test_alpha(SUITE_ALPHA, TESTS)`.
pub const TEST_ALPHA: f64 = 1.005_028_534_904_525_4e-5;

/// The number of standard errors that a single test allows on both sides of the expected mean.
///
/// A normal quantity exceeds it with probability [`TEST_ALPHA`].
pub const CRITICAL_Z: f64 = 4.416_088_707_869_151;

/// The number of standard errors by which a bias must exceed the limit to be noticed with
/// probability 0.99: the "power" that stands beside every smallest visible bias.
pub const POWER_Z: f64 = 2.326_347_874_040_841;

/// What each of `tests` tests may use up so that all together use `suite_alpha`, after Šidák.
///
/// # Panics
/// If `tests` is 0.
#[must_use]
pub fn per_test_alpha(suite_alpha: f64, tests: u32) -> f64 {
    assert!(tests > 0, "{tests} tests share α = {suite_alpha}");
    -expm1(log1p(-suite_alpha) / f64::from(tests))
}

/// The seed of a test: `fixed`, unless the environment variable `STATISTICS_SEED` holds a number.
///
/// With it, every test draws other random numbers: `STATISTICS_SEED=7 cargo test` is another suite
/// with the same rate of false alarms. Tests keep apart as long as their fixed seeds do.
///
/// # Panics
/// If the variable is no number: a misspelt seed must not look like a fresh one.
#[must_use]
pub fn seed(fixed: u64) -> u64 {
    let Ok(text) = std::env::var("STATISTICS_SEED") else {
        return fixed;
    };
    let fresh: u64 =
        text.parse().unwrap_or_else(|_| panic!("STATISTICS_SEED is `{text}`, not a number"));
    fixed ^ scramble(fresh)
}

/// The finaliser of SplitMix64: neighbouring numbers become unlike each other.
fn scramble(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::{normal_upper_tail, two_sided_critical_z};

    #[test]
    fn the_constants_are_what_their_definitions_give() {
        let alpha = per_test_alpha(SUITE_ALPHA, TESTS);
        assert!((TEST_ALPHA / alpha - 1.0).abs() < 1e-13, "α₁ = {alpha:e}, not {TEST_ALPHA:e}");
        let z = two_sided_critical_z(TEST_ALPHA);
        assert!((CRITICAL_Z - z).abs() < 1e-13, "z = {z}, not {CRITICAL_Z}");
        let missed = normal_upper_tail(POWER_Z);
        assert!((missed - 0.01).abs() < 1e-15, "a bias is missed with probability {missed}");
    }

    /// Abdi's table of the correction: α = 0.05 over 10 tests is 0.0051162.
    #[test]
    fn tests_share_a_rate_as_published() {
        let alpha = per_test_alpha(0.05, 10);
        assert!((alpha - 0.005_116_196_9).abs() < 1e-10, "α₁ = {alpha}");
        assert!((per_test_alpha(0.05, 1) - 0.05).abs() < 1e-17, "a single test has the whole rate");
    }

    #[test]
    fn all_tests_together_use_up_the_rate() {
        let quiet = (0..TESTS).fold(1.0, |quiet, _| quiet * (1.0 - TEST_ALPHA));
        assert!((1.0 - quiet - SUITE_ALPHA).abs() < 1e-12, "some alarm: {}", 1.0 - quiet);
    }

    /// The published first two numbers of SplitMix64 with the state 1234567.
    #[test]
    fn fresh_seeds_are_scrambled_as_published() {
        let golden = 0x9e37_79b9_7f4a_7c15_u64;
        let (first, second) = (scramble(1_234_567), scramble(golden.wrapping_add(1_234_567)));
        assert_eq!(first, 6_457_827_717_110_365_317, "first number");
        assert_eq!(second, 3_203_168_211_198_807_973, "second number");
    }
}
