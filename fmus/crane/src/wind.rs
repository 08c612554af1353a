//! Wind: a force on the payload.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::Vector;

use crate::cut::{STRONGEST, cut_acceleration};

/// The force as three inputs.
#[derive(Clone, Variables)]
pub struct Wind<R: Scalar> {
    /// Force on the payload, world x.
    #[variable(unit = "N")]
    pub x: R,
    /// Force on the payload, world y.
    #[variable(unit = "N")]
    pub y: R,
    /// Force on the payload, upwards.
    #[variable(unit = "N")]
    pub z: R,
}

impl<R: Scalar> Wind<R> {
    /// What it and gravity pull a mass with: g + F/m (m/s²).
    pub fn pull(&self, mass: R, gravity: R) -> Vector<R> {
        let [x, y, z] = [self.x, self.y, self.z].map(|force| cut_acceleration(force / mass));
        Vector::new(x, y, z - gravity)
    }
}

impl Wind<f64> {
    /// Whether the force is not cut.
    pub fn is_physical(&self, mass: f64) -> bool {
        [self.x, self.y, self.z].iter().all(|force| force.abs() <= STRONGEST * mass)
    }
}
