//! What SSP documents say, the same for SSP 1.0 and SSP 2.0.

use crate::types::{BaseUnit, DataType, DefaultExperiment, Item};
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
    /// `source`: a URI, relative to the `.ssd` file. [`source_path`](super::source_path) makes a path of it.
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

/// A `Connector`.
#[derive(Debug, Clone, PartialEq)]
pub struct Connector {
    /// `name`: on a component, that of the variable.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// `kind`.
    pub kind: ConnectorKind,
    /// The type, if given.
    pub connector_type: Option<ConnectorType>,
    /// `Dimension`s (SSP 2.0); none for a scalar.
    pub dimensions: Vec<Dimension>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// `kind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum ConnectorKind {
    Input,
    Output,
    Parameter,
    CalculatedParameter,
    Inout,
    /// SSP 2.0.
    StructuralParameter,
    /// SSP 2.0.
    Constant,
    /// SSP 2.0.
    Local,
    /// SSP 2.0.
    Unspecified,
}

impl ConnectorKind {
    pub(crate) const NAMES: [(&'static str, Self); 9] = [
        ("input", Self::Input),
        ("output", Self::Output),
        ("parameter", Self::Parameter),
        ("calculatedParameter", Self::CalculatedParameter),
        ("inout", Self::Inout),
        ("structuralParameter", Self::StructuralParameter),
        ("constant", Self::Constant),
        ("local", Self::Local),
        ("unspecified", Self::Unspecified),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        Self::NAMES.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }
}

/// The type of a connector. `Real` is Float64, `Integer` is Int32.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConnectorType {
    /// The type.
    pub data_type: DataType,
    /// `unit`, of a float.
    pub unit: Option<String>,
    /// `name` of the enumeration.
    pub enumeration: Option<String>,
}

/// The size of an array in one direction (SSP 2.0).
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Dimension {
    /// `size`.
    Fixed(u64),
    /// `sizeConnector`: the connector that holds the size.
    Connector(String),
    /// Not said.
    Unspecified,
}

/// A `Connection`. Start and end do not say which way the data flows; [`System::flow`] does.
#[derive(Debug, Clone, PartialEq)]
pub struct Connection {
    /// `startElement` and `startConnector`.
    pub start: Endpoint,
    /// `endElement` and `endConnector`.
    pub end: Endpoint,
    /// `suppressUnitConversion`.
    pub suppress_unit_conversion: bool,
    /// What happens to the value on its way, after any conversion of units.
    pub transformation: Option<Transformation>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// One end of a connection.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Endpoint {
    /// The element; `None` is the enclosing system itself.
    pub element: Option<String>,
    /// The connector.
    pub connector: String,
    /// `startIndices`, `endIndices`: the element of an array (SSP 2.0); empty for all of it.
    pub indices: Vec<u64>,
}

impl fmt::Display for Endpoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(element) = &self.element {
            write!(f, "{element}.")?;
        }
        f.write_str(&self.connector)?;
        if !self.indices.is_empty() {
            let indices: Vec<String> = self.indices.iter().map(u64::to_string).collect();
            write!(f, "[{}]", indices.join(","))?;
        }
        Ok(())
    }
}

/// A transformation from a source's value to a target's.
#[derive(Debug, Clone, PartialEq)]
pub enum Transformation {
    /// target = factor · source + offset.
    Linear {
        /// `factor`.
        factor: f64,
        /// `offset`.
        offset: f64,
    },
    /// Source and target, pair by pair.
    Boolean(Vec<(bool, bool)>),
    /// Source and target, pair by pair.
    Integer(Vec<(i64, i64)>),
    /// Items of the source's and the target's enumeration, pair by pair.
    Enumeration(Vec<(String, String)>),
}

/// A `ParameterBinding`: values for the element that has it and everything inside.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterBinding {
    /// `type`: the media type; absent means an SSP parameter set.
    pub media_type: Option<String>,
    /// `prefix`: put before every name in the set.
    pub prefix: String,
    /// The values.
    pub values: Source<ParameterSet>,
    /// How names and values of the set are mapped; absent means one to one, and with it only what is mapped is applied.
    pub mapping: Option<Source<ParameterMapping>>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// A document that stands in another one, or in a file of its own.
#[derive(Debug, Clone, PartialEq)]
pub enum Source<T> {
    /// In the document itself.
    Inline(T),
    /// In a file.
    File {
        /// `source`: a URI. [`source_path`](super::source_path) makes a path of it.
        source: String,
        /// What the URI is relative to.
        base: SourceBase,
    },
}

/// `sourceBase`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SourceBase {
    /// `SSD`: the `.ssd` file.
    #[default]
    Ssd,
    /// `component`: the component's own source.
    Component,
}

impl SourceBase {
    pub(crate) const NAMES: [(&'static str, Self); 2] = [("SSD", Self::Ssd), ("component", Self::Component)];
}

/// The content of an `.ssv` file: `ParameterSet`.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterSet {
    /// `version`.
    pub version: SspVersion,
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// `Parameters`.
    pub parameters: Vec<Parameter>,
    /// `Enumerations`.
    pub enumerations: Vec<Enumeration>,
    /// `Units`.
    pub units: Vec<Unit>,
}

/// A `Parameter`.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// `name`.
    pub name: String,
    /// `description`.
    pub description: Option<String>,
    /// Its type; the value fits it.
    pub data_type: DataType,
    /// Its value.
    pub value: Value,
    /// `unit`, of a float.
    pub unit: Option<String>,
    /// `name` of the enumeration, if said.
    pub enumeration: Option<String>,
    /// `Dimension`s (SSP 2.0); none for a scalar.
    pub dimensions: Vec<Dimension>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// Values of a parameter: one of a scalar, all in row-major order of an array. Displayed as in the XML, with blanks
/// between.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Of a float of either width.
    Float(Vec<f64>),
    /// Of an integer of any width.
    Integer(Vec<i128>),
    /// Of a Boolean.
    Boolean(Vec<bool>),
    /// Of a string.
    String(Vec<String>),
    /// Names of items.
    Enumeration(Vec<String>),
    /// Of a binary.
    Binary(Vec<Vec<u8>>),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use crate::xml_out::{float, hex, join};
        f.write_str(&match self {
            Self::Float(values) => join(values, |v| float(*v)),
            Self::Integer(values) => join(values, i128::to_string),
            Self::Boolean(values) => join(values, bool::to_string),
            Self::String(values) | Self::Enumeration(values) => values.join(" "),
            Self::Binary(values) => join(values, |v| hex(v)),
        })
    }
}

/// The content of an `.ssm` file: `ParameterMapping`.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterMapping {
    /// `version`.
    pub version: SspVersion,
    /// `description`.
    pub description: Option<String>,
    /// `MappingEntry`s.
    pub entries: Vec<MappingEntry>,
}

/// A `MappingEntry`.
#[derive(Debug, Clone, PartialEq)]
pub struct MappingEntry {
    /// `source`: the name in the parameter set, with the binding's prefix.
    pub source: String,
    /// `target`: the name in the system or component.
    pub target: String,
    /// `suppressUnitConversion`.
    pub suppress_unit_conversion: bool,
    /// What happens to the value.
    pub transformation: Option<Transformation>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
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
