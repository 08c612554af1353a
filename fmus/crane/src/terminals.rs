//! The terminals of cranes: what is connected together. A drive's axis has the same member names as a crane's.

use swayless_export::Terminal;

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
