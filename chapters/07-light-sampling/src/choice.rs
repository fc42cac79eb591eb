//! One of several, in proportion to weights.

/// A distribution over the numbers 0 to n − 1.
#[derive(Clone, Debug)]
pub struct Choice {
    /// pmf of each number.
    pmf: Vec<f32>,
    /// The sums of the pmf up to and with each number; the last one is 1.
    cumulative: Vec<f32>,
}

impl Choice {
    /// Numbers in proportion to `weights`, which are finite, not negative, and not all 0 if there are
    /// any.
    #[must_use]
    pub fn new(weights: &[f64]) -> Self {
        let total: f64 = weights.iter().sum();
        debug_assert!(weights.is_empty() || (total > 0.0 && total.is_finite()), "total {total}");
        let pmf = weights.iter().map(|weight| (weight / total) as f32).collect();
        let sums = weights.iter().scan(0.0, |sum, weight| {
            *sum += weight;
            Some(*sum)
        });
        let mut cumulative: Vec<f32> = sums.map(|sum| (sum / total) as f32).collect();
        // Rounding must not leave a gap at the end, nor let the last number have it that has no
        // weight.
        if let Some(last) = weights.iter().rposition(|&weight| weight > 0.0) {
            cumulative[last..].fill(1.0);
        }
        Self { pmf, cumulative }
    }

    // ANCHOR: pick
    /// The number that `u` ∈ [0, 1) picks: the first whose cumulative sum exceeds u.
    ///
    /// A number of weight 0 adds nothing to the sum, so it is never the first.
    #[inline]
    #[must_use]
    pub fn pick(&self, u: f32) -> usize {
        self.cumulative.partition_point(|&sum| sum <= u)
    }

    /// The probability of a number.
    #[inline]
    #[must_use]
    pub fn pmf(&self, number: usize) -> f32 {
        self.pmf[number]
    }
    // ANCHOR_END: pick
}

#[cfg(test)]
mod tests {
    use super::Choice;

    /// accuracy.md M12.
    #[test]
    fn an_entry_without_weight_is_never_chosen() {
        let largest = 1.0_f32.next_down();
        let weights = [0.0, 1.0, 0.0, 3.0, 0.0, 1e-30, 0.0];
        let choice = Choice::new(&weights);
        for i in 0..=10_000_u16 {
            let u = (f32::from(i) / 10_000.0).min(largest);
            let picked = choice.pick(u);
            assert!(weights[picked] > 0.0, "u = {u} picks {picked}");
        }
        assert_eq!(choice.pick(0.0), 1, "the smallest u");
        assert!([3, 5].contains(&choice.pick(largest)), "the largest u");
    }

    #[test]
    fn numbers_come_in_proportion_to_their_weights() {
        let choice = Choice::new(&[1.0, 2.0, 5.0]);
        let mut counts = [0; 3];
        for i in 0..8000_u16 {
            counts[choice.pick((f32::from(i) + 0.5) / 8000.0)] += 1;
        }
        assert_eq!(counts, [1000, 2000, 5000], "of 8000 evenly spaced u");
        assert_eq!([0, 1, 2].map(|i| choice.pmf(i)), [0.125, 0.25, 0.625], "the pmf");
    }
}
