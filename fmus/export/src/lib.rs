//! Turns one model into an FMU for FMI 2.0 and FMI 3.0, co-simulation and model exchange.
//!
//! A model implements [`Model`]: structs of variables, each variable declared once at its field, and pure functions of
//! one point in time. [`export_fmu!`] then makes all C functions of both standards from it, and `swayless_describe`,
//! from which the packager takes the model descriptions.

mod access;
mod backup;
mod clocked;
mod clocks;
mod co_simulation;
mod configuration;
mod course;
mod declaration;
mod dependencies;
mod describe;
mod description;
mod event;
mod flow;
#[doc(hidden)]
pub mod fmi2;
#[doc(hidden)]
pub mod fmi3;
mod initialization;
mod instance;
mod integrator;
mod layout;
mod log;
mod model;
mod model_exchange;
mod panics;
mod phase;
mod raw;
mod raw_state;
mod schedule;
mod sensitivity;
mod sizes;
mod snapshot;
mod structure;
mod symbols;
mod terminal;
mod token;
mod unit;
mod uri;
mod variables;

pub use swayless_abi as abi;
pub use swayless_export_derive::{Enumeration, Variables};
pub use swayless_scalar::Scalar;

pub use clocks::{Clock, Interval};
pub use declaration::{Declaration, Declarer, Kind};
#[doc(hidden)]
pub use describe::swayless_describe;
pub use model::{Environment, Event, Indicators, Info, Model, Point, Problem};
pub use terminal::Terminal;
pub use unit::{UNITS, Unit};
pub use variables::{Enumeration, Value, Variables, lift};
