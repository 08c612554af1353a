//! The variables of the Cartesian controller.

use swayless_crane::{BaseVelocity, FASTEST, HoistSheaveParameters, JibParameters, STRONGEST};
use swayless_export::{Enumeration, Scalar, Variables};

/// No angle is greater (rad), and no joint farther (m).
pub const MOST_TURNED: f64 = 1e6;
pub const FARTHEST: f64 = 1e4;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Machine {
    /// A boom that slews and luffs, with a hoist: a mobile boom crane.
    Boom,
    /// A trolley on a jib that slews, with a hoist: a tower crane.
    Tower,
    /// A boom that slews, luffs and extends: a boom lift.
    BoomLift,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Frame {
    /// x and y are the world's.
    World,
    /// x is radial, away from the slewing axis, y tangential, towards increasing slew.
    Crane,
    /// x is ahead of an operator who looks along operator.heading, y to the left.
    Ground,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Scaling {
    /// All axes get slower together: the load keeps to its path.
    Uniform,
    /// All axes but the hoist, as in the thesis: the load does not keep its height.
    Thesis,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// What is controlled.
    #[variable(start = Machine::Boom)]
    pub machine: Machine,
    /// Which directions velocity.x and velocity.y have.
    #[variable(start = Frame::World)]
    pub frame: Frame,
    /// What happens where an axis would be too fast.
    #[variable(start = Scaling::Uniform)]
    pub scaling: Scaling,
    pub boom: BoomParameters<R>,
    pub jib: JibParameters<R>,
    pub hoist_sheave: HoistSheaveParameters<R>,
    pub slew: SlewLimits<R>,
    pub luff: LuffLimits<R>,
    pub hoist: HoistLimits<R>,
    pub trolley: TrolleyParameters<R>,
    pub extension: ExtensionLimits<R>,
    pub drive: DriveParameters<R>,
    /// How close to a singular luff angle the load gets slower.
    #[variable(unit = "rad", start = 0.05, min = 1e-4, max = 0.5)]
    pub singularity_margin: R,
    /// Time from one sample to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.02, min = 0.0, max = 1e3)]
    pub sample_time: R,
    /// How far ahead the rates are right: the age of the measured positions, and half of the time that rates are held.
    #[variable(unit = "s", min = 0.0, max = 10.0)]
    pub look_ahead: R,
}

#[derive(Clone, Variables)]
pub struct BoomParameters<R: Scalar> {
    /// Length of the boom without its extension (r).
    #[variable(unit = "m", start = 18.0, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Distance of the slewing axis ahead of the base's reference point (a).
    #[variable(unit = "m", min = -1e4, max = 1e4)]
    pub offset: R,
}

#[derive(Clone, Variables)]
pub struct SlewLimits<R: Scalar> {
    /// Greatest slew rate; 0 locks the axis.
    #[variable(unit = "rad/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub rate_limit: R,
    /// Greatest acceleration of the slew.
    #[variable(unit = "rad/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub acceleration_limit: R,
}

#[derive(Clone, Variables)]
pub struct LuffLimits<R: Scalar> {
    /// Greatest luff rate; 0 locks the axis.
    #[variable(unit = "rad/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub rate_limit: R,
    /// Greatest acceleration of the luff.
    #[variable(unit = "rad/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub acceleration_limit: R,
    /// Greatest speed of the luff line; 0 locks the axis.
    #[variable(unit = "m/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub line_speed_limit: R,
    /// Greatest acceleration of the luff line.
    #[variable(unit = "m/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub line_acceleration_limit: R,
    /// Least luff angle, before which the load comes to rest.
    #[variable(unit = "rad", start = -MOST_TURNED, min = -1e9, max = 1e9)]
    pub angle_min: R,
    /// Greatest luff angle, before which the load comes to rest.
    #[variable(unit = "rad", start = MOST_TURNED, min = -1e9, max = 1e9)]
    pub angle_max: R,
}

#[derive(Clone, Variables)]
pub struct HoistLimits<R: Scalar> {
    /// Greatest rate of the suspension length; 0 locks it.
    #[variable(unit = "m/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub rate_limit: R,
    /// Greatest acceleration of the suspension length.
    #[variable(unit = "m/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub acceleration_limit: R,
    /// Greatest speed of the hoist line; 0 locks the axis.
    #[variable(unit = "m/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub line_speed_limit: R,
    /// Greatest acceleration of the hoist line.
    #[variable(unit = "m/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub line_acceleration_limit: R,
    /// Least suspension length, before which the load comes to rest.
    #[variable(unit = "m", min = 0.0, max = FARTHEST)]
    pub length_min: R,
    /// Greatest suspension length, before which the load comes to rest.
    #[variable(unit = "m", start = FARTHEST, min = 0.0, max = FARTHEST)]
    pub length_max: R,
}

#[derive(Clone, Variables)]
pub struct TrolleyParameters<R: Scalar> {
    /// Greatest speed of the trolley; 0 locks the axis.
    #[variable(unit = "m/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub rate_limit: R,
    /// Greatest acceleration of the trolley.
    #[variable(unit = "m/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub acceleration_limit: R,
    /// Least radius, before which the load comes to rest.
    #[variable(unit = "m", min = 0.0, max = FARTHEST)]
    pub radius_min: R,
    /// Greatest radius, before which the load comes to rest.
    #[variable(unit = "m", start = FARTHEST, min = 0.0, max = FARTHEST)]
    pub radius_max: R,
    /// How close to the slewing axis the load gets slower.
    #[variable(unit = "m", start = 0.5, min = 1e-4, max = 1e3)]
    pub singularity_margin: R,
}

#[derive(Clone, Variables)]
pub struct ExtensionLimits<R: Scalar> {
    /// Greatest rate of the boom's extension; 0 locks the axis.
    #[variable(unit = "m/s", start = FASTEST, min = 0.0, max = FASTEST)]
    pub rate_limit: R,
    /// Greatest acceleration of the boom's extension.
    #[variable(unit = "m/s2", start = STRONGEST, min = 1e-6, max = STRONGEST)]
    pub acceleration_limit: R,
    /// Least extension, before which the load comes to rest.
    #[variable(unit = "m", start = -FARTHEST, min = -1e5, max = 1e5)]
    pub length_min: R,
    /// Greatest extension, before which the load comes to rest.
    #[variable(unit = "m", start = FARTHEST, min = -1e5, max = 1e5)]
    pub length_max: R,
}

#[derive(Clone, Variables)]
pub struct DriveParameters<R: Scalar> {
    /// Natural frequency of the drives' response, which all axes share; 0 for drives that follow at once.
    #[variable(unit = "rad/s", min = 0.0, max = 1e4)]
    pub natural_frequency: R,
    /// Damping ratio of the drives' response.
    #[variable(unit = "1", start = 0.75, min = 0.0, max = 10.0)]
    pub damping_ratio: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub velocity: VelocityInputs<R>,
    pub slew: SlewInputs<R>,
    pub luff: LuffInputs<R>,
    pub hoist: HoistInputs<R>,
    pub trolley: TrolleyInputs<R>,
    pub extension: ExtensionInputs<R>,
    pub base: BaseInputs<R>,
    pub operator: OperatorInputs<R>,
}

#[derive(Clone, Variables)]
pub struct VelocityInputs<R: Scalar> {
    /// Velocity that the load is to have, along x.
    #[variable(unit = "m/s")]
    pub x: R,
    /// Velocity that the load is to have, along y.
    #[variable(unit = "m/s")]
    pub y: R,
    /// Velocity that the load is to have, upwards.
    #[variable(unit = "m/s")]
    pub z: R,
}

#[derive(Clone, Variables)]
pub struct SlewInputs<R: Scalar> {
    /// Slew angle relative to the base.
    #[variable(unit = "rad")]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct LuffInputs<R: Scalar> {
    /// Angle of the boom above the horizontal.
    #[variable(unit = "rad", start = std::f64::consts::FRAC_PI_4)]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Suspension length, for the ends of its range only.
    #[variable(unit = "m", start = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct TrolleyInputs<R: Scalar> {
    /// Distance of the trolley from the slewing axis.
    #[variable(unit = "m", start = 20.0)]
    pub radius: R,
}

#[derive(Clone, Variables)]
pub struct ExtensionInputs<R: Scalar> {
    /// Extension of the boom beyond its length (ρ).
    #[variable(unit = "m")]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct BaseInputs<R: Scalar> {
    /// Yaw of the base.
    #[variable(unit = "rad")]
    pub yaw: R,
    pub velocity: BaseVelocity<R>,
    /// Yaw rate of the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub yaw_rate: R,
}

#[derive(Clone, Variables)]
pub struct OperatorInputs<R: Scalar> {
    /// Where the operator looks: angle from world x, positive counter-clockwise seen from above.
    #[variable(unit = "rad")]
    pub heading: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub slew: SlewRate<R>,
    pub luff: LuffRates<R>,
    pub hoist: HoistRates<R>,
    pub trolley: TrolleyRate<R>,
    pub extension: ExtensionRate<R>,
    /// Share of the commanded speed that the load is given.
    #[variable(output, unit = "1", start = 1.0, clock = "sample")]
    pub speed_fraction: R,
    pub base: BaseFraction<R>,
    /// Whether the crane cannot do all that is asked for, or an input is beyond what any crane does and was cut there.
    #[variable(output, clock = "sample")]
    pub saturated: bool,
    /// Whether the crane is within the margin of a singular position, or boom and jib lie almost in one line.
    #[variable(output, clock = "sample")]
    pub singular: bool,
}

#[derive(Clone, Variables)]
pub struct SlewRate<R: Scalar> {
    /// Slew rate relative to the base.
    #[variable(output, unit = "rad/s", clock = "sample")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct LuffRates<R: Scalar> {
    /// Luff rate, positive upwards.
    #[variable(output, unit = "rad/s", clock = "sample")]
    pub rate: R,
    /// Speed at which the luff line is reeled in, for a boom that is luffed by it.
    #[variable(output, unit = "m/s", clock = "sample")]
    pub line_speed: R,
}

#[derive(Clone, Variables)]
pub struct HoistRates<R: Scalar> {
    /// Rate of the suspension length; positive lowers the load.
    #[variable(output, unit = "m/s", clock = "sample")]
    pub rate: R,
    /// Speed at which the hoist line is paid out, where it runs over a sheave on the jib.
    #[variable(output, unit = "m/s", clock = "sample")]
    pub line_speed: R,
}

#[derive(Clone, Variables)]
pub struct TrolleyRate<R: Scalar> {
    /// Velocity of the trolley along the jib, positive outwards.
    #[variable(output, unit = "m/s", clock = "sample")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct ExtensionRate<R: Scalar> {
    /// Rate of the boom's extension.
    #[variable(output, unit = "m/s", clock = "sample")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct BaseFraction<R: Scalar> {
    /// Share of the base's motion that the crane makes up for.
    #[variable(output, unit = "1", start = 1.0, clock = "sample")]
    pub cancelled_fraction: R,
}
