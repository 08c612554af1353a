//! The variables of the boom lift.

use swayless_crane::{LuffParameters, LuffStates, LuffStop, Position, SlewInputs, SlewStates};
use swayless_export::{Scalar, Variables};
use swayless_mechanics::Limits;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    pub boom: BoomParameters<R>,
    pub luff: LuffParameters<R>,
    pub extension: ExtensionParameters<R>,
}

#[derive(Clone, Variables)]
pub struct BoomParameters<R: Scalar> {
    /// Length of the boom without its extension, from its foot (r).
    #[variable(unit = "m", start = 12.0, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Height of the boom's foot.
    #[variable(unit = "m", min = -1e4, max = 1e4)]
    pub height: R,
}

#[derive(Clone, Variables)]
pub struct ExtensionParameters<R: Scalar> {
    /// Least extension, where it stops.
    #[variable(unit = "m", min = 0.0, max = 1e4)]
    pub length_min: R,
    /// Greatest extension, where it stops.
    #[variable(unit = "m", start = 8.0, min = 0.0, max = 1e4)]
    pub length_max: R,
}

impl ExtensionParameters<f64> {
    /// Between which lengths the boom extends.
    pub fn limits(&self) -> Limits {
        Limits { min: self.length_min, max: self.length_max }
    }
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub slew: SlewInputs<R>,
    pub luff: LuffInputs<R>,
    pub extension: ExtensionInputs<R>,
}

#[derive(Clone, Variables)]
pub struct LuffInputs<R: Scalar> {
    /// Luff rate, positive upwards.
    #[variable(unit = "rad/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct ExtensionInputs<R: Scalar> {
    /// Rate of the extension; positive makes the boom longer.
    #[variable(unit = "m/s")]
    pub rate: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    pub slew: SlewStates<R>,
    pub luff: LuffStates<R>,
    pub extension: ExtensionStates<R>,
}

#[derive(Clone, Variables)]
pub struct ExtensionStates<R: Scalar> {
    /// Extension of the boom beyond its own length (ρ).
    #[variable(unit = "m", output, start = 1.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    pub tip: Position<R>,
}

#[derive(Clone, Variables)]
pub struct Discrete {
    /// Whether luff or extension stands at a limit, or a rate is beyond what any lift has and is cut there.
    #[variable(output)]
    pub at_limit: bool,
    pub luff: LuffStop,
    pub extension: ExtensionStop,
}

#[derive(Clone, Variables)]
pub struct ExtensionStop {
    /// Whether the extension stands at a limit.
    #[variable(depends_on = ["extension.length", "extension.rate"])]
    pub stopped: bool,
}
