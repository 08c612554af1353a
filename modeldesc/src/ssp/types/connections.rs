//! Connectors and what connects them.

use super::Transformation;
use crate::types::DataType;
use std::fmt;

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

/// A `Connection`. Start and end do not say which way the data flows; [`System::flow`](super::System::flow) does.
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
