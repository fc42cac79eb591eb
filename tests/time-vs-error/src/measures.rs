//! Numbers for the error of a picture.

use workbench::Image;

use crate::truth::Truth;

/// The errors of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// √ of the mean over pixels and channels of (x − r)².
    pub rmse: f64,
    /// relMSE without the share of the reference's own noise; may fall below 0 by chance.
    pub rel_mse: f64,
    /// The same without the worst pixels, see [`trimmed_rel_mse`].
    pub trimmed: f64,
    /// The mean of the picture relative to that of the reference, less 1.
    pub bias: f64,
}

/// The errors of `picture` against `truth`.
///
/// # Panics
/// If the sizes differ.
#[must_use]
pub fn errors(picture: &Image, truth: &Truth) -> Errors {
    let reference = &truth.image;
    let rel_mse = statistics::relative_mean_squared_error(&picture.pixels, &reference.pixels);
    Errors {
        rmse: rmse(&picture.pixels, &reference.pixels),
        rel_mse: rel_mse - truth.own_rel_mse(),
        trimmed: trimmed_rel_mse(&picture.pixels, &reference.pixels, &truth.variance),
        bias: grey_mean(picture) / grey_mean(reference) - 1.0,
    }
}

/// √ of the mean over pixels and channels of (x − r)²; infinite if a value is not finite.
#[must_use]
pub fn rmse(picture: &[[f32; 3]], reference: &[[f32; 3]]) -> f64 {
    let [a, b] = [picture.as_flattened(), reference.as_flattened()];
    let squares = a.iter().zip(b).map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2));
    finite((squares.sum::<f64>() / a.len() as f64).sqrt())
}

/// Without the worst pixels, the mean over pixels and channels of ((x − r)² − σ²) / (r² + 0.01); σ
/// is the reference's standard error.
///
/// One pixel of a thousand is left out, at least one: those in which the sum over the channels of
/// (x − r)² / (r² + 0.01) is largest. A few pixels with an improbable, bright path in them
/// ("fireflies") can make up most of relMSE. Without them the number says how the other pixels
/// fare, and varies far less from seed to seed. It is no estimate of the whole error: a method that
/// has all its error in few pixels looks too good in it.
#[must_use]
pub fn trimmed_rel_mse(picture: &[[f32; 3]], reference: &[[f32; 3]], variance: &[[f32; 3]]) -> f64 {
    let mut pixels: Vec<[f64; 2]> = picture
        .iter()
        .zip(reference)
        .zip(variance)
        .map(|((x, r), v)| {
            let terms = (0..3).map(|c| {
                let [x, r, v] = [x[c], r[c], v[c]].map(f64::from);
                [(x - r) * (x - r), v].map(|square| square / (r * r + 0.01))
            });
            terms.fold([0.0; 2], |sum, term| [sum[0] + term[0], sum[1] + term[1]])
        })
        .collect();
    pixels.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let worst = worst_pixels(pixels.len());
    // What is not a number is no outlier but a fault.
    if pixels.iter().any(|[error, _]| !error.is_finite()) {
        return f64::INFINITY;
    }
    pixels.truncate(pixels.len() - worst);
    let sum: f64 = pixels.iter().map(|[error, own]| error - own).sum();
    sum / (3 * pixels.len()) as f64
}

/// How many pixels are left out of so many: 0.1 %, at least one.
fn worst_pixels(pixels: usize) -> usize {
    ((pixels as f64 / 1000.0).round() as usize).max(1)
}

