//! Which way the data flows through a connection (SSP 2.0, section 5.4.2, allowed connections).

use super::types::*;
use std::error::Error;
use std::fmt;

/// A connection in the direction of the data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow<'a> {
    /// Where the value comes from.
    pub from: &'a Endpoint,
    /// The connector there.
    pub from_connector: &'a Connector,
    /// Where the value goes.
    pub to: &'a Endpoint,
    /// The connector there.
    pub to_connector: &'a Connector,
}

/// Why a connection has no direction.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlowError {
    /// There is no such element.
    NoElement(String),
    /// The element, or the system itself, declares no such connector.
    NoConnector(String),
    /// The kinds do not go together.
    Kinds {
        /// The connection's start with its kind.
        start: String,
        /// Its end with its kind.
        end: String,
    },
}

impl fmt::Display for FlowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoElement(name) => write!(f, "there is no element `{name}` in the system"),
            Self::NoConnector(name) => write!(f, "there is no connector `{name}`; declare it"),
            Self::Kinds { start, end } => {
                write!(f, "{start} and {end} cannot be connected; connect an output with an input")
            }
        }
    }
}

impl Error for FlowError {}

impl System {
    /// The element of this name.
    pub fn element(&self, name: &str) -> Option<&Element> {
        self.elements.iter().find(|element| element.name() == name)
    }

    /// The connector at an end of a connection.
    ///
    /// # Errors
    ///
    /// [`FlowError::NoElement`] and [`FlowError::NoConnector`].
    pub fn connector(&self, endpoint: &Endpoint) -> Result<&Connector, FlowError> {
        let connectors = match &endpoint.element {
            None => self.connectors.as_slice(),
            Some(name) => self.element(name).ok_or_else(|| FlowError::NoElement(name.clone()))?.connectors(),
        };
        connectors
            .iter()
            .find(|connector| connector.name == endpoint.connector)
            .ok_or_else(|| FlowError::NoConnector(endpoint.to_string()))
    }

    /// A connection in the direction of the data, which follows from the kinds of its connectors; where both directions
    /// are possible (between connectors of kind inout or unspecified), from start to end.
    ///
    /// # Errors
    ///
    /// [`FlowError`] if an end does not exist or the kinds do not go together.
    pub fn flow<'a>(&'a self, connection: &'a Connection) -> Result<Flow<'a>, FlowError> {
        let (start, end) = (&connection.start, &connection.end);
        let (start_connector, end_connector) = (self.connector(start)?, self.connector(end)?);
        let starts = End { own: start.element.is_none(), kind: start_connector.kind };
        let ends = End { own: end.element.is_none(), kind: end_connector.kind };
        if allowed(starts, ends) {
            Ok(Flow { from: start, from_connector: start_connector, to: end, to_connector: end_connector })
        } else if allowed(ends, starts) {
            Ok(Flow { from: end, from_connector: end_connector, to: start, to_connector: start_connector })
        } else {
            let named = |endpoint: &Endpoint, connector: &Connector| {
                let owner = if endpoint.element.is_none() { "the system's " } else { "" };
                format!("{owner}`{endpoint}` ({})", connector.kind.as_str())
            };
            Err(FlowError::Kinds { start: named(start, start_connector), end: named(end, end_connector) })
        }
    }
}

/// An end of a connection, as the table of allowed connections sees it.
#[derive(Clone, Copy)]
struct End {
    /// Whether the connector is the enclosing system's own.
    own: bool,
    kind: ConnectorKind,
}

/// The table of allowed connections. A system's own inputs are sources inside it, its outputs are destinations.
fn allowed(source: End, destination: End) -> bool {
    use ConnectorKind as K;
    if source.kind == K::Unspecified || destination.kind == K::Unspecified {
        return true;
    }
    match (source.own, destination.own) {
        (true, true) => matches!(
            (source.kind, destination.kind),
            (K::StructuralParameter | K::Parameter, K::CalculatedParameter | K::Output | K::Local)
                | (K::Input, K::Output | K::Local)
        ),
        (true, false) => matches!(
            (source.kind, destination.kind),
            (K::StructuralParameter, K::StructuralParameter | K::Parameter | K::Input | K::Inout)
                | (K::Parameter, K::Parameter | K::Input | K::Inout)
                | (K::Input, K::Input | K::Inout)
        ),
        (false, false) => matches!(
            (source.kind, destination.kind),
            (K::Constant, K::StructuralParameter | K::Parameter | K::Input | K::Inout)
                | (K::CalculatedParameter, K::Parameter | K::Input | K::Inout)
                | (K::Output | K::Local, K::Input | K::Inout)
                | (K::Inout, K::Input)
        ),
        (false, true) => matches!(
            (source.kind, destination.kind),
            (K::Constant, K::Constant | K::CalculatedParameter | K::Output | K::Local)
                | (K::CalculatedParameter, K::CalculatedParameter | K::Output | K::Local)
                | (K::Output | K::Local | K::Inout, K::Output | K::Local)
        ),
    }
}
