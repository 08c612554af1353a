//! Reading SSP documents.

mod common;
mod parameters;
mod system;

use super::NAMESPACE;
use super::types::*;
use crate::problem::{Problem, ReadError, Report};
use crate::xml_in::{self, Node};

/// Reads a system description, the text of an `.ssd` file (SSP 2.0, section 5).
///
/// # Errors
///
/// [`ReadError`] if the text is not well-formed XML, has a document type definition or is nested absurdly deep, or if
/// its root is not a `SystemStructureDescription`.
pub fn read_system(xml: &str) -> Result<(SystemStructureDescription, Vec<Problem>), ReadError> {
    read(xml, "SystemStructureDescription", "SystemStructureDescription", system::description)
}

/// Reads a parameter set, the text of an `.ssv` file (SSP 2.0, section 6).
///
/// # Errors
///
/// As of [`read_system`], for a root `ParameterSet`.
pub fn read_parameters(xml: &str) -> Result<(ParameterSet, Vec<Problem>), ReadError> {
    read(xml, "ParameterSet", "SystemStructureParameterValues", parameters::set)
}

/// Reads a parameter mapping, the text of an `.ssm` file (SSP 2.0, section 7).
///
/// # Errors
///
/// As of [`read_system`], for a root `ParameterMapping`.
pub fn read_mapping(xml: &str) -> Result<(ParameterMapping, Vec<Problem>), ReadError> {
    read(xml, "ParameterMapping", "SystemStructureParameterMapping", parameters::mapping)
}

fn read<T>(
    xml: &str,
    root: &str,
    schema: &str,
    content: fn(&Node, &mut Report) -> T,
) -> Result<(T, Vec<Problem>), ReadError> {
    let mut report = Report::default();
    let node = xml_in::parse(xml, &mut report)?;
    if node.name != root {
        return Err(ReadError {
            line: node.line,
            message: format!("the root is `{}` but must be `{root}`", node.name),
        });
    }
    if node.namespace.strip_prefix(NAMESPACE) != Some(schema) {
        report.error(
            node.line,
            format!(
                "`{root}` is in the namespace `{}` but must be in `{NAMESPACE}{schema}`; correct its xmlns",
                node.namespace
            ),
        );
    }
    let value = content(&node, &mut report);
    Ok((value, report.into_problems()))
}
