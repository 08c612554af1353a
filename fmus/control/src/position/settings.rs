//! What a position controller is told, and what it shows.

use crate::crane::{Crane, State};
use crate::observer::Uncertainty;
use crate::poles::Feedback;
use crate::profile::Limits;

/// Where shaping takes place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A shaped move is planned, and feedback acts on what deviates from the plan.
    Planned,
    /// The shaper sits in the position loop, designed for the poles of the sway loop; a prediction takes its delay out of the
    /// loop.
    InLoop,
    /// The same without the prediction.
    PlainLoop,
}

/// What the crane is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// Move at a velocity (m/s).
    Velocity(f64),
    /// Go to a position (m).
    Position(f64),
    /// Stay.
    Hold,
    /// Nothing: no command, once it has run out.
    Off,
}

/// What the controller is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The crane as it is now.
    pub crane: Crane,
    /// Where shaping takes place.
    pub form: Form,
    /// What the command keeps to.
    pub limits: Limits,
    /// The gains.
    pub feedback: Feedback,
    /// Greatest part of the command that comes from feedback alone (m/s).
    pub correction_limit: f64,
    /// What the observer reckons with.
    pub uncertainty: Uncertainty,
    /// Age of what the camera shows (s).
    pub hook_latency: f64,
    /// Age of what the laser shows (s).
    pub position_latency: f64,
    /// Time constant with which the position follows the laser (s).
    pub position_filter: f64,
    /// Time in which feedback fades out and in (s).
    pub fade_time: f64,
    /// How near to its goal a position is reached (m).
    pub position_tolerance: f64,
    /// How far a hook may swing that counts as settled (m).
    pub swing_tolerance: f64,
}

/// What the sensors show; nothing where they see nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Displacement of the hook from the vertical through the trolley (m).
    pub hook: Option<f64>,
    /// Position of the trolley (m).
    pub position: Option<f64>,
}

/// What the controller shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shown {
    /// The command (m/s).
    pub velocity: f64,
    /// The part of it that comes from feedback alone (m/s).
    pub correction: f64,
    /// Whether the goal is reached.
    pub at_target: bool,
    /// Whether nothing moves or swings any more.
    pub settled: bool,
    /// How far it is to the goal (m).
    pub position_error: f64,
    /// The plan, after the model.
    pub planned: State,
    /// Where the crane is, as far as it is known.
    pub estimated: State,
    /// Whether the closed loop is stable.
    pub is_stable: bool,
}
