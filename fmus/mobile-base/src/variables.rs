//! The variables of the mobile base.

use swayless_crane::{BaseAcceleration, BaseStates, BaseVelocity};
use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Distance from the rear axle to the front axle.
    #[variable(unit = "m", start = 4.0, min = 0.1, max = 100.0)]
    pub wheelbase: R,
    /// Greatest speed, in either direction.
    #[variable(unit = "m/s", start = 2.0, min = 1e-3, max = 100.0)]
    pub speed_limit: R,
    /// Greatest angle of the front wheels, to either side.
    #[variable(unit = "rad", start = 0.6, min = 1e-3, max = 1.5)]
    pub steering_limit: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Speed of the rear axle; negative drives backwards.
    #[variable(unit = "m/s")]
    pub speed: R,
    /// Angle of the front wheels, positive to the left.
    #[variable(unit = "rad")]
    pub steering: R,
    /// Time derivative of the speed; it matters to the accelerations only.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
    /// Time derivative of the front wheels' angle; it matters to the yaw acceleration only.
    #[variable(unit = "rad/s")]
    pub steering_rate: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub base: BaseStates<R>,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub base: BaseOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct BaseOutputs<R: Scalar> {
    pub velocity: BaseVelocity<R>,
    /// Yaw rate of the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub yaw_rate: R,
    pub acceleration: BaseAcceleration<R>,
    /// Yaw acceleration of the base.
    #[variable(unit = "rad/s2")]
    pub yaw_acceleration: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether speed or steering is beyond its limit, or a time derivative beyond what any base has, and is cut there.
    #[variable(output)]
    pub at_limit: bool,
    pub cut: Cut,
}

#[derive(Clone, Variables)]
pub struct Cut {
    /// Whether the speed is cut at its limit.
    #[variable(depends_on = ["speed"])]
    pub speed: bool,
    /// Whether the steering is cut at its limit.
    #[variable(depends_on = ["steering"])]
    pub steering: bool,
}
