//! The model structure: complete, without strangers, with dependencies that can be.

use super::Scope;
use super::references::states;
use crate::problem::Report;
use crate::types::*;
use std::collections::HashSet;

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    let structure = &scope.description.structure;
    let states = states(scope.description);
    let lists: [(&str, &[Unknown]); 5] = [
        ("output", &structure.outputs),
        ("state derivative", &structure.derivatives),
        ("clocked state", &structure.clocked_states),
        ("initial unknown", &structure.initial_unknowns),
        ("event indicator", &structure.event_indicators),
    ];
    for (list, unknowns) in lists {
        let mut seen = HashSet::new();
        for unknown in unknowns {
            let Some(variable) = scope.variable(unknown.variable) else {
                report.error(
                    unknown.line,
                    format!("the {list} with index {} does not exist among the variables", unknown.variable),
                );
                continue;
            };
            if !seen.insert(unknown.variable) {
                report.error(unknown.line, format!("the {list} `{}` is listed twice", variable.name));
            }
            let initial = list == "initial unknown";
            dependencies(scope, unknown, variable, initial, &states, report);
        }
    }
    outputs(scope, report);
    derivatives(scope, report);
    clocked_states(scope, report);
    event_indicators(scope, report);
    initial_unknowns(scope, &states, report);
}

/// The variables of a list of unknowns.
fn listed(unknowns: &[Unknown]) -> HashSet<usize> {
    unknowns.iter().map(|unknown| unknown.variable).collect()
}

fn outputs(scope: &Scope<'_>, report: &mut Report) {
    let outputs = &scope.description.structure.outputs;
    let listed = listed(outputs);
    for (index, variable) in scope.description.variables.iter().enumerate() {
        if variable.causality == Causality::Output && !listed.contains(&index) {
            report.error(
                variable.line,
                format!("the output `{}` is missing among the outputs of ModelStructure", variable.name),
            );
        }
    }
    for unknown in outputs {
        if let Some(variable) = scope.variable(unknown.variable)
            && variable.causality != Causality::Output
        {
            report.error(
                unknown.line,
                format!("`{}` is among the outputs of ModelStructure but is no output", variable.name),
            );
        }
    }
}

fn derivatives(scope: &Scope<'_>, report: &mut Report) {
    for unknown in &scope.description.structure.derivatives {
        let Some(variable) = scope.variable(unknown.variable) else { continue };
        match variable.derivative {
            None => report.error(
                unknown.line,
                format!("`{}` is among the state derivatives but has no attribute `derivative`", variable.name),
            ),
            Some(state) => {
                if let Some(state) = scope.variable(state)
                    && !matches!(state.causality, Causality::Local | Causality::Output)
                {
                    report.error(
                        unknown.line,
                        format!("the continuous state `{}` must be a local variable or an output", state.name),
                    );
                }
            }
        }
    }
}

fn clocked_states(scope: &Scope<'_>, report: &mut Report) {
    for unknown in &scope.description.structure.clocked_states {
        let Some(variable) = scope.variable(unknown.variable) else { continue };
        if variable.previous.is_none() || variable.clocks.is_empty() {
            report.error(
                unknown.line,
                format!("the clocked state `{}` needs the attributes `clocks` and `previous`", variable.name),
            );
        }
    }
}

fn event_indicators(scope: &Scope<'_>, report: &mut Report) {
    let indicators = &scope.description.structure.event_indicators;
    for unknown in indicators {
        let Some(variable) = scope.variable(unknown.variable) else { continue };
        let fits = variable.data_type.is_float()
            && variable.variability == Variability::Continuous
            && matches!(variable.causality, Causality::Local | Causality::Output);
        if !fits {
            report.error(
                unknown.line,
                format!("the event indicator `{}` must be a continuous float, local or output", variable.name),
            );
        }
    }
    let number = scope.description.number_of_event_indicators;
    if scope.is(FmiVersion::V3) && number != indicators.len() {
        report.error(0, format!("there should be {number} event indicators but {} are listed", indicators.len()));
    }
}

