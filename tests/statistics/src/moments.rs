//! Mean and variance of a stream of numbers.

/// Count, mean and variance of numbers that are seen one by one.
///
/// Welford's recurrence in f64: no large sums are subtracted from each other, so the variance is
/// right even where it is small beside the mean. A number that is not finite is counted apart, and
/// every test of this crate fails on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    /// Σ (x − mean)².
    squares: f64,
    non_finite: u64,
}

impl Moments {
    /// Nothing seen yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes one number.
    #[inline]
    pub fn push(&mut self, x: f64) {
        if !x.is_finite() {
            self.non_finite += 1;
            return;
        }
        self.count += 1;
        let before = x - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (x - self.mean);
    }

    /// Takes all that another has seen.
    ///
    /// The result depends on the order in the last bits: merge in a fixed one.
    pub fn merge(&mut self, other: &Self) {
        self.non_finite += other.non_finite;
        if other.count == 0 {
            return;
        }
        let (a, b) = (self.count as f64, other.count as f64);
        let difference = other.mean - self.mean;
        self.mean += difference * b / (a + b);
        self.squares += other.squares + difference * difference * a * b / (a + b);
        self.count += other.count;
    }

    /// How many finite numbers were seen.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// How many numbers were infinite or NaN; the other results leave them out.
    #[must_use]
    pub fn non_finite(&self) -> u64 {
        self.non_finite
    }

    /// Their mean; 0 when there are none.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The estimate of their distribution's variance, Σ (x − mean)² / (n − 1); 0 for n < 2.
    #[must_use]
    pub fn variance(&self) -> f64 {
        if self.count < 2 { 0.0 } else { self.squares / (self.count - 1) as f64 }
    }

    /// The estimate of the variance of their mean.
    #[must_use]
    pub fn variance_of_mean(&self) -> f64 {
        if self.count < 2 { 0.0 } else { self.variance() / self.count as f64 }
    }

    /// The square root of it.
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        self.variance_of_mean().sqrt()
    }

    /// Whether a test can say anything of these numbers.
    ///
    /// # Errors
    /// A sentence, if one of them is not finite, or if there are fewer than 2: nothing at all would
    /// pass every test.
    pub(crate) fn sound(&self, name: &str) -> Result<(), String> {
        if self.non_finite > 0 {
            let of = self.count + self.non_finite;
            return Err(format!("{name}: {} of {of} samples are not finite", self.non_finite));
        }
        if self.count < 2 {
            return Err(format!("{name}: {} samples say nothing", self.count));
        }
        Ok(())
    }
}

impl Extend<f64> for Moments {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, numbers: I) {
        numbers.into_iter().for_each(|x| self.push(x));
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(numbers: I) -> Self {
        let mut moments = Self::new();
        moments.extend(numbers);
        moments
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The data set "NumAcc4" of the NIST reference data: mean 10000000.2, deviation 0.1 exactly.
    #[test]
    fn a_small_variance_beside_a_large_mean_is_right() {
        let pairs = (0..500).flat_map(|_| [10_000_000.1, 10_000_000.3]);
        let moments: Moments = [10_000_000.2].into_iter().chain(pairs).collect();
        assert_eq!(moments.count(), 1001, "numbers");
        assert!((moments.mean() - 10_000_000.2).abs() < 1e-8, "mean {}", moments.mean());
        let deviation = moments.variance().sqrt();
        assert!((deviation - 0.1).abs() < 1e-8, "standard deviation {deviation}");
    }

    #[test]
    fn parts_merged_are_the_whole() {
        let number = |i: i32| f64::from(i * i % 97) - 11.0;
        let whole: Moments = (0..1000).map(number).collect();
        for cut in [0, 1, 2, 500, 999, 1000] {
            let mut merged: Moments = (0..cut).map(number).collect();
            merged.merge(&(cut..1000).map(number).collect());
            assert_eq!(merged.count(), whole.count(), "numbers, cut at {cut}");
            let mean = (merged.mean() - whole.mean()).abs();
            let variance = (merged.variance() / whole.variance() - 1.0).abs();
            assert!(mean < 1e-12 && variance < 1e-12, "cut at {cut}: {merged:?}, not {whole:?}");
        }
    }

    #[test]
    fn what_is_not_finite_is_counted_and_never_averaged() {
        let mut moments: Moments = [1.0, f64::NAN, 3.0, f64::INFINITY].into_iter().collect();
        moments.merge(&[f64::NEG_INFINITY].into_iter().collect());
        assert_eq!((moments.count(), moments.non_finite()), (2, 3), "{moments:?}");
        assert_eq!(moments.mean().to_bits(), 2.0_f64.to_bits(), "{moments:?}");
        let sentence = moments.sound("light").expect_err("three samples are broken");
        assert!(sentence.contains("3 of 5"), "{sentence}");
    }

    #[test]
    fn nothing_and_one_number_have_no_variance() {
        for numbers in [&[][..], &[7.0]] {
            let moments: Moments = numbers.iter().copied().collect();
            assert_eq!(moments.variance().to_bits(), 0, "{moments:?}");
            assert!(moments.sound("few").is_err(), "{moments:?} passes");
        }
    }
}
