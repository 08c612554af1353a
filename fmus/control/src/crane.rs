//! One axis of a crane as its controller knows it: the drive, and hook and payload behind it.

use serde::{Deserialize, Serialize};

use crate::drive::{Drive, Motion};
use crate::pendulum::{Modes, Pendulum, Swing};

/// The model that a controller predicts with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crane {
    /// Hook and payload.
    pub pendulum: Pendulum,
    /// The drive.
    pub drive: Drive,
}

/// Where an axis is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Numbers", into = "Numbers")]
pub struct State {
    /// The trolley.
    pub motion: Motion,
    /// Hook and payload, relative to it.
    pub swing: Swing,
}

/// What a state is serialized as.
type Numbers = [f64; 7];

/// No crane is farther, faster or swings wider (SI): what a controller computes with stays finite.
pub const BOUND: f64 = 1e9;

impl From<State> for Numbers {
    fn from(State { motion, swing }: State) -> Self {
        let Motion { position, velocity, acceleration } = motion;
        [position, velocity, acceleration, swing.place[0], swing.place[1], swing.rate[0], swing.rate[1]]
    }
}

impl TryFrom<Numbers> for State {
    type Error = &'static str;

    fn try_from(numbers: Numbers) -> Result<Self, Self::Error> {
        if !numbers.iter().all(|number| number.abs() <= BOUND) {
            return Err("a crane is where none can be");
        }
        let [position, velocity, acceleration, hook, payload, hook_rate, payload_rate] = numbers;
        Ok(Self {
            motion: Motion { position, velocity, acceleration },
            swing: Swing { place: [hook, payload].into(), rate: [hook_rate, payload_rate].into() },
        })
    }
}

impl State {
    /// At rest at a position (m).
    #[must_use]
    pub fn at(position: f64) -> Self {
        Self { motion: Motion { position, ..Motion::default() }, swing: Swing::default() }
    }

    /// Displacement of the hook (m) and its rate (m/s), relative to the trolley.
    #[must_use]
    pub fn hook(&self) -> [f64; 2] {
        [self.swing.place[0], self.swing.rate[0]]
    }

    /// The same within what a crane can do; at rest if it is no number at all.
    #[must_use]
    pub fn bounded(&self) -> Self {
        let numbers: Numbers = (*self).into();
        if numbers.iter().any(|number| number.is_nan()) {
            return Self::default();
        }
        Self::try_from(numbers.map(|number| number.clamp(-BOUND, BOUND))).unwrap_or_default()
    }
}

impl Crane {
    /// The state after an interval (s) in which the command (m/s) was held. The drive is exact; hook and payload see the mean of
    /// its acceleration, which is as good as exact over intervals that are short beside its response.
    #[must_use]
    pub fn after(&self, modes: &Modes, State { motion, swing }: State, command: f64, interval: f64) -> State {
        if interval <= 0.0 {
            return State { motion, swing };
        }
        let next = self.drive.after(motion, command, interval);
        let mean = (next.velocity - motion.velocity) / interval;
        let swing = modes.transition(interval).of(swing, self.pendulum.rest(mean));
        State { motion: next, swing }.bounded()
    }
}
