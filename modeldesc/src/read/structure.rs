//! The entries of `ModelStructure`, and how references become indices.

use crate::problem::Report;
use crate::types::*;
use crate::xml_in::{Fields, Node};
use std::collections::HashMap;

/// How a version refers to a variable.
pub(super) enum References {
    /// FMI 2.0: by its position, counted from 1.
    Position(usize),
    /// FMI 3.0: by its value reference.
    ValueReference(HashMap<u32, usize>),
}

impl References {
    /// By position in a list of this length.
    pub(super) fn by_position(variables: &[Variable]) -> Self {
        Self::Position(variables.len())
    }

    /// By value reference; the first of several with the same one holds it.
    pub(super) fn by_value_reference(variables: &[Variable]) -> Self {
        let mut indices = HashMap::with_capacity(variables.len());
        for (index, variable) in variables.iter().enumerate() {
            indices.entry(variable.value_reference).or_insert(index);
        }
        Self::ValueReference(indices)
    }

    /// The index a reference means; what leads nowhere is reported.
    pub(super) fn resolve(&self, reference: u32, key: &str, line: usize, report: &mut Report) -> Option<usize> {
        let (index, what) = match self {
            Self::Position(count) => {
                let index = usize::try_from(reference).ok().and_then(|r| r.checked_sub(1)).filter(|i| i < count);
                (index, "index")
            }
            Self::ValueReference(indices) => (indices.get(&reference).copied(), "value reference"),
        };
        if index.is_none() {
            report.error(line, format!("`{key}` refers to {what} {reference}, which no variable has"));
        }
        index
    }
}

/// An entry; `None` if the variable it is about does not exist.
pub(super) fn unknown(node: &Node, key: &'static str, references: &References, report: &mut Report) -> Option<Unknown> {
    let mut fields = Fields::of(node);
    let variable = match fields.get(key) {
        Some(_) => fields.value(key, report),
        None => {
            fields.required(key, report);
            None
        }
    };
    let dependencies = fields.list::<u32>("dependencies", report);
    let kinds = fields.get("dependenciesKind").and_then(|text| kinds(node, text, report));
    fields.finish(report);
    let variable = references.resolve(variable?, key, node.line, report)?;
    // An unknown that depends on something unknown may depend on anything.
    let resolved = dependencies.and_then(|list| {
        let resolved: Vec<Option<usize>> = list
            .into_iter()
            .map(|reference| references.resolve(reference, "dependencies", node.line, report))
            .collect();
        resolved.into_iter().collect::<Option<Vec<usize>>>()
    });
    let lost = resolved.is_none() && node.attributes.iter().any(|(name, _)| name == "dependencies");
    Some(Unknown {
        variable,
        dependencies: resolved,
        dependencies_kind: if lost { None } else { kinds },
        line: node.line,
    })
}

fn kinds(node: &Node, text: &str, report: &mut Report) -> Option<Vec<DependencyKind>> {
    let mut kinds = Vec::new();
    for word in text.split_ascii_whitespace() {
        match DependencyKind::NAMES.iter().find(|(name, _)| *name == word) {
            Some((_, kind)) => kinds.push(*kind),
            None => {
                let names: Vec<&str> = DependencyKind::NAMES.iter().map(|(name, _)| *name).collect();
                let short: String = word.chars().take(40).collect();
                report
                    .error(node.line, format!("`dependenciesKind` holds `{short}` but must hold {}", names.join(", ")));
                return None;
            }
        }
    }
    Some(kinds)
}
