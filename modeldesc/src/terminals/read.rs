//! Reading terminals and icons.

use super::*;
use crate::problem::{Problem, ReadError, Report};
use crate::xml_in::{self, Child, Fields, Node, check_children};

/// Reads the text of a `terminalsAndIcons.xml`, with the problems of its form.
///
/// # Errors
///
/// [`ReadError`] if the text is not well-formed XML, has a document type definition or is nested absurdly deep, or if
/// its root is not `fmiTerminalsAndIcons`.
pub fn read(xml: &str) -> Result<(TerminalsAndIcons, Vec<Problem>), ReadError> {
    let (content, _, report) = with_root(xml)?;
    Ok((content, report.into_problems()))
}

/// The content, the root, and what there is to say of its form.
pub(super) fn with_root(xml: &str) -> Result<(TerminalsAndIcons, Node, Report), ReadError> {
    let mut report = Report::default();
    let root = xml_in::parse(xml, &mut report)?;
    if root.name != "fmiTerminalsAndIcons" {
        return Err(ReadError {
            line: root.line,
            message: format!("the root is `{}` but must be `fmiTerminalsAndIcons`", root.name),
        });
    }
    let mut fields = Fields::of(&root);
    let version = fields.required("fmiVersion", &mut report);
    if !version.is_empty() && !version.starts_with("3.") {
        report.error(root.line, format!("fmiVersion is `{version}` but must be 3.0"));
    }
    fields.finish(&mut report);
    check_children(&root, &[Child::Maybe("GraphicalRepresentation"), Child::Maybe("Terminals")], &mut report);
    let mut content = TerminalsAndIcons::default();
    for child in &root.children {
        match child.name.as_str() {
            "GraphicalRepresentation" => graphical_representation(child, &mut content, &mut report),
            "Terminals" => {
                Fields::of(child).finish(&mut report);
                check_children(child, &[Child::Some("Terminal")], &mut report);
                content.terminals = inner_terminals(child, &mut report);
            }
            _ => {}
        }
    }
    Ok((content, root, report))
}

fn graphical_representation(node: &Node, content: &mut TerminalsAndIcons, report: &mut Report) {
    Fields::of(node).finish(report);
    check_children(node, &[Child::Maybe("CoordinateSystem"), Child::Maybe("Icon")], report);
    for child in &node.children {
        let mut fields = Fields::of(child);
        match child.name.as_str() {
            "CoordinateSystem" => {
                content.coordinate_system = Some(CoordinateSystem {
                    area: area(&mut fields, report),
                    scale_to_mm: fields.required_value("suggestedScalingFactorTo_mm", report),
                });
            }
            "Icon" => content.icon = Some(area(&mut fields, report)),
            _ => continue,
        }
        fields.finish(report);
    }
}

fn area(fields: &mut Fields<'_>, report: &mut Report) -> Area {
    let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|key| fields.required_value(key, report));
    Area { x1, y1, x2, y2 }
}

fn inner_terminals(node: &Node, report: &mut Report) -> Vec<Terminal> {
    node.children.iter().filter(|child| child.name == "Terminal").map(|child| terminal(child, report)).collect()
}

fn terminal(node: &Node, report: &mut Report) -> Terminal {
    let lists = [
        Child::Many("TerminalMemberVariable"),
        Child::Many("TerminalStreamMemberVariable"),
        Child::Many("Terminal"),
        Child::Maybe("TerminalGraphicalRepresentation"),
    ];
    check_children(node, &lists, report);
    let mut fields = Fields::of(node);
    let mut terminal = Terminal {
        name: fields.required("name", report),
        matching_rule: fields.required("matchingRule", report),
        terminal_kind: fields.text("terminalKind"),
        description: fields.text("description"),
        terminals: inner_terminals(node, report),
        line: node.line,
        ..Terminal::default()
    };
    fields.finish(report);
    for child in &node.children {
        let line = child.line;
        let mut fields = Fields::of(child);
        match child.name.as_str() {
            "TerminalMemberVariable" => terminal.members.push(Member {
                variable: fields.required("variableName", report),
                name: fields.text("memberName"),
                kind: fields.required("variableKind", report),
                line,
            }),
            "TerminalStreamMemberVariable" => terminal.streams.push(Stream {
                in_name: fields.required("inStreamMemberName", report),
                out_name: fields.required("outStreamMemberName", report),
                in_variable: fields.required("inStreamVariableName", report),
                out_variable: fields.required("outStreamVariableName", report),
                line,
            }),
            "TerminalGraphicalRepresentation" => {
                terminal.graphics = Some(TerminalGraphics {
                    area: area(&mut fields, report),
                    icon_base_name: fields.required("iconBaseName", report),
                    color: fields.list("defaultConnectionColor", report),
                    stroke_size: fields.value("defaultConnectionStrokeSize", report),
                });
            }
            _ => continue,
        }
        fields.finish(report);
    }
    terminal
}
