//! The variables of the vertically accelerated pendulum.

use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Length of the pendulum, from the cart to the payload (L).
    #[variable(unit = "m", start = 0.5, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Swing at the start.
    #[variable(unit = "rad", min = -std::f64::consts::PI, max = std::f64::consts::PI)]
    pub swing_start: R,
    pub swing: SwingParameters<R>,
    pub rig: RigParameters<R>,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct SwingParameters<R: Scalar> {
    /// Rate of the swing at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub rate_start: R,
    /// Damping of the swing (d); for small swing 2ζω.
    #[variable(unit = "1/s", min = 0.0, max = 1e3)]
    pub damping: R,
}

#[derive(Clone, Variables)]
pub struct RigParameters<R: Scalar> {
    /// Whether the counterweight moves the cart; otherwise its acceleration is the input.
    pub enabled: bool,
    /// Mass of the counterweight (M).
    #[variable(unit = "kg", start = 3.0, min = 1e-3, max = 1e6)]
    pub counterweight_mass: R,
    /// Mass of the cart with all that hangs on it (m).
    #[variable(unit = "kg", start = 2.5, min = 1e-3, max = 1e6)]
    pub mass: R,
    /// Viscous friction of the cart (b).
    #[variable(unit = "kg/s", start = 0.4, min = 0.0, max = 1e9)]
    pub friction: R,
    /// Height to which the cart can rise from 0.
    #[variable(unit = "m", start = 1.3, min = 1e-3, max = 1e4)]
    pub travel: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Acceleration of the cart, positive upwards; without effect while the rig is on.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    /// Swing, from the vertical.
    #[variable(unit = "rad", output, calculated)]
    pub swing: R,
    pub payload: PayloadStates<R>,
    pub cart: CartStates<R>,
}

#[derive(Clone, Variables)]
pub struct PayloadStates<R: Scalar> {
    /// Velocity of the payload across the rod, seen from the cart (u).
    #[variable(unit = "m/s", calculated)]
    pub velocity_across: R,
}

#[derive(Clone, Variables)]
pub struct CartStates<R: Scalar> {
    /// Height of the cart.
    #[variable(unit = "m", output, min = -1e12, max = 1e12)]
    pub z: R,
    /// Velocity of the cart, positive upwards.
    #[variable(unit = "m/s", output, min = -1e9, max = 1e9)]
    pub velocity: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub swing: SwingOutputs<R>,
    pub cart: CartOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct SwingOutputs<R: Scalar> {
    /// Time derivative of the swing.
    #[variable(unit = "rad/s")]
    pub rate: R,
    /// Amplitude the payload would swing with under a cart without acceleration.
    #[variable(unit = "rad")]
    pub amplitude: R,
}

#[derive(Clone, Variables)]
pub struct CartOutputs<R: Scalar> {
    /// Acceleration of the cart, positive upwards.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether the cart rests on an end of its travel, or an acceleration or friction is beyond what is physical and was cut.
    #[variable(output)]
    pub at_limit: bool,
    pub cart: CartStop,
}

#[derive(Clone, Variables)]
pub struct CartStop {
    /// Whether the cart rests on an end of its travel.
    #[variable(depends_on = ["cart.z", "cart.velocity"])]
    pub stopped: bool,
}
