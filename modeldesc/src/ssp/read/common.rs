//! What the documents of SSP share: metadata, units, enumerations, types, transformations (SSP 2.0, section 4).

use super::super::types::*;
use crate::problem::Report;
use crate::read::base_unit;
use crate::types::{BaseUnit, DataType, Item};
use crate::xml_in::{Child, Fields, Node, check_children_but};

/// Elements of SSP 2.0 that describe the document and not the system; they may stand in every element.
const ABOUT: [&str; 2] = ["MetaData", "Signature"];

/// The types by the names of their elements. `Real` and `Integer` are those of SSP 1.0.
const TYPES: [(&str, DataType); 17] = [
    ("Real", DataType::Float64),
    ("Integer", DataType::Int32),
    ("Float64", DataType::Float64),
    ("Float32", DataType::Float32),
    ("Int8", DataType::Int8),
    ("UInt8", DataType::UInt8),
    ("Int16", DataType::Int16),
    ("UInt16", DataType::UInt16),
    ("Int32", DataType::Int32),
    ("UInt32", DataType::UInt32),
    ("Int64", DataType::Int64),
    ("UInt64", DataType::UInt64),
    ("Boolean", DataType::Boolean),
    ("String", DataType::String),
    ("Enumeration", DataType::Enumeration),
    ("Binary", DataType::Binary),
    ("Clock", DataType::Clock),
];

/// The type that an element's name stands for.
pub(super) fn data_type(name: &str) -> Option<DataType> {
    TYPES.iter().find(|(known, _)| *known == name).map(|(_, data_type)| *data_type)
}

/// Like [`check_children_but`], with what describes the document allowed everywhere.
pub(super) fn children(node: &Node, allowed: &[Child], report: &mut Report) {
    check_children_but(node, allowed, &ABOUT, report);
}

/// The attributes of a document's root beside its name. Who made the file and when is of no use to us.
pub(super) fn root(node: &Node, fields: &mut Fields<'_>, report: &mut Report) -> (SspVersion, Option<String>) {
    let text = fields.required("version", report);
    let version = if text.starts_with("1.") { SspVersion::V1 } else { SspVersion::V2 };
    if !text.is_empty() && !text.starts_with("1.") && !text.starts_with("2.") {
        report.error(node.line, format!("`version` is `{text}`; only SSP 1 and SSP 2 can be read"));
    }
    for key in ["id", "author", "fileversion", "copyright", "license", "generationTool", "generationDateAndTime"] {
        fields.get(key);
    }
    (version, fields.text("description"))
}

/// The description of an element, which may also have an identifier that we do not need.
pub(super) fn description(fields: &mut Fields<'_>) -> Option<String> {
    fields.get("id");
    fields.text("description")
}

pub(super) fn units(node: &Node, report: &mut Report) -> Vec<Unit> {
    children(node, &[Child::Some("Unit")], report);
    let mut units = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "Unit") {
        children(node, &[Child::Once("BaseUnit")], report);
        let mut fields = Fields::of(node);
        let name = fields.required("name", report);
        let description = description(&mut fields);
        fields.finish(report);
        let base = node
            .children
            .iter()
            .find(|child| child.name == "BaseUnit")
            .map_or(BaseUnit { exponents: [0; 8], factor: 1.0, offset: 0.0 }, |child| base_unit(child, report));
        units.push(Unit { name, description, base, line: node.line });
    }
    units
}

pub(super) fn enumerations(node: &Node, report: &mut Report) -> Vec<Enumeration> {
    children(node, &[Child::Some("Enumeration")], report);
    let mut enumerations = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "Enumeration") {
        children(node, &[Child::Some("Item")], report);
        let mut fields = Fields::of(node);
        let name = fields.required("name", report);
        let description = description(&mut fields);
        fields.finish(report);
        let mut items = Vec::new();
        for child in node.children.iter().filter(|child| child.name == "Item") {
            let mut fields = Fields::of(child);
            items.push(Item {
                name: fields.required("name", report),
                value: fields.required_value("value", report),
                description: None,
            });
            fields.finish(report);
        }
        enumerations.push(Enumeration { name, description, items });
    }
    enumerations
}

pub(super) fn dimension(node: &Node, report: &mut Report) -> Dimension {
    let mut fields = Fields::of(node);
    let size = fields.value("size", report);
    let connector = fields.text("sizeConnector");
    fields.finish(report);
    match (size, connector) {
        (Some(_), Some(_)) => {
            report.error(node.line, "`Dimension` must not have both `size` and `sizeConnector`");
            Dimension::Unspecified
        }
        (Some(size), None) => Dimension::Fixed(size),
        (None, Some(connector)) => Dimension::Connector(connector),
        (None, None) => Dimension::Unspecified,
    }
}

/// The names of the transformations' elements.
pub(super) const TRANSFORMATIONS: [&str; 4] = [
    "LinearTransformation",
    "BooleanMappingTransformation",
    "IntegerMappingTransformation",
    "EnumerationMappingTransformation",
];

/// The transformation among the children of a connection or a mapping entry.
pub(super) fn transformation(node: &Node, report: &mut Report) -> Option<Transformation> {
    let mut found = None;
    for child in &node.children {
        let transformation = match child.name.as_str() {
            "LinearTransformation" => {
                let mut fields = Fields::of(child);
                let factor = fields.value("factor", report).unwrap_or(1.0);
                let offset = fields.value("offset", report).unwrap_or(0.0);
                fields.finish(report);
                Transformation::Linear { factor, offset }
            }
            "BooleanMappingTransformation" => Transformation::Boolean(entries(child, report, |fields, key, report| {
                fields.required_value(key, report)
            })),
            "IntegerMappingTransformation" => Transformation::Integer(entries(child, report, |fields, key, report| {
                fields.required_value(key, report)
            })),
            "EnumerationMappingTransformation" => {
                Transformation::Enumeration(entries(child, report, |fields, key, report| fields.required(key, report)))
            }
            _ => continue,
        };
        if found.is_some() {
            report.error(child.line, format!("`{}` has more than one transformation", node.name));
        }
        found = Some(transformation);
    }
    found
}

fn entries<T>(
    node: &Node,
    report: &mut Report,
    value: fn(&mut Fields<'_>, &'static str, &mut Report) -> T,
) -> Vec<(T, T)> {
    children(node, &[Child::Some("MapEntry")], report);
    let mut entries = Vec::new();
    for child in node.children.iter().filter(|child| child.name == "MapEntry") {
        let mut fields = Fields::of(child);
        entries.push((value(&mut fields, "source", report), value(&mut fields, "target", report)));
        fields.finish(report);
    }
    entries
}
