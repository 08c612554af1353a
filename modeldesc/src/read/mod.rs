//! Reading a `modelDescription.xml` of FMI 2.0 or FMI 3.0.
//!
//! A reader goes as far as it can: what it cannot make sense of is reported with its line and left out, and the rest is
//! read. Only a text that is no model description at all is an error. The result is normalised: references are indices
//! into the variables, counted from 0, and what the standard says of absent attributes is filled in.

mod common;
mod fmi2;
mod fmi3;
mod structure;

#[cfg(feature = "ssp")]
pub(crate) use common::base_unit;

use crate::problem::{Problem, ReadError, Report};
use crate::types::*;
use crate::xml_in::{self, Fields, Node};

/// Reads a model description: FMI 2.0 (standard 2.0.5, section 2.2) or FMI 3.0 (standard 3.0.2, section 2.4).
///
/// Beside the description come the problems of its form: everything that the standard's schema would complain about,
/// and references that lead nowhere, in the order of the lines. What it means is for [`check`](crate::check::check).
///
/// # Errors
///
/// [`ReadError`] if the text is not well-formed XML, has a document type definition or is nested absurdly deep, if its
/// root is no `fmiModelDescription`, or if it is for a version other than 2.0 and 3.
pub fn read(xml: &str) -> Result<(ModelDescription, Vec<Problem>), ReadError> {
    let mut report = Report::default();
    let root = xml_in::parse(xml, &mut report)?;
    if root.name != "fmiModelDescription" {
        return Err(ReadError {
            line: root.line,
            message: format!("the root is `{}` but must be `fmiModelDescription`", root.name),
        });
    }
    let version = root.attributes.iter().find(|(key, _)| key == "fmiVersion").map_or("", |(_, value)| value.trim());
    let description = if version == "2.0" {
        fmi2::read(&root, &mut report)
    } else if version.starts_with("3.") {
        if version != "3.0" {
            report.warning(root.line, format!("fmiVersion is `{version}`; it is read as 3.0"));
        }
        fmi3::read(&root, &mut report)
    } else {
        return Err(ReadError {
            line: root.line,
            message: format!("fmiVersion is `{version}`; only FMI 2.0 and FMI 3.0 can be read"),
        });
    };
    Ok((description, report.into_problems()))
}

/// Like [`read`], from the bytes of a file: UTF-8 with or without a byte order mark. Latin-1 that is declared as such is
/// read and reported.
///
/// # Errors
///
/// As of [`read`], and if the bytes are in another encoding.
pub fn read_bytes(bytes: &[u8]) -> Result<(ModelDescription, Vec<Problem>), ReadError> {
    read(&xml_in::decode(bytes)?)
}

/// The attributes of the root that both versions share.
fn root(fields: &mut Fields<'_>, version: FmiVersion, token: &'static str, report: &mut Report) -> ModelDescription {
    fields.get("fmiVersion");
    let mut description =
        ModelDescription::new(version, fields.required("modelName", report), fields.required(token, report));
    description.description = fields.text("description");
    description.author = fields.text("author");
    description.version = fields.text("version");
    description.copyright = fields.text("copyright");
    description.license = fields.text("license");
    description.generation_tool = fields.text("generationTool");
    description.generation_date_and_time = fields.text("generationDateAndTime");
    description.variable_naming_convention = fields
        .one_of(
            "variableNamingConvention",
            &[("flat", NamingConvention::Flat), ("structured", NamingConvention::Structured)],
            report,
        )
        .unwrap_or_default();
    description
}

/// What `variable` is when the standard leaves it to the table (FMI 2.0.5 section 2.2.7, FMI 3.0.2 section 2.4.7.4).
fn default_variability(version: FmiVersion, causality: Causality, data_type: DataType) -> Variability {
    match version {
        FmiVersion::V2 => Variability::Continuous,
        FmiVersion::V3 => match causality {
            Causality::StructuralParameter | Causality::Parameter | Causality::CalculatedParameter => {
                Variability::Fixed
            }
            _ if data_type.is_float() => Variability::Continuous,
            _ => Variability::Discrete,
        },
    }
}

/// The attributes of a variable that both versions share; `fields` are those of the element that carries its name.
fn variable_head(
    node: &Node,
    fields: &mut Fields<'_>,
    data_type: DataType,
    version: FmiVersion,
    report: &mut Report,
) -> Variable {
    let name = fields.required("name", report);
    let value_reference = fields.required_value("valueReference", report);
    let description = fields.text("description");
    let causality = fields.one_of("causality", &Causality::NAMES, report).unwrap_or(Causality::Local);
    let variability = fields
        .one_of("variability", &Variability::NAMES, report)
        .unwrap_or_else(|| default_variability(version, causality, data_type));
    let mut variable = Variable::new(name, value_reference, data_type, causality, variability);
    variable.description = description;
    variable.can_handle_multiple_set_per_time_instant =
        fields.value("canHandleMultipleSetPerTimeInstant", report).unwrap_or(true);
    variable.line = node.line;
    variable
}

/// `initial`, which overrides the table's default; a clock has none.
fn read_initial(
    node: &Node,
    fields: &mut Fields<'_>,
    variable: &mut Variable,
    version: FmiVersion,
    report: &mut Report,
) {
    let Some(initial) = fields.one_of("initial", &Initial::NAMES, report) else { return };
    let forbidden = match version {
        FmiVersion::V2 => matches!(variable.causality, Causality::Input | Causality::Independent),
        FmiVersion::V3 => variable.causality == Causality::Independent,
    };
    if forbidden {
        report.error(
            node.line,
            format!(
                "`{}` must not have `initial` because it is {}; remove it",
                variable.name,
                variable.causality.as_str()
            ),
        );
    } else {
        variable.initial = Some(initial);
    }
}
