//! One number for the error of a picture.

/// relMSE = mean over pixels and channels of (x − ref)² / (ref² + 0.01).
///
/// Infinite if a value is not finite. To compare it with a renderer's true error, subtract the
/// reference's own expected relMSE.
///
/// # Panics
/// If the pictures are not of the same size, or are empty.
#[must_use]
pub fn relative_mean_squared_error(picture: &[[f32; 3]], reference: &[[f32; 3]]) -> f64 {
    let [a, b] = [picture.as_flattened(), reference.as_flattened()];
    assert!(a.len() == b.len() && !a.is_empty(), "{} and {} values", a.len(), b.len());
    let errors = a.iter().zip(b).map(|(&a, &b)| {
        let [a, b] = [f64::from(a), f64::from(b)];
        (a - b) * (a - b) / (b * b + 0.01)
    });
    let mean = errors.sum::<f64>() / a.len() as f64;
    if mean.is_nan() { f64::INFINITY } else { mean }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.5² / (1² + 0.01) in one channel, nothing in the others.
    #[test]
    fn relative_mean_squared_error_is_its_formula() {
        let error = relative_mean_squared_error(&[[1.5, 0.0, 2.0]], &[[1.0, 0.0, 2.0]]);
        assert!((error - 0.25 / 1.01 / 3.0).abs() < 1e-15, "relMSE = {error}");
    }

    /// A picture with a NaN is infinitely wrong, and no limit lets it pass.
    #[test]
    fn nan_is_no_small_error() {
        let error = relative_mean_squared_error(&[[f32::NAN, 0.0, 0.0]], &[[1.0, 0.0, 0.0]]);
        assert!(error.is_infinite(), "relMSE = {error}");
    }
}
