//! Reading system descriptions.

use super::super::types::*;
use super::common::*;
use super::parameters;
use crate::problem::Report;
use crate::types::{DataType, DefaultExperiment};
use crate::xml_in::{Child, Fields, Node};

pub(super) fn description(node: &Node, report: &mut Report) -> SystemStructureDescription {
    let mut fields = Fields::of(node);
    let (version, description) = root(node, &mut fields, report);
    let name = fields.required("name", report);
    fields.finish(report);
    children(
        node,
        &[
            Child::Once("System"),
            Child::Maybe("Enumerations"),
            Child::Maybe("Units"),
            Child::Maybe("DefaultExperiment"),
        ],
        report,
    );
    let mut result = SystemStructureDescription {
        version,
        name,
        description,
        system: System::default(),
        enumerations: Vec::new(),
        units: Vec::new(),
        default_experiment: None,
    };
    for child in &node.children {
        match child.name.as_str() {
            "System" => result.system = system(child, report),
            "Enumerations" => result.enumerations = enumerations(child, report),
            "Units" => result.units = units(child, report),
            "DefaultExperiment" => {
                let mut fields = Fields::of(child);
                result.default_experiment = Some(DefaultExperiment {
                    start_time: fields.value("startTime", report),
                    stop_time: fields.value("stopTime", report),
                    ..DefaultExperiment::default()
                });
                fields.finish(report);
            }
            _ => {}
        }
    }
    result
}

/// What every element begins with, in the standard's order.
const ELEMENT: [Child; 3] =
    [Child::Maybe("Connectors"), Child::Maybe("ElementGeometry"), Child::Maybe("ParameterBindings")];

fn system(node: &Node, report: &mut Report) -> System {
    let mut allowed = ELEMENT.to_vec();
    allowed.extend(
        ["Elements", "Connections", "SignalDictionaries", "SystemGeometry", "GraphicalElements"].map(Child::Maybe),
    );
    children(node, &allowed, report);
    let mut fields = Fields::of(node);
    let mut system = System {
        name: fields.required("name", report),
        description: super::common::description(&mut fields),
        line: node.line,
        ..System::default()
    };
    fields.finish(report);
    for child in &node.children {
        match child.name.as_str() {
            "Connectors" => system.connectors = connectors(child, report),
            "ParameterBindings" => system.parameter_bindings = parameter_bindings(child, report),
            "Elements" => system.elements = elements(child, report),
            "Connections" => {
                children(child, &[Child::Some("Connection")], report);
                let connections = child.children.iter().filter(|child| child.name == "Connection");
                system.connections = connections.map(|node| connection(node, report)).collect();
            }
            _ => {}
        }
    }
    system
}

fn elements(node: &Node, report: &mut Report) -> Vec<Element> {
    if node.children.is_empty() {
        report.error(node.line, "`Elements` must not be empty; remove it");
    }
    let mut elements = Vec::new();
    for child in &node.children {
        match child.name.as_str() {
            "Component" => elements.push(Element::Component(component(child, report))),
            "System" => elements.push(Element::System(system(child, report))),
            "SignalDictionaryReference" => report
                .warning(child.line, "signal dictionaries are not read; connect the elements with each other directly"),
            _ => report.error(child.line, format!("`{}` does not belong into `Elements`; remove it", child.name)),
        }
    }
    elements
}

fn component(node: &Node, report: &mut Report) -> Component {
    children(node, &ELEMENT, report);
    let mut fields = Fields::of(node);
    let mut component = Component {
        name: fields.required("name", report),
        description: super::common::description(&mut fields),
        media_type: fields.text("type"),
        source: fields.required("source", report),
        implementation: fields.one_of("implementation", &Implementation::NAMES, report).unwrap_or_default(),
        line: node.line,
        ..Component::default()
    };
    fields.finish(report);
    for child in &node.children {
        match child.name.as_str() {
            "Connectors" => component.connectors = connectors(child, report),
            "ParameterBindings" => component.parameter_bindings = parameter_bindings(child, report),
            _ => {}
        }
    }
    component
}

fn connectors(node: &Node, report: &mut Report) -> Vec<Connector> {
    children(node, &[Child::Some("Connector")], report);
    let nodes = node.children.iter().filter(|child| child.name == "Connector");
    nodes.map(|node| connector(node, report)).collect()
}

