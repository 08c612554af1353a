//! The variables of the bridge crane.

use swayless_crane::{HoistInputs, HoistParameters, HoistStates, HoistStop, Wind};
use swayless_export::{Scalar, Variables};
use swayless_mechanics::{Limits, Payload, Swing, SwingFrame, Vector};

/// No trolley or bridge goes farther (m).
const FARTHEST: f64 = 1e4;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub rail: RailParameters<R>,
    pub trolley: TrolleyParameters<R>,
    pub bridge: BridgeParameters<R>,
    pub hoist: HoistParameters<R>,
    pub hook: HookParameters<R>,
    pub rigging: RiggingParameters<R>,
    pub payload: PayloadParameters<R>,
    pub swing: SwingParameters<R>,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct RailParameters<R: Scalar> {
    /// Height of the point on the trolley that the cable hangs from.
    #[variable(unit = "m", start = 10.0, min = -FARTHEST, max = FARTHEST)]
    pub height: R,
}

#[derive(Clone, Variables)]
pub struct TrolleyParameters<R: Scalar> {
    /// Least position of the trolley, where it stops.
    #[variable(unit = "m", start = -1e3, min = -FARTHEST, max = FARTHEST)]
    pub x_min: R,
    /// Greatest position of the trolley, where it stops.
    #[variable(unit = "m", start = 1e3, min = -FARTHEST, max = FARTHEST)]
    pub x_max: R,
}

impl TrolleyParameters<f64> {
    /// Between which positions the trolley runs.
    pub fn limits(&self) -> Limits {
        Limits { min: self.x_min, max: self.x_max }
    }
}

#[derive(Clone, Variables)]
pub struct BridgeParameters<R: Scalar> {
    /// Least position of the bridge, where it stops.
    #[variable(unit = "m", start = -1e3, min = -FARTHEST, max = FARTHEST)]
    pub y_min: R,
    /// Greatest position of the bridge, where it stops.
    #[variable(unit = "m", start = 1e3, min = -FARTHEST, max = FARTHEST)]
    pub y_max: R,
}

impl BridgeParameters<f64> {
    /// Between which positions the bridge runs.
    pub fn limits(&self) -> Limits {
        Limits { min: self.y_min, max: self.y_max }
    }
}

#[derive(Clone, Variables)]
pub struct HookParameters<R: Scalar> {
    /// Mass of the hook (m₁).
    #[variable(unit = "kg", start = 500.0, min = 1e-6, max = 1e9)]
    pub mass: R,
    pub swing: SwingStart<R>,
}

#[derive(Clone, Variables)]
pub struct RiggingParameters<R: Scalar> {
    /// Distance from the hook to the payload (L_p).
    #[variable(unit = "m", start = 3.0, min = 1e-2, max = 1e4)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct PayloadParameters<R: Scalar> {
    /// Mass of the payload (m₂), at most 1000 times that of the hook; without payload the hook is a single pendulum.
    #[variable(unit = "kg", start = 1000.0, min = 0.0, max = 1e9)]
    pub mass: R,
    pub swing: SwingStart<R>,
}

#[derive(Clone, Variables)]
pub struct SwingParameters<R: Scalar> {
    /// Damping of the swing of cable and rigging (d); for a single pendulum and small swing 2ζω.
    #[variable(unit = "1/s", min = 0.0, max = 1e3)]
    pub damping: R,
}

#[derive(Clone, Variables)]
pub struct SwingStart<R: Scalar> {
    /// Swing towards world x at the start.
    #[variable(unit = "rad", min = -1.57, max = 1.57)]
    pub radial_start: R,
    /// Swing towards world y at the start.
    #[variable(unit = "rad", min = -std::f64::consts::PI, max = std::f64::consts::PI)]
    pub tangential_start: R,
    /// Rate of the swing towards world x at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub radial_rate_start: R,
    /// Rate of the swing towards world y at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub tangential_rate_start: R,
}

impl<R: Scalar> SwingStart<R> {
    /// The direction at the start and its rate.
    pub fn direction(&self, frame: &SwingFrame<R>) -> (Vector<R>, Vector<R>) {
        let swing = Swing { radial: self.radial_start, tangential: self.tangential_start };
        let rates = Swing { radial: self.radial_rate_start, tangential: self.tangential_rate_start };
        (frame.direction(swing), frame.direction_rate(swing, rates))
    }
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub trolley: TrolleyInputs<R>,
    pub bridge: BridgeInputs<R>,
    pub hoist: HoistInputs<R>,
    /// On the payload; on the hook if there is none.
    pub wind: Wind<R>,
}

