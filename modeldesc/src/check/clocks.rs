//! Clocks and what belongs to them (FMI 3.0.2 sections 2.2.8 and 2.4.7).

use super::Scope;
use super::lines::Part;
use crate::problem::Report;
use crate::types::*;
use std::collections::HashSet;

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    let description = scope.description;
    for definition in &description.type_definitions {
        if let Some(clock) = &definition.clock {
            let line = scope.lines.line(Part::Type, &definition.name);
            times(clock, &format!("the clock type `{}`", definition.name), line, report);
        }
    }
    let mut befores = HashSet::new();
    for (index, variable) in description.variables.iter().enumerate() {
        if variable.data_type == DataType::Clock {
            clock(scope, variable, report);
        }
        clocked(scope, variable, report);
        previous(scope, index, variable, report);
        if let Some(previous) = variable.previous
            && !befores.insert(previous)
        {
            report.error(
                variable.line,
                format!("the previous value of `{}` is also that of another variable", variable.name),
            );
        }
    }
    let can_activate =
        |variable: &Variable| variable.data_type == DataType::Clock && variable.causality == Causality::Input;
    if description.scheduled_execution.is_some() && !description.variables.iter().any(can_activate) {
        report.warning(
            scope.lines.line(Part::Interface, "ScheduledExecution"),
            "there is no input clock, so that ScheduledExecution has nothing to activate",
        );
    }
}

fn clock(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    if variable.start.is_some() {
        report.error(line, format!("the clock `{name}` must not have a start value; remove it"));
    }
    // Without an interval it can be neither written nor read without a problem.
    let Some(clock) = scope.clock(variable) else { return };
    let owner = format!("the clock `{name}`");
    if scope.declared_type(variable).and_then(|definition| definition.clock) != Some(clock) {
        times(&clock, &owner, line, report);
    }
    needed_times(&clock, &owner, line, report);
    let input = variable.causality == Causality::Input;
    if !input && clock.interval_variability != IntervalVariability::Triggered {
        report.error(
            line,
            format!(
                "{owner} is no input and must have intervalVariability=triggered, not {}",
                clock.interval_variability.as_str()
            ),
        );
    }
    if !input && clock.can_be_deactivated {
        report.warning(line, format!("{owner} is no input; nobody can deactivate it"));
    }
    priority(scope, variable, &clock, report);
}

fn priority(scope: &Scope<'_>, variable: &Variable, clock: &Clock, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    let scheduled = scope.description.scheduled_execution.is_some();
    match (scheduled, variable.causality, clock.priority) {
        (true, Causality::Input, None) => {
            report.error(line, format!("the input clock `{name}` needs a `priority` for ScheduledExecution"));
        }
        (true, Causality::Local, _) => {
            report.error(line, format!("the clock `{name}` is local, which ScheduledExecution does not allow"));
        }
        // The standard demands one of every clock, the checkers forbid it here; there is nothing to order.
        (true, Causality::Output, Some(_)) => report.warning(
            line,
            format!("the output clock `{name}` has a `priority`, which some importers refuse; remove it"),
        ),
        (false, _, Some(_)) => report.warning(
            line,
            format!("the clock `{name}` has a `priority`, which only ScheduledExecution heeds; remove it"),
        ),
        _ => {}
    }
}

/// Times that are given: positive, and only where a clock is periodic.
fn times(clock: &Clock, owner: &str, line: usize, report: &mut Report) {
    let variability = clock.interval_variability;
    let given = [
        ("intervalDecimal", clock.interval_decimal.is_some()),
        ("shiftDecimal", clock.shift_decimal.is_some()),
        ("resolution", clock.resolution.is_some()),
        ("intervalCounter", clock.interval_counter.is_some()),
        ("shiftCounter", clock.shift_counter.is_some()),
    ];
    for (key, _) in given.into_iter().filter(|(_, given)| *given && !variability.is_periodic()) {
        report.error(
            line,
            format!("{owner} has `{key}` but is {} and ticks at no fixed distance; remove it", variability.as_str()),
        );
    }
    if let Some(interval) = clock.interval_decimal
        && !(interval > 0.0 && interval.is_finite())
    {
        report.error(line, format!("`intervalDecimal` of {owner} is {interval} but must be positive"));
    }
    if let Some(shift) = clock.shift_decimal
        && !(shift >= 0.0 && shift.is_finite())
    {
        report.error(line, format!("`shiftDecimal` of {owner} is {shift} but must not be negative"));
    }
    for (key, value) in [("resolution", clock.resolution), ("intervalCounter", clock.interval_counter)] {
        if value == Some(0) {
            report.error(line, format!("`{key}` of {owner} is 0 but must be positive"));
        }
    }
}