fn connector(node: &Node, report: &mut Report) -> Connector {
    let mut fields = Fields::of(node);
    let name = fields.required("name", report);
    let description = super::common::description(&mut fields);
    let kind = fields.one_of("kind", &ConnectorKind::NAMES, report).unwrap_or_else(|| {
        if fields.get("kind").is_none() {
            fields.required("kind", report);
        }
        ConnectorKind::Unspecified
    });
    fields.finish(report);
    let mut connector =
        Connector { name, description, kind, connector_type: None, dimensions: Vec::new(), line: node.line };
    for child in &node.children {
        match (child.name.as_str(), data_type(&child.name)) {
            ("Dimension", _) => connector.dimensions.push(dimension(child, report)),
            ("ConnectorGeometry" | "MetaData" | "Signature", _) => {}
            // `Clock` is also the name of a reference to a clock.
            ("Clock", _) if child.attributes.iter().any(|(key, _)| key == "name" || key == "clock") => {}
            (_, Some(data_type)) if connector.connector_type.is_none() => {
                connector.connector_type = Some(connector_type(child, data_type, report));
            }
            _ => report.error(child.line, format!("`{}` does not belong into `{}`; remove it", child.name, node.name)),
        }
    }
    connector
}

fn connector_type(node: &Node, data_type: DataType, report: &mut Report) -> ConnectorType {
    let mut fields = Fields::of(node);
    let connector_type = ConnectorType {
        data_type,
        unit: if data_type.is_float() { fields.text("unit") } else { None },
        enumeration: if data_type == DataType::Enumeration { Some(fields.required("name", report)) } else { None },
    };
    // What else clocks and binaries have is of no use to us.
    if !matches!(data_type, DataType::Clock | DataType::Binary) {
        fields.finish(report);
    }
    connector_type
}

fn connection(node: &Node, report: &mut Report) -> Connection {
    let mut allowed = TRANSFORMATIONS.map(Child::Maybe).to_vec();
    allowed.push(Child::Maybe("ConnectionGeometry"));
    children(node, &allowed, report);
    let mut fields = Fields::of(node);
    super::common::description(&mut fields);
    let connection = Connection {
        start: Endpoint {
            element: fields.text("startElement"),
            connector: fields.required("startConnector", report),
            indices: fields.list("startIndices", report).unwrap_or_default(),
        },
        end: Endpoint {
            element: fields.text("endElement"),
            connector: fields.required("endConnector", report),
            indices: fields.list("endIndices", report).unwrap_or_default(),
        },
        suppress_unit_conversion: fields.flag("suppressUnitConversion", report),
        transformation: transformation(node, report),
        line: node.line,
    };
    fields.finish(report);
    connection
}

fn parameter_bindings(node: &Node, report: &mut Report) -> Vec<ParameterBinding> {
    children(node, &[Child::Some("ParameterBinding")], report);
    let nodes = node.children.iter().filter(|child| child.name == "ParameterBinding");
    nodes.filter_map(|node| parameter_binding(node, report)).collect()
}

/// A binding; `None` if there are no values, which is reported.
fn parameter_binding(node: &Node, report: &mut Report) -> Option<ParameterBinding> {
    children(node, &[Child::Maybe("ParameterValues"), Child::Maybe("ParameterMapping")], report);
    let mut fields = Fields::of(node);
    super::common::description(&mut fields);
    let media_type = fields.text("type");
    let prefix = fields.text("prefix").unwrap_or_default();
    let file = file(&mut fields, report);
    fields.finish(report);
    let child = |name: &str| node.children.iter().find(|child| child.name == name);
    let values = source(node.line, file, child("ParameterValues"), "ParameterSet", parameters::set, report)?;
    let mapping = child("ParameterMapping").and_then(|node| {
        let mut fields = Fields::of(node);
        super::common::description(&mut fields);
        fields.get("type");
        let file = super::system::file(&mut fields, report);
        fields.finish(report);
        let inline = (!node.children.is_empty()).then_some(node);
        source(node.line, file, inline, "ParameterMapping", parameters::mapping, report)
    });
    Some(ParameterBinding { media_type, prefix, values, mapping, line: node.line })
}

/// `source` and `sourceBase`.
fn file(fields: &mut Fields<'_>, report: &mut Report) -> (Option<String>, SourceBase) {
    let source = fields.text("source");
    let base = fields.one_of("sourceBase", &SourceBase::NAMES, report).unwrap_or_default();
    (source, base)
}

/// A document in a file or inside `inline`: exactly one of both.
fn source<T>(
    line: usize,
    (file, base): (Option<String>, SourceBase),
    inline: Option<&Node>,
    root: &'static str,
    content: fn(&Node, &mut Report) -> T,
    report: &mut Report,
) -> Option<Source<T>> {
    match (file, inline) {
        (Some(source), None) => Some(Source::File { source, base }),
        (None, Some(node)) => {
            children(node, &[Child::Once(root)], report);
            let child = node.children.iter().find(|child| child.name == root)?;
            Some(Source::Inline(content(child, report)))
        }
        (Some(_), Some(_)) => {
            report.error(line, format!("there are both a `source` and a `{root}` inside; remove one of them"));
            None
        }
        (None, None) => {
            report.error(line, format!("there is neither a `source` nor a `{root}` inside; give one of them"));
            None
        }
    }
}
