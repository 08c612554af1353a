//! Reading parameter sets and parameter mappings, inline or from their files.

use super::super::types::*;
use super::common::*;
use crate::problem::Report;
use crate::types::{DataType, FmiVersion};
use crate::xml_in::{Child, Fields, Node, hex_bytes};

pub(super) fn set(node: &Node, report: &mut Report) -> ParameterSet {
    let mut fields = Fields::of(node);
    let (version, description) = root(node, &mut fields, report);
    let name = fields.required("name", report);
    fields.finish(report);
    children(node, &[Child::Once("Parameters"), Child::Maybe("Enumerations"), Child::Maybe("Units")], report);
    let mut set = ParameterSet {
        version,
        name,
        description,
        parameters: Vec::new(),
        enumerations: Vec::new(),
        units: Vec::new(),
    };
    for child in &node.children {
        match child.name.as_str() {
            "Parameters" => {
                children(child, &[Child::Many("Parameter")], report);
                let parameters = child.children.iter().filter(|child| child.name == "Parameter");
                set.parameters.extend(parameters.filter_map(|node| parameter(node, report)));
            }
            "Enumerations" => set.enumerations = enumerations(child, report),
            "Units" => set.units = units(child, report),
            _ => {}
        }
    }
    set
}

/// A parameter; `None` if it has no value.
fn parameter(node: &Node, report: &mut Report) -> Option<Parameter> {
    let mut fields = Fields::of(node);
    let name = fields.required("name", report);
    let description = description(&mut fields);
    fields.finish(report);
    let mut typed = None;
    let mut dimensions = Vec::new();
    for child in &node.children {
        match (child.name.as_str(), data_type(&child.name)) {
            ("Dimension", _) => dimensions.push(dimension(child, report)),
            ("MetaData" | "Signature", _) => {}
            (_, Some(data_type)) if typed.is_none() && data_type != DataType::Clock => {
                typed = Some((child, data_type));
            }
            _ => report.error(child.line, format!("`{}` does not belong into `{}`; remove it", child.name, node.name)),
        }
    }
    let Some((child, data_type)) = typed else {
        report.error(node.line, format!("the parameter `{name}` needs a type and a value, such as `Real`"));
        return None;
    };
    let mut fields = Fields::of(child);
    let value = value(child, data_type, &mut fields, report);
    let unit = if data_type.is_float() { fields.text("unit") } else { None };
    let enumeration = if data_type == DataType::Enumeration { fields.text("name") } else { None };
    if data_type == DataType::Binary {
        fields.get("mime-type");
    }
    fields.finish(report);
    let value = value?;
    Some(Parameter { name, description, data_type, value, unit, enumeration, dimensions, line: node.line })
}

fn value(node: &Node, data_type: DataType, fields: &mut Fields<'_>, report: &mut Report) -> Option<Value> {
    match data_type {
        DataType::String => texts(node, fields, report).map(Value::String),
        DataType::Enumeration => texts(node, fields, report).map(Value::Enumeration),
        DataType::Binary => {
            let texts = texts(node, fields, report)?;
            let bytes: Option<Vec<Vec<u8>>> = texts.iter().map(|text| hex_bytes(text)).collect();
            if bytes.is_none() {
                report.error(node.line, "the value of a `Binary` must be pairs of hexadecimal digits");
            }
            bytes.map(Value::Binary)
        }
        _ => {
            children(node, &[], report);
            if fields.get("value").is_none() {
                fields.required("value", report);
                return None;
            }
            if data_type.is_float() {
                fields.list("value", report).map(Value::Float)
            } else if data_type == DataType::Boolean {
                fields.list("value", report).map(Value::Boolean)
            } else {
                let values: Vec<i128> = fields.list("value", report)?;
                let (least, greatest) = data_type.integer_range(FmiVersion::V3)?;
                if let Some(value) = values.iter().find(|value| !(least..=greatest).contains(*value)) {
                    report.error(
                        node.line,
                        format!("`value` of `{}` is {value} but must be from {least} to {greatest}", node.name),
                    );
                    return None;
                }
                Some(Value::Integer(values))
            }
        }
    }
}

/// The values of a type whose values may hold blanks: an attribute, or an element for each (SSP 2.0).
fn texts(node: &Node, fields: &mut Fields<'_>, report: &mut Report) -> Option<Vec<String>> {
    children(node, &[Child::Many("Value")], report);
    let attribute = fields.text("value");
    let mut values = Vec::new();
    for child in node.children.iter().filter(|child| child.name == "Value") {
        let mut fields = Fields::of(child);
        values.push(fields.required("value", report));
        fields.finish(report);
    }
    match (attribute, values.is_empty()) {
        (Some(value), true) => Some(vec![value]),
        (None, false) => Some(values),
        (Some(_), false) => {
            report.error(node.line, format!("`{}` must not have both `value` and `Value`", node.name));
            None
        }
        (None, true) => {
            fields.required("value", report);
            None
        }
    }
}

pub(super) fn mapping(node: &Node, report: &mut Report) -> ParameterMapping {
    let mut fields = Fields::of(node);
    let (version, description) = root(node, &mut fields, report);
    fields.finish(report);
    children(node, &[Child::Many("MappingEntry")], report);
    let mut entries = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "MappingEntry") {
        children(node, &TRANSFORMATIONS.map(Child::Maybe), report);
        let mut fields = Fields::of(node);
        fields.get("id");
        fields.get("description");
        entries.push(MappingEntry {
            source: fields.required("source", report),
            target: fields.required("target", report),
            suppress_unit_conversion: fields.flag("suppressUnitConversion", report),
            transformation: transformation(node, report),
            line: node.line,
        });
        fields.finish(report);
    }
    ParameterMapping { version, description, entries }
}
