//! Writing terminals and icons.

use super::*;
use crate::write::WriteError;
use crate::xml_out::{Document, Element, join};

/// Writes terminals and icons as the text of a `terminalsAndIcons.xml` of FMI 3.0. The same content always gives the same
/// bytes.
///
/// # Errors
///
/// [`WriteError`] if a text holds a character that XML cannot hold.
pub fn write(content: &TerminalsAndIcons) -> Result<String, WriteError> {
    let mut document = Document::new();
    document.open(Element::new("fmiTerminalsAndIcons").text("fmiVersion", "3.0"));
    if content.coordinate_system.is_some() || content.icon.is_some() {
        document.open(Element::new("GraphicalRepresentation"));
        if let Some(system) = &content.coordinate_system {
            document.empty(
                area(Element::new("CoordinateSystem"), &system.area)
                    .float("suggestedScalingFactorTo_mm", system.scale_to_mm),
            );
        }
        if let Some(icon) = &content.icon {
            document.empty(area(Element::new("Icon"), icon));
        }
        document.close();
    }
    document.list("Terminals", &content.terminals, terminal);
    Ok(document.finish()?)
}

fn area(element: Element, area: &Area) -> Element {
    element.float("x1", area.x1).float("y1", area.y1).float("x2", area.x2).float("y2", area.y2)
}

fn terminal(document: &mut Document, terminal: &Terminal) {
    let element = Element::new("Terminal")
        .text("name", &terminal.name)
        .text("matchingRule", &terminal.matching_rule)
        .maybe("terminalKind", terminal.terminal_kind.as_deref())
        .maybe("description", terminal.description.as_deref());
    document.open(element);
    for member in &terminal.members {
        document.empty(
            Element::new("TerminalMemberVariable")
                .text("variableName", &member.variable)
                .maybe("memberName", member.name.as_deref())
                .text("variableKind", &member.kind),
        );
    }
    for stream in &terminal.streams {
        document.empty(
            Element::new("TerminalStreamMemberVariable")
                .text("inStreamMemberName", &stream.in_name)
                .text("outStreamMemberName", &stream.out_name)
                .text("inStreamVariableName", &stream.in_variable)
                .text("outStreamVariableName", &stream.out_variable),
        );
    }
    for inner in &terminal.terminals {
        self::terminal(document, inner);
    }
    if let Some(graphics) = &terminal.graphics {
        let element = Element::new("TerminalGraphicalRepresentation");
        let color = graphics.color.as_ref().map(|color| join(color, u32::to_string));
        document.empty(
            area(element, &graphics.area)
                .text("iconBaseName", &graphics.icon_base_name)
                .maybe("defaultConnectionColor", color.as_deref())
                .maybe_float("defaultConnectionStrokeSize", graphics.stroke_size),
        );
    }
    document.close();
}
