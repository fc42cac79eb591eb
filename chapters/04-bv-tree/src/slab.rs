//! The space between two parallel planes, and why a rounded test of it never misses.

use glam::{Vec3, Vec4};
use ray_casting::Interval;
use ray_casting::math::gamma;

/// Next to zero, where floats are evenly spaced, a product is off by up to half a step, whatever its
/// size: this many steps cover those of a test.
const ROUNDING_NEAR_ZERO: f32 = f32::from_bits(4);

/// A ray as one slab lo ≤ n·p ≤ hi wants it.
///
/// With o = n·**o** and d = n·**d**, the ray crosses the plane n·p = c at t = (c − o) / d. Four
/// steps make the interval that [`SlabQuery::clip`] computes contain every t at which a primitive
/// between the planes can report a hit:
///
/// 1. The slab is widened by a padding E to [lo − E, hi + E], for what the primitive's own test
///    rounded. It costs nothing: lo − E − o = lo − (o + E), so the origin moves instead, once a
///    ray. That sum is rounded as well: γ(2) |o| is added to E for it, and a few of the smallest floats.
/// 2. c − o, 1/d and their product are rounded: t is off by a factor within 1 ± γ(3). The plane
///    that the ray enters through is brought nearer by the factor 1 − γ(6), the other moved away by
///    1 + γ(6): enough for the rounding of the hit's own t, too. (A negative t moves the wrong way,
///    but then the true one is negative as well, and nothing behind the origin is asked for.)
/// 3. For d = 0 the ray never crosses. 1/d is ∞ and t = ±∞ says on which side of each plane it
///    runs. Only an origin exactly on a plane gives 0 · ∞ = NaN, and `overlap` lets NaN constrain
///    nothing; at the plane of entry not even that occurs, since there 1/d is at most the largest
///    finite number.
/// 4. That also keeps the entry a lower bound when 1/d overflows for a tiny d.
#[derive(Clone, Copy, Debug)]
pub struct SlabQuery {
    /// o + E or o − E, for the plane through which the ray enters,
    pub origin_near: f32,
    /// and for the one through which it leaves.
    pub origin_far: f32,
    /// 1/d, corrected for the plane through which the ray enters,
    pub inverse_near: f32,
    /// and for the one through which it leaves.
    pub inverse_far: f32,
}

impl SlabQuery {
    // ANCHOR: new
    /// Prepares a ray with n·**o** = `origin` and n·**d** = `direction`.
    #[inline(always)]
    #[must_use]
    pub fn new(origin: f32, direction: f32, padding: f32) -> Self {
        // A zero of either sign counts as positive: −0 + 0 = 0.
        let inverse = 1.0 / (direction + 0.0);
        let padding = (padding + gamma(2) * origin.abs() + ROUNDING_NEAR_ZERO).copysign(inverse);
        Self {
            origin_near: origin + padding,
            origin_far: origin - padding,
            inverse_near: smaller(larger(inverse, -f32::MAX), f32::MAX) * (1.0 - gamma(6)),
            inverse_far: inverse * (1.0 + gamma(6)),
        }
    }
    // ANCHOR_END: new

    /// Whether the ray enters through the plane hi.
    #[inline]
    #[must_use]
    pub fn is_backward(&self) -> bool {
        self.inverse_far < 0.0
    }

    // ANCHOR: clip
    /// The t for which the ray is inside the slab [`slab.min`, `slab.max`]. The end may be NaN.
    #[inline]
    #[must_use]
    pub fn clip(&self, slab: Interval) -> Interval {
        let (near, far) =
            if self.is_backward() { (slab.max, slab.min) } else { (slab.min, slab.max) };
        let enter = (near - self.origin_near) * self.inverse_near;
        let leave = (far - self.origin_far) * self.inverse_far;
        Interval::new(enter, leave)
    }
    // ANCHOR_END: clip
}

