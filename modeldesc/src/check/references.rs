//! How variables refer to each other: value references, aliases, the independent variable, derivatives, dimensions.

use super::Scope;
use super::lines::Part;
use super::values::initial_size;
use crate::problem::Report;
use crate::types::*;
use std::collections::{HashMap, HashSet};

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    match scope.description.fmi_version {
        FmiVersion::V2 => alias_sets(scope, report),
        FmiVersion::V3 => unique_references(scope, report),
    }
    independent(scope, report);
    let states = states(scope.description);
    for (index, variable) in scope.description.variables.iter().enumerate() {
        derivative(scope, index, variable, report);
        // Without model exchange, states need not be exposed.
        if variable.reinit && !states.contains(&index) && scope.description.model_exchange.is_some() {
            report
                .error(variable.line, format!("`{}` is no continuous state and must not have `reinit`", variable.name));
        }
        dimensions(scope, variable, report);
    }
}

/// The continuous states: what the derivatives in the model structure are derivatives of.
pub(super) fn states(description: &ModelDescription) -> HashSet<usize> {
    let derivatives = description.structure.derivatives.iter();
    derivatives.filter_map(|unknown| description.variables.get(unknown.variable)?.derivative).collect()
}

fn unique_references(scope: &Scope<'_>, report: &mut Report) {
    let mut seen: HashMap<u32, &str> = HashMap::new();
    for variable in &scope.description.variables {
        if let Some(first) = seen.insert(variable.value_reference, &variable.name) {
            report.error(
                variable.line,
                format!(
                    "`{}` has the value reference {} of `{first}`; make them unique",
                    variable.name, variable.value_reference
                ),
            );
        }
    }
}

/// In FMI 2.0, variables of one type with one value reference are names of one thing (section 2.2.7).
fn alias_sets(scope: &Scope<'_>, report: &mut Report) {
    let mut sets: HashMap<(DataType, u32), Vec<&Variable>> = HashMap::new();
    for variable in &scope.description.variables {
        let set = sets.entry((variable.data_type, variable.value_reference)).or_default();
        if let Some(first) = set.first() {
            let both = format!("`{}` and `{}` have the same value reference", first.name, variable.name);
            let constant = |v: &Variable| v.variability == Variability::Constant;
            if constant(first) != constant(variable) {
                report.error(variable.line, format!("{both} but only one of them is constant"));
            } else if constant(first) && first.start != variable.start {
                report.error(variable.line, format!("{both} and are constant but start at different values"));
            }
            if scope.attributes(first).unit != scope.attributes(variable).unit {
                report.error(variable.line, format!("{both} but different units"));
            }
        }
        let settable = |v: &Variable| v.start.is_some() && v.variability != Variability::Constant;
        if let Some(other) = set.iter().find(|other| settable(other) && settable(variable)) {
            report.error(
                variable.line,
                format!(
                    "`{}` and `{}` have the same value reference and both a start value; leave it to one of them",
                    other.name, variable.name
                ),
            );
        }
        set.push(variable);
    }
}

fn independent(scope: &Scope<'_>, report: &mut Report) {
    let mut found: Option<&Variable> = None;
    for variable in scope.description.variables.iter().filter(|v| v.causality == Causality::Independent) {
        if let Some(first) = found {
            report.error(
                variable.line,
                format!("`{}` and `{}` are both independent; only one variable can be", first.name, variable.name),
            );
        }
        if !variable.data_type.is_float() {
            report.error(variable.line, format!("the independent variable `{}` must be a float", variable.name));
        }
        if !variable.dimensions.is_empty() {
            report.error(variable.line, format!("the independent variable `{}` must be a scalar", variable.name));
        }
        found = Some(variable);
    }
    if found.is_none() && scope.is(FmiVersion::V3) {
        report.error(scope.lines.line(Part::Root, ""), "there is no independent variable; declare one, such as `time`");
    }
}

fn derivative(scope: &Scope<'_>, index: usize, variable: &Variable, report: &mut Report) {
    let Some(state) = variable.derivative else { return };
    let line = variable.line;
    let name = &variable.name;
    let Some(state_variable) = scope.variable(state) else {
        report.error(line, format!("`{name}` is the derivative of variable {state}, which does not exist"));
        return;
    };
    if state == index {
        report.error(line, format!("`{name}` is its own derivative"));
    }
    for variable in [variable, state_variable] {
        if !variable.data_type.is_float() || variable.variability != Variability::Continuous {
            report.error(
                line,
                format!(
                    "`{name}` is the derivative of `{}`, but `{}` is no continuous float",
                    state_variable.name, variable.name
                ),
            );
        }
    }
    if variable.dimensions != state_variable.dimensions {
        report.error(line, format!("`{name}` and `{}`, whose derivative it is, differ in size", state_variable.name));
    }
}

fn dimensions(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    if !variable.dimensions.is_empty()
        && (variable.data_type == DataType::Clock || variable.causality == Causality::StructuralParameter)
    {
        report.error(line, format!("`{name}` is a clock or a structural parameter and must be a scalar"));
    }
    for dimension in &variable.dimensions {
        match *dimension {
            Dimension::Fixed(0) => report.error(line, format!("`{name}` has a dimension of size 0")),
            Dimension::Fixed(_) => {}
            Dimension::Variable(reference) => match scope.by_reference(reference) {
                None => report.error(
                    line,
                    format!("a dimension of `{name}` has value reference {reference}, which no variable has"),
                ),
                Some(size) => {
                    let is_size = size.data_type == DataType::UInt64
                        && (size.causality == Causality::StructuralParameter
                            || size.variability == Variability::Constant);
                    if !is_size {
                        report.error(
                            line,
                            format!(
                                "a dimension of `{name}` is `{}`, which must be a structural parameter or a constant \
                                 of type UInt64",
                                size.name
                            ),
                        );
                    } else if initial_size(scope, reference) == Some(0) {
                        report.error(line, format!("`{name}` has the dimension `{}`, which starts at 0", size.name));
                    }
                }
            },
        }
    }
}
