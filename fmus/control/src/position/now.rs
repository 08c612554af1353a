//! What a position controller remembers from sample to sample, beside the past of its velocity.

use serde::{Deserialize, Serialize};

use crate::crane::{BOUND, State};
use crate::observer::Observer;

/// The part of the memory that changes at every sample.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Now {
    pub estimate: State,
    pub observer: Option<Observer>,
    /// The command given (m/s), held since.
    pub command: f64,
    /// The plan after the model, and the command that it is given.
    pub planned: State,
    pub planned_command: f64,
    /// The unshaped move: where it is and how fast.
    pub place: f64,
    pub velocity: f64,
    /// How far feedback of swing and position is faded in, 0 … 1.
    pub trust: [f64; 2],
    /// Whether the position has been seen.
    pub located: bool,
    /// Where to stay, once it stands.
    pub held: Option<f64>,
    pub off: bool,
    /// The controller's own time (s).
    pub time: f64,
}

impl Default for Now {
    fn default() -> Self {
        Self {
            estimate: State::default(),
            observer: None,
            command: 0.0,
            planned: State::default(),
            planned_command: 0.0,
            place: 0.0,
            velocity: 0.0,
            trust: [0.0; 2],
            located: false,
            held: None,
            off: true,
            time: 0.0,
        }
    }
}

impl Now {
    /// Whether a controller can have come to remember this.
    pub fn is_possible(&self) -> bool {
        let numbers = [self.command, self.planned_command, self.place, self.velocity, self.held.unwrap_or_default()];
        numbers.iter().all(|number| number.abs() <= BOUND)
            && (0.0..=BOUND).contains(&self.time)
            && self.trust.iter().all(|trust| (0.0..=1.0).contains(trust))
    }
}
