//! Imports FMUs, wires them to systems and steps them together.

pub mod archive;
pub mod error;
mod graph;
pub mod importer;
mod loader;
pub mod master;
pub mod package;
pub mod recorder;
pub mod report;
mod run;
pub mod shapers;
pub mod signals;
pub mod simulation;
pub mod slave;
pub mod system;
pub mod terminals;
pub mod validate;

pub use error::{Error, Result};
pub use importer::Fmu;
pub use master::AlgorithmKind;
pub use recorder::{Column, CsvWriter, Observer, Recording, Value};
pub use run::Run;
pub use signals::InputSignals;
pub use simulation::{Options, Summary, simulate};
pub use system::System;
