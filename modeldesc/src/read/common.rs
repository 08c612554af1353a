//! What both versions write alike: units, bounds, start values, log categories, the default experiment.

use crate::problem::Report;
use crate::types::*;
use crate::xml_in::{Child, Fields, Node, check_children};

pub(super) fn units(node: &Node, version: FmiVersion, report: &mut Report) -> Vec<Unit> {
    check_children(node, &[Child::Some("Unit")], report);
    Fields::of(node).finish(report);
    let mut units = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "Unit") {
        check_children(node, &[Child::Maybe("BaseUnit"), Child::Many("DisplayUnit")], report);
        let mut fields = Fields::of(node);
        let mut unit = Unit { name: fields.required("name", report), ..Unit::default() };
        fields.finish(report);
        for child in &node.children {
            match child.name.as_str() {
                "BaseUnit" => unit.base = Some(base_unit(child, report)),
                "DisplayUnit" => {
                    let mut fields = Fields::of(child);
                    unit.display_units.push(DisplayUnit {
                        name: fields.required("name", report),
                        factor: fields.value("factor", report).unwrap_or(1.0),
                        offset: fields.value("offset", report).unwrap_or(0.0),
                        inverse: version == FmiVersion::V3 && fields.flag("inverse", report),
                    });
                    fields.finish(report);
                }
                _ => {}
            }
        }
        units.push(unit);
    }
    units
}

/// `BaseUnit`, which SSP writes in the same way.
pub(crate) fn base_unit(node: &Node, report: &mut Report) -> BaseUnit {
    let mut fields = Fields::of(node);
    let base = BaseUnit {
        exponents: BaseUnit::SYMBOLS.map(|symbol| fields.value(symbol, report).unwrap_or(0)),
        factor: fields.value("factor", report).unwrap_or(1.0),
        offset: fields.value("offset", report).unwrap_or(0.0),
    };
    fields.finish(report);
    base
}

pub(super) fn log_categories(node: &Node, report: &mut Report) -> Vec<LogCategory> {
    check_children(node, &[Child::Some("Category")], report);
    Fields::of(node).finish(report);
    let mut categories = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "Category") {
        let mut fields = Fields::of(node);
        categories.push(LogCategory { name: fields.required("name", report), description: fields.text("description") });
        fields.finish(report);
    }
    categories
}

pub(super) fn default_experiment(node: &Node, report: &mut Report) -> DefaultExperiment {
    let mut fields = Fields::of(node);
    let experiment = DefaultExperiment {
        start_time: fields.value("startTime", report),
        stop_time: fields.value("stopTime", report),
        tolerance: fields.value("tolerance", report),
        step_size: fields.value("stepSize", report),
    };
    fields.finish(report);
    experiment
}

pub(super) fn items(node: &Node, version: FmiVersion, report: &mut Report) -> Vec<Item> {
    check_children(node, &[Child::Some("Item")], report);
    let mut items = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "Item") {
        let mut fields = Fields::of(node);
        let name = fields.required("name", report);
        let value = fields.required_value("value", report);
        in_range(value, DataType::Enumeration, version, "value", node, report);
        items.push(Item { name, value, description: fields.text("description") });
        fields.finish(report);
    }
    items
}

/// Reports a number that does not fit into its type.
fn in_range(
    value: impl Into<i128>,
    data_type: DataType,
    version: FmiVersion,
    key: &str,
    node: &Node,
    report: &mut Report,
) -> bool {
    let value = value.into();
    let Some((least, greatest)) = data_type.integer_range(version) else { return true };
    let fits = (least..=greatest).contains(&value);
    if !fits {
        report
            .error(node.line, format!("`{key}` of `{}` is {value} but must be from {least} to {greatest}", node.name));
    }
    fits
}

/// Quantity, unit, bounds and the like, as far as the type has them.
pub(super) fn attributes(
    node: &Node,
    fields: &mut Fields<'_>,
    data_type: DataType,
    version: FmiVersion,
    report: &mut Report,
) -> Attributes {
    let mut attributes = Attributes::default();
    if data_type.is_float() {
        attributes.unit = fields.text("unit");
        attributes.display_unit = fields.text("displayUnit");
        attributes.relative_quantity = fields.flag("relativeQuantity", report);
        attributes.unbounded = fields.flag("unbounded", report);
        attributes.nominal = fields.value("nominal", report);
        attributes.min = fields.value("min", report);
        attributes.max = fields.value("max", report);
    } else if data_type.integer_range(version).is_some() {
        let mut bound = |key| {
            fields
                .value::<i128>(key, report)
                .filter(|value| in_range(*value, data_type, version, key, node, report))
                .map(|value| value as f64)
        };
        attributes.min = bound("min");
        attributes.max = bound("max");
    } else {
        return attributes;
    }
    attributes.quantity = fields.text("quantity");
    attributes
}

/// The attribute `start`, which all types but strings and binaries have.
pub(super) fn start(
    node: &Node,
    fields: &mut Fields<'_>,
    data_type: DataType,
    version: FmiVersion,
    report: &mut Report,
) -> Option<Start> {
    if data_type.is_float() {
        fields.list("start", report).map(Start::Float)
    } else if data_type == DataType::Boolean {
        fields.list("start", report).map(Start::Boolean)
    } else if data_type.integer_range(version).is_some() {
        let values: Vec<i128> = fields.list("start", report)?;
        let fits = values.iter().all(|value| in_range(*value, data_type, version, "start", node, report));
        fits.then_some(Start::Integer(values))
    } else {
        None
    }
}
