//! The sRGB curve between linear light and the bytes of a picture, exactly and by table.
//!
//! ```text
//! c = 12.92 L                      for L ≤ 0.0031308,
//! c = 1.055 L^(1/2.4) − 0.055      above,               byte = ⌊255 c + ½⌋
//! ```
//!
//! IEC 61966-2-1. The tables are computed once with the pinned `libm`, hence the same everywhere.

use std::sync::LazyLock;

/// What a pixel that is not a number looks like: magenta, which nobody takes for a result.
pub const NOT_A_NUMBER: [u8; 3] = [255, 0, 255];

// ANCHOR: thresholds
/// `THRESHOLDS[k]` is the smallest linear value whose byte is k + 1.
///
/// Looking a value up in them is as exact as the formula in infinite precision, and cannot fail to
/// be monotone.
static THRESHOLDS: LazyLock<[f32; 255]> =
    LazyLock::new(|| std::array::from_fn(|k| at_least(linear((k as f64 + 0.5) / 255.0))));
// ANCHOR_END: thresholds

/// The linear value of each byte.
static LINEAR: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| linear(byte as f64 / 255.0) as f32));

// ANCHOR: encode
/// The byte of a linear value: 0 below 0, 255 above 1; also 0 for NaN, but see [`encode_pixel`].
#[must_use]
pub fn encode(value: f32) -> u8 {
    // At most 255 thresholds lie below any value.
    THRESHOLDS.partition_point(|&threshold| threshold <= value) as u8
}
// ANCHOR_END: encode

/// The three bytes of a pixel; [`NOT_A_NUMBER`] if one of its values is NaN.
#[must_use]
pub fn encode_pixel(pixel: [f32; 3]) -> [u8; 3] {
    if pixel.iter().any(|value| value.is_nan()) { NOT_A_NUMBER } else { pixel.map(encode) }
}

/// The linear value of a byte, in [0, 1].
#[must_use]
pub fn decode(byte: u8) -> f32 {
    LINEAR[usize::from(byte)]
}

/// The linear value of c ∈ [0, 1]: the curve read backwards.
fn linear(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
}

/// The smallest f32 that is not below `value`.
fn at_least(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}

#[cfg(test)]
mod tests {
    use super::{NOT_A_NUMBER, decode, encode, encode_pixel};

    /// The byte by formula, in f64, before rounding.
    fn by_formula(value: f64) -> f64 {
        let c = if value <= 0.003_130_8 {
            12.92 * value
        } else {
            1.055 * libm::pow(value, 1.0 / 2.4) - 0.055
        };
        255.0 * c
    }

    /// accuracy.md G1.
    #[test]
    fn known_values_have_their_bytes() {
        let bytes = [0.0, 0.003_130_8, 0.18, 0.5, 1.0].map(encode);
        assert_eq!(bytes, [0, 10, 118, 188, 255], "bytes of 0, .0031308, .18, .5, 1");
    }

    /// accuracy.md G2.
    #[test]
    fn every_byte_survives_decoding_and_encoding() {
        for byte in 0..=255 {
            assert_eq!(encode(decode(byte)), byte, "byte {byte}, linear {}", decode(byte));
        }
    }

    /// accuracy.md G3.
    #[test]
    fn values_out_of_range_are_clamped_and_nan_is_magenta() {
        let bytes = [-1.0, f32::NEG_INFINITY, 1e30, f32::INFINITY].map(encode);
        assert_eq!(bytes, [0, 0, 255, 255], "bytes of −1, −∞, 1e30, ∞");
        assert_eq!(encode_pixel([0.5, f32::NAN, 0.5]), NOT_A_NUMBER, "a pixel with a NaN");
    }

    /// accuracy.md G4.
    #[test]
    fn the_neighbours_of_one_are_white() {
        let bytes = [1.0_f32.next_down(), 1.0, 1.0_f32.next_up()].map(encode);
        assert_eq!(bytes, [255; 3], "bytes around 1");
    }

    /// accuracy.md G7.
    #[test]
    fn a_ramp_is_monotone_uses_every_byte_and_is_half_a_byte_off_at_most() {
        let (mut used, mut previous) = ([false; 256], 0);
        for step in 0..=65_536 {
            let value = step as f32 / 65_536.0;
            let byte = encode(value);
            let error = (f64::from(byte) - by_formula(f64::from(value))).abs();
            assert!(byte >= previous, "{value}: {byte} after {previous}");
            assert!(error <= 0.5 + 1e-6, "{value}: {byte} is off by {error}");
            used[usize::from(byte)] = true;
            previous = byte;
        }
        let unused = used.iter().filter(|&&used| !used).count();
        assert_eq!(unused, 0, "bytes that never occur");
    }
}
