//! Checking where and how an FMU and its terminals are drawn.

use super::{Area, TerminalGraphics, TerminalsAndIcons};
use crate::problem::Report;
use crate::xml_in::Node;

/// Where the parts stand that do not know it themselves; 0 for what was not read.
#[derive(Debug, Default)]
pub(super) struct Lines {
    coordinate_system: usize,
    icon: usize,
}

impl Lines {
    pub(super) fn of(root: &Node) -> Self {
        let parts = || root.children.iter().flat_map(|child| &child.children);
        let line = |name: &str| parts().find(|node| node.name == name).map_or(0, |node| node.line);
        Self { coordinate_system: line("CoordinateSystem"), icon: line("Icon") }
    }
}

pub(super) fn check(content: &TerminalsAndIcons, lines: &Lines, report: &mut Report) {
    if let Some(system) = &content.coordinate_system {
        let line = lines.coordinate_system;
        let Area { x1, y1, x2, y2 } = system.area;
        if !(is_finite(&system.area) && x1 < x2 && y1 < y2) {
            report.error(line, "the coordinate system must go from its lower left to its upper right corner");
        }
        if !(system.scale_to_mm > 0.0 && system.scale_to_mm.is_finite()) {
            report.error(line, format!("`suggestedScalingFactorTo_mm` is {} but must be positive", system.scale_to_mm));
        }
    }
    if let Some(icon) = &content.icon {
        area(icon, "the icon", lines.icon, report);
    }
}

fn is_finite(area: &Area) -> bool {
    [area.x1, area.y1, area.x2, area.y2].iter().all(|value| value.is_finite())
}

fn area(area: &Area, owner: &str, line: usize, report: &mut Report) {
    if !is_finite(area) || area.x1 == area.x2 || area.y1 == area.y2 {
        report.error(line, format!("{owner} is drawn in an empty area; give it two different corners"));
    } else if area.x1 > area.x2 || area.y1 > area.y2 {
        report.warning(line, format!("{owner} is drawn flipped, which some importers refuse"));
    }
}

/// The picture of a terminal.
pub(super) fn terminal(graphics: &TerminalGraphics, name: &str, line: usize, report: &mut Report) {
    area(&graphics.area, &format!("the terminal `{name}`"), line, report);
    let picture = graphics.icon_base_name.as_str();
    if picture.is_empty() || picture.starts_with('/') || picture.contains(':') || picture.split('/').any(|p| p == "..")
    {
        report.error(
            line,
            format!(
                "the terminal `{name}` has the iconBaseName `{picture}`; it must name a picture below \
                 terminalsAndIcons/, without its extension"
            ),
        );
    }
    if let Some(color) = &graphics.color
        && (color.len() != 3 || color.iter().any(|part| *part > 255))
    {
        report.error(
            line,
            format!("the connections of the terminal `{name}` need a colour of three numbers from 0 to 255"),
        );
    }
    if let Some(size) = graphics.stroke_size
        && !(size > 0.0 && size.is_finite())
    {
        report
            .error(line, format!("the connections of the terminal `{name}` have the stroke size {size}, not above 0"));
    }
}
