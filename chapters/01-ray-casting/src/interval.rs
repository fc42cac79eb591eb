//! Ranges of the ray parameter t.

/// The numbers from `min` to `max`, both included; empty when `min > max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub min: f32,
    /// The upper end.
    pub max: f32,
}

impl Interval {
    /// No number at all, and the neutral element of [`Interval::hull`].
    pub const EMPTY: Self = Self { min: f32::INFINITY, max: f32::NEG_INFINITY };
    /// From 0 to infinity: all that lies in front of a ray's origin.
    pub const FORWARD: Self = Self { min: 0.0, max: f32::INFINITY };

    /// The interval from `min` to `max`.
    #[inline]
    #[must_use]
    pub const fn new(min: f32, max: f32) -> Self {
        Self { min, max }
    }

    /// Whether no number lies in it; so too when an end is not a number.
    #[inline]
    #[must_use]
    pub fn is_empty(self) -> bool {
        let some = self.min <= self.max;
        !some
    }

    /// Whether `x` lies in it, the ends included.
    #[inline]
    #[must_use]
    pub fn contains(self, x: f32) -> bool {
        self.min <= x && x <= self.max
    }

    /// The numbers that lie in both.
    #[inline]
    #[must_use]
    pub const fn intersection(self, other: Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// The smallest interval that covers both.
    #[inline]
    #[must_use]
    pub const fn hull(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// `max − min`; negative when empty.
    #[inline]
    #[must_use]
    pub fn length(self) -> f32 {
        self.max - self.min
    }
}

#[cfg(test)]
mod tests {
    use super::Interval;

    #[test]
    fn a_single_point_is_not_empty() {
        assert!(!Interval::new(1.0, 1.0).is_empty(), "[1, 1] holds the number 1");
        assert!(Interval::EMPTY.is_empty(), "{:?}", Interval::EMPTY);
        assert!(Interval::new(f32::NAN, 1.0).is_empty(), "an unknown end holds nothing");
    }

    #[test]
    fn the_empty_interval_changes_no_hull() {
        let some = Interval::new(-2.0, 3.0);
        assert_eq!(Interval::EMPTY.hull(some), some, "∅ ∪ [−2, 3]");
        assert!(some.intersection(Interval::EMPTY).is_empty(), "∅ ∩ [−2, 3]");
    }
}
