//! Suspended payloads and crane kinematics, over any [`Scalar`](swayless_scalar::Scalar).
//!
//! Frames: world x, y horizontal, z up. A payload is written by the unit vector **n** from its pivot to it and by its
//! velocity across the cable **w**; a crane is only the map from its joint rates to its pivot's velocity.

mod axes;
mod boom;
mod cartesian;
mod double_payload;
mod jib;
mod limit;
mod luff_force;
mod luffing;
mod mode;
mod payload;
mod saturation;
mod singular;
mod swing;
mod vehicle;
mod vertical;

pub use axes::{AXES, Axis, AxisRates, RateRange, RateRanges};
pub use boom::{Boom, BoomAccelerations, BoomRates};
pub use cartesian::Machine;
pub use double_payload::{DoublePayload, DoubleSuspension, DoubleVelocity};
pub use jib::{Jib, JibRates};
pub use limit::Limits;
pub use luff_force::{Hanging, LuffLoad};
pub use luffing::{DEAD_ANGLE, Luffing, Motion, Rigging, Rope};
pub use mode::{Mode, ModeState};
pub use payload::{Payload, Suspension};
pub use saturation::{Restraint, Saturated, Scaling};
pub use singular::{Margin, Pace};
pub use swing::{Swing, SwingFrame};
pub use vehicle::{Driving, Vehicle, VehicleRates};
pub use vertical::{CounterweightRig, FASTEST_BRAKING, VerticalPendulum};

/// A vector in the world frame.
pub type Vector<R> = nalgebra::Vector3<R>;
