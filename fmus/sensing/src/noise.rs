//! Noise: normal random numbers that a seed repeats.

use rand_distr::{Distribution, StandardNormal};
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;
use serde::{Deserialize, Serialize};

/// A source of independent normal random numbers.
///
/// The generator is SplitMix64: its state is one number of 64 bits, and every such number is a state that it goes on from,
/// so that no saved state can be one on which it gets stuck.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Noise {
    generator: SplitMix64,
}

impl Noise {
    /// The source that a seed gives.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { generator: SplitMix64::seed_from_u64(seed) }
    }

    /// The next number, of mean 0 and standard deviation 1.
    pub fn draw(&mut self) -> f64 {
        StandardNormal.sample(&mut self.generator)
    }
}
