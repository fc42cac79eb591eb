//! How wrong a picture is likely to be, told from its own samples.

use crate::Image;
use crate::spread::STANDARD_ERRORS;

/// An estimate of the relMSE of a picture, and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LikelyError {
    /// The expected relMSE: the mean of the pixels' relative variances.
    pub(crate) rel_mse: f64,
    /// What must be added to it so that the true relMSE lies below in 95 % of all cases.
    pub(crate) margin: f64,
}

impl LikelyError {
    // ANCHOR: likely-error
    /// The likely error of a picture whose pixels have these relative variances: `v` with the
    /// brightness that was found, `w` with the least that is believable.
    ///
    /// ```text
    /// relMSE = (1/N) Σ v,   relMSE + margin = (1/N) [Σ w + 2 √(2 Σ w²)]
    /// ```
    ///
    /// The true error of a pixel is the square of a mean of deviations, dᵢ dⱼ summed over all pairs
    /// of samples. v and w estimate the pairs with i = j. What they cannot know are the others: their
    /// mean is zero and their variance 2 w², however far the samples stray. They are independent
    /// from pixel to pixel, hence the root of the sum of squares; channels that vary together vary
    /// at most as one. Of a single pixel, 1 + 2 √2 times w is the 95th percentile of χ² with one
    /// degree of freedom; the sum over many pixels tends to a normal distribution, for which two
    /// standard errors hold in 97.7 % of all cases.
    pub(crate) fn of(variances: impl Iterator<Item = [f64; 2]>) -> Option<Self> {
        let mut pixels = 0.0;
        let [mut likely, mut cautious, mut squares] = [0.0; 3];
        for [v, w] in variances {
            pixels += 1.0;
            likely += v;
            cautious += w;
            squares += w * w;
        }
        let largest = cautious + STANDARD_ERRORS * f64::sqrt(2.0 * squares);
        let rel_mse = likely / pixels;
        (pixels > 0.0).then_some(Self { rel_mse, margin: largest / pixels - rel_mse })
    }
    // ANCHOR_END: likely-error

    /// ε, the relative error that a picture states: the root of the largest likely relMSE.
    pub(crate) fn bound(self) -> f64 {
        (self.rel_mse + self.margin).sqrt()
    }
}

/// A picture with what its samples tell of its error, as
/// [`expose_estimate`](crate::expose_estimate) and [`expose_until`](crate::expose_until) return it.
#[derive(Clone, Debug)]
pub struct Estimate {
    /// In each pixel the mean of its samples; NaN where a sample was not finite.
    pub image: Image,
    /// The variance of that mean for each pixel and channel, s²/n, in squared units of the
    /// picture. NaN where a sample was not finite, and everywhere below 2 samples a pixel.
    pub variance_of_mean: Image,
    /// Samples a pixel; where pixels differ, the fewest.
    pub samples: u32,
    /// The samples of each pixel, row by row.
    pub counts: Vec<u32>,
    /// `None` below four samples a pixel, and after a sample that is not finite.
    pub(crate) likely_error: Option<LikelyError>,
}

impl Estimate {
    /// The relative error ε that the picture states, as a fraction of 1: see
    /// [`Film::estimated_error`](crate::Film::estimated_error).
    ///
    /// NaN below four samples a pixel, and if any sample was not finite, so that no test passes
    /// over it.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.likely_error.map_or(f64::NAN, LikelyError::bound)
    }

    /// The expected relMSE, which the true one exceeds about as often as not; NaN like
    /// [`Estimate::relative_error`].
    ///
    /// From a few samples of a dark or rarely lit pixel it is estimated too large rather than too
    /// small.
    #[must_use]
    pub fn rel_mse(&self) -> f64 {
        self.likely_error.map_or(f64::NAN, |error| error.rel_mse)
    }
}

#[cfg(test)]
mod tests {
    use super::LikelyError;

    #[test]
    fn the_bound_of_one_pixel_is_the_95th_percentile_of_chi_square() {
        let error = LikelyError::of([[0.25; 2]].into_iter()).expect("one pixel");
        assert_eq!(error.rel_mse, 0.25, "the relMSE");
        let ratio = error.bound() * error.bound() / 0.25;
        assert!((ratio - 3.8415).abs() < 0.02, "the bound is {ratio} times the variance");
    }

    #[test]
    fn the_margin_shrinks_with_the_number_of_pixels() {
        let of = |pixels| LikelyError::of((0..pixels).map(|_| [1.0; 2])).expect("a picture");
        let [few, many] = [of(100), of(10_000)];
        assert!((few.margin - 0.1 * 8.0_f64.sqrt()).abs() < 1e-12, "{few:?}");
        assert!((few.margin / many.margin - 10.0).abs() < 1e-9, "{few:?} and {many:?}");
    }

    #[test]
    fn doubts_about_the_brightness_are_in_the_margin_alone() {
        let [sure, doubtful] =
            [0.5, 2.0].map(|w| LikelyError::of([[0.5, w]; 9].into_iter()).expect("nine pixels"));
        assert_eq!((sure.rel_mse, doubtful.rel_mse), (0.5, 0.5), "the relMSE");
        let ratio = (doubtful.bound() / sure.bound()).powi(2);
        assert!((ratio - 4.0).abs() < 1e-12, "{sure:?} and {doubtful:?}");
    }

    #[test]
    fn no_pixel_has_no_error_and_agreement_has_error_zero() {
        assert_eq!(LikelyError::of(std::iter::empty()), None, "of nothing");
        let error = LikelyError::of([[0.0; 2]; 4].into_iter()).map(LikelyError::bound);
        assert_eq!(error, Some(0.0), "of pixels without variance");
    }
}
