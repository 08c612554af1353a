//! What crane FMUs have in common: variables of joints, swing, wind and positions, terminals, and where inputs that no
//! crane can have are cut.

mod base;
mod cut;
mod hoist;
mod luff;
mod position;
mod rigging;
mod slew;
mod suspended;
mod swing;
pub mod terminals;
mod wind;

pub use base::{BaseAcceleration, BaseStates, BaseVelocity};
pub use cut::{FASTEST, STRONGEST, are_physical, cut, cut_acceleration};
pub use hoist::{HoistInputs, HoistParameters, HoistStates, HoistStop};
pub use luff::{LuffParameters, LuffStates, LuffStop};
pub use position::Position;
pub use rigging::{HoistSheaveParameters, JibParameters};
pub use slew::{SlewInputs, SlewStates};
pub use suspended::{CableStates, PayloadStates, suspended};
pub use swing::{SwingOutputs, SwingParameters};
pub use wind::Wind;
