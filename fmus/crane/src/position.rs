//! A position in the world.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::Vector;

/// A position as three outputs.
#[derive(Clone, Variables)]
pub struct Position<R: Scalar> {
    /// Position, world x.
    #[variable(unit = "m")]
    pub x: R,
    /// Position, world y.
    #[variable(unit = "m")]
    pub y: R,
    /// Position, upwards.
    #[variable(unit = "m")]
    pub z: R,
}

impl<R: Scalar> From<Vector<R>> for Position<R> {
    fn from(vector: Vector<R>) -> Self {
        Self { x: vector.x, y: vector.y, z: vector.z }
    }
}
