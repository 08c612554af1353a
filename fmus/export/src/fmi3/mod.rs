//! The functions of FMI 3.0.2, generic over the model; `export_fmu!` gives them their C symbols.

#![allow(non_snake_case, reason = "the functions are named as in the standard")]

mod binary;
mod callbacks;
mod clock;
mod co_simulation;
mod common;
mod configuration;
mod dependencies;
mod derivative;
mod model_exchange;
mod scheduled_execution;
mod state;
mod values;

pub use binary::*;
pub use clock::*;
pub use co_simulation::*;
pub use common::*;
pub use configuration::*;
pub use dependencies::*;
pub use derivative::*;
pub use model_exchange::*;
pub use scheduled_execution::*;
pub use state::*;
pub use values::*;
