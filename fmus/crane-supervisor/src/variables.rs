//! The variables of the supervisor. What belongs to an axis carries no unit: an axis turns (rad) or goes (m).

use swayless_export::{Enumeration, Scalar, Variables};
use swayless_supervision::AXES;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum State {
    /// The axes do what is commanded.
    Ready,
    /// At least one axis does less than is commanded.
    Limited,
    /// The emergency stop holds.
    Stopped,
    /// A fault holds.
    Fault,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum FaultCode {
    /// No fault.
    None,
    /// A command or the swing was beyond what can be.
    Input,
    /// A position was not valid for longer than fault_time.
    PositionInvalid,
    /// A position was for longer than fault_time where its axis cannot be.
    PositionImplausible,
    /// A position rested although its axis should have moved.
    PositionFrozen,
    /// The hook was not valid for longer than fault_time.
    HookInvalid,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Least position of each axis.
    #[variable(start = -1e6, min = -1e9, max = 1e9)]
    pub position_min: [R; AXES],
    /// Greatest position of each axis.
    #[variable(start = 1e6, min = -1e9, max = 1e9)]
    pub position_max: [R; AXES],
    /// How far from either end of its range an axis goes slowly towards it; 0 for no such zone.
    #[variable(start = 0.5, min = 0.0, max = 1e9)]
    pub slow_zone: R,
    /// What is slow, as a share of velocity_limit.
    #[variable(unit = "1", start = 0.25, min = 0.0, max = 1.0)]
    pub slow_share: R,
    /// Greatest speed of each axis.
    #[variable(start = 0.75, min = 1e-6, max = 1e6)]
    pub velocity_limit: [R; AXES],
    /// How strongly each axis is slowed down, for a stop and towards the ends of its range.
    #[variable(start = 0.5, min = 1e-6, max = 1e6)]
    pub deceleration: [R; AXES],
    /// How late an axis follows, and its position is known: it begins to slow down earlier by that.
    #[variable(unit = "s", min = 0.0, max = 1e3)]
    pub reaction_time: R,
    /// Amplitude of the swing beyond which no axis speeds up.
    #[variable(unit = "rad", start = 0.3, min = 0.0, max = std::f64::consts::PI)]
    pub swing_limit: R,
    /// How long a sensor may fail.
    #[variable(unit = "s", start = 0.5, min = 0.0, max = 1e3)]
    pub fault_time: R,
    /// A position may jump as far as its axis goes in this time at its greatest speed.
    #[variable(unit = "s", start = 0.5, min = 0.0, max = 1e6)]
    pub jump_time: R,
    /// A position may rest while its axis should have gone as far as in this time at its greatest speed.
    #[variable(unit = "s", start = 2.0, min = 1e-2, max = 1e6)]
    pub frozen_time: R,
    /// For how long after a drive or an event record stays.
    #[variable(unit = "s", start = 10.0, min = 0.0, max = 1e6)]
    pub record_time: R,
    /// Time from one sample to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.02, min = 0.0, max = 1e3)]
    pub sample_time: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Commanded velocity of each axis.
    #[variable]
    pub command: [R; AXES],
    /// Measured position of each axis.
    #[variable]
    pub position: [R; AXES],
    /// Whether each position is valid.
    #[variable(name = "position.valid", start = true)]
    pub position_valid: [bool; AXES],
    pub hook: HookInputs,
    pub swing: SwingInputs<R>,
    /// Whether the emergency stop is pressed.
    pub emergency_stop: bool,
    /// Pressing it, from false to true, ends a stop and a fault if nothing holds them any more.
    pub reset: bool,
}

#[derive(Clone, Variables)]
pub struct HookInputs {
    /// Whether the swing is measured.
    #[variable(start = true)]
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct SwingInputs<R: Scalar> {
    /// Amplitude of the swing.
    #[variable(unit = "rad")]
    pub amplitude: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// Velocity of each axis that is safe.
    #[variable(output, clock = "sample")]
    pub velocity: [R; AXES],
    /// What the crane may do.
    #[variable(output, start = State::Ready, clock = "sample")]
    pub state: State,
    pub fault: FaultVariables,
    /// Whether what happens is to be recorded.
    #[variable(output, clock = "sample")]
    pub record: bool,
    pub event: EventVariables,
}

#[derive(Clone, Variables)]
pub struct FaultVariables {
    /// What is wrong, or was and has not been reset.
    #[variable(output, start = FaultCode::None, clock = "sample")]
    pub code: FaultCode,
    /// The axis that it is of, 1 to 4; 0 if of none.
    #[variable(output, clock = "sample")]
    pub axis: i32,
}

#[derive(Clone, Variables)]
pub struct EventVariables {
    /// How often state or fault have changed.
    #[variable(output, clock = "sample")]
    pub count: i32,
}
