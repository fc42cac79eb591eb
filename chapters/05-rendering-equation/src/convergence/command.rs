//! The command line of `estimate`.

use clap::Parser;

use super::report::report;
use super::{Integrand, Sampling, Study};

/// Integrates functions over the hemisphere by chance, and shows how fast the error falls
#[derive(Clone, Debug, Parser)]
#[command(name = "estimate")]
pub struct Command {
    /// The function
    #[arg(value_enum, value_name = "FUNCTION", default_value_t)]
    pub integrand: Integrand,

    /// All functions, one after the other
    #[arg(long, conflicts_with = "integrand")]
    pub all: bool,

    /// One density only [default: all]
    #[arg(long, value_enum)]
    pub density: Option<Sampling>,

    /// The largest number of samples; each row has 4 times as many as the one before
    #[arg(long, value_name = "N", default_value_t = 65_536,
          value_parser = clap::value_parser!(u64).range(64..=1 << 32))]
    pub samples: u64,

    /// Independent runs behind every rms or median error
    #[arg(long, value_name = "R", default_value_t = 101,
          value_parser = clap::value_parser!(u64).range(1..=1 << 20))]
    pub runs: u64,

    /// Seed of the random numbers
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,
}

impl Command {
    /// Everything that is printed.
    #[must_use]
    pub fn run(&self) -> String {
        let only = [self.integrand];
        let integrands: &[Integrand] = if self.all { &Integrand::ALL } else { &only };
        let densities = match &self.density {
            Some(density) => std::slice::from_ref(density),
            None => &Sampling::ALL,
        };
        let Self { samples, runs, seed, .. } = *self;
        let studies = integrands.iter().map(|&integrand| Study { integrand, samples, runs, seed });
        studies.map(|study| report(&study, densities)).collect::<Vec<_>>().join("\n")
    }
}
