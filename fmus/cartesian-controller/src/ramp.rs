//! How fast the velocity of the load changes: as all axes can follow together, so that none of them is late by itself.

use serde::{Deserialize, Serialize};
use swayless_crane::STRONGEST;
use swayless_mechanics::{AXES, AxisRates, RateRanges, Vector};

/// What was told at one instant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "([f64; 3], [f64; AXES])", into = "([f64; 3], [f64; AXES])")]
pub struct Told {
    /// The velocity that the load was given of the command, in the world (m/s).
    pub velocity: Vector<f64>,
    /// The rates of the axes.
    pub rates: AxisRates,
}

impl From<Told> for ([f64; 3], [f64; AXES]) {
    fn from(Told { velocity, rates }: Told) -> Self {
        (velocity.into(), rates.into())
    }
}

impl TryFrom<([f64; 3], [f64; AXES])> for Told {
    type Error = &'static str;

    fn try_from((velocity, rates): ([f64; 3], [f64; AXES])) -> Result<Self, Self::Error> {
        // Both are cut at 100.
        let can_be = velocity.iter().chain(&rates).all(|value| value.abs() < 1e3);
        can_be.then_some(Self { velocity: velocity.into(), rates: rates.into() }).ok_or("an axis is faster than any")
    }
}

/// How far rates can change until the next sample.
#[derive(Debug, Clone, Copy)]
pub struct Ramp {
    /// What was told before.
    pub before: Told,
    /// The changes that the axes can follow.
    pub changes: RateRanges,
}

impl Ramp {
    /// From what was told `passed` (s) ago, with the greatest acceleration of each axis (rad/s², m/s²). There is none where
    /// no axis is held back.
    pub fn new(before: Told, limits: &AxisRates, passed: f64) -> Option<Self> {
        let change = |limit: f64| if limit < STRONGEST { limit * passed } else { f64::INFINITY };
        let is_held_back = limits.iter().any(|limit| *limit < STRONGEST);
        is_held_back.then(|| Self { before, changes: RateRanges::either_way(&limits.map(change)) })
    }
}
