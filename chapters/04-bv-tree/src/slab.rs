//! The space between two parallel planes, and why a rounded test of it never misses.

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
