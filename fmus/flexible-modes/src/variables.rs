//! The variables of the flexible modes.

use std::f64::consts::TAU;

use swayless_export::{Scalar, Variables};

/// Room for modes.
pub const ROOM: usize = 8;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub mode: ModeParameters<R>,
}

#[derive(Clone, Variables)]
pub struct ModeParameters<R: Scalar> {
    /// How many modes there are (n).
    #[variable(start = 2, min = 1, max = 8)]
    pub count: u32,
    /// Natural frequency of each mode (ω).
    #[variable(
        unit = "rad/s",
        start = [TAU, 2.0 * TAU, 3.0 * TAU, 4.0 * TAU, 5.0 * TAU, 6.0 * TAU, 7.0 * TAU, 8.0 * TAU],
        min = 1e-3,
        max = 1e4,
        length = "mode.count"
    )]
    pub frequency: [R; ROOM],
    /// Damping ratio of each mode (ζ).
    #[variable(unit = "1", min = 0.0, max = 10.0, length = "mode.count")]
    pub damping_ratio: [R; ROOM],
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub base: BaseInputs<R>,
}

#[derive(Clone, Variables)]
pub struct BaseInputs<R: Scalar> {
    /// Velocity of the base that carries the modes.
    #[variable(unit = "m/s")]
    pub velocity: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub mode: ModeStates<R>,
}

#[derive(Clone, Variables)]
pub struct ModeStates<R: Scalar> {
    /// Deflection of each mode, relative to the base (y).
    #[variable(unit = "m", output, length = "mode.count")]
    pub deflection: [R; ROOM],
    /// Velocity of each mode relative to the ground (p): the rate of its deflection and the base's velocity together.
    #[variable(unit = "m/s", length = "mode.count")]
    pub velocity: [R; ROOM],
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// Deflection of a body that has all the modes: the sum of theirs.
    #[variable(unit = "m")]
    pub deflection: R,
    /// The most that this deflection can come to: the sum of the modes' amplitudes.
    #[variable(unit = "m")]
    pub amplitude: R,
    pub mode: ModeOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct ModeOutputs<R: Scalar> {
    /// Time derivative of each deflection.
    #[variable(unit = "m/s", length = "mode.count")]
    pub rate: [R; ROOM],
    /// Amplitude of each mode if the base kept its velocity and nothing were damped.
    #[variable(unit = "m", length = "mode.count")]
    pub amplitude: [R; ROOM],
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether the base's velocity is beyond what any base has and is cut there.
    #[variable(output, depends_on = ["base.velocity"])]
    pub at_limit: bool,
}
