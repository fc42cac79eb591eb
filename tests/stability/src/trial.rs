//! What a case reports to.

use crate::random::Random;

/// One run of a case over a number of inputs: what was tried, what failed, how far off it was.
#[derive(Debug)]
pub struct Trial {
    /// How many random inputs to take.
    pub rays: u64,
    /// Where they come from.
    pub random: Random,
    found: Found,
}

/// What a trial, or several, found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Inputs for which the fact was looked at.
    pub tried: u64,
    /// Those for which it did not hold.
    pub failures: u64,
    /// The largest error, in the unit that the case states (units in the last place, as a rule); 0
    /// where there is nothing to measure.
    pub worst: f64,
    /// The first failure: its inputs as exact bits, and what came out.
    pub first: Option<String>,
}

impl Trial {
    /// A trial of `rays` inputs.
    #[must_use]
    pub fn new(rays: u64, random: Random) -> Self {
        Self { rays, random, found: Found::default() }
    }

    /// Reports whether the fact holds for one input. `input` is asked for only if it does not.
    #[inline]
    pub fn require(&mut self, holds: bool, input: impl FnOnce() -> String) {
        self.found.tried += 1;
        if !holds {
            self.found.fail(input);
        }
    }

    /// Reports an error that may be at most `limit`. NaN is more than any limit.
    #[inline]
    pub fn within(&mut self, error: f64, limit: f64, input: impl FnOnce() -> String) {
        self.found.tried += 1;
        let fits = error <= limit;
        if !fits {
            self.found.fail(|| format!("error {error:.4e}, at most {limit:.4e}: {}", input()));
        }
        // `max` would drop a NaN.
        if error.is_nan() || error > self.found.worst {
            self.found.worst = error;
        }
    }

    /// What came out.
    #[must_use]
    pub fn finish(self) -> Found {
        self.found
    }
}

impl Found {
    #[cold]
    fn fail(&mut self, input: impl FnOnce() -> String) {
        self.failures += 1;
        if self.first.is_none() {
            self.first = Some(input());
        }
    }

    /// Both together; `self` came first.
    #[must_use]
    pub fn and(self, later: Self) -> Self {
        let worse = later.worst.is_nan() || later.worst > self.worst;
        Self {
            tried: self.tried + later.tried,
            failures: self.failures + later.failures,
            worst: if worse { later.worst } else { self.worst },
            first: self.first.or(later.first),
        }
    }

    /// Whether something was tried and nothing failed.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.tried > 0 && self.failures == 0 && !self.worst.is_nan()
    }
}

#[cfg(test)]
mod tests {
    use super::{Found, Trial};
    use crate::random::Random;

    fn trial(run: impl Fn(&mut Trial)) -> Found {
        let mut trial = Trial::new(1, Random::new(0, 0));
        run(&mut trial);
        trial.finish()
    }

    #[test]
    fn nothing_tried_is_nothing_shown() {
        assert!(!trial(|_| {}).holds(), "an empty trial holds");
    }

    #[test]
    fn nan_is_more_than_any_limit_and_stays() {
        let broken = trial(|t| t.within(f64::NAN, f64::INFINITY, String::new));
        assert_eq!((broken.failures, broken.worst.is_nan()), (1, true), "{broken:?}");
        let fine = trial(|t| t.within(1.0, 2.0, String::new));
        for both in [fine.clone().and(broken.clone()), broken.and(fine)] {
            assert!(both.worst.is_nan() && !both.holds(), "{both:?}");
        }
    }

    #[test]
    fn the_first_failure_is_kept() {
        let found = trial(|t| {
            for i in 0..4 {
                t.require(i < 2, || format!("input {i}"));
            }
        });
        assert_eq!((found.tried, found.failures), (4, 2), "{found:?}");
        assert_eq!(found.first.as_deref(), Some("input 2"), "{found:?}");
    }
}
