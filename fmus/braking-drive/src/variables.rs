//! The variables of the braking drive. Command and velocity carry no unit: the same drive turns an axis (rad/s) or
//! moves a trolley (m/s).

use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Time constant while the axis speeds up (τ_a).
    #[variable(unit = "s", start = 0.2, min = 1e-4, max = 1e6)]
    pub acceleration_time_constant: R,
    /// Time constant while the axis brakes (τ_b).
    #[variable(unit = "s", start = 0.065, min = 1e-4, max = 1e6)]
    pub braking_time_constant: R,
    /// Greatest speed that a command asks for.
    #[variable(start = 1e6, min = 0.0, max = 1e6)]
    pub velocity_limit: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Commanded velocity.
    #[variable(discrete)]
    pub command: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    /// Position of the axis: the integral of its velocity.
    #[variable(output)]
    pub position: R,
    /// Velocity of the axis (v).
    #[variable(output, min = -1e6, max = 1e6)]
    pub velocity: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// Acceleration of the axis.
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// Whether the axis slows down, to a lower speed, to rest or to turn back.
    #[variable(output, depends_on = ["command", "velocity"])]
    pub braking: bool,
    /// Whether the command is beyond the velocity limit and was cut there.
    #[variable(output, depends_on = ["command"])]
    pub saturated: bool,
    /// The command within the velocity limit (v_c).
    #[variable(depends_on = ["command"])]
    pub target: R,
    pub reversal: Reversal<R>,
}

#[derive(Clone, Variables)]
pub struct Reversal<R: Scalar> {
    /// Whether the axis still moves against the command.
    #[variable(depends_on = ["command", "velocity"])]
    pub ahead: bool,
    /// When the axis turns back, or last did.
    #[variable(unit = "s", depends_on = ["command", "velocity"])]
    pub time: R,
}
