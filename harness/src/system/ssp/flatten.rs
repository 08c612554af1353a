//! Connections through the connectors of nested systems, made direct.

use std::collections::HashMap;

use swayless_modeldesc::ssp::{self, Connection, ConnectorKind, Element, Endpoint, Transformation};

use super::Reader;
use crate::system;

/// A connector by the path of its owner: `inner.crane` and `slew.angle`, or the empty path for the root system's own.
type Node = (String, String);

/// A connection in the direction of the data.
struct Edge {
    from: Node,
    factor: f64,
    offset: f64,
    convert_units: bool,
    line: usize,
}

/// Adds the connections from outputs of components to inputs of components, and names the root's own connectors.
pub(super) fn connections(reader: &mut Reader) {
    let mut edges: HashMap<Node, Vec<Edge>> = HashMap::new();
    let mut order = Vec::new();
    let root = &reader.description.system;
    collect(reader, root, "", &mut edges, &mut order);

    let components = components(root, "");
    for to in order.iter().filter(|(owner, _)| components.contains(owner)) {
        for (from, edge) in sources(&edges, to, &mut Vec::new()) {
            let (target, source) = (port(to), port(&from));
            if components.contains(&from.0) {
                reader.system.add_connection(system::Connection {
                    from: source,
                    to: target,
                    factor: edge.factor,
                    offset: edge.offset,
                    convert_units: edge.convert_units,
                    place: reader.place(edge.line),
                });
            } else if from.0.is_empty() {
                untransformed(reader, &edge);
                reader.system.connectors.entry(from.1).or_default().push(target);
            }
        }
    }
    for to in order.iter().filter(|(owner, _)| owner.is_empty()) {
        for (from, edge) in sources(&edges, to, &mut Vec::new()) {
            if components.contains(&from.0) {
                untransformed(reader, &edge);
                reader.system.connectors.entry(to.1.clone()).or_default().push(port(&from));
            }
        }
    }
}

/// The root's own connectors are other names of variables, no more.
fn untransformed(reader: &mut Reader, edge: &Edge) {
    if (edge.factor, edge.offset) != (1.0, 0.0) {
        let text = "a transformation between a connector of the root system and a variable is not supported";
        let error = reader.wrong(edge.line, text.to_owned());
        reader.errors.push(error);
    }
}

/// The names of all components.
fn components(system: &ssp::System, path: &str) -> Vec<String> {
    let names = system.elements.iter().flat_map(|element| {
        let name = format!("{path}{}", element.name());
        match element {
            Element::Component(_) => vec![name],
            Element::System(inner) => components(inner, &format!("{name}.")),
        }
    });
    names.collect()
}

/// The connections of a system and of those inside it, by their ends.
fn collect(
    reader: &mut Reader,
    system: &ssp::System,
    path: &str,
    edges: &mut HashMap<Node, Vec<Edge>>,
    order: &mut Vec<Node>,
) {
    for connection in &system.connections {
        // Connections that have no direction were found by the check of the document.
        let Ok(flow) = system.flow(connection) else { continue };
        if flow.from_connector.kind == ConnectorKind::Parameter || flow.to_connector.kind == ConnectorKind::Parameter {
            let text = "connections of parameters are not supported; give the parameter in a ParameterBinding";
            let error = reader.wrong(connection.line, text.to_owned());
            reader.errors.push(error);
            continue;
        }
        let Some((factor, offset)) = linear(connection) else {
            let text = format!(
                "the connection from {} to {} has a mapping transformation; only linear ones are supported",
                flow.from, flow.to
            );
            let error = reader.wrong(connection.line, text);
            reader.errors.push(error);
            continue;
        };
        let to = node(path, flow.to);
        if !edges.contains_key(&to) {
            order.push(to.clone());
        }
        edges.entry(to).or_default().push(Edge {
            from: node(path, flow.from),
            factor,
            offset,
            convert_units: !connection.suppress_unit_conversion,
            line: connection.line,
        });
    }
    for element in &system.elements {
        if let Element::System(inner) = element {
            collect(reader, inner, &format!("{path}{}.", inner.name), edges, order);
        }
    }
}

fn linear(connection: &Connection) -> Option<(f64, f64)> {
    match connection.transformation {
        None => Some((1.0, 0.0)),
        Some(Transformation::Linear { factor, offset }) => Some((factor, offset)),
        Some(_) => None,
    }
}

fn node(path: &str, end: &Endpoint) -> Node {
    let owner = match &end.element {
        Some(element) => format!("{path}{element}"),
        None => path.trim_end_matches('.').to_owned(),
    };
    let indices: Vec<String> = end.indices.iter().map(u64::to_string).collect();
    let element = if indices.is_empty() { String::new() } else { format!("[{}]", indices.join(",")) };
    (owner, format!("{}{element}", end.connector))
}

fn port((owner, connector): &Node) -> String {
    if owner.is_empty() { connector.clone() } else { format!("{owner}.{connector}") }
}

/// Where the value of a connector comes from in the end, with what happens on the way as one connection.
fn sources(edges: &HashMap<Node, Vec<Edge>>, to: &Node, way: &mut Vec<Node>) -> Vec<(Node, Edge)> {
    // Connectors that feed each other in a circle have no source.
    if way.contains(to) {
        return Vec::new();
    }
    way.push(to.clone());
    let mut found = Vec::new();
    for edge in edges.get(to).into_iter().flatten() {
        let here = |from: Node, factor, offset, convert_units| {
            (from.clone(), Edge { from, factor, offset, convert_units, line: edge.line })
        };
        let further = sources(edges, &edge.from, way);
        if further.is_empty() {
            found.push(here(edge.from.clone(), edge.factor, edge.offset, edge.convert_units));
        }
        for (from, before) in further {
            let (factor, offset) = (edge.factor * before.factor, edge.factor * before.offset + edge.offset);
            found.push(here(from, factor, offset, edge.convert_units && before.convert_units));
        }
    }
    way.pop();
    found
}