/// Times that must be given, and that must go together, in a periodic clock.
fn needed_times(clock: &Clock, owner: &str, line: usize, report: &mut Report) {
    let variability = clock.interval_variability;
    if !variability.is_periodic() {
        return;
    }
    let constant = variability == IntervalVariability::Constant;
    if constant && clock.interval_decimal.is_none() {
        report.error(line, format!("{owner} is constant and needs `intervalDecimal`"));
    }
    let counters = clock.interval_counter.is_some() || clock.shift_counter.is_some();
    if !clock.supports_fraction {
        if counters {
            report.error(line, format!("{owner} has counters; set `supportsFraction` or remove them"));
        }
        return;
    }
    // Whoever says its interval as a number says it as a fraction as well; only a tunable one need not.
    let said = clock.interval_decimal.is_some() && variability == IntervalVariability::Fixed;
    if clock.interval_counter.is_none() {
        if constant || said {
            report.error(line, format!("{owner} supports fractions and needs `intervalCounter`"));
        } else if clock.shift_counter.is_some() {
            report.warning(line, format!("{owner} has `shiftCounter` without `intervalCounter`"));
        }
    }
    let Some(resolution) = clock.resolution else {
        if counters {
            report.error(line, format!("{owner} has counters and needs `resolution`"));
        }
        return;
    };
    let pairs = [
        ("interval", clock.interval_decimal, clock.interval_counter),
        ("shift", clock.shift_decimal, clock.shift_counter),
    ];
    for (what, decimal, counter) in pairs {
        let (Some(decimal), Some(counter)) = (decimal, counter) else { continue };
        let fraction = counter as f64 / resolution as f64;
        // The standard's schema keeps the decimal in 32 bits.
        if (fraction - decimal).abs() > f64::from(f32::EPSILON) * decimal.abs() {
            report.error(
                line,
                format!("the {what} of {owner} is {decimal} but also {counter}/{resolution}; make them equal"),
            );
        }
    }
}

/// The clocks of a variable.
fn clocked(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    let mut seen = HashSet::new();
    for reference in &variable.clocks {
        if !seen.insert(reference) {
            report.error(line, format!("`{name}` has the clock with value reference {reference} twice"));
        }
        match scope.by_reference(*reference).filter(|clock| clock.data_type == DataType::Clock) {
            None => {
                report
                    .error(line, format!("`{name}` has the clock with value reference {reference}, which is no clock"));
            }
            Some(_) if *reference == variable.value_reference => {
                report.error(line, format!("the clock `{name}` is its own clock"));
            }
            Some(clock) if clock.causality == Causality::Local && variable.causality != Causality::Local => {
                report.error(line, format!("`{name}` has the local clock `{}` but is not local itself", clock.name));
            }
            Some(_) => {}
        }
    }
    if !variable.clocks.is_empty() && !matches!(variable.variability, Variability::Discrete | Variability::Tunable) {
        report.error(line, format!("`{name}` has clocks and must be discrete or tunable"));
    }
}

/// The value of a clocked state before its clock ticks.
fn previous(scope: &Scope<'_>, index: usize, variable: &Variable, report: &mut Report) {
    let Some(previous) = variable.previous else { return };
    let line = variable.line;
    let name = &variable.name;
    let is_clock = variable.data_type == DataType::Clock;
    if is_clock || variable.clocks.is_empty() || variable.variability != Variability::Discrete {
        report.error(line, format!("`{name}` has a previous value and must be discrete, have clocks and be none"));
    }
    if scope.description.structure.clocked_states.iter().all(|state| state.variable != index) {
        report.error(
            line,
            format!("`{name}` has a previous value and is missing among the clocked states of ModelStructure"),
        );
    }
    match scope.variable(previous) {
        None => report.error(line, format!("the previous value of `{name}` does not exist")),
        Some(_) if previous == index => report.error(line, format!("`{name}` is its own previous value")),
        Some(before) => {
            let fits = before.data_type == variable.data_type
                && before.variability == Variability::Discrete
                && before.causality != Causality::Input;
            if !fits {
                report.error(
                    line,
                    format!(
                        "`{}`, the previous value of `{name}`, must be of its type, discrete and no input",
                        before.name
                    ),
                );
            }
        }
    }
}
