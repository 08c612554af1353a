//! Systems and their elements.

use super::{Connection, Connector, ParameterBinding};

/// A `System`: elements and the connections between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct System {
    /// `name`; the root system's may be empty.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// `Connectors`: how the system looks from outside.
    pub connectors: Vec<Connector>,
    /// `ParameterBindings`, later ones taking precedence.
    pub parameter_bindings: Vec<ParameterBinding>,
    /// `Elements`.
    pub elements: Vec<Element>,
    /// `Connections`.
    pub connections: Vec<Connection>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// An element of a system.
#[derive(Debug, Clone, PartialEq)]
pub enum Element {
    /// Something that runs: an FMU, or another system in a file.
    Component(Component),
    /// A system within the system.
    System(System),
}

impl Element {
    /// Its name, unique in its system.
    pub fn name(&self) -> &str {
        match self {
            Self::Component(component) => &component.name,
            Self::System(system) => &system.name,
        }
    }

    /// Its connectors.
    pub fn connectors(&self) -> &[Connector] {
        match self {
            Self::Component(component) => &component.connectors,
            Self::System(system) => &system.connectors,
        }
    }

    /// Its parameter bindings.
    pub fn parameter_bindings(&self) -> &[ParameterBinding] {
        match self {
            Self::Component(component) => &component.parameter_bindings,
            Self::System(system) => &system.parameter_bindings,
        }
    }

    /// The line it begins in, 0 when it was not read from a file.
    pub fn line(&self) -> usize {
        match self {
            Self::Component(component) => component.line,
            Self::System(system) => system.line,
        }
    }
}

/// A `Component`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Component {
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// `type`: the media type of the source; absent means an FMU ([`Component::FMU`]).
    pub media_type: Option<String>,
    /// `source`: a URI, relative to the `.ssd` file. [`source_path`](crate::ssp::source_path) makes a path of it.
    pub source: String,
    /// `implementation`.
    pub implementation: Implementation,
    /// `Connectors`.
    pub connectors: Vec<Connector>,
    /// `ParameterBindings`, later ones taking precedence.
    pub parameter_bindings: Vec<ParameterBinding>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

impl Component {
    /// The media type of an FMU.
    pub const FMU: &'static str = "application/x-fmu-sharedlibrary";
    /// The media type of a system description.
    pub const SSD: &'static str = "application/x-ssp-definition";
    /// The media type of a system package.
    pub const SSP: &'static str = "application/x-ssp-package";
}

/// `implementation`: which interface of an FMU to use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Implementation {
    #[default]
    Any,
    ModelExchange,
    CoSimulation,
    ScheduledExecution,
}

impl Implementation {
    pub(crate) const NAMES: [(&'static str, Self); 4] = [
        ("any", Self::Any),
        ("ModelExchange", Self::ModelExchange),
        ("CoSimulation", Self::CoSimulation),
        ("ScheduledExecution", Self::ScheduledExecution),
    ];
}
