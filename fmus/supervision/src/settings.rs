//! What the supervisor goes by, what it sees, and what it says.

use serde::{Deserialize, Serialize};

use crate::{Limits, Tolerances, UNPHYSICAL};

/// How many axes a supervisor has at most; those that a crane does not have stand still.
pub const AXES: usize = 4;

/// When a sample is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Now (s).
    pub now: f64,
    /// The time from one sample to the next (s); 0 if that is not known: then the next is expected to be as far away as the
    /// last is.
    pub interval: f64,
}

/// What is safe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The limits of each axis.
    pub axes: [Limits; AXES],
    /// How far from either end of its range an axis has to go slowly.
    pub slow_zone: f64,
    /// What is slow, as a share of the greatest speed.
    pub slow_share: f64,
    /// How late an axis follows (s).
    pub reaction: f64,
    /// The swing beyond which no axis speeds up (rad).
    pub swing_limit: f64,
    /// What is still believed of positions and hook.
    pub within: Tolerances,
    /// For how long what comes behind a drive or an event is recorded (s).
    pub record_time: f64,
}

/// What is seen at a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// The velocities that are asked for.
    pub command: [f64; AXES],
    /// The positions of the axes.
    pub position: [f64; AXES],
    /// Whether each is valid.
    pub position_valid: [bool; AXES],
    /// Whether the hook is seen.
    pub hook_valid: bool,
    /// The amplitude of its swing (rad).
    pub swing: f64,
    /// Whether the emergency stop is pressed.
    pub emergency_stop: bool,
    /// Whether the reset is pressed.
    pub reset: bool,
}

/// What the crane may do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum State {
    /// What is asked for.
    #[default]
    Ready,
    /// Less than is asked for.
    Limited,
    /// Nothing: it has been stopped by the emergency stop.
    Stopped,
    /// Nothing: it has been stopped by a fault.
    Fault,
}

/// A crane at rest that is asked for nothing and has all sensors.
impl Default for Observation {
    fn default() -> Self {
        Self {
            command: [0.0; AXES],
            position: [0.0; AXES],
            position_valid: [true; AXES],
            hook_valid: true,
            swing: 0.0,
            emergency_stop: false,
            reset: false,
        }
    }
}

/// A crane without ends that goes with a speed of 1 and stops within a second.
impl Default for Settings {
    fn default() -> Self {
        let free = Limits { position_min: -UNPHYSICAL, position_max: UNPHYSICAL, velocity: 1.0, deceleration: 1.0 };
        Self {
            axes: [free; AXES],
            slow_zone: 0.0,
            slow_share: 0.25,
            reaction: 0.0,
            swing_limit: 0.3,
            within: Tolerances { fault_time: 0.5, jump_time: 0.5, frozen_time: 2.0 },
            record_time: 10.0,
        }
    }
}
