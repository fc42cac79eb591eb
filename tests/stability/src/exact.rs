//! Exact arithmetic: sums of doubles that are not rounded, for decisions that no rounding may
//! touch.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use glam::Vec3;

/// A number as a sum of doubles that do not overlap, the smallest first: an *expansion*.
///
/// Sums, differences and products of expansions are exact, as long as no term leaves the range of
/// doubles: products of up to six `f32` never do. Shewchuk, "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates" (1997), theorems 10 and 18.
#[derive(Clone, Debug, Default)]
pub struct Exact(Vec<f64>);

impl From<f64> for Exact {
    fn from(x: f64) -> Self {
        let mut sum = Self::default();
        sum.add_double(x);
        sum
    }
}

impl From<f32> for Exact {
    fn from(x: f32) -> Self {
        Self::from(f64::from(x))
    }
}

impl Exact {
    /// Whether it is less than, equal to or greater than 0.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        self.0.last().map_or(Ordering::Equal, |x| x.total_cmp(&0.0))
    }

    /// The nearest double, or one of its neighbours.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.0.iter().sum()
    }

    /// Every term in turn takes `x` in and hands on what it was rounded by; no zero is kept.
    fn add_double(&mut self, x: f64) {
        let mut carry = x;
        let mut kept = 0;
        for i in 0..self.0.len() {
            let (sum, error) = two_sum(carry, self.0[i]);
            if error != 0.0 {
                self.0[kept] = error;
                kept += 1;
            }
            carry = sum;
        }
        self.0.truncate(kept);
        if carry != 0.0 {
            self.0.push(carry);
        }
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: Self) -> Exact {
        let mut sum = self.clone();
        other.0.iter().for_each(|&x| sum.add_double(x));
        sum
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: Self) -> Exact {
        let mut sum = self.clone();
        other.0.iter().for_each(|&x| sum.add_double(-x));
        sum
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: Self) -> Exact {
        let mut sum = Exact::default();
        for (a, b) in self.0.iter().flat_map(|a| other.0.iter().map(move |b| (a, b))) {
            let product = a * b;
            sum.add_double(a.mul_add(*b, -product));
            sum.add_double(product);
        }
        sum
    }
}

/// a + b rounded, and what the rounding took away. Knuth's, for summands of any size.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// `a` − `b`.
#[must_use]
pub fn difference(a: Vec3, b: Vec3) -> [Exact; 3] {
    [0, 1, 2].map(|i| &Exact::from(a[i]) - &Exact::from(b[i]))
}

/// `v`, as it is.
#[must_use]
pub fn vector(v: Vec3) -> [Exact; 3] {
    v.to_array().map(Exact::from)
}

/// `a` · `b`.
#[must_use]
pub fn dot(a: &[Exact; 3], b: &[Exact; 3]) -> Exact {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// `a` × `b`.
#[must_use]
pub fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

/// (v₁ − v₀) × (v₂ − v₀).
#[must_use]
pub fn normal(corners: [Vec3; 3]) -> [Exact; 3] {
    let [v0, v1, v2] = corners;
    cross(&difference(v1, v0), &difference(v2, v0))
}

/// N·(p − v₀): positive in front of the triangle.
#[must_use]
pub fn height(corners: [Vec3; 3], point: Vec3) -> Exact {
    dot(&normal(corners), &difference(point, corners[0]))
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use glam::{Vec3, vec3};

    use super::{Exact, height};

    #[test]
    fn nothing_is_rounded() {
        let [large, small] = [1e30_f32, 1e-30].map(Exact::from);
        let sum = &large + &small;
        assert_eq!((&sum - &large).value(), f64::from(1e-30_f32), "(10³⁰ + 10⁻³⁰) − 10³⁰");
        let square = &(&sum * &sum) - &(&large * &large);
        let rest = &(&square - &(&large * &small)) - &(&large * &small);
        assert_eq!(rest.value(), f64::from(1e-30_f32).powi(2), "(a + b)² − a² − 2ab");
        assert_eq!((&rest - &(&small * &small)).sign(), Ordering::Equal, "… − b²");
    }

    /// 10⁻⁴⁰ above a plane in which coordinates are near 1: 2⁻¹³³, where 53 bits see nothing.
    #[test]
    fn the_side_of_a_plane_is_told_from_any_distance() {
        let corners = [vec3(0.3, 0.1, 0.0), vec3(0.7, 0.2, 0.0), vec3(0.4, 0.9, 0.0)];
        for (z, side) in
            [(1e-40, Ordering::Greater), (0.0, Ordering::Equal), (-1e-40, Ordering::Less)]
        {
            assert_eq!(height(corners, vec3(0.5, 0.5, z)).sign(), side, "z = {z:e}");
        }
        let tilted = [Vec3::X, Vec3::Y, Vec3::Z];
        let third = vec3(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);
        // The float 1/3 is larger than a third.
        assert_eq!(height(tilted, third).sign(), Ordering::Greater, "x + y + z = 1");
    }
}
