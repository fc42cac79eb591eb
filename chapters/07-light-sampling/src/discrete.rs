//! One of several, in proportion to weights.

/// A distribution over the numbers 0 to n − 1.
#[derive(Clone, Debug)]
pub struct Discrete {
    /// pmf of each number.
    pmf: Vec<f32>,
    /// The sums of the pmf up to and with each number; the last one is 1.
    cumulative: Vec<f32>,
}

/// A uniform number is a multiple of 1 / STEPS, and so is every probability here.
const STEPS: f64 = 16_777_216.0;

impl Discrete {
    /// Numbers in proportion to `weights`, which are finite, not negative, and not all 0 if there are
    /// any; at most 2²⁴ of them are above 0.
    ///
    /// A uniform number is one of 2²⁴, so the probabilities are whole numbers of 2⁻²⁴: rounded, but
    /// to 1 at least where the weight is not 0. They are what [`Discrete::pick`] does, exactly. With
    /// a pmf of 10⁻⁹ instead, a number would come never, or 60 times as often as it says.
    #[must_use]
    pub fn new(weights: &[f64]) -> Self {
        let total: f64 = weights.iter().sum();
        debug_assert!(weights.is_empty() || (total > 0.0 && total.is_finite()), "total {total}");
        let least = |i: usize| if weights[i] > 0.0 { 1.0 } else { 0.0 };
        let (mut sum, mut end) = (0.0, 0.0);
        let mut ends = Vec::with_capacity(weights.len());
        for (i, weight) in weights.iter().enumerate() {
            sum += weight;
            // Without a weight of its own, a number ends where the one before does.
            end = if *weight > 0.0 { (sum / total * STEPS).round().max(end + 1.0) } else { end };
            ends.push(end);
            debug_assert!(end >= least(i), "number {i} ends at {end}");
        }
        // Those after it may have pushed a number too far, and the last one ends at 1.
        let mut most = STEPS;
        for (i, end) in ends.iter_mut().enumerate().rev() {
            *end = end.min(most);
            most = *end - least(i);
        }
        if let Some(last) = weights.iter().rposition(|&weight| weight > 0.0) {
            ends[last..].fill(STEPS);
        }
        let starts = [0.0].into_iter().chain(ends.iter().copied());
        let pmf = starts.zip(&ends).map(|(start, end)| ((end - start) / STEPS) as f32).collect();
        Self { pmf, cumulative: ends.iter().map(|end| (end / STEPS) as f32).collect() }
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
    use super::Discrete;

    /// accuracy.md M12.
    #[test]
    fn an_entry_without_weight_is_never_chosen() {
        let largest = 1.0_f32.next_down();
        let weights = [0.0, 1.0, 0.0, 3.0, 0.0, 1e-30, 0.0];
        let discrete = Discrete::new(&weights);
        for i in 0..=10_000_u16 {
            let u = (f32::from(i) / 10_000.0).min(largest);
            let picked = discrete.pick(u);
            assert!(weights[picked] > 0.0, "u = {u} picks {picked}");
        }
        assert_eq!(discrete.pick(0.0), 1, "the smallest u");
        assert_eq!(discrete.pick(largest), 5, "the largest u");
    }

    #[test]
    fn numbers_come_in_proportion_to_their_weights() {
        let discrete = Discrete::new(&[1.0, 2.0, 5.0]);
        let mut counts = [0; 3];
        for i in 0..8000_u16 {
            counts[discrete.pick((f32::from(i) + 0.5) / 8000.0)] += 1;
        }
        assert_eq!(counts, [1000, 2000, 5000], "of 8000 evenly spaced u");
        assert_eq!([0, 1, 2].map(|i| discrete.pmf(i)), [0.125, 0.25, 0.625], "the pmf");
    }

    /// All 2²⁴ uniform numbers, counted: what is drawn is what the pmf says, even where a weight is
    /// less than a billionth of the others, at the start, in between and at the end.
    #[test]
    fn the_pmf_is_how_many_uniform_numbers_pick_a_number() {
        let tiny = 1e-12;
        for weights in [
            vec![tiny, 1.0, tiny, tiny, 0.3, 0.0, tiny],
            vec![1.0, tiny, tiny, tiny],
            vec![tiny; 5],
            vec![1.0 / 3.0; 3],
        ] {
            let discrete = Discrete::new(&weights);
            let mut counts = vec![0_u32; weights.len()];
            for i in 0..1_u32 << 24 {
                counts[discrete.pick(i as f32 / 16_777_216.0)] += 1;
            }
            for (number, (count, weight)) in counts.iter().zip(&weights).enumerate() {
                let pmf = discrete.pmf(number);
                assert_eq!(*count as f32 / 16_777_216.0, pmf, "number {number} of {weights:?}");
                assert_eq!(pmf > 0.0, *weight > 0.0, "number {number} of {weights:?}: {pmf}");
            }
        }
    }
}
