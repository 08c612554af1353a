//! The variables of the boom crane.

use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub boom: BoomParameters<R>,
    pub luff: LuffParameters<R>,
    pub hoist: HoistParameters<R>,
    pub payload: PayloadParameters<R>,
    pub swing: SwingParameters<R>,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct BoomParameters<R: Scalar> {
    /// Length of the boom, from its foot to its tip (r).
    #[variable(unit = "m", start = 18.0, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Distance of the slewing axis and boom foot ahead of the base's reference point (a).
    #[variable(unit = "m", min = -1e4, max = 1e4)]
    pub offset: R,
    /// Height of the boom foot above the base's reference point (h).
    #[variable(unit = "m", start = 1.5, min = -1e4, max = 1e4)]
    pub height: R,
}

#[derive(Clone, Variables)]
pub struct LuffParameters<R: Scalar> {
    /// Least luff angle, where the boom stops.
    #[variable(unit = "rad", min = -1.57, max = 1.57)]
    pub angle_min: R,
    /// Greatest luff angle, where the boom stops.
    #[variable(unit = "rad", start = 1.5, min = -1.57, max = 1.57)]
    pub angle_max: R,
}

#[derive(Clone, Variables)]
pub struct HoistParameters<R: Scalar> {
    /// Least suspension length, where the hoist stops.
    #[variable(unit = "m", start = 0.5, min = 1e-3)]
    pub length_min: R,
    /// Greatest suspension length, where the hoist stops.
    #[variable(unit = "m", start = 200.0, min = 1e-3, max = 1e4)]
    pub length_max: R,
}

#[derive(Clone, Variables)]
pub struct PayloadParameters<R: Scalar> {
    /// Mass of the payload; it matters to wind only.
    #[variable(unit = "kg", start = 1000.0, min = 1e-6, max = 1e9)]
    pub mass: R,
}

#[derive(Clone, Variables)]
pub struct SwingParameters<R: Scalar> {
    /// Damping of the swing (d); for small swing 2ζω.
    #[variable(unit = "1/s", min = 0.0, max = 1e3)]
    pub damping: R,
    /// Radial swing at the start.
    #[variable(unit = "rad", min = -1.57, max = 1.57)]
    pub radial_start: R,
    /// Tangential swing at the start.
    #[variable(unit = "rad", min = -std::f64::consts::PI, max = std::f64::consts::PI)]
    pub tangential_start: R,
    /// Rate of the radial swing at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub radial_rate_start: R,
    /// Rate of the tangential swing at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub tangential_rate_start: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub base: BaseInputs<R>,
    pub slew: SlewInputs<R>,
    pub luff: LuffInputs<R>,
    pub hoist: HoistInputs<R>,
    pub wind: Wind<R>,
}

#[derive(Clone, Variables)]
pub struct BaseInputs<R: Scalar> {
    pub velocity: BaseVelocity<R>,
    /// Yaw rate of the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub yaw_rate: R,
}

#[derive(Clone, Variables)]
pub struct BaseVelocity<R: Scalar> {
    /// Velocity of the base's reference point, world x.
    #[variable(unit = "m/s")]
    pub x: R,
    /// Velocity of the base's reference point, world y.
    #[variable(unit = "m/s")]
    pub y: R,
}

#[derive(Clone, Variables)]
pub struct SlewInputs<R: Scalar> {
    /// Slew rate relative to the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct LuffInputs<R: Scalar> {
    /// Luff rate, positive upwards.
    #[variable(unit = "rad/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Rate of the suspension length; positive lowers the payload.
    #[variable(unit = "m/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct Wind<R: Scalar> {
    /// Force on the payload, world x.
    #[variable(unit = "N")]
    pub x: R,
    /// Force on the payload, world y.
    #[variable(unit = "N")]
    pub y: R,
    /// Force on the payload, upwards.
    #[variable(unit = "N")]
    pub z: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub base: BaseStates<R>,
    pub slew: SlewStates<R>,
    pub luff: LuffStates<R>,
    pub hoist: HoistStates<R>,
    pub cable: CableStates<R>,
    pub payload: PayloadStates<R>,
}

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

#[derive(Clone, Variables)]
pub struct SlewStates<R: Scalar> {
    /// Slew angle relative to the base.
    #[variable(unit = "rad", output)]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct LuffStates<R: Scalar> {
    /// Angle of the boom above the horizontal.
    #[variable(unit = "rad", output, start = std::f64::consts::FRAC_PI_4)]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct HoistStates<R: Scalar> {
    /// Suspension length, from the boom tip to the payload.
    #[variable(unit = "m", output, start = 10.0, min = 1e-3, nominal = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct CableStates<R: Scalar> {
    /// Unit vector from the boom tip to the payload, in the world frame (n).
    #[variable(unit = "1", calculated)]
    pub direction: [R; 3],
}

#[derive(Clone, Variables)]
pub struct PayloadStates<R: Scalar> {
    /// Velocity of the payload across the cable, in the world frame (w).
    #[variable(unit = "m/s", calculated)]
    pub velocity_across: [R; 3],
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub swing: SwingOutputs<R>,
    pub tip: TipOutputs<R>,
    pub payload: PayloadOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct SwingOutputs<R: Scalar> {
    /// Radial swing, positive away from the slewing axis.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Tangential swing, positive towards increasing slew.
    #[variable(unit = "rad")]
    pub tangential: R,
    /// Time derivative of the radial swing.
    #[variable(unit = "rad/s")]
    pub radial_rate: R,
    /// Time derivative of the tangential swing.
    #[variable(unit = "rad/s")]
    pub tangential_rate: R,
    /// Amplitude the payload would swing with if the tip kept its velocity and the hoist stopped.
    #[variable(unit = "rad")]
    pub amplitude: R,
}

#[derive(Clone, Variables)]
pub struct TipOutputs<R: Scalar> {
    /// Position of the boom tip, world x.
    #[variable(unit = "m")]
    pub x: R,
    /// Position of the boom tip, world y.
    #[variable(unit = "m")]
    pub y: R,
    /// Height of the boom tip.
    #[variable(unit = "m")]
    pub z: R,
}

#[derive(Clone, Variables)]
pub struct PayloadOutputs<R: Scalar> {
    /// Position of the payload, world x.
    #[variable(unit = "m")]
    pub x: R,
    /// Position of the payload, world y.
    #[variable(unit = "m")]
    pub y: R,
    /// Height of the payload.
    #[variable(unit = "m")]
    pub z: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether luff or hoist stands at a limit, or an input is beyond what any crane does and was cut there.
    #[variable(output)]
    pub at_limit: bool,
    pub luff: LuffStop,
    pub hoist: HoistStop,
}

#[derive(Clone, Variables)]
pub struct LuffStop {
    /// Whether the boom stands at a limit.
    #[variable(depends_on = ["luff.angle", "luff.rate"])]
    pub stopped: bool,
}

#[derive(Clone, Variables)]
pub struct HoistStop {
    /// Whether the hoist stands at a limit.
    #[variable(depends_on = ["hoist.length", "hoist.rate"])]
    pub stopped: bool,
}
