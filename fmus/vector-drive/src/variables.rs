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
    pub motor: MotorParameters<R>,
    /// Greatest force of the motor.
    #[variable(start = 1e12, min = 1e-6, max = 1e12)]
    pub force_limit: R,
}

#[derive(Clone, Variables)]
pub struct MotorParameters<R: Scalar> {
    /// Mass of motor and gear, as the axis feels it.
    #[variable(start = 1.0, min = 1e-6, max = 1e9)]
    pub mass: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Commanded velocity.
    #[variable(discrete)]
    pub command: R,
    pub load: Load<R>,
}

#[derive(Clone, Variables)]
pub struct Load<R: Scalar> {
    /// Force of the load on the axis; where it is positive, positive velocities work against it.
    #[variable]
    pub force: R,
    /// Mass of the load, as the axis feels it.
    #[variable]
    pub mass: R,
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
    /// Force of the motor.
    pub force: R,
    pub brake: BrakeOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct BrakeOutputs<R: Scalar> {
    /// Force of the brake.
    pub force: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub switch: Switch<R>,
    pub limiter: Limiter<R>,
    /// Whether the load is heavier than the motor can hold.
    #[variable(output, depends_on = ["load.force"])]
    pub overloaded: bool,
    /// Whether the motor is at its limit, so that the axis cannot follow, or only with the brake.
    #[variable(output, depends_on = ["command", "load.force", "load.mass"])]
    pub limited: bool,
    /// Whether mass and force of the load are within what is not cut.
    #[variable(output, start = true, depends_on = ["load.force", "load.mass"])]
    pub valid: bool,
    pub overload: Overload<R>,
    pub brake: Brake,
    pub motor: Motor<R>,
}

#[derive(Clone, Variables)]
pub struct Overload<R: Scalar> {
    /// Sign of a load force that the motor cannot hold, else 0.
    #[variable(depends_on = ["load.force"])]
    pub direction: R,
    /// Whether the axis goes along with such a load, held back by the brake.
    #[variable]
    pub lowering: bool,
}

#[derive(Clone, Variables)]
pub struct Brake {
    /// Whether the brake holds the axis at rest.
    #[variable]
    pub closed: bool,
    /// Whether the brake adds to the force of the motor while the axis moves.
    #[variable]
    pub helping: bool,
}

#[derive(Clone, Variables)]
pub struct Motor<R: Scalar> {
    /// Sign of the force limit that the motor is at, else 0.
    #[variable]
    pub saturation: R,
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
