//! Parameter sets, their mappings and what binds them to systems.

use super::{Dimension, Enumeration, SspVersion, Unit};
use crate::types::DataType;
use std::fmt;

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
        /// `source`: a URI. [`source_path`](crate::ssp::source_path) makes a path of it.
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
