//! What is known of the position of an axis: read from a sensor, or reckoned where that fails.

use serde::{Deserialize, Serialize};

use crate::{Fault, Limits};

/// No axis is further, and no command greater.
pub const UNPHYSICAL: f64 = 1e9;

/// An axis that moves by less than this share of what it should does not move.
const MOVES: f64 = 0.02;

/// What a sensor says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Where the axis is.
    pub position: f64,
    /// Whether the sensor stands by that.
    pub valid: bool,
}

/// What is still believed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// For how long a sensor may fail (s).
    pub fault_time: f64,
    /// A position may jump as far as the axis goes in this time at its greatest speed (s).
    pub jump_time: f64,
    /// A position may rest while the axis should have gone as far as in this time at its greatest speed (s).
    pub frozen_time: f64,
}

impl Tolerances {
    /// Whether a sensor has failed for too long. A time that is added up has its rounding.
    pub(crate) fn is_too_long(&self, time: f64) -> bool {
        time > self.fault_time * (1.0 + 1e-9)
    }
}

/// What is known of a position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sight {
    /// The position: as read last, and from there on reckoned.
    position: f64,
    /// The last reading that was believed, if any was.
    seen: Option<f64>,
    /// The time since then (s).
    blind: f64,
    /// Where the axis was when it last moved, and how far it should have gone since.
    moved: f64,
    travel: f64,
}

impl Sight {
    /// Nothing.
    pub const NONE: Self = Self { position: 0.0, seen: None, blind: 0.0, moved: 0.0, travel: 0.0 };

    /// Where the axis is, as far as that is known.
    #[must_use]
    pub fn position(&self) -> f64 {
        self.position
    }

    /// Whether the position is one that was read just now.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.seen.is_some() && self.blind == 0.0
    }

    /// Doubts what has been read: the next reading may be anywhere.
    pub(crate) fn doubt(&mut self) {
        self.seen = None;
    }

    /// Whether all is finite.
    pub(crate) fn is_sound(&self) -> bool {
        let numbers = [self.position, self.seen.unwrap_or_default(), self.blind, self.moved, self.travel];
        numbers.iter().all(|number| number.abs() <= f64::MAX)
    }

    /// Takes a reading, after so much time (s) with a velocity that the axis should have had. Tells what is wrong.
    pub fn read(
        &mut self,
        reading: Reading,
        (elapsed, velocity): (f64, f64),
        limits: &Limits,
        within: Tolerances,
    ) -> Fault {
        self.position = (self.position + velocity * elapsed).clamp(-UNPHYSICAL, UNPHYSICAL);
        self.blind += elapsed;
        let jump = limits.velocity * (self.blind + within.jump_time);
        let plausible = reading.position.abs() <= UNPHYSICAL
            && self.seen.is_none_or(|seen| (reading.position - seen).abs() <= jump);
        if reading.valid && plausible {
            if self.seen.is_none() {
                self.moved = reading.position;
            }
            *self = Self { position: reading.position, seen: Some(reading.position), blind: 0.0, ..*self };
            return self.watch(velocity * elapsed, limits.velocity * within.frozen_time);
        }
        match (within.is_too_long(self.blind), reading.valid) {
            (false, _) => Fault::None,
            (true, false) => Fault::PositionInvalid,
            (true, true) => Fault::PositionImplausible,
        }
    }

    /// Looks whether the axis moves, which should have gone so far.
    fn watch(&mut self, travel: f64, most: f64) -> Fault {
        self.travel += travel;
        if (self.position - self.moved).abs() > MOVES * most {
            (self.moved, self.travel) = (self.position, 0.0);
        }
        if self.travel.abs() > most { Fault::PositionFrozen } else { Fault::None }
    }
}