/// The [`SlabQuery`] of each axis, side by side: x, y, z and one that nobody asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisQueries {
    pub(crate) origin_near: Vec4,
    pub(crate) origin_far: Vec4,
    pub(crate) inverse_near: Vec4,
    pub(crate) inverse_far: Vec4,
}

impl AxisQueries {
    /// As [`SlabQuery::new`], for three slabs at a time.
    ///
    /// Here the compiler does not find the instructions for four numbers by itself, as it does in
    /// [`four`](crate::four): they are asked for. What `max` and `min` make of a NaN depends on the
    /// processor, but here is none, unless the direction has one; and with such a ray nobody asks.
    #[inline(always)]
    pub(crate) fn new(origin: Vec3, direction: Vec3, padding: f32) -> Self {
        let (origin, direction) = (origin.extend(0.0), direction.extend(1.0));
        let inverse = 1.0 / (direction + Vec4::ZERO);
        let padding = Vec4::splat(padding) + gamma(2) * origin.abs() + ROUNDING_NEAR_ZERO;
        let padding = padding.copysign(inverse);
        let finite = inverse.max(Vec4::splat(-f32::MAX)).min(Vec4::splat(f32::MAX));
        Self {
            origin_near: origin + padding,
            origin_far: origin - padding,
            inverse_near: finite * (1.0 - gamma(6)),
            inverse_far: inverse * (1.0 + gamma(6)),
        }
    }

    /// Bit i is set if slab i is entered through the plane hi.
    #[inline(always)]
    pub(crate) fn are_backward(&self) -> u32 {
        self.inverse_far.cmplt(Vec4::ZERO).bitmask()
    }
}

// ANCHOR: overlap
/// The part of `a` that lies in `b`; an end of `a` that is NaN constrains nothing.
#[inline]
#[must_use]
pub(crate) fn overlap(a: Interval, b: Interval) -> Interval {
    Interval::new(larger(a.min, b.min), smaller(a.max, b.max))
}

/// The larger of two numbers, and the second if the first is NaN.
#[inline]
#[must_use]
pub(crate) fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller of two numbers, and the second if the first is NaN.
#[inline]
#[must_use]
pub(crate) fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
// ANCHOR_END: overlap

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use workbench::Sampler;

    use super::{AxisQueries, SlabQuery};

    /// Also where 1/d overflows, for zeros of both signs, and where an origin or a padding is none.
    #[test]
    fn three_slabs_together_are_three_slabs() {
        let special = [0.0, -0.0, 1e-45, -1e-39, 1.0, -1.0, 3e38, f32::MAX];
        for i in 0..100_000 {
            let mut sampler = Sampler::new(22, i, 0);
            let mut number = || {
                let u = sampler.next_1d();
                if u < 0.25 {
                    special[(32.0 * u) as usize]
                } else {
                    (sampler.next_1d() - 0.5) * 10.0_f32.powi((80.0 * (u - 0.625)) as i32)
                }
            };
            let mut vector = || Vec3::new(number(), number(), number());
            let (origin, direction) = (vector(), vector());
            let padding = number().abs();
            let together = AxisQueries::new(origin, direction, padding);
            for axis in 0..3 {
                let alone = SlabQuery::new(origin[axis], direction[axis], padding);
                let expected =
                    [alone.origin_near, alone.origin_far, alone.inverse_near, alone.inverse_far];
                let AxisQueries { origin_near, origin_far, inverse_near, inverse_far } = together;
                let found =
                    [origin_near, origin_far, inverse_near, inverse_far].map(|four| four[axis]);
                assert_eq!(
                    found.map(f32::to_bits),
                    expected.map(f32::to_bits),
                    "axis {axis} of a ray from {origin} along {direction}, padding {padding}: \
                     {found:?}, {expected:?}"
                );
                let backward = together.are_backward() & (1 << axis) != 0;
                assert_eq!(backward, alone.is_backward(), "direction {}", direction[axis]);
            }
        }
    }
}
