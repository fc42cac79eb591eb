//! Which pixels need more samples than others.

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::spread::Spread;

/// How far the neighbours of a pixel are, in each direction: 24 are enough for a median that hardly
/// moves, and few enough that what they show is still what the pixel shows.
const REACH: usize = 2;

/// How many pixels one thread looks at in a row, at least: fewer are not worth handing out.
const CHUNK: usize = 1 << 12;

/// What is kept of a pixel under `--error`, besides its samples.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Need {
    /// Of the samples that all pixels take alike.
    spread: Spread,
    /// How many of those were finite.
    finite: u32,
    /// How many samples the pixel should hold in all.
    pub(crate) wanted: u32,
}

impl Need {
    /// Adds a finite sample of those that all pixels take alike.
    #[inline]
    pub(crate) fn add(&mut self, sample: [f32; 3]) {
        self.spread.add(self.finite, sample);
        self.finite += 1;
    }

    /// The relative variance of one sample; `None` if there are too few to tell.
    pub(crate) fn relative_variance(&self) -> Option<f64> {
        let [of_mean, _] = self.spread.relative_variances(self.finite)?;
        Some(of_mean * f64::from(self.finite))
    }
}

// ANCHOR: need
/// How many samples each pixel needs, in any unit, from the relative variances vⱼ of one sample in
/// each pixel, row by row (NaN where it is not known).
///
/// ```text
/// nᵢ ∝ √vᵢ,   vᵢ = median of vⱼ over the neighbours j ≠ i
/// ```
///
/// The relMSE Σ vᵢ/nᵢ of a given number Σ nᵢ of samples is least where no sample would do more good
/// in another pixel: vᵢ/nᵢ² is the same everywhere \[Neyman34]. Two things make the rule safe:
///
/// - *A pixel has no say in its own number.* Its number then knows nothing of its samples, and their
///   mean is right whatever the number is. A pixel that decided for itself would stop while it happens
///   not to have met its rare bright samples, and be too dark.
/// - *A median*, since one sample that is a thousand times as bright as others, met by one of 24
///   neighbours, is chance. A mean would send the samples after it.
pub(crate) fn needs(variances: &[f64], width: usize) -> Vec<f64> {
    let height = variances.len() / width;
    let need = |i: usize| {
        let (x, y) = (i % width, i / width);
        let mut neighbours = [0.0; (2 * REACH + 1) * (2 * REACH + 1)];
        let mut count = 0;
        for near_y in y.saturating_sub(REACH)..(y + REACH + 1).min(height) {
            for near_x in x.saturating_sub(REACH)..(x + REACH + 1).min(width) {
                let j = near_y * width + near_x;
                if j != i && !variances[j].is_nan() {
                    neighbours[count] = variances[j];
                    count += 1;
                }
            }
        }
        let known = &mut neighbours[..count];
        if known.is_empty() {
            return 0.0;
        }
        let (_, median, _) = known.select_nth_unstable_by(count / 2, f64::total_cmp);
        median.sqrt()
    };
    (0..variances.len()).into_par_iter().with_min_len(CHUNK).map(need).collect()
}
// ANCHOR_END: need

/// How many samples each pixel should hold, so that they are `total` in all, in proportion to its
/// need: at least those that it holds, at most `most`.
///
/// No more than `total`, and fewer by a fraction of a sample a pixel, or if those that need more may
/// not hold more. Where nobody needs anything, all get alike.
pub(crate) fn shares(needs: &[f64], held: &[u32], total: u64, most: u32) -> Vec<u32> {
    let nobody = needs.iter().all(|&need| need == 0.0);
    let share = |i: usize, unit: f64| {
        let need = if nobody { 1.0 } else { needs[i] };
        // Beyond the largest u32, the cast stops there.
        ((unit * need) as u32).min(most).max(held[i])
    };
    let pixels = || (0..held.len()).into_par_iter().with_min_len(CHUNK);
    // Whole numbers: their sum does not depend on its order.
    let sum = |unit: f64| pixels().map(|i| u64::from(share(i, unit))).sum::<u64>();

    if sum(f64::INFINITY) <= total {
        return pixels().map(|i| share(i, f64::INFINITY)).collect();
    }
    // The largest unit whose shares are not too many lies between two powers of two, and is narrowed
    // down to the precision of a double.
    let (mut low, mut high) = (0.0, 1.0);
    while sum(high) <= total {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (low + high);
        if sum(middle) <= total {
            low = middle;
        } else {
            high = middle;
        }
    }
    pixels().map(|i| share(i, low)).collect()
}

