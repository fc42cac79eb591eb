//! The functions beyond + − × ÷ and √, from one pinned library.
//!
//! The standard library's versions differ between platforms in the last bit; `libm` is portable
//! Rust and gives the same bits everywhere. No other file of a chapter calls such a function.

/// sin x and cos x; x in radians.
#[inline]
#[must_use]
pub fn sin_cos(x: f32) -> (f32, f32) {
    libm::sincosf(x)
}

/// tan x; x in radians.
#[inline]
#[must_use]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// sin x and cos x in double precision; x in radians.
#[inline]
#[must_use]
pub fn sin_cos_f64(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// The angle of the point (x, y), in radians, −π to π.
#[inline]
#[must_use]
pub fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2f(y, x)
}

/// arccos x in radians, 0 to π; x in [−1, 1].
#[inline]
#[must_use]
pub fn acos(x: f32) -> f32 {
    libm::acosf(x)
}

/// xᵖ for x in [0, 1] and p ≥ 0; 0⁰ = 1.
///
/// A whole p is reached by squaring, several times faster than through logarithms. In double
/// precision, since each squaring doubles the relative error: at p = 2²⁴ all 24 bits of single
/// precision would be lost.
#[inline]
#[must_use]
pub fn power(x: f32, p: f32) -> f32 {
    const WHOLE: f32 = 33_554_432.0;
    if p > WHOLE || p.fract() != 0.0 {
        return libm::pow(f64::from(x), f64::from(p)) as f32;
    }
    let (mut square, mut rest, mut product) = (f64::from(x), p as u32, 1.0_f64);
    while rest > 0 {
        if rest % 2 == 1 {
            product *= square;
        }
        square *= square;
        rest /= 2;
    }
    product as f32
}

/// xᵖ in double precision, for x in [0, 1] and any p > 0.
#[inline]
#[must_use]
pub fn power_f64(x: f64, p: f64) -> f64 {
    libm::pow(x, p)
}

/// 2ˣ in double precision.
#[inline]
#[must_use]
pub fn exp2_f64(x: f64) -> f64 {
    libm::exp2(x)
}

/// log₂ x in double precision, for x > 0.
#[inline]
#[must_use]
pub fn log2_f64(x: f64) -> f64 {
    libm::log2(x)
}

/// u, half the distance from 1 to the next `f32`: no rounding changes a result by a larger share.
pub const UNIT_ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// γ(n) = n u / (1 − n u): bounds the relative error of n roundings in a row. \[Higham02] §3.1.
#[inline]
#[must_use]
pub const fn gamma(n: u32) -> f32 {
    let nu = n as f32 * UNIT_ROUNDOFF;
    nu / (1.0 - nu)
}

#[cfg(test)]
mod tests {
    use super::gamma;

    #[test]
    fn gamma_agrees_with_its_published_values() {
        for (n, expected) in [(3, 1.788_139_7e-7), (5, 2.980_233_3e-7), (7, 4.172_327e-7)] {
            let difference = (gamma(n) - expected).abs();
            assert!(difference <= 1e-13, "γ({n}) = {:e}, expected {expected:e}", gamma(n));
        }
    }
}