#[derive(Clone, Variables)]
pub struct TrolleyInputs<R: Scalar> {
    /// Velocity of the trolley along the bridge, world x.
    #[variable(unit = "m/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct BridgeInputs<R: Scalar> {
    /// Velocity of the bridge along its runway, world y.
    #[variable(unit = "m/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub trolley: TrolleyStates<R>,
    pub bridge: BridgeStates<R>,
    pub hoist: HoistStates<R>,
    pub cable: CableStates<R>,
    pub rigging: RiggingStates<R>,
}

#[derive(Clone, Variables)]
pub struct TrolleyStates<R: Scalar> {
    /// Position of the trolley, world x.
    #[variable(unit = "m", output)]
    pub x: R,
}

#[derive(Clone, Variables)]
pub struct BridgeStates<R: Scalar> {
    /// Position of the bridge, world y.
    #[variable(unit = "m", output)]
    pub y: R,
}

#[derive(Clone, Variables)]
pub struct CableStates<R: Scalar> {
    /// Unit vector from the trolley to the hook, in the world frame (n₁).
    #[variable(unit = "1", calculated)]
    pub direction: [R; 3],
    /// Velocity of the centre of mass of hook and payload across the cable, in the world frame (w₁).
    #[variable(unit = "m/s", calculated)]
    pub velocity_across: [R; 3],
}

#[derive(Clone, Variables)]
pub struct RiggingStates<R: Scalar> {
    /// Unit vector from the hook to the payload, in the world frame (n₂); it rests where there is no payload.
    #[variable(unit = "1", calculated)]
    pub direction: [R; 3],
    /// Velocity of the payload across the rigging, in the world frame (w₂); it rests where there is no payload.
    #[variable(unit = "m/s", calculated)]
    pub velocity_across: [R; 3],
}

impl<R: Scalar> From<Payload<R>> for CableStates<R> {
    fn from(hook: Payload<R>) -> Self {
        Self { direction: hook.direction.into(), velocity_across: hook.velocity.into() }
    }
}

impl<R: Scalar> From<Payload<R>> for RiggingStates<R> {
    fn from(payload: Payload<R>) -> Self {
        Self { direction: payload.direction.into(), velocity_across: payload.velocity.into() }
    }
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub hook: MassOutputs<R>,
    pub payload: MassOutputs<R>,
    pub swing: SwingOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct MassOutputs<R: Scalar> {
    pub swing: AngleOutputs<R>,
    pub displacement: Displacement<R>,
    /// Position, world x.
    #[variable(unit = "m")]
    pub x: R,
    /// Position, world y.
    #[variable(unit = "m")]
    pub y: R,
    /// Height.
    #[variable(unit = "m")]
    pub z: R,
}

#[derive(Clone, Variables)]
pub struct AngleOutputs<R: Scalar> {
    /// Swing towards world x, from the vertical.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Swing towards world y, from the vertical.
    #[variable(unit = "rad")]
    pub tangential: R,
    /// Time derivative of the swing towards world x.
    #[variable(unit = "rad/s")]
    pub radial_rate: R,
    /// Time derivative of the swing towards world y.
    #[variable(unit = "rad/s")]
    pub tangential_rate: R,
}

#[derive(Clone, Variables)]
pub struct Displacement<R: Scalar> {
    /// Position relative to the trolley, towards world x.
    #[variable(unit = "m")]
    pub radial: R,
    /// Position relative to the trolley, towards world y.
    #[variable(unit = "m")]
    pub tangential: R,
}

#[derive(Clone, Variables)]
pub struct SwingOutputs<R: Scalar> {
    /// Angle at which hook and payload, in line and at rest, had the energy of their swing if the trolley kept its
    /// velocity and the hoist stopped; without payload the hook's amplitude.
    #[variable(unit = "rad")]
    pub amplitude: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether trolley, bridge or hoist stands at a limit, or an input is beyond what any crane does and was cut there.
    #[variable(output)]
    pub at_limit: bool,
    pub trolley: TrolleyStop,
    pub bridge: BridgeStop,
    pub hoist: HoistStop,
    pub payload: PayloadSwitch,
}

#[derive(Clone, Variables)]
pub struct TrolleyStop {
    /// Whether the trolley stands at a limit.
    #[variable(depends_on = ["trolley.x", "trolley.rate"])]
    pub stopped: bool,
}

#[derive(Clone, Variables)]
pub struct BridgeStop {
    /// Whether the bridge stands at a limit.
    #[variable(depends_on = ["bridge.y", "bridge.rate"])]
    pub stopped: bool,
}

#[derive(Clone, Variables)]
pub struct PayloadSwitch {
    /// Whether there is a payload, with a mass above 0.
    #[variable(start = true, depends_on = [])]
    pub attached: bool,
}
