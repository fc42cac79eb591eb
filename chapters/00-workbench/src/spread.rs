//! How far the samples of a pixel lie apart.

/// Added to the square of a mean before an error is divided by it: below a radiance of a tenth,
/// errors count almost as they are, so that black pixels do not count infinitely. The 0.01 of the
/// usual relMSE.
pub(crate) const FLOOR: f64 = 0.01;

/// How many standard errors are believable: a normal quantity is further off, on one side, in 2.3 %
/// of all cases.
pub(crate) const STANDARD_ERRORS: f64 = 2.0;

/// The fewest finite samples that tell a pixel's error: two in each half.
pub(crate) const FEWEST: u32 = 4;

/// Sum and spread of half of a pixel's samples, for each channel.
#[derive(Clone, Copy, Debug, Default)]
struct Half {
    /// S = Σ x.
    sum: [f64; 3],
    /// M = Σ (x − S/n)².
    squares: [f64; 3],
}

impl Half {
    // ANCHOR: spread
    /// Adds a sample to the `count` ones that are here.
    ///
    /// ```text
    /// Mₙ₊₁ = Mₙ + (n x − Sₙ)² / (n (n + 1))
    /// ```
    ///
    /// After Youngs and Cramer 1971. No large numbers are subtracted from each other as in
    /// Σ x² − S²/n. While n x is exact, as for every f32 x up to n = 2²⁹, samples that agree have
    /// M = 0 to the last bit.
    #[inline]
    fn add(&mut self, count: u32, sample: [f64; 3]) {
        let n = f64::from(count);
        // Without samples, n x − S is 0, whatever it is multiplied by.
        let weight = 1.0 / (n.max(1.0) * (n + 1.0));
        for ((sum, squares), x) in self.sum.iter_mut().zip(&mut self.squares).zip(sample) {
            let difference = n * x - *sum;
            *squares += difference * difference * weight;
            *sum += x;
        }
    }
    // ANCHOR_END: spread
}

/// How far the samples of a pixel lie apart, the even ones and the odd ones by themselves.
///
/// Two halves, because an error is divided by the brightness of its pixel: a rare bright sample
/// makes its pixel's mean bright and its spread wide, and divided by each other the two hide that
/// the other pixels, which wait for such a sample, are wrong. One half's spread and the other's
/// mean know nothing of each other.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spread([Half; 2]);

impl Spread {
    /// Adds the sample that follows `count` finite ones.
    #[inline]
    pub(crate) fn add(&mut self, count: u32, sample: [f32; 3]) {
        self.0[(count % 2) as usize].add(count / 2, sample.map(f64::from));
    }

    /// The variance of the mean of `count` samples, s²/n for each channel; NaN below 2 samples.
    pub(crate) fn variance_of_mean(&self, count: u32) -> [f64; 3] {
        if count < 2 {
            return [f64::NAN; 3];
        }
        let ([a, b], [n_a, n_b]) = (&self.0, halves(count));
        let n = f64::from(count);
        [0, 1, 2].map(|c| {
            let apart = a.sum[c] / n_a - b.sum[c] / n_b;
            let squares = a.squares[c] + b.squares[c] + apart * apart * (n_a * n_b / n);
            squares / (n - 1.0) / n
        })
    }

    // ANCHOR: relative-variance
    /// The pixel's part of the expected relMSE, its mean over the channels: once with the brightness
    /// that was found, and once with the least that is believable.
    ///
    /// ```text
    /// v = ½ [s²₀ / (m₁² + 0.01) + s²₁ / (m₀² + 0.01)] / n
    /// ```
    ///
    /// with s² and m of the even samples (0) and of the odd ones (1). In the second value, each m
    /// is less by two of its standard errors, and at least 0: a pixel that happened to meet its rare
    /// bright light in *both* halves takes itself for bright. `None` below four samples.
    pub(crate) fn relative_variances(&self, count: u32) -> Option<[f64; 2]> {
        if count < FEWEST {
            return None;
        }
        let n = halves(count);
        let variance = |half: usize, c: usize| self.0[half].squares[c] / (n[half] - 1.0);
        let mean = |half: usize, c: usize| self.0[half].sum[c] / n[half];
        let doubt = |half, c| STANDARD_ERRORS * f64::sqrt(variance(half, c) / n[half]);
        let mut sums = [0.0; 2];
        for (one, other) in [(0, 1), (1, 0)] {
            for c in 0..3 {
                let brightest = mean(other, c);
                let darkest = f64::max(brightest - doubt(other, c), 0.0);
                sums[0] += variance(one, c) / (brightest * brightest + FLOOR);
                sums[1] += variance(one, c) / (darkest * darkest + FLOOR);
            }
        }
        Some(sums.map(|sum| sum / 6.0 / f64::from(count)))
    }
    // ANCHOR_END: relative-variance
}

/// How many of `count` samples are even, and how many odd.
fn halves(count: u32) -> [f64; 2] {
    [f64::from(count.div_ceil(2)), f64::from(count / 2)]
}

#[cfg(test)]
mod tests {
    use super::{FLOOR, Spread};
    use crate::Sampler;

    fn spread(samples: &[f32]) -> Spread {
        let mut spread = Spread::default();
        for (count, &x) in (0..).zip(samples) {
            spread.add(count, [x, 2.0 * x, 0.0]);
        }
        spread
    }

