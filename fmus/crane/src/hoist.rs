//! The hoist: what lengthens the suspension.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::Limits;

/// Parameters of a hoist.
#[derive(Clone, Variables)]
pub struct HoistParameters<R: Scalar> {
    /// Least suspension length, where the hoist stops.
    #[variable(unit = "m", start = 0.5, min = 1e-3)]
    pub length_min: R,
    /// Greatest suspension length, where the hoist stops.
    #[variable(unit = "m", start = 200.0, min = 1e-3, max = 1e4)]
    pub length_max: R,
}

impl HoistParameters<f64> {
    /// Between which lengths the hoist runs.
    pub fn limits(&self) -> Limits {
        Limits { min: self.length_min, max: self.length_max }
    }
}

/// Inputs of a hoist.
#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Rate of the suspension length; positive lowers the payload.
    #[variable(unit = "m/s")]
    pub rate: R,
}

/// States of a hoist.
#[derive(Clone, Variables)]
pub struct HoistStates<R: Scalar> {
    /// Suspension length, from the pivot to what hangs there.
    #[variable(unit = "m", output, start = 10.0, min = 1e-3, nominal = 10.0)]
    pub length: R,
}

/// Whether a hoist is stopped.
#[derive(Clone, Variables)]
pub struct HoistStop {
    /// Whether the hoist stands at a limit.
    #[variable(depends_on = ["hoist.length", "hoist.rate"])]
    pub stopped: bool,
}
