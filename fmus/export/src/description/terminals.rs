//! Terminals and icons: what a model groups, and where it is drawn.

use swayless_abi::describe::TERMINAL_PICTURE;
use swayless_modeldesc::terminals::{Area, CoordinateSystem, Member, Terminal, TerminalGraphics, TerminalsAndIcons};
use swayless_modeldesc::types::{Causality, FmiVersion};

use crate::model::Model;
use crate::terminal::Terminal as Declared;
use crate::token::Variant;

/// Half the side of the FMU's icon; the standard's default.
const HALF: f64 = 100.0;
/// The greatest side of a terminal.
const STUB: f64 = 20.0;
/// How a kind begins that is nobody else's, as the standard asks of a vendor's own.
const KINDS: &str = "_swayless_";
/// The colour of connections: that of the icons' frames.
const COLOR: [u32; 3] = [0x3b, 0x4a, 0x5a];

/// The terminals of a model, at the left of its icon where they take something, else at the right.
pub fn of<M: Model>() -> TerminalsAndIcons {
    let variables = super::of::<M>(FmiVersion::V3, Variant::Plain).variables;
    let is_input = |name: &str| variables.iter().any(|v| v.name == name && v.causality == Causality::Input);
    let takes = |terminal: &&Declared| terminal.members.iter().any(|(variable, _)| is_input(variable));
    let (left, right): (Vec<&Declared>, Vec<&Declared>) = M::INFO.terminals.iter().partition(takes);
    let whole = Area { x1: -HALF, y1: -HALF, x2: HALF, y2: HALF };
    TerminalsAndIcons {
        coordinate_system: Some(CoordinateSystem { area: whole, scale_to_mm: 0.1 }),
        icon: Some(whole),
        terminals: [side(&left, -HALF - STUB), side(&right, HALF)].concat(),
    }
}

/// Terminals one below the other, from this x on.
fn side(terminals: &[&Declared], x1: f64) -> Vec<Terminal> {
    let pitch = 2.0 * HALF / terminals.len().max(1) as f64;
    let height = STUB.min(pitch / 2.0);
    let middle = |index: usize| HALF - (index as f64 + 0.5) * pitch;
    let area = |y: f64| Area { x1, y1: y - height / 2.0, x2: x1 + STUB, y2: y + height / 2.0 };
    terminals.iter().enumerate().map(|(index, declared)| terminal(declared, area(middle(index)))).collect()
}

fn terminal(declared: &Declared, area: Area) -> Terminal {
    let members = declared.members.iter().map(|(variable, name)| Member {
        variable: (*variable).to_string(),
        name: Some((*name).to_string()),
        kind: "signal".to_string(),
        line: 0,
    });
    Terminal {
        name: declared.name.to_string(),
        matching_rule: "bus".to_string(),
        terminal_kind: Some(format!("{KINDS}{}", declared.kind)),
        description: Some(declared.description.to_string()),
        members: members.collect(),
        graphics: Some(TerminalGraphics {
            area,
            icon_base_name: TERMINAL_PICTURE.to_string(),
            color: Some(COLOR.to_vec()),
            stroke_size: None,
        }),
        ..Terminal::default()
    }
}
