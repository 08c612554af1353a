//! Writing SSP documents: deterministic, indented, valid against the schemas of their version.

mod common;
mod parameters;
mod system;

use super::NAMESPACE;
use super::types::*;
use crate::types::DefaultExperiment;
use crate::write::WriteError;
use crate::xml_out::{Document, Element as Xml};

/// Writes a system description as the text of an `.ssd` file.
///
/// # Errors
///
/// [`WriteError`] if something in it is not in its version of the standard (arrays and most types are new in SSP 2.0),
/// a value is not of its type, or a text holds a character that XML cannot hold.
pub fn write_system(description: &SystemStructureDescription) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: description.version };
    let root = Xml::new("ssd:SystemStructureDescription")
        .text("xmlns:ssd", &format!("{NAMESPACE}SystemStructureDescription"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"))
        .text("xmlns:ssv", &format!("{NAMESPACE}SystemStructureParameterValues"))
        .text("xmlns:ssm", &format!("{NAMESPACE}SystemStructureParameterMapping"))
        .text("version", &description.version.to_string())
        .text("name", &description.name)
        .maybe("description", description.description.as_deref());
    writer.document.open(root);
    writer.system(&description.system)?;
    writer.enumerations(["ssd:Enumerations", "ssc:Enumeration", "ssc:Item"], &description.enumerations)?;
    writer.units("ssd:Units", &description.units);
    if let Some(DefaultExperiment { start_time, stop_time, .. }) = description.default_experiment {
        let experiment = Xml::new("ssd:DefaultExperiment");
        writer.document.empty(experiment.maybe_float("startTime", start_time).maybe_float("stopTime", stop_time));
    }
    Ok(writer.document.finish()?)
}

/// Writes a parameter set as the text of an `.ssv` file.
///
/// # Errors
///
/// As of [`write_system`].
pub fn write_parameters(set: &ParameterSet) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: set.version };
    let root = Xml::new("ssv:ParameterSet")
        .text("xmlns:ssv", &format!("{NAMESPACE}SystemStructureParameterValues"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"));
    writer.parameter_set(root, set)?;
    Ok(writer.document.finish()?)
}

/// Writes a parameter mapping as the text of an `.ssm` file.
///
/// # Errors
///
/// As of [`write_system`].
pub fn write_mapping(mapping: &ParameterMapping) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: mapping.version };
    let root = Xml::new("ssm:ParameterMapping")
        .text("xmlns:ssm", &format!("{NAMESPACE}SystemStructureParameterMapping"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"));
    writer.mapping(root, mapping);
    Ok(writer.document.finish()?)
}

/// A document of some version in the making.
struct Writer {
    document: Document,
    version: SspVersion,
}