#[cfg(test)]
mod tests {
    use super::{needs, shares};

    const WIDTH: usize = 12;

    /// Variances that differ from pixel to pixel: 1 on the left, 16 on the right, a little more or
    /// less.
    fn variances() -> Vec<f64> {
        (0..WIDTH * 9)
            .map(|i| {
                let variance = if i % WIDTH < WIDTH / 2 { 1.0 } else { 16.0 };
                variance * (1.0 + 0.01 * ((7 * i) % 11) as f64)
            })
            .collect()
    }

    #[test]
    fn the_need_is_the_root_of_the_median_of_the_neighbours() {
        let needs = needs(&variances(), WIDTH);
        for (i, need) in needs.iter().enumerate() {
            // Two columns from the border and beyond, all neighbours are of one kind.
            let ratio = match i % WIDTH {
                0..4 => need / 1.0,
                8.. => need / 4.0,
                _ => continue,
            };
            assert!((1.0..1.06).contains(&ratio), "pixel {i} needs {need}");
        }
    }

    #[test]
    fn a_pixel_has_no_say_in_its_own_number() {
        let before = needs(&variances(), WIDTH);
        for (i, &need) in before.iter().enumerate() {
            for own in [0.0, 1e6, f64::NAN] {
                let mut changed = variances();
                changed[i] = own;
                let after = needs(&changed, WIDTH)[i];
                assert_eq!(after, need, "the need of pixel {i} whose own variance is {own}");
            }
        }
    }

    #[test]
    fn one_bright_sample_moves_no_neighbour() {
        let mut variances = vec![1.0; WIDTH * 9];
        variances[4 * WIDTH + 5] = 1e9;
        assert_eq!(needs(&variances, WIDTH), vec![1.0; WIDTH * 9], "needs around it");
    }

    #[test]
    fn pixels_without_neighbours_that_tell_anything_need_nothing() {
        assert_eq!(needs(&[5.0], 1), [0.0], "a single pixel");
        assert_eq!(needs(&[f64::NAN; 9], 3), [0.0; 9], "no finite sample anywhere");
        assert_eq!(needs(&[4.0, f64::NAN, 9.0], 3), [3.0, 3.0, 2.0], "one row");
    }

    #[test]
    fn all_samples_are_shared_out_in_proportion() {
        let found = shares(&[1.0, 2.0, 5.0, 0.0], &[0; 4], 800, 1000);
        assert_eq!(found, [100, 200, 500, 0], "800 samples");
        // Three in proportion 1 : 2 : 5, one holds 200 already: 600 are left for the others.
        let found = shares(&[1.0, 2.0, 5.0, 1.0], &[10, 10, 10, 200], 800, 1000);
        assert_eq!(found, [75, 150, 375, 200], "with 200 held by one that needs few");
        let found = shares(&[1.0, 2.0, 5.0, 1.0], &[10; 4], 800, 250);
        assert_eq!(found, [150, 250, 250, 150], "with at most 250 each");
        assert_eq!(shares(&[0.0; 3], &[4; 3], 60, 100), [20; 3], "nobody needs anything");
    }

    #[test]
    fn no_more_are_shared_out_than_there_are() {
        for total in [100, 1000, 12_345, 1 << 36] {
            let (held, needs) = (vec![1; 108], needs(&variances(), WIDTH));
            let found = shares(&needs, &held, total, u32::MAX);
            let sum: u64 = found.iter().map(|&n| u64::from(n)).sum();
            let least = total.saturating_sub(108);
            assert!((least..=total.max(108)).contains(&sum), "{sum} of {total}");
        }
        assert_eq!(shares(&[1.0, 1e-300], &[2, 2], 1 << 20, 64), [64, 64], "enough for all");
        assert_eq!(shares(&[1.0, 0.0], &[2, 2], 1 << 20, 64), [64, 2], "one needs none");
    }
}
