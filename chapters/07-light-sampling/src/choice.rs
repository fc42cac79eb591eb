//! Which of many lights is asked.

use clap::ValueEnum;

/// What the probability to choose a light is in proportion to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Choice {
    /// Nothing: all lights are equally likely.
    Uniform,
    /// The light's power, the same from everywhere.
    Power,
    /// A bound of the light that it could send to the point that asks
    #[default]
    Nearby,
}
