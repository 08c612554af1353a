//! What SSP documents say, the same for SSP 1.0 and SSP 2.0.

mod connections;
mod parameters;
mod system;

pub use connections::{Connection, Connector, ConnectorKind, ConnectorType, Dimension, Endpoint};
pub use parameters::{
    MappingEntry, Parameter, ParameterBinding, ParameterMapping, ParameterSet, Source, SourceBase, Transformation,
    Value,
};
pub use system::{Component, Element, Implementation, System};

use crate::types::{BaseUnit, DefaultExperiment, Item};
use std::fmt;

/// A version of the SSP standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SspVersion {
    /// SSP 1.0.
    V1,
    /// SSP 2.0.
    V2,
}

impl fmt::Display for SspVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::V1 => "1.0",
            Self::V2 => "2.0",
        })
    }
}

/// The content of an `.ssd` file.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemStructureDescription {
    /// `version`.
    pub version: SspVersion,
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// `System`: the root system.
    pub system: System,
    /// `Enumerations`.
    pub enumerations: Vec<Enumeration>,
    /// `Units`.
    pub units: Vec<Unit>,
    /// `DefaultExperiment`; SSP knows only its start and stop time (s).
    pub default_experiment: Option<DefaultExperiment>,
}

/// An `Enumeration`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Enumeration {
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// Its `Item`s; SSP gives them no description.
    pub items: Vec<Item>,
}

/// A `Unit`.
#[derive(Debug, Clone, PartialEq)]
pub struct Unit {
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// Its dimensions and conversion to SI.
    pub base: BaseUnit,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}
