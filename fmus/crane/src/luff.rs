//! Luffing: what raises a boom.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::Limits;

/// Parameters of luffing.
#[derive(Clone, Variables)]
pub struct LuffParameters<R: Scalar> {
    /// Least luff angle, where the boom stops.
    #[variable(unit = "rad", min = -1.57, max = 1.57)]
    pub angle_min: R,
    /// Greatest luff angle, where the boom stops.
    #[variable(unit = "rad", start = 1.5, min = -1.57, max = 1.57)]
    pub angle_max: R,
}

impl LuffParameters<f64> {
    /// Between which angles the boom luffs.
    pub fn limits(&self) -> Limits {
        Limits { min: self.angle_min, max: self.angle_max }
    }
}

/// States of luffing.
#[derive(Clone, Variables)]
pub struct LuffStates<R: Scalar> {
    /// Angle of the boom above the horizontal.
    #[variable(unit = "rad", output, start = std::f64::consts::FRAC_PI_4)]
    pub angle: R,
}

/// Whether luffing is stopped.
#[derive(Clone, Variables)]
pub struct LuffStop {
    /// Whether the boom stands at a limit of luffing.
    #[variable(depends_on = ["luff.angle", "luff.rate"])]
    pub stopped: bool,
}
