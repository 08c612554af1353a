//! The variables of the sway damper.

use swayless_export::{Scalar, Variables};

/// All that a sample depends on.
pub const READ: [&str; 7] =
    ["command.x", "command.y", "swing.radial", "swing.tangential", "slew.angle", "base.yaw", "valid"];

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Velocity per swing angle, in m/s per rad (k).
    #[variable(unit = "m/s", start = 2.0, min = 0.0, max = 100.0, tunable)]
    pub gain: R,
    /// How far ahead of the measured swing the feedback is.
    #[variable(unit = "s", min = 0.0, max = 10.0, tunable)]
    pub lead_time: R,
    /// Time constant of the filter of the swing rate, which is found from differences.
    #[variable(unit = "s", start = 0.1, min = 0.0, max = 10.0, tunable)]
    pub filter_time: R,
    /// Greatest correction to the command.
    #[variable(unit = "m/s", start = 0.2, min = 0.0, max = 100.0, tunable)]
    pub correction_limit: R,
    /// Time in which the correction fades out when the swing is not measured, and in again.
    #[variable(unit = "s", start = 0.5, min = 0.0, max = 1e3)]
    pub fade_time: R,
    /// Time from one sample to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.04, min = 0.0, max = 10.0)]
    pub sample_time: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub command: Command<R>,
    pub swing: Swing<R>,
    pub slew: Slew<R>,
    pub base: Base<R>,
    /// Whether the swing is measured.
    #[variable(start = true)]
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct Command<R: Scalar> {
    /// Commanded velocity in world x.
    #[variable(unit = "m/s")]
    pub x: R,
    /// Commanded velocity in world y.
    #[variable(unit = "m/s")]
    pub y: R,
}

#[derive(Clone, Variables)]
pub struct Swing<R: Scalar> {
    /// Radial swing angle, away from the slewing axis.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Tangential swing angle, towards increasing slew.
    #[variable(unit = "rad")]
    pub tangential: R,
}

#[derive(Clone, Variables)]
pub struct Slew<R: Scalar> {
    /// Slew angle, relative to the base.
    #[variable(unit = "rad")]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct Base<R: Scalar> {
    /// Yaw of the base.
    #[variable(unit = "rad")]
    pub yaw: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub velocity: Velocity<R>,
}

#[derive(Clone, Variables)]
pub struct Velocity<R: Scalar> {
    /// Velocity in world x that damps the swing.
    #[variable(output, unit = "m/s", clock = "sample", depends_on = READ)]
    pub x: R,
    /// Velocity in world y that damps the swing.
    #[variable(output, unit = "m/s", clock = "sample", depends_on = READ)]
    pub y: R,
}
