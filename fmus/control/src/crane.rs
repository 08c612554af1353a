//! One axis of a crane as its controller knows it: the drive, and hook and payload behind it.

use serde::{Deserialize, Serialize};

use crate::drive::{Drive, Motion};
use crate::pendulum::{Modes, Pendulum, Swing};
use crate::poles::Feedback;

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

    /// Where the trolley comes to rest (m) if nothing is commanded any more but feedback of the swing, k (θ + lead θ̇).
    ///
    /// Drive and swing, integrated from now to rest, say ∫V = ∫command + V̇/ω_H² + 2 ζ_H V/ω_H and
    /// S ∫p = ṗ + b V. With the first row of S⁻¹, L_h/((1 + M) g) (1, √M), feedback adds k/g times the velocity at which the
    /// loads' centre of mass moves, less k lead θ.
    #[must_use]
    pub fn comes_to_rest_at(&self, State { motion, swing }: State, feedback: Feedback) -> f64 {
        let Self { pendulum, drive } = self;
        let omega = drive.natural_frequency;
        let lag = motion.acceleration / (omega * omega) + 2.0 * drive.damping_ratio * motion.velocity / omega;
        let loads = motion.velocity + pendulum.push().dot(&swing.rate) / (1.0 + pendulum.mass_ratio);
        let lean = swing.place[0] / pendulum.hoist;
        motion.position + lag + feedback.sway_gain * (loads / pendulum.gravity - feedback.lead_time * lean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a crane that is left alone with its feedback, sample by sample, until it stands.
    #[test]
    fn a_crane_comes_to_rest_where_it_is_said_to() {
        let feedback = Feedback { position_gain: 0.0, sway_gain: 3.0, lead_time: 0.4 };
        let start = State {
            motion: Motion { position: 5.0, velocity: 0.4, acceleration: -0.3 },
            swing: Swing { place: [0.3, 0.5].into(), rate: [-0.2, 0.4].into() },
        };
        for mass_ratio in [0.5, 0.0, 4.0] {
            let pendulum = Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio };
            let crane = Crane { pendulum, drive: Drive { natural_frequency: 3.7, damping_ratio: 0.75 } };
            let (modes, interval, mut state) = (pendulum.modes(), 5e-3, start);
            if mass_ratio == 0.0 {
                state.swing = Swing { place: [0.3, 0.0].into(), rate: [-0.2, 0.0].into() };
            }
            let wanted = crane.comes_to_rest_at(state, feedback);
            for _ in 0..30_000 {
                let [place, rate] = state.hook();
                let command = feedback.sway_gain * (place + feedback.lead_time * rate) / pendulum.hoist;
                state = crane.after(&modes, state, command, interval);
            }
            let found = state.motion.position;
            // A command is held for 5 ms, which is 2.5 ms late, at 0.08 m/s in the beginning.
            assert!((found - wanted).abs() < 3e-4, "M = {mass_ratio}: {found} m for {wanted} m");
        }
    }
}
