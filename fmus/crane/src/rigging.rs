//! The jib that a boom's ropes come from.

use swayless_export::{Scalar, Variables};

/// The jib.
#[derive(Clone, Variables)]
pub struct JibParameters<R: Scalar> {
    /// Length of the jib, from the boom's foot to the start of the luff line (H).
    #[variable(unit = "m", start = 6.5, min = 1e-3, max = 1e4)]
    pub length: R,
    /// Angle of the jib above the horizontal on the boom's side (Ψ).
    #[variable(unit = "rad", start = 2.4, min = 0.0, max = std::f64::consts::PI)]
    pub angle: R,
}

/// The sheave on it.
#[derive(Clone, Variables)]
pub struct HoistSheaveParameters<R: Scalar> {
    /// Distance of the hoist line's sheave on the jib from the boom's foot (A).
    #[variable(unit = "m", start = 6.0, min = 0.0, max = 1e4)]
    pub distance: R,
}
