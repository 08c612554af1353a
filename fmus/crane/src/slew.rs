//! Slewing: what turns a crane about its vertical axis.

use swayless_export::{Scalar, Variables};

/// Inputs of slewing.
#[derive(Clone, Variables)]
pub struct SlewInputs<R: Scalar> {
    /// Slew rate relative to the base, positive counter-clockwise seen from above.
    #[variable(unit = "rad/s")]
    pub rate: R,
}

/// States of slewing.
#[derive(Clone, Variables)]
pub struct SlewStates<R: Scalar> {
    /// Slew angle relative to the base.
    #[variable(unit = "rad", output)]
    pub angle: R,
}