    /// s² of `samples` in two passes.
    fn variance(samples: &[f64]) -> f64 {
        let n = samples.len() as f64;
        let mean = samples.iter().sum::<f64>() / n;
        samples.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0)
    }

    #[test]
    fn the_variance_is_that_of_two_passes_even_far_from_zero() {
        for (offset, n) in [(0.0, 2), (0.0, 3), (0.0, 1000), (1e4, 1001), (-1e6, 500)] {
            let mut sampler = Sampler::new(3, 0, n);
            let samples: Vec<f32> = (0..n).map(|_| offset + sampler.next_1d()).collect();
            let exact: Vec<f64> = samples.iter().copied().map(f64::from).collect();
            let expected = variance(&exact) / n as f64;
            let found = spread(&samples).variance_of_mean(n as u32);
            assert!(
                (found[0] - expected).abs() <= 1e-10 * expected,
                "{n} samples around {offset}: {found:?}, two passes {expected}"
            );
            assert!((found[1] - 4.0 * expected).abs() <= 4e-10 * expected, "twice: {found:?}");
            assert_eq!(found[2], 0.0, "the black channel");
        }
    }

    #[test]
    fn samples_that_agree_have_no_variance_at_all() {
        for value in [0.1, 1.0 / 3.0, 17.0, 1e-30, 1e30, -0.7, f32::MAX] {
            let mut spread = Spread::default();
            for count in 0..10_000 {
                spread.add(count, [value; 3]);
                let variance = spread.variance_of_mean(count + 1);
                assert!(count == 0 || variance == [0.0; 3], "{variance:?} of {value}s");
            }
            let relative = spread.relative_variances(10_000);
            assert_eq!(relative, Some([0.0; 2]), "of 10 000 times {value}");
        }
    }

    #[test]
    fn the_relative_variance_divides_each_half_by_the_other() {
        let spread = spread(&[1.0, 2.0, 3.0, 6.0, 5.0]);
        // Even: 1, 3, 5 with m = 3, s² = 4. Odd: 2, 6 with m = 4, s² = 8. The second channel is
        // twice the first, the third black.
        let first = 4.0 / (16.0 + FLOOR) + 8.0 / (9.0 + FLOOR);
        let second = 16.0 / (64.0 + FLOOR) + 32.0 / (36.0 + FLOOR);
        let expected = (first + second) / 2.0 / 3.0 / 5.0;
        let [found, _] = spread.relative_variances(5).expect("five samples are enough");
        assert!((found - expected).abs() < 1e-15, "{found}, by hand {expected}");
    }

    #[test]
    fn the_second_relative_variance_divides_by_the_least_believable_brightness() {
        let spread = spread(&[1.0, 2.0, 3.0, 6.0, 5.0]);
        // 3 − 2 √(4/3) = 0.6906, and 4 − 2 √(8/2) = 0; the second channel is twice the first.
        let least = 3.0 - 2.0 * f64::sqrt(4.0 / 3.0);
        let first = 4.0 / FLOOR + 8.0 / (least * least + FLOOR);
        let second = 16.0 / FLOOR + 32.0 / (4.0 * least * least + FLOOR);
        let expected = (first + second) / 2.0 / 3.0 / 5.0;
        let [_, found] = spread.relative_variances(5).expect("five samples are enough");
        assert!((found / expected - 1.0).abs() < 1e-12, "{found}, by hand {expected}");
    }

    /// A pixel at the edge of the lamp, as the Cornell box has two at 8 × 8 pixels: one sample in 200
    /// is as bright as the lamp. Here each half has met one in 32.
    #[test]
    fn rare_light_that_both_halves_have_met_is_not_taken_for_brightness() {
        let mut samples = [0.07; 64];
        (samples[10], samples[33]) = (17.0, 17.0);
        let truth = 0.07 + 17.0 / 200.0;
        let mean = (62.0 * 0.07 + 2.0 * 17.0) / 64.0;
        let error = (mean - truth) * (mean - truth) / (truth * truth + FLOOR);
        let [likely, cautious] = spread(&samples).relative_variances(64).expect("64 samples");
        let margin = 1.0 + 8.0_f64.sqrt();
        assert!(margin * likely < error, "{likely} would do, the error is {error}");
        assert!(margin * cautious > error, "{cautious} does not do, the error is {error}");
    }

    #[test]
    fn the_second_relative_variance_is_never_the_smaller_one() {
        for seed in 0..1000 {
            let mut sampler = Sampler::new(seed, 0, 0);
            let mut samples = [0.0; 16];
            for sample in &mut samples {
                *sample = if sampler.next_1d() < 0.2 { 17.0 } else { sampler.next_1d() };
            }
            let [likely, cautious] = spread(&samples).relative_variances(16).expect("16 samples");
            assert!(likely <= cautious, "{likely} and {cautious} of {samples:?}");
        }
    }

    #[test]
    fn too_few_samples_tell_nothing() {
        assert_eq!(spread(&[1.0, 2.0, 1.0]).relative_variances(3), None, "three samples");
        let variance = spread(&[1.0]).variance_of_mean(1);
        assert!(variance[0].is_nan(), "one sample has the variance {variance:?}");
    }
}
