//! Where a path ends.

use std::str::FromStr;

use ray_casting::Rgb;

/// How paths end.
#[derive(Clone, Copy, Debug)]
pub struct Ending {
    /// D: most scattering events. The light of longer ways is lost: a bias.
    pub depth: u32,
    /// The game that ends paths early, without a bias.
    pub roulette: Roulette,
}

// ANCHOR: roulette
/// Russian roulette: a path goes on with probability q, and what it then finds counts 1/q times.
///
/// ```text
/// E[L'] = q · L/q + (1 − q) · 0 = L
/// ```
///
/// Right on average for any q > 0, so q is free to be small where little is to be gained
/// \[ArvoKirk90].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Roulette {
    /// No game: only the depth ends paths.
    Off,
    /// The same q at every event, above 0 and at most 1.
    Constant(f32),
    /// q follows the throughput β, see [`Roulette::survival`].
    #[default]
    Throughput,
}

impl Roulette {
    /// Below this throughput paths are at stake: after about four reflections at a white wall.
    /// Playing earlier ends paths that matter; later, paths go on that do not.
    const STAKE: f32 = 0.3;

    /// Events after which every path is at stake, whatever its throughput.
    const PATIENCE: u32 = 128;

    /// q, the probability to go on after this many scattering events with this throughput β.
    ///
    /// ```text
    /// q = min(1, max(β) / stake),   from event 128 on also at most (n / (n + 1))²
    /// ```
    ///
    /// The survivors of the first rule all have the same throughput: no path is followed that
    /// counts for less than the stake, and none comes to count for more than it had at the start.
    /// The second rule is for paths that lose nothing, as those caught in glass: they too must end.
    /// Of them (128/n)² get as far as event n, so that the mean length is finite; and a light that
    /// dims as ρⁿ, for any ρ < 1, has a finite variance. With a constant q ≤ ρ² it would not.
    #[inline]
    #[must_use]
    pub fn survival(self, throughput: Rgb, events: u32) -> f32 {
        match self {
            Self::Off => 1.0,
            Self::Constant(q) => drawable(q),
            Self::Throughput => {
                let most = if events < Self::PATIENCE { 1.0 } else { patience(events) };
                drawable((throughput.max_element() / Self::STAKE).min(most))
            }
        }
    }
}

/// (n / (n + 1))².
fn patience(events: u32) -> f32 {
    let ratio = events as f32 / (events as f32 + 1.0);
    ratio * ratio
}

/// The smallest multiple of 2⁻²⁴ that is not below `q`.
///
/// A uniform number is one of 2²⁴: it is below 10⁻⁹ not once in 10⁹ times but once in 2²⁴. Divided
/// by a probability that it does not have, a path that survives would count 60 times too much.
#[inline]
fn drawable(q: f32) -> f32 {
    const STEPS: f32 = 16_777_216.0;
    if q >= 0.5 {
        return q.min(1.0); // every f32 from ½ to 1 is such a multiple
    }
    let below = (q * STEPS) as u32 as f32;
    if below < q * STEPS { (below + 1.0) / STEPS } else { below / STEPS }
}
// ANCHOR_END: roulette

impl FromStr for Roulette {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "off" => Ok(Self::Off),
            "throughput" => Ok(Self::Throughput),
            _ => (text.parse().ok().filter(|q| 0.0 < *q && *q <= 1.0).map(Self::Constant))
                .ok_or_else(|| {
                    "expected `throughput`, `off`, or a number above 0, at most 1".into()
                }),
        }
    }
}
