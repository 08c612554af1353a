//! The base that a mobile crane stands on.

use swayless_export::{Scalar, Variables};

/// Where a base is.
#[derive(Clone, Variables)]
pub struct BaseStates<R: Scalar> {
    /// Position of the base's reference point, world x.
    #[variable(unit = "m", output)]
    pub x: R,
    /// Position of the base's reference point, world y.
    #[variable(unit = "m", output)]
    pub y: R,
    /// Yaw of the base.
    #[variable(unit = "rad", output)]
    pub yaw: R,
}

/// How it moves.
#[derive(Clone, Variables)]
pub struct BaseVelocity<R: Scalar> {
    /// Velocity of the base's reference point, world x.
    #[variable(unit = "m/s")]
    pub x: R,
    /// Velocity of the base's reference point, world y.
    #[variable(unit = "m/s")]
    pub y: R,
}

/// How its motion changes.
#[derive(Clone, Variables)]
pub struct BaseAcceleration<R: Scalar> {
    /// Acceleration of the base's reference point, world x.
    #[variable(unit = "m/s2")]
    pub x: R,
    /// Acceleration of the base's reference point, world y.
    #[variable(unit = "m/s2")]
    pub y: R,
}
