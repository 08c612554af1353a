//! The variables of the luffing and hoisting ropes.

use swayless_crane::{HoistSheaveParameters, JibParameters};
use swayless_export::{Enumeration, Scalar, Variables};

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Reaction {
    /// The hoist line pulls the boom's tip towards its sheave on the jib: lines and payload exchange their energy.
    Consistent,
    /// That pull is left out, as in the thesis.
    Thesis,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub boom: BoomParameters<R>,
    pub jib: JibParameters<R>,
    pub hoist_sheave: HoistSheaveParameters<R>,
    pub payload: PayloadParameters<R>,
    /// Whether the hoist line's pull on the boom's tip counts in the luff line's force and mass.
    #[variable(start = Reaction::Consistent)]
    pub reaction: Reaction,
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct BoomParameters<R: Scalar> {
    /// Length of the boom, from its foot to its tip (r).
    #[variable(unit = "m", start = 18.0, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Mass of the boom.
    #[variable(unit = "kg", start = 3000.0, min = 0.0, max = 1e9)]
    pub mass: R,
    /// Moment of inertia of the boom about its foot (I_O), not about its centre of mass.
    #[variable(unit = "kg.m2", start = 324_000.0, min = 0.0, max = 1e15)]
    pub inertia: R,
    /// Distance of the boom's centre of mass from its foot.
    #[variable(unit = "m", start = 9.0, min = 0.0, max = 1e4)]
    pub center: R,
}

#[derive(Clone, Variables)]
pub struct PayloadParameters<R: Scalar> {
    /// Mass of the payload.
    #[variable(unit = "kg", start = 1000.0, min = 0.0, max = 1e9)]
    pub mass: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub luff: LuffInputs<R>,
    pub hoist: HoistInputs<R>,
    pub swing: SwingInputs<R>,
}

#[derive(Clone, Variables)]
pub struct LuffInputs<R: Scalar> {
    /// Speed at which the luff line is reeled in; positive raises the boom.
    #[variable(unit = "m/s")]
    pub line_speed: R,
    /// Time derivative of the luff line's speed.
    #[variable(unit = "m/s2")]
    pub line_acceleration: R,
    /// Angle of the boom above the horizontal.
    #[variable(unit = "rad", start = std::f64::consts::FRAC_PI_4)]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Speed at which the hoist line is paid out; positive lowers the payload.
    #[variable(unit = "m/s")]
    pub line_speed: R,
    /// Time derivative of the hoist line's speed.
    #[variable(unit = "m/s2")]
    pub line_acceleration: R,
    /// Suspension length, from the boom tip to the payload.
    #[variable(unit = "m", start = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct SwingInputs<R: Scalar> {
    /// Radial swing of the payload, positive away from the boom's foot.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Time derivative of the radial swing.
    #[variable(unit = "rad/s")]
    pub radial_rate: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub luff: LuffOutputs<R>,
    pub hoist: HoistOutputs<R>,
}

#[derive(Clone, Variables)]
pub struct LuffOutputs<R: Scalar> {
    /// Luff rate, positive upwards.
    #[variable(unit = "rad/s")]
    pub rate: R,
    /// Time derivative of the luff rate.
    #[variable(unit = "rad/s2")]
    pub acceleration: R,
    /// Length of the luff line, from the jib to the boom's tip (C).
    #[variable(unit = "m")]
    pub line_length: R,
    /// Force in the luff line (F_c).
    #[variable(unit = "N")]
    pub line_force: R,
    /// Force in the luff line while both lines are held: the load of the luffing drive at rest.
    #[variable(unit = "N")]
    pub line_force_static: R,
    /// Boom and payload as a mass on the luff line: the inertia of the luffing drive's load.
    #[variable(unit = "kg")]
    pub line_mass: R,
}

#[derive(Clone, Variables)]
pub struct HoistOutputs<R: Scalar> {
    /// Rate of the suspension length; positive lowers the payload.
    #[variable(unit = "m/s")]
    pub rate: R,
    /// Time derivative of that rate.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
    /// Length of the hoist line between its sheave on the jib and the boom's tip (B).
    #[variable(unit = "m")]
    pub line_length: R,
    /// Force in the hoist line (F_p).
    #[variable(unit = "N")]
    pub line_force: R,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether boom and jib lie almost in one line, where the luff line has no lever; the ropes are those just before.
    #[variable(output, depends_on = ["luff.angle"])]
    pub singular: bool,
    /// Whether an input is beyond what any crane does and was cut there.
    #[variable(output)]
    pub at_limit: bool,
}
