//! The variables of the vector drive. Command and velocity carry no unit: the same drive turns an axis (rad/s) or
//! pulls a rope (m/s).

use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Greatest speed that a command asks for (p).
    #[variable(start = 0.75, min = 0.0, max = 1e6)]
    pub velocity_limit: R,
    /// Speed up to which a reversed command is taken at once (X); above, the axis brakes to it first.
    #[variable(start = 0.05, min = 0.0, max = 1e6)]
    pub reversal_threshold: R,
    /// Greatest acceleration (a_max).
    #[variable(start = 0.63, min = 1e-9, max = 1e6)]
    pub acceleration_limit: R,
    /// Damping ratio of the second-order response (ζ_H).
    #[variable(unit = "1", start = 0.75, min = 0.0, max = 10.0)]
    pub damping_ratio: R,
    /// Natural frequency of the second-order response (ω_H).
    #[variable(unit = "rad/s", start = 3.7, min = 1e-6, max = 1e4)]
    pub natural_frequency: R,
    /// A command up to this magnitude counts as 0.
    #[variable(min = 0.0, max = 1e6)]
    pub dead_zone: R,
    /// Whether the second-order response is there; without it the drive is purely acceleration-limited.
    #[variable(start = true)]
    pub smoothing: bool,
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
    pub limiter: LimiterStates<R>,
    pub response: ResponseStates<R>,
}

#[derive(Clone, Variables)]
pub struct LimiterStates<R: Scalar> {
    /// Velocity behind the rate limiter (r).
    #[variable]
    pub reference: R,
}

#[derive(Clone, Variables)]
pub struct ResponseStates<R: Scalar> {
    /// Velocity behind the second-order response.
    #[variable]
    pub velocity: R,
    /// Its time derivative.
    #[variable]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// Velocity of the axis (V_t).
    pub velocity: R,
    /// Acceleration of the axis.
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub switch: Switch<R>,
    pub limiter: Limiter<R>,
}

#[derive(Clone, Variables)]
pub struct Switch<R: Scalar> {
    /// Sign of the command behind saturator and dead zone.
    #[variable(depends_on = ["command"])]
    pub direction: R,
    /// Whether the axis moves against the command faster than the threshold, so that it brakes first.
    #[variable]
    pub opposed: bool,
}

#[derive(Clone, Variables)]
pub struct Limiter<R: Scalar> {
    /// What the rate limiter runs to.
    #[variable]
    pub target: R,
    /// The slope of the rate limiter on its way.
    #[variable]
    pub slope: R,
    /// Whether the rate limiter has met its target and follows it.
    #[variable(start = true)]
    pub tracking: bool,
}
