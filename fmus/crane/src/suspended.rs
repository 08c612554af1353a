//! A suspended payload as states: its direction and its velocity across the cable.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::{Payload, Vector};

/// The cable.
#[derive(Clone, Variables)]
pub struct CableStates<R: Scalar> {
    /// Unit vector from the pivot to the payload, in the world frame (n).
    #[variable(unit = "1", calculated)]
    pub direction: [R; 3],
}

/// The payload.
#[derive(Clone, Variables)]
pub struct PayloadStates<R: Scalar> {
    /// Velocity of the payload across the cable, in the world frame (w).
    #[variable(unit = "m/s", calculated)]
    pub velocity_across: [R; 3],
}

/// The payload of these states.
pub fn suspended<R: Scalar>(cable: &CableStates<R>, payload: &PayloadStates<R>) -> Payload<R> {
    Payload { direction: Vector::from(cable.direction), velocity: Vector::from(payload.velocity_across) }
}

impl<R: Scalar> From<Payload<R>> for CableStates<R> {
    fn from(payload: Payload<R>) -> Self {
        Self { direction: payload.direction.into() }
    }
}

impl<R: Scalar> From<Payload<R>> for PayloadStates<R> {
    fn from(payload: Payload<R>) -> Self {
        Self { velocity_across: payload.velocity.into() }
    }
}
