//! When the ramps of (5.25) are over: the conditions (5.22)–(5.24) and (5.31).
//!
//! The thesis prints (5.22) and (5.23) with the comparisons the wrong way round; here a short pulse is one that has ended before
//! the shaper's next impulse, and a long one begins to end when the train is over.

use super::Compensated;
use crate::Shaper;

/// After this many time constants 5 % of a ramp is left, and the thesis counts it as complete.
const COMPLETE: f64 = 3.0;

/// Which ramps are complete before the next begins (5.31); the closed form of UMZVc assumes it of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RampsComplete {
    /// Of the accelerating train: t₂ > 3τ_a and t₃ − t₂ > 3τ_b.
    pub accelerating: [bool; 2],
    /// Of the braking train: t₂′ > 3τ_b and t₃′ − t₂′ > 3τ_a.
    pub braking: [bool; 2],
}

impl RampsComplete {
    /// Whether all are.
    #[must_use]
    pub fn all(self) -> bool {
        (self.accelerating.iter().chain(&self.braking)).all(|complete| *complete)
    }
}

impl Compensated {
    /// Whether the ramps of a drive with the given time constants (in seconds) are complete before the next begins (5.31).
    #[must_use]
    pub fn ramps_complete(&self, acceleration_time_constant: f64, braking_time_constant: f64) -> RampsComplete {
        let (up, down) = (COMPLETE * acceleration_time_constant, COMPLETE * braking_time_constant);
        let complete = |train: &Shaper, first: f64, second: f64| {
            let mut times = train.impulses().windows(2).map(|pair| pair[1].time - pair[0].time).zip([first, second]);
            std::array::from_fn(|_| times.next().is_none_or(|(time, ramp)| time > ramp))
        };
        RampsComplete {
            accelerating: complete(&self.accelerating, up, down),
            braking: complete(&self.braking, down, up),
        }
    }
}

/// How a pulse, a command that begins and ends, meets a shaper's impulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PulseLength {
    /// The drive is at rest again before the shaper's next impulse (5.22): t_p < tᵢ₊₁ − tᵢ − 3τ_b for all i.
    Short,
    /// Its start and its end, or two impulses' ramps, meet; the residual vibration of either alone says nothing.
    Interfering,
    /// The drive is at full speed before its end begins (5.23), (5.24): t_p > tₙ + 3τ_a.
    Long,
}

/// How a pulse of the given duration meets the impulses of a shaper, in a drive with the given time constants (all in seconds).
#[must_use]
pub fn pulse_length(
    shaper: &Shaper,
    duration: f64,
    acceleration_time_constant: f64,
    braking_time_constant: f64,
) -> PulseLength {
    let spaces = shaper.impulses().windows(2).map(|pair| pair[1].time - pair[0].time);
    let shortest = spaces.fold(f64::INFINITY, f64::min);
    if duration > shaper.duration() + COMPLETE * acceleration_time_constant {
        PulseLength::Long
    } else if duration < shortest - COMPLETE * braking_time_constant {
        PulseLength::Short
    } else {
        PulseLength::Interfering
    }
}
