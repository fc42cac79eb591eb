//! The two ways to count directions: by solid angle, and by the area they lead to.
//!
//! ```text
//! dω = |cos θ'| / r² dA
//! ```
//!
//! A small patch dA at distance r, tilted by θ' against the ray, covers the solid angle dω. A
//! density is per unit of *something*: the same choice of a direction has one value per steradian
//! and another per square metre, and to mix the two is to be wrong by dω/dA (errata 17).

use glam::Vec3;

// ANCHOR: conversion
/// The density per steradian of a choice that has the density `pdf_area` per unit area.
///
/// ```text
/// p_ω = p_A r² / |cos θ'|
/// ```
///
/// θ' is the angle at the far end, between the ray and the normal there; `cos_theta` is not 0.
#[inline]
#[must_use]
pub fn pdf_solid_angle(pdf_area: f32, distance_squared: f32, cos_theta: f32) -> f32 {
    pdf_area * distance_squared / cos_theta.abs()
}

/// The density per unit area of a choice that has the density `pdf_solid_angle` per steradian.
///
/// ```text
/// p_A = p_ω |cos θ'| / r²
/// ```
#[inline]
#[must_use]
pub fn pdf_area(pdf_solid_angle: f32, distance_squared: f32, cos_theta: f32) -> f32 {
    pdf_solid_angle * cos_theta.abs() / distance_squared
}
// ANCHOR_END: conversion

// ANCHOR: geometry-term
/// G of the area form of the rendering equation, in 1/m², for two points that see each other.
///
/// ```text
/// G(x', x'') = |cos θ'| |cos θ''| / r²
/// ```
///
/// Visibility, the V of the book, is the caller's: it takes a ray. The normals are unit vectors.
#[inline]
#[must_use]
pub fn geometry_term(from: Vec3, from_normal: Vec3, to: Vec3, to_normal: Vec3) -> f32 {
    let path = to - from;
    let distance_squared = path.length_squared();
    let cosines = from_normal.dot(path).abs() * to_normal.dot(path).abs();
    cosines / (distance_squared * distance_squared)
}
// ANCHOR_END: geometry-term

#[cfg(test)]
mod tests {
    use super::{geometry_term, pdf_area, pdf_solid_angle};
    use glam::Vec3;

    #[test]
    fn the_two_conversions_undo_each_other() {
        for (distance, cos) in [(1.0_f32, 1.0), (3.0, -0.25), (1e-3, 1e-3), (1e4, 0.7)] {
            let there = pdf_solid_angle(0.5, distance * distance, cos);
            let back = pdf_area(there, distance * distance, cos);
            assert!((back - 0.5).abs() < 1e-6, "r = {distance}, cos θ' = {cos}: {back}");
        }
    }

    /// A patch of 1 mm² at 1 m, seen head on, covers 10⁻⁶ sr: a uniform choice on it has the density
    /// 10⁶ per steradian and 10⁶ per square metre; at 2 m it covers a quarter.
    #[test]
    fn a_far_patch_is_denser_in_solid_angle() {
        assert_eq!(pdf_solid_angle(1e6, 1.0, 1.0), 1e6, "at 1 m");
        assert_eq!(pdf_solid_angle(1e6, 4.0, 1.0), 4e6, "at 2 m");
        assert_eq!(pdf_solid_angle(1e6, 4.0, -0.5), 8e6, "at 2 m, tilted by 60°, from behind");
    }

    /// The unit square over its own copy at distance 1, by a midpoint rule: the form factor
    /// ∬ G / π is 0.199825 (Howell's catalogue, C-11).
    #[test]
    fn the_geometry_term_gives_the_form_factor_of_two_squares() {
        let n: u16 = 20;
        let at = |i: u16| (f32::from(i) + 0.5) / f32::from(n);
        let mut sum = 0.0_f64;
        for (a, b) in (0..n).flat_map(|a| (0..n).map(move |b| (a, b))) {
            for (c, d) in (0..n).flat_map(|c| (0..n).map(move |d| (c, d))) {
                let (from, to) = (Vec3::new(at(a), 0.0, at(b)), Vec3::new(at(c), 1.0, at(d)));
                sum += f64::from(geometry_term(from, Vec3::Y, to, Vec3::NEG_Y));
            }
        }
        let factor = sum / f64::from(n).powi(4) / std::f64::consts::PI;
        assert!((factor - 0.199_825).abs() < 2e-4, "F = {factor}");
    }
}