/// The mean over pixels and channels.
#[must_use]
pub fn grey_mean(image: &Image) -> f64 {
    image.mean().iter().sum::<f64>() / 3.0
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::{errors, grey_mean, rmse, trimmed_rel_mse, worst_pixels};
    use crate::truth::Truth;
    use workbench::Image;

    fn grey(values: &[f32]) -> Image {
        let pixels = values.iter().map(|&v| [v; 3]).collect();
        Image { width: values.len() as u32, height: 1, pixels }
    }

    #[test]
    fn nothing_is_wrong_with_the_right_picture() {
        let truth = Truth::exact(grey(&[0.5, 1.0, 2.0]));
        let found = errors(&truth.image.clone(), &truth);
        assert_eq!([found.rmse, found.rel_mse, found.trimmed, found.bias], [0.0; 4], "{found:?}");
    }

    /// 10 % too bright everywhere: RMSE 0.1, relMSE 0.01/1.01, bias 10 %.
    #[test]
    fn a_constant_factor_is_its_closed_form() {
        let truth = Truth::exact(grey(&[1.0; 8]));
        let found = errors(&grey(&[1.1; 8]), &truth);
        assert!((found.rmse - 0.1).abs() < 1e-7, "RMSE {}", found.rmse);
        assert!((found.rel_mse - 0.01 / 1.01).abs() < 1e-7, "relMSE {}", found.rel_mse);
        assert!((found.trimmed - 0.01 / 1.01).abs() < 1e-7, "trimmed {}", found.trimmed);
        assert!((found.bias - 0.1).abs() < 1e-7, "bias {}", found.bias);
    }

    /// One firefly among a thousand pixels is all of the error, and trimming takes it away.
    #[test]
    fn trimming_drops_the_worst_pixel_of_a_thousand() {
        let mut picture = grey(&[1.0; 1000]);
        picture.pixels[17] = [0.0, 101.0, 1.0];
        picture.pixels[18] = [2.01, 1.0, 1.0];
        let reference = grey(&[1.0; 1000]);
        let whole = statistics::relative_mean_squared_error(&picture.pixels, &reference.pixels);
        let expected = (1.0 + 10_000.0 + 1.01 * 1.01) / 1.01 / 3000.0;
        assert!((whole / expected - 1.0).abs() < 1e-6, "relMSE {whole}, by hand {expected}");
        let none = vec![[0.0; 3]; 1000];
        let trimmed = trimmed_rel_mse(&picture.pixels, &reference.pixels, &none);
        let expected = 1.01 / 2997.0;
        assert!((trimmed / expected - 1.0).abs() < 1e-5, "trimmed {trimmed}, by hand {expected}");
        assert_eq!([1, 999, 1024, 4096, 16384].map(worst_pixels), [1, 1, 1, 4, 16], "how many");
    }

    /// A perfect picture against a noisy reference has the reference's error, which is taken off.
    #[test]
    fn the_noise_of_the_reference_is_taken_off() {
        let mut truth = Truth::exact(grey(&[1.0; 2000]));
        for (i, pixel) in truth.image.pixels.iter_mut().enumerate() {
            *pixel = [if i % 2 == 0 { 1.1 } else { 0.9 }; 3];
        }
        truth.variance = vec![[0.01; 3]; 2000];
        let found = errors(&grey(&[1.0; 2000]), &truth);
        assert!((found.rmse - 0.1).abs() < 1e-7, "RMSE is not corrected: {}", found.rmse);
        assert!(found.rel_mse.abs() < 1e-7, "relMSE {}", found.rel_mse);
        assert!(found.trimmed.abs() < 1e-6, "trimmed {}", found.trimmed);
        assert!(found.bias.abs() < 1e-7, "bias {}", found.bias);
    }

    #[test]
    fn what_is_not_finite_is_infinitely_wrong() {
        let truth = Truth::exact(grey(&[1.0; 4]));
        let found = errors(&grey(&[1.0, f32::NAN, 1.0, 1.0]), &truth);
        assert!(found.rmse == f64::INFINITY, "RMSE {}", found.rmse);
        assert!(found.rel_mse == f64::INFINITY, "relMSE {}", found.rel_mse);
        assert!(found.trimmed == f64::INFINITY, "trimmed {}", found.trimmed);
        assert!(found.bias.is_nan(), "bias {}", found.bias);
        assert!(rmse(&[[f32::INFINITY; 3]], &[[1.0; 3]]) == f64::INFINITY, "infinity");
        assert_eq!(grey_mean(&grey(&[1.0, 3.0])), 2.0, "the mean");
    }
}
