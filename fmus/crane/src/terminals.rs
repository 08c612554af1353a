//! The terminals of cranes and their drives: what is connected together. A drive's axis has the same member names as a
//! crane's.

use swayless_export::Terminal;

/// Command of an axis.
pub const COMMAND: Terminal = Terminal {
    name: "command",
    description: "Commanded velocity",
    kind: "command",
    members: &[("command", "command")],
};

/// Axis that a drive moves. A drive does not ask where its axis is, so its own travel has another name than the
/// position of the axis.
pub const DRIVEN_AXIS: Terminal = Terminal {
    name: "axis",
    description: "The axis that is driven",
    kind: "axis",
    members: &[("velocity", "rate"), ("acceleration", "acceleration"), ("position", "travel")],
};

/// Load that a drive works against.
pub const DRIVEN_LOAD: Terminal = Terminal {
    name: "load",
    description: "The load on the axis",
    kind: "load",
    members: &[("load.force", "force"), ("load.mass", "mass")],
};

/// Slewing axis.
pub const SLEW: Terminal = Terminal {
    name: "slew",
    description: "Slewing axis",
    kind: "axis",
    members: &[("slew.rate", "rate"), ("slew.angle", "position")],
};

/// Luffing axis.
pub const LUFF: Terminal = Terminal {
    name: "luff",
    description: "Luffing axis",
    kind: "axis",
    members: &[("luff.rate", "rate"), ("luff.angle", "position")],
};

/// Hoisting axis.
pub const HOIST: Terminal = Terminal {
    name: "hoist",
    description: "Hoisting axis; it lengthens the suspension",
    kind: "axis",
    members: &[("hoist.rate", "rate"), ("hoist.length", "position")],
};

/// Force on the payload.
pub const WIND: Terminal = Terminal {
    name: "wind",
    description: "Force on the payload",
    kind: "force",
    members: &[("wind.x", "x"), ("wind.y", "y"), ("wind.z", "z")],
};

/// Position of a boom's tip.
pub const TIP: Terminal = Terminal {
    name: "tip",
    description: "Position of the boom tip",
    kind: "position",
    members: &[("tip.x", "x"), ("tip.y", "y"), ("tip.z", "z")],
};

/// Position of the payload.
pub const PAYLOAD: Terminal = Terminal {
    name: "payload",
    description: "Position of the payload",
    kind: "position",
    members: &[("payload.x", "x"), ("payload.y", "y"), ("payload.z", "z")],
};

/// Swing of the payload.
pub const SWING: Terminal = Terminal {
    name: "swing",
    description: "Swing of the payload",
    kind: "swing",
    members: &[
        ("swing.radial", "radial"),
        ("swing.tangential", "tangential"),
        ("swing.radial_rate", "radial_rate"),
        ("swing.tangential_rate", "tangential_rate"),
        ("swing.amplitude", "amplitude"),
    ],
};
