//! The model structure.

use super::name_of;

/// `ModelStructure`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelStructure {
    /// The outputs.
    pub outputs: Vec<Unknown>,
    /// The derivatives of the continuous states.
    pub derivatives: Vec<Unknown>,
    /// The clocked states (FMI 3.0).
    pub clocked_states: Vec<Unknown>,
    /// What must be solved for in initialization.
    pub initial_unknowns: Vec<Unknown>,
    /// The event indicators (FMI 3.0).
    pub event_indicators: Vec<Unknown>,
}

/// An entry of `ModelStructure`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Unknown {
    /// The variable, as an index into [`ModelDescription::variables`](super::ModelDescription::variables).
    pub variable: usize,
    /// What it depends on, as indices into [`ModelDescription::variables`](super::ModelDescription::variables); `None` means on everything it could.
    pub dependencies: Option<Vec<usize>>,
    /// How, one for each dependency.
    pub dependencies_kind: Option<Vec<DependencyKind>>,
    /// The line it stands in, 0 when it was not read from a file.
    pub line: usize,
}

/// `dependenciesKind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum DependencyKind {
    Dependent,
    Constant,
    Fixed,
    Tunable,
    Discrete,
}

impl DependencyKind {
    /// Every kind with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 5] = [
        ("dependent", Self::Dependent),
        ("constant", Self::Constant),
        ("fixed", Self::Fixed),
        ("tunable", Self::Tunable),
        ("discrete", Self::Discrete),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}
