//! The variables of the boom crane.

use swayless_crane::{
    BaseAcceleration, BaseStates, BaseVelocity, CableStates, HoistParameters, HoistStates, HoistStop, LuffParameters,
    LuffStates, LuffStop, PayloadStates, Position, SlewStates, SwingOutputs, SwingParameters, Wind,
};
use swayless_export::{Scalar, Variables};
use swayless_mechanics::Limits;

/// No boom is shorter (m).
const SHORTEST: f64 = 1e-3;

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
    /// Length of the boom, from its foot to its tip (r), where its extension is 0.
    #[variable(unit = "m", start = 18.0, min = SHORTEST, max = 1e4)]
    pub length: R,
    /// Least extension of the telescoping boom, where it stops; in any case it stops before its length is 0.
    #[variable(unit = "m", start = -1e3, min = -1e4, max = 1e4)]
    pub extension_min: R,
    /// Greatest extension of the telescoping boom, where it stops.
    #[variable(unit = "m", start = 1e3, min = -1e4, max = 1e4)]
    pub extension_max: R,
    /// Distance of the slewing axis and boom foot ahead of the base's reference point (a).
    #[variable(unit = "m", min = -1e4, max = 1e4)]
    pub offset: R,
    /// Height of the boom foot above the base's reference point (h).
    #[variable(unit = "m", start = 1.5, min = -1e4, max = 1e4)]
    pub height: R,
}

impl BoomParameters<f64> {
    /// Between which extensions the boom telescopes.
    pub fn limits(&self) -> Limits {
        Limits { min: self.extension_min.max(SHORTEST - self.length), max: self.extension_max }
    }
}

#[derive(Clone, Variables)]
pub struct PayloadParameters<R: Scalar> {
    /// Mass of the payload; it matters to wind and tension only.
    #[variable(unit = "kg", start = 1000.0, min = 1e-6, max = 1e9)]
    pub mass: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub base: BaseInputs<R>,
    pub slew: SlewInputs<R>,
    pub luff: LuffInputs<R>,
    pub hoist: HoistInputs<R>,
    pub boom: BoomInputs<R>,
    pub wind: Wind<R>,
}

#[derive(Clone, Variables)]
pub struct BaseInputs<R: Scalar> {
    pub velocity: BaseVelocity<R>,
    /// Yaw rate of the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub yaw_rate: R,
    pub acceleration: BaseAcceleration<R>,
    /// Yaw acceleration of the base; it matters to the tension only.
    #[variable(unit = "rad/s2")]
    pub yaw_acceleration: R,
}

#[derive(Clone, Variables)]
pub struct SlewInputs<R: Scalar> {
    /// Slew rate relative to the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub rate: R,
    /// Time derivative of the slew rate; it matters to the tension only.
    #[variable(unit = "rad/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct LuffInputs<R: Scalar> {
    /// Luff rate, positive upwards.
    #[variable(unit = "rad/s")]
    pub rate: R,
    /// Time derivative of the luff rate; it matters to the tension only.
    #[variable(unit = "rad/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Rate of the suspension length; positive lowers the payload.
    #[variable(unit = "m/s")]
    pub rate: R,
    /// Time derivative of the hoist rate; it matters to the tension only.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct BoomInputs<R: Scalar> {
    /// Rate of the boom's extension, positive outwards.
    #[variable(unit = "m/s")]
    pub rate: R,
    /// Time derivative of the boom rate; it matters to the tension only.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub base: BaseStates<R>,
    pub slew: SlewStates<R>,
    pub luff: LuffStates<R>,
    pub hoist: HoistStates<R>,
    pub boom: BoomStates<R>,
    pub cable: CableStates<R>,
    pub payload: PayloadStates<R>,
}

#[derive(Clone, Variables)]
pub struct BoomStates<R: Scalar> {
    /// Extension of the telescoping boom beyond its length.
    #[variable(unit = "m", output)]
    pub extension: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub swing: SwingOutputs<R>,
    pub tip: Position<R>,
    pub payload: Position<R>,
    /// Tension of the cable, with the accelerations that are given; without them, rates are taken as constant.
    #[variable(unit = "N")]
    pub tension: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether luff, hoist or telescope stands at a limit, or an input is beyond what any crane does and was cut there.
    #[variable(output)]
    pub at_limit: bool,
    /// Whether the tension is not positive, so that a cable would be slack; the motion is computed as if it were taut.
    #[variable(output)]
    pub slack: bool,
    pub luff: LuffStop,
    pub hoist: HoistStop,
    pub boom: BoomStop,
}

#[derive(Clone, Variables)]
pub struct BoomStop {
    /// Whether the telescope stands at a limit.
    #[variable(depends_on = ["boom.extension", "boom.rate"])]
    pub stopped: bool,
}
