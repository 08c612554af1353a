//! Terminals and icons (FMI 3.0.2 section 2.4.9): which variables belong together in a connection, and how to draw the
//! FMU. They stand in a file of their own, [`TERMINALS_AND_ICONS`].

#[cfg(feature = "read")]
mod check;
#[cfg(feature = "read")]
mod graphics;
#[cfg(feature = "read")]
mod read;
mod write;

#[cfg(feature = "read")]
pub use check::{check, read_and_check};
#[cfg(feature = "read")]
pub use read::read;
pub use write::write;

/// The entry of an FMU that holds them.
pub const TERMINALS_AND_ICONS: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// The content of a `terminalsAndIcons.xml`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TerminalsAndIcons {
    /// `CoordinateSystem`, in which everything is placed; from −100 to 100 when absent.
    pub coordinate_system: Option<CoordinateSystem>,
    /// Where the FMU's icon is drawn.
    pub icon: Option<Area>,
    /// `Terminals`.
    pub terminals: Vec<Terminal>,
}

impl TerminalsAndIcons {
    /// All terminals, the nested ones after those that hold them.
    pub fn all_terminals(&self) -> Vec<&Terminal> {
        let mut found: Vec<&Terminal> = Vec::new();
        let mut rest: Vec<&Terminal> = self.terminals.iter().rev().collect();
        while let Some(terminal) = rest.pop() {
            found.push(terminal);
            rest.extend(terminal.terminals.iter().rev());
        }
        found
    }
}

/// `CoordinateSystem`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoordinateSystem {
    /// Its lower left and upper right corner.
    pub area: Area,
    /// `suggestedScalingFactorTo_mm`.
    pub scale_to_mm: f64,
}

/// A rectangle by two corners. An icon whose second corner is not the upper right one is drawn flipped.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub struct Area {
    pub x1: f64,
    pub y1: f64,
    pub x2: f64,
    pub y2: f64,
}

/// `Terminal`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Terminal {
    /// `name`, unique among its siblings.
    pub name: String,
    /// `matchingRule`: `plug`, `bus`, `sequence` or a name of another standard.
    pub matching_rule: String,
    /// `terminalKind`.
    pub terminal_kind: Option<String>,
    /// `description`.
    pub description: Option<String>,
    /// `TerminalMemberVariable`s.
    pub members: Vec<Member>,
    /// `TerminalStreamMemberVariable`s.
    pub streams: Vec<Stream>,
    /// `Terminal`s inside.
    pub terminals: Vec<Terminal>,
    /// `TerminalGraphicalRepresentation`.
    pub graphics: Option<TerminalGraphics>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// `TerminalMemberVariable`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Member {
    /// `variableName`.
    pub variable: String,
    /// `memberName`, by which members of connected terminals find each other.
    pub name: Option<String>,
    /// `variableKind`: `signal`, `inflow`, `outflow` or a name of another standard.
    pub kind: String,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// `TerminalStreamMemberVariable`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Stream {
    /// `inStreamMemberName`.
    pub in_name: String,
    /// `outStreamMemberName`.
    pub out_name: String,
    /// `inStreamVariableName`.
    pub in_variable: String,
    /// `outStreamVariableName`.
    pub out_variable: String,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

/// `TerminalGraphicalRepresentation`.
#[derive(Debug, Clone, PartialEq)]
pub struct TerminalGraphics {
    /// Where it is drawn.
    pub area: Area,
    /// `iconBaseName`: the picture's file beside the document, without its extension.
    pub icon_base_name: String,
    /// `defaultConnectionColor`: red, green, blue.
    pub color: Option<Vec<u32>>,
    /// `defaultConnectionStrokeSize`.
    pub stroke_size: Option<f64>,
}
