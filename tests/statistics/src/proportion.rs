//! How often something happens.

use crate::beta::{binomial_at_least, binomial_at_most};
use crate::suite::TEST_ALPHA;

/// Asserts that something with probability `p` happened `successes` times in `trials`.
///
/// # Panics
/// If [`check_proportion`] fails.
#[track_caller]
pub fn assert_proportion(name: &str, successes: u64, trials: u64, p: f64) {
    if let Err(sentence) = check_proportion(name, successes, trials, p) {
        panic!("{sentence}");
    }
}

/// Whether `successes` in `trials` fit a probability `p` of each: the exact binomial test on both
/// sides, each with half of [`TEST_ALPHA`].
///
/// # Errors
/// If they do not, if there were no trials, if there are more successes than trials, or if `p` is
/// no probability.
pub fn check_proportion(name: &str, successes: u64, trials: u64, p: f64) -> Result<(), String> {
    if trials == 0 || successes > trials || !(0.0..=1.0).contains(&p) {
        return Err(format!("{name}: {successes} of {trials} with probability {p} says nothing"));
    }
    let tails = [binomial_at_most(successes, trials, p), binomial_at_least(successes, trials, p)];
    let tail = tails[0].min(tails[1]);
    if tail >= 0.5 * TEST_ALPHA {
        return Ok(());
    }
    Err(format!(
        "{name}: {successes} of {trials} ({:.3} %) where {:.3} % are expected; one-sided \
         probability {tail:.1e} is below {:.1e}",
        100.0 * successes as f64 / trials as f64,
        100.0 * p,
        0.5 * TEST_ALPHA
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn likely_counts_pass_and_unlikely_ones_fail() {
        assert_proportion("coin", 5_100, 10_000, 0.5);
        for successes in [4_700, 5_300] {
            assert!(check_proportion("coin", successes, 10_000, 0.5).is_err(), "{successes}");
        }
    }

    /// What "95 % of all intervals hold the truth" can mean for 400 renders.
    #[test]
    fn a_coverage_of_85_percent_is_not_95() {
        assert_proportion("coverage", 374, 400, 0.95);
        assert!(check_proportion("coverage", 340, 400, 0.95).is_err(), "85 % pass for 95 %");
    }

    #[test]
    fn certain_and_impossible_things_have_no_scatter() {
        assert_proportion("certain", 10, 10, 1.0);
        assert_proportion("impossible", 0, 10, 0.0);
        assert!(check_proportion("certain", 9, 10, 1.0).is_err(), "9 of 10 were certain");
        assert!(check_proportion("impossible", 1, 10, 0.0).is_err(), "1 of 10 was impossible");
    }

    #[test]
    fn nothing_never_passes() {
        assert!(check_proportion("none", 0, 0, 0.5).is_err(), "no trials");
        assert!(check_proportion("none", 2, 1, 0.5).is_err(), "2 of 1");
        assert!(check_proportion("none", 1, 2, f64::NAN).is_err(), "NaN");
    }
}
