//! How much each of two estimates counts.

use clap::ValueEnum;

/// How lamps are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Estimator {
    /// By chance, as in chapter 6.
    Scatter,
    /// By sampling the lights.
    Light,
    /// Both ways, weighted.
    #[default]
    Mis,
}

// ANCHOR: heuristic
/// The weights of multiple importance sampling.
///
/// A direction that one strategy has drawn with density p could have been drawn by the other one,
/// with density p'. Any weights with w(p, p') + w(p', p) = 1 give the right mean; good ones are small
/// where their strategy is bad \[VeachGuibas95].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Heuristic {
    /// w = p / (p + p')
    Balance,
    /// w = p² / (p² + p'²)
    #[default]
    Power,
}

impl Heuristic {
    /// The weight of a direction drawn with density `own`, which the other strategy draws with
    /// density `other`; both per steradian, `own` above 0.
    #[inline]
    #[must_use]
    pub fn weight(self, own: f32, other: f32) -> f32 {
        // Dividing first: p² would overflow for a tiny lamp.
        let ratio = other / own;
        match self {
            Self::Balance => 1.0 / (1.0 + ratio),
            Self::Power => 1.0 / (1.0 + ratio * ratio),
        }
    }
}
// ANCHOR_END: heuristic

#[cfg(test)]
mod tests {
    use super::Heuristic::{Balance, Power};

    /// accuracy.md E11.
    #[test]
    fn the_weights_of_both_strategies_add_up_to_one() {
        for heuristic in [Balance, Power] {
            for (a, b) in [(1.0, 1.0), (1e-20, 1e20), (0.3, 7.0), (f32::MAX, 1e-3), (1e-38, 1.0)] {
                let sum = heuristic.weight(a, b) + heuristic.weight(b, a);
                assert!((sum - 1.0).abs() <= 1e-6, "{heuristic:?} of {a:e} and {b:e}: {sum}");
            }
            assert_eq!(heuristic.weight(1.0, 0.0), 1.0, "{heuristic:?} without competition");
        }
    }
}
