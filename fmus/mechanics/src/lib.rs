//! Suspended payloads and crane kinematics, over any [`Scalar`](swayless_scalar::Scalar).
//!
//! Frames: world x, y horizontal, z up. A payload is written by the unit vector **n** from its pivot to it and by its
//! velocity across the cable **w**; a crane is only the map from its joint rates to its pivot's velocity.

mod boom;
mod double_payload;
mod limit;
mod payload;
mod swing;

pub use boom::{Boom, BoomAccelerations, BoomRates};
pub use double_payload::{DoublePayload, DoubleSuspension, DoubleVelocity};
pub use limit::Limits;
pub use payload::{Payload, Suspension};
pub use swing::{Swing, SwingFrame};

/// A vector in the world frame.
pub type Vector<R> = nalgebra::Vector3<R>;
