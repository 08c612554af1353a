//! The variables of the anti-sway and positioning controller.

use swayless_export::{Enumeration, Scalar, Variables};

/// How many targets can be stored.
pub const TARGETS: usize = 16;

/// All that a sample depends on.
pub const READ: [&str; 10] = [
    "mode",
    "manual.velocity",
    "target.index",
    "target.position",
    "hook.displacement",
    "hook.valid",
    "hoist.length",
    "crane.position",
    "position.valid",
    "enabled",
];

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Form {
    /// A shaped move is planned, and feedback acts on what deviates from the plan.
    Planned,
    /// The shaper sits in the position loop, designed for the poles that sway feedback gives the crane, with a prediction.
    InLoop,
    /// The same without the prediction.
    PlainLoop,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Mode {
    /// The velocity is manual.velocity.
    Manual,
    /// To the target.
    GoTo,
    /// Stays.
    Hold,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Where shaping takes place.
    #[variable(start = Form::Planned)]
    pub form: Form,
    /// Positions for target.index 1 to 16.
    #[variable(unit = "m", min = -1e6, max = 1e6)]
    pub stored_target: [R; TARGETS],
    /// Greatest commanded speed.
    #[variable(unit = "m/s", start = 0.75, min = 0.0, max = 100.0)]
    pub velocity_limit: R,
    /// Greatest rate of change of the commanded velocity.
    #[variable(unit = "m/s2", start = 0.63, min = 1e-6, max = 1e3)]
    pub acceleration_limit: R,
    /// Velocity per distance to where the trolley is to be (K_p).
    #[variable(unit = "1/s", start = 0.14, min = 0.0, max = 10.0, tunable)]
    pub position_gain: R,
    /// Velocity per swing angle of the hook, in m/s per rad (k).
    #[variable(unit = "m/s", start = 3.0, min = 0.0, max = 100.0, tunable)]
    pub sway_gain: R,
    /// How far ahead of the swing its feedback is.
    #[variable(unit = "s", start = 0.4, min = 0.0, max = 10.0, tunable)]
    pub lead_time: R,
    /// Greatest part of the velocity that comes from feedback alone.
    #[variable(unit = "m/s", start = 0.35, min = 0.0, max = 100.0, tunable)]
    pub correction_limit: R,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
    pub rigging: RiggingParameters<R>,
    /// Mass of the payload per mass of the hook; 0 for none.
    #[variable(unit = "1", start = 0.5, min = 0.0, max = 1e3)]
    pub mass_ratio: R,
    pub drive: DriveParameters<R>,
    pub hook: HookParameters<R>,
    pub position: PositionParameters<R>,
    pub observer: ObserverParameters<R>,
    /// Time in which feedback fades out when a sensor fails, and in again.
    #[variable(unit = "s", start = 0.5, min = 0.0, max = 1e3)]
    pub fade_time: R,
    /// How near to its target the trolley is there.
    #[variable(unit = "m", start = 0.005, min = 0.0, max = 1e3)]
    pub position_tolerance: R,
    /// How far the hook may swing that counts as settled.
    #[variable(unit = "m", start = 0.01, min = 0.0, max = 1e3)]
    pub swing_tolerance: R,
    /// Time from one sample to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.02, min = 0.0, max = 10.0)]
    pub sample_time: R,
}

#[derive(Clone, Variables)]
pub struct RiggingParameters<R: Scalar> {
    /// Distance from the hook to the payload (L_p).
    #[variable(unit = "m", start = 3.0, min = 0.01, max = 1e4)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct DriveParameters<R: Scalar> {
    /// Natural frequency of the drive's response.
    #[variable(unit = "rad/s", start = 3.7, min = 0.1, max = 1e3)]
    pub natural_frequency: R,
    /// Damping ratio of the drive's response.
    #[variable(unit = "1", start = 0.75, min = 0.01, max = 10.0)]
    pub damping_ratio: R,
}

#[derive(Clone, Variables)]
pub struct HookParameters<R: Scalar> {
    /// Age of the measured displacement, on average.
    #[variable(unit = "s", start = 0.12, min = 0.0, max = 10.0)]
    pub latency: R,
    /// Standard deviation of its noise, as the observer reckons with it.
    #[variable(unit = "m", start = 0.003, min = 1e-6, max = 1e3)]
    pub noise: R,
}

#[derive(Clone, Variables)]
pub struct PositionParameters<R: Scalar> {
    /// Age of the measured position, on average.
    #[variable(unit = "s", start = 0.02, min = 0.0, max = 10.0)]
    pub latency: R,
    /// Time constant with which the estimated position follows the measured one.
    #[variable(unit = "s", start = 0.2, min = 0.0, max = 1e3)]
    pub filter_time: R,
}

#[derive(Clone, Variables)]
pub struct ObserverParameters<R: Scalar> {
    /// Acceleration of hook and payload that the model does not know of, in m/s² per √Hz.
    #[variable(start = 0.02, min = 1e-6, max = 1e3)]
    pub disturbance: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// What to do.
    #[variable(start = Mode::Manual)]
    pub mode: Mode,
    pub manual: Manual<R>,
    pub target: Target<R>,
    pub hook: Hook<R>,
    pub hoist: Hoist<R>,
    pub crane: Crane<R>,
    pub position: Position,
    /// Whether the controller commands anything; if not, the velocity runs out.
    #[variable(start = true)]
    pub enabled: bool,
}

#[derive(Clone, Variables)]
pub struct Manual<R: Scalar> {
    /// Velocity that the operator wants.
    #[variable(unit = "m/s")]
    pub velocity: R,
}

#[derive(Clone, Variables)]
pub struct Target<R: Scalar> {
    /// Which stored target to go to; 0 for target.position.
    pub index: i32,
    /// Where to go if the index is 0.
    #[variable(unit = "m")]
    pub position: R,
}

#[derive(Clone, Variables)]
pub struct Hook<R: Scalar> {
    /// Measured displacement of the hook from the vertical through the trolley.
    #[variable(unit = "m")]
    pub displacement: R,
    /// Whether it is measured.
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct Hoist<R: Scalar> {
    /// Distance from trolley to hook (L_h).
    #[variable(unit = "m", start = 8.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct Crane<R: Scalar> {
    /// Measured position of the trolley.
    #[variable(unit = "m")]
    pub position: R,
}

#[derive(Clone, Variables)]
pub struct Position {
    /// Whether it is measured.
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// Commanded velocity.
    #[variable(output, unit = "m/s", clock = "sample", depends_on = READ)]
    pub velocity: R,
    /// Whether the trolley is within position_tolerance of its target.
    #[variable(output, clock = "sample", depends_on = READ)]
    pub at_target: bool,
    /// Whether the hook swings by swing_tolerance at most, and would if the trolley stopped.
    #[variable(output, clock = "sample", depends_on = READ)]
    pub settled: bool,
    /// Distance to the target, or to where the trolley is held.
    #[variable(output, unit = "m", clock = "sample", depends_on = READ)]
    pub position_error: R,
    /// Whether all inputs can be what they are, and the closed loop is stable.
    #[variable(output, clock = "sample", depends_on = READ)]
    pub valid: bool,
    /// Part of the velocity that comes from feedback alone.
    #[variable(output, unit = "m/s", clock = "sample", depends_on = READ)]
    pub correction: R,
    pub planned: Planned<R>,
    pub estimated: Estimated<R>,
}

#[derive(Clone, Variables)]
pub struct Planned<R: Scalar> {
    /// Where the trolley is by the plan.
    #[variable(output, unit = "m", clock = "sample", depends_on = READ)]
    pub position: R,
    /// Displacement of the hook by the plan.
    #[variable(output, unit = "m", clock = "sample", depends_on = READ)]
    pub displacement: R,
}

#[derive(Clone, Variables)]
pub struct Estimated<R: Scalar> {
    /// Where the trolley is, as far as it is known.
    #[variable(output, unit = "m", clock = "sample", depends_on = READ)]
    pub position: R,
    /// Displacement of the hook now, as far as it is known.
    #[variable(output, unit = "m", clock = "sample", depends_on = READ)]
    pub displacement: R,
}
