//! The variables of the tower crane.

use swayless_crane::{
    CableStates, HoistInputs, HoistParameters, HoistStates, HoistStop, PayloadStates, Position, SlewInputs, SlewStates,
    SwingOutputs, SwingParameters, Wind,
};
use swayless_export::{Scalar, Variables};
use swayless_mechanics::Limits;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub jib: JibParameters<R>,
    pub trolley: TrolleyParameters<R>,
    pub hoist: HoistParameters<R>,
    pub payload: PayloadParameters<R>,
    pub swing: SwingParameters<R>,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct JibParameters<R: Scalar> {
    /// Height of the jib, on which the trolley runs.
    #[variable(unit = "m", start = 40.0, min = -1e4, max = 1e4)]
    pub height: R,
}

#[derive(Clone, Variables)]
pub struct TrolleyParameters<R: Scalar> {
    /// Least radius, where the trolley stops.
    #[variable(unit = "m", start = 3.0, min = 0.0, max = 1e4)]
    pub radius_min: R,
    /// Greatest radius, where the trolley stops.
    #[variable(unit = "m", start = 60.0, min = 0.0, max = 1e4)]
    pub radius_max: R,
}

impl TrolleyParameters<f64> {
    /// Between which radii the trolley runs.
    pub fn limits(&self) -> Limits {
        Limits { min: self.radius_min, max: self.radius_max }
    }
}

#[derive(Clone, Variables)]
pub struct PayloadParameters<R: Scalar> {
    /// Mass of the payload; it matters to wind only.
    #[variable(unit = "kg", start = 1000.0, min = 1e-6, max = 1e9)]
    pub mass: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub slew: SlewInputs<R>,
    pub trolley: TrolleyInputs<R>,
    pub hoist: HoistInputs<R>,
    pub wind: Wind<R>,
}

#[derive(Clone, Variables)]
pub struct TrolleyInputs<R: Scalar> {
    /// Velocity of the trolley along the jib, positive outwards.
    #[variable(unit = "m/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub slew: SlewStates<R>,
    pub trolley: TrolleyStates<R>,
    pub hoist: HoistStates<R>,
    pub cable: CableStates<R>,
    pub payload: PayloadStates<R>,
}

#[derive(Clone, Variables)]
pub struct TrolleyStates<R: Scalar> {
    /// Distance of the trolley from the slewing axis.
    #[variable(unit = "m", output, start = 20.0, nominal = 10.0)]
    pub radius: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub swing: SwingOutputs<R>,
    pub trolley: Position<R>,
    pub payload: Position<R>,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether trolley or hoist stands at a limit, or an input is beyond what any crane does and was cut there.
    #[variable(output)]
    pub at_limit: bool,
    pub trolley: TrolleyStop,
    pub hoist: HoistStop,
}

#[derive(Clone, Variables)]
pub struct TrolleyStop {
    /// Whether the trolley stands at a limit.
    #[variable(depends_on = ["trolley.radius", "trolley.rate"])]
    pub stopped: bool,
}
