//! The functions of FMI 3.0.2, generic over the model; `export_fmu!` gives them their C symbols.

#![allow(non_snake_case, reason = "the functions are named as in the standard")]

mod callbacks;
mod co_simulation;
mod common;
mod derivative;
mod model_exchange;
mod not_offered;
mod state;
mod values;

pub use co_simulation::*;
pub use common::*;
pub use derivative::*;
pub use model_exchange::*;
pub use not_offered::*;
pub use state::*;
pub use values::*;
