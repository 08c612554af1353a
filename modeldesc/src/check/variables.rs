//! Each variable for itself: causality, variability, initial, type.

use super::{Scope, definitions};
use crate::problem::Report;
use crate::types::*;

pub(super) fn check(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    combination(scope, variable, report);
    declared_type(scope, variable, report);
    let owner = format!("`{}`", variable.name);
    // Inherited units and bounds are checked together with the variable's own, which may contradict them.
    definitions::attributes(scope, &scope.attributes(variable), &owner, variable.line, report);
    for alias in &variable.aliases {
        if let Some(display) = &alias.display_unit {
            let unit = scope.attributes(variable).unit.map(|name| scope.unit(&name));
            definitions::display_unit(unit, display, &format!("`{}`", alias.name), variable.line, report);
        }
    }
    if !variable.can_handle_multiple_set_per_time_instant && variable.causality != Causality::Input {
        report.error(
            variable.line,
            format!("{owner} is no input and must not have `canHandleMultipleSetPerTimeInstant`"),
        );
    }
    if variable.intermediate_update
        && (variable.data_type == DataType::Clock
            || matches!(variable.causality, Causality::Parameter | Causality::StructuralParameter))
    {
        report
            .error(variable.line, format!("{owner} is a clock or a parameter and must not have `intermediateUpdate`"));
    }
}

/// The tables of causality, variability and initial (FMI 2.0.5 section 2.2.7, FMI 3.0.2 section 2.4.7.4).
fn combination(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let (causality, variability) = (variable.causality, variable.variability);
    let line = variable.line;
    let name = &variable.name;
    if causality == Causality::StructuralParameter && scope.is(FmiVersion::V2) {
        report.error(line, format!("`{name}` is a structural parameter, which FMI 2.0 does not know"));
        return;
    }
    if variable.data_type == DataType::Clock {
        let causality_fits = matches!(causality, Causality::Input | Causality::Output | Causality::Local);
        if !causality_fits || !matches!(variability, Variability::Discrete | Variability::Tunable) {
            report.error(
                line,
                format!("the clock `{name}` must be a discrete or tunable input, output or local variable"),
            );
        }
        return;
    }
    let continuous = variability == Variability::Continuous;
    if continuous && !variable.data_type.is_float() {
        report.error(
            line,
            format!("`{name}` is a {} and cannot be continuous; make it discrete", type_name(scope, variable)),
        );
    }
    let allowed = Initial::allowed_for(causality, variability);
    if allowed.is_empty() && !(causality == Causality::Independent && continuous) {
        report.error(
            line,
            format!(
                "`{name}` cannot be both causality={} and variability={}",
                causality.as_str(),
                variability.as_str()
            ),
        );
        return;
    }
    match variable.initial {
        Some(initial) if !allowed.contains(&initial) => {
            let allowed: Vec<&str> = allowed.iter().map(|initial| initial.as_str()).collect();
            let allowed = if allowed.is_empty() {
                "no `initial`".to_owned()
            } else {
                format!("initial={}", allowed.join(" or "))
            };
            report.error(
                line,
                format!(
                    "`{name}` has initial={} but as {} {} must have {allowed}",
                    initial.as_str(),
                    variability.as_str(),
                    causality.as_str()
                ),
            );
        }
        None if !allowed.is_empty() => {
            report.error(line, format!("`{name}` has no `initial`, not even the standard's default"));
        }
        _ => {}
    }
}

/// What the version calls the type.
fn type_name(scope: &Scope<'_>, variable: &Variable) -> &'static str {
    match variable.data_type {
        DataType::Int32 if scope.is(FmiVersion::V2) => "Integer",
        other => other.as_str(),
    }
}

fn declared_type(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let name = &variable.name;
    let Some(declared) = &variable.declared_type else {
        if variable.data_type == DataType::Enumeration {
            report.error(variable.line, format!("the enumeration `{name}` needs a `declaredType` with its items"));
        }
        return;
    };
    match scope.declared_type(variable) {
        None => report.error(
            variable.line,
            format!("`{name}` has the type `{declared}`, which is not defined in TypeDefinitions"),
        ),
        Some(definition) if definition.data_type != variable.data_type => report.error(
            variable.line,
            format!(
                "`{name}` is a {} but its type `{declared}` is for {}",
                variable.data_type.as_str(),
                definition.data_type.as_str()
            ),
        ),
        Some(_) => {}
    }
}
