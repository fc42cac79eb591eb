//! Units in the last place, and floats as exact bits.

use glam::Vec3;
use ray_casting::Ray;

/// u of single precision, 2⁻²⁴: the largest relative error of one rounding.
pub const U: f64 = 1.0 / 16_777_216.0;

/// The distance from |`x`| to the next larger `f32`.
#[inline]
#[must_use]
pub fn ulp(x: f32) -> f64 {
    f64::from(x.abs().next_up()) - f64::from(x.abs())
}

/// How many units in the last place of `exact` the float `x` is off; NaN if one of them is.
#[inline]
#[must_use]
pub fn ulps(x: f32, exact: f64) -> f64 {
    (f64::from(x) - exact).abs() / ulp(exact as f32)
}

/// γ(n) = n u / (1 − n u), in double precision.
#[inline]
#[must_use]
pub fn gamma(n: u32) -> f64 {
    let nu = f64::from(n) * U;
    nu / (1.0 - nu)
}

/// A float as Rust that gives back its bits.
#[must_use]
pub fn float(x: f32) -> String {
    format!("f32::from_bits({:#010x}) /* {x:e} */", x.to_bits())
}

/// A vector likewise.
#[must_use]
pub fn vec3(v: Vec3) -> String {
    let [x, y, z] = v.to_array().map(|x| format!("{:#010x}", x.to_bits()));
    format!("Vec3::from([{x}, {y}, {z}].map(f32::from_bits)) /* {v} */")
}

/// A ray likewise.
#[must_use]
pub fn ray(ray: &Ray) -> String {
    let extent = format!("Interval::new({}, {})", float(ray.extent.min), float(ray.extent.max));
    let (origin, direction) = (vec3(ray.origin), vec3(ray.direction));
    let from = match ray.origin_primitive {
        Ray::NO_PRIMITIVE => String::new(),
        primitive => format!("origin_primitive: {primitive}, "),
    };
    format!("Ray {{ extent: {extent}, {from}..Ray::new({origin}, {direction}) }}")
}

#[cfg(test)]
mod tests {
    use super::{float, ulp, ulps};

    #[test]
    fn a_unit_in_the_last_place_is_the_step_to_the_next_float() {
        assert!((ulp(1.0) - 2.0_f64.powi(-23)).abs() < 1e-30, "{:e}", ulp(1.0));
        assert!((ulps(1.0_f32.next_up(), 1.0) - 1.0).abs() < 1e-12, "one step is not 1 ULP");
        assert!(ulps(f32::NAN, 1.0).is_nan(), "NaN is some ULP off");
    }

    #[test]
    fn bits_are_rust() {
        assert_eq!(float(1.0), "f32::from_bits(0x3f800000) /* 1e0 */", "the bits of 1");
    }
}