/// Exactly the outputs, states and state derivatives that are not given, and the calculated parameters.
fn initial_unknowns(scope: &Scope<'_>, states: &HashSet<usize>, report: &mut Report) {
    let structure = &scope.description.structure;
    let derivatives = listed(&structure.derivatives);
    let listed = listed(&structure.initial_unknowns);
    let is_expected = |index: usize, variable: &Variable| {
        let computed = matches!(variable.initial, Some(Initial::Approx | Initial::Calculated));
        let output = variable.causality == Causality::Output && variable.clocks.is_empty();
        variable.causality == Causality::CalculatedParameter
            || computed && (output || states.contains(&index) || derivatives.contains(&index))
    };
    for (index, variable) in scope.description.variables.iter().enumerate() {
        if is_expected(index, variable) && !listed.contains(&index) {
            report.error(
                variable.line,
                format!("`{}` is missing among the initial unknowns of ModelStructure", variable.name),
            );
        }
    }
    for unknown in &structure.initial_unknowns {
        // Clocked variables may be listed, as the exporter wishes.
        if let Some(variable) = scope.variable(unknown.variable)
            && !is_expected(unknown.variable, variable)
            && variable.clocks.is_empty()
        {
            report.error(
                unknown.line,
                format!(
                    "`{}` is among the initial unknowns but is neither a calculated parameter nor a calculated output, \
                     state or state derivative",
                    variable.name
                ),
            );
        }
    }
}

fn dependencies(
    scope: &Scope<'_>,
    unknown: &Unknown,
    variable: &Variable,
    initial: bool,
    states: &HashSet<usize>,
    report: &mut Report,
) {
    let line = unknown.line;
    let name = &variable.name;
    let count = unknown.dependencies.as_ref().map(Vec::len);
    if let Some(kinds) = &unknown.dependencies_kind {
        match count {
            None => report.error(line, format!("`{name}` has `dependenciesKind` but no `dependencies`")),
            Some(count) if count != kinds.len() => report.error(
                line,
                format!("`{name}` has {count} dependencies but {} kinds of them; give one for each", kinds.len()),
            ),
            Some(_) => {}
        }
        let linear = |kind: &&DependencyKind| **kind != DependencyKind::Dependent;
        if let Some(kind) = kinds.iter().find(linear)
            && !variable.data_type.is_float()
        {
            report.error(line, format!("`{name}` is no float and cannot have the dependency kind {}", kind.as_str()));
        }
        let late = [DependencyKind::Fixed, DependencyKind::Tunable, DependencyKind::Discrete];
        if let Some(kind) = kinds.iter().find(|kind| initial && late.contains(kind)) {
            report
                .error(line, format!("the initial unknown `{name}` cannot have the dependency kind {}", kind.as_str()));
        }
    }
    let mut seen = HashSet::new();
    for &index in unknown.dependencies.iter().flatten() {
        let Some(known) = scope.variable(index) else {
            report.error(line, format!("`{name}` depends on variable {index}, which does not exist"));
            continue;
        };
        if !seen.insert(index) {
            report.error(line, format!("`{name}` depends twice on `{}`; name it once", known.name));
        }
        if !is_known(known, index, initial, states) {
            report.warning(
                line,
                format!(
                    "`{name}` depends on `{}`, which is itself computed; name the inputs, states and parameters behind it",
                    known.name
                ),
            );
        }
    }
}

/// What an unknown may depend on (FMI 3.0.2 section 2.4.8): in initialization, inputs and what starts exactly; later,
/// inputs, parameters and states.
fn is_known(known: &Variable, index: usize, initial: bool, states: &HashSet<usize>) -> bool {
    match known.causality {
        Causality::Input | Causality::Independent | Causality::Parameter | Causality::StructuralParameter => true,
        _ if initial => known.initial == Some(Initial::Exact),
        _ => states.contains(&index) || matches!(known.variability, Variability::Discrete | Variability::Tunable),
    }
}
