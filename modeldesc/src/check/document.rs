//! The root, the interfaces, the log categories and the default experiment.

use super::Scope;
use super::lines::Part;
use crate::problem::Report;
use crate::types::*;
use std::collections::HashSet;

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    root(scope, report);
    interfaces(scope, report);
    log_categories(scope, report);
    if let Some(experiment) = &scope.description.default_experiment {
        default_experiment(scope, experiment, report);
    }
}

fn root(scope: &Scope<'_>, report: &mut Report) {
    let description = scope.description;
    let line = scope.lines.line(Part::Root, "");
    if description.model_name.is_empty() {
        report.error(line, "`modelName` is empty; name the model");
    }
    if description.instantiation_token.is_empty() {
        let key = if scope.is(FmiVersion::V2) { "guid" } else { "instantiationToken" };
        report.error(line, format!("`{key}` is empty; give the FMU a token that changes with its description"));
    }
    if let Some(text) = &description.generation_date_and_time
        && !is_date_time(text)
    {
        report.error(
            line,
            format!("`generationDateAndTime` is `{text}` but must be a date and time such as 2024-12-31T23:59:59Z"),
        );
    }
    if description.variables.is_empty() {
        report.error(line, "there are no variables; declare at least one");
    }
}

/// `xs:dateTime`.
fn is_date_time(text: &str) -> bool {
    let number = |text: &str, digits: usize, least: u32, greatest: u32| {
        text.len() == digits
            && text.bytes().all(|b| b.is_ascii_digit())
            && text.parse().is_ok_and(|n: u32| (least..=greatest).contains(&n))
    };
    let Some((date, time)) = text.split_once('T') else { return false };
    let mut date = date.trim_start_matches('-').splitn(3, '-');
    let (Some(year), Some(month), Some(day)) = (date.next(), date.next(), date.next()) else { return false };
    let (time, zone) = match time.find(['Z', '+', '-']) {
        Some(at) => time.split_at(at),
        None => (time, ""),
    };
    let zone_is_fine = matches!(zone, "" | "Z")
        || zone[1..]
            .split_once(':')
            .is_some_and(|(hours, minutes)| number(hours, 2, 0, 14) && number(minutes, 2, 0, 59))
            && !zone.starts_with('Z');
    let mut time = time.splitn(3, ':');
    let (Some(hour), Some(minute), Some(second)) = (time.next(), time.next(), time.next()) else { return false };
    let (second, fraction) = second.split_once('.').unwrap_or((second, "0"));
    year.len() >= 4
        && year.bytes().all(|b| b.is_ascii_digit())
        && number(month, 2, 1, 12)
        && number(day, 2, 1, 31)
        && number(hour, 2, 0, 24)
        && number(minute, 2, 0, 59)
        && number(second, 2, 0, 59)
        && !fraction.is_empty()
        && fraction.bytes().all(|b| b.is_ascii_digit())
        && zone_is_fine
}

fn interfaces(scope: &Scope<'_>, report: &mut Report) {
    let description = scope.description;
    let interfaces = [
        ("ModelExchange", &description.model_exchange),
        ("CoSimulation", &description.co_simulation),
        ("ScheduledExecution", &description.scheduled_execution),
    ];
    if interfaces.iter().all(|(_, interface)| interface.is_none()) {
        report.error(
            scope.lines.line(Part::Root, ""),
            "there is neither ModelExchange nor CoSimulation nor ScheduledExecution; offer at least one",
        );
    }
    let has_clocks = description.variables.iter().any(|variable| variable.data_type == DataType::Clock);
    for (name, interface) in interfaces {
        let Some(interface) = interface else { continue };
        let line = scope.lines.line(Part::Interface, name);
        let identifier = &interface.model_identifier;
        if !is_c_identifier(identifier) {
            report.error(
                line,
                format!("`modelIdentifier` of {name} is `{identifier}` but must be a C identifier: letters, digits, _"),
            );
        }
        if interface.can_serialize_fmu_state && !interface.can_get_and_set_fmu_state {
            report.error(line, format!("{name} can serialize a state but not get it; set canGetAndSetFMUState"));
        }
        if interface.can_return_early_after_intermediate_update && !interface.provides_intermediate_update {
            report.error(
                line,
                format!("{name} returns early after intermediate updates but has none; set providesIntermediateUpdate"),
            );
        }
        if let Some(size) = interface.fixed_internal_step_size
            && !(size > 0.0 && size.is_finite())
        {
            report.error(line, format!("`fixedInternalStepSize` of {name} is {size} but must be positive"));
        }
        if name == "CoSimulation" && has_clocks && !interface.has_event_mode {
            report.error(line, "there are clocks but CoSimulation has no event mode; set hasEventMode");
        }
    }
}

/// A name that a C compiler takes.
fn is_c_identifier(text: &str) -> bool {
    text.bytes().next().is_some_and(|b| b.is_ascii_alphabetic() || b == b'_')
        && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

fn log_categories(scope: &Scope<'_>, report: &mut Report) {
    let mut seen = HashSet::new();
    for category in &scope.description.log_categories {
        let line = scope.lines.last(Part::Category, &category.name);
        if category.name.is_empty() {
            report.error(line, "a log category needs a name");
        } else if !seen.insert(&category.name) {
            report.error(line, format!("the log category `{}` is there twice; remove one of them", category.name));
        }
    }
}

fn default_experiment(scope: &Scope<'_>, experiment: &DefaultExperiment, report: &mut Report) {
    let line = scope.lines.line(Part::Experiment, "");
    let start = experiment.start_time.unwrap_or(0.0);
    if !start.is_finite() {
        report.error(line, format!("`startTime` is {start} but must be finite"));
    }
    if let Some(stop) = experiment.stop_time {
        if !stop.is_finite() {
            report.error(line, format!("`stopTime` is {stop} but must be finite"));
        } else if stop <= start {
            report.error(line, format!("`stopTime` is {stop} but must be after the start at {start}"));
        }
    }
    if let Some(tolerance) = experiment.tolerance
        && !(tolerance > 0.0 && tolerance.is_finite())
    {
        report.error(line, format!("`tolerance` is {tolerance} but must be positive"));
    }
    if let Some(step) = experiment.step_size {
        if !(step > 0.0 && step.is_finite()) {
            report.error(line, format!("`stepSize` is {step} but must be positive"));
        } else if experiment.stop_time.is_some_and(|stop| stop > start && step > stop - start) {
            report.error(line, format!("`stepSize` is {step}, longer than the whole experiment"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_xml_schema() {
        for good in ["2024-02-29T12:00:00Z", "2024-12-31T23:59:59.125+01:00", "2024-01-01T00:00:00"] {
            assert!(is_date_time(good), "{good}");
        }
        for bad in [
            "",
            "2024-01-01",
            "2024-13-01T00:00:00Z",
            "2024-01-01 00:00:00",
            "2024-01-01T00:00:60Z",
            "2024-01-01T00:00:00.Z",
            "24-01-01T00:00:00Z",
            "2024-01-01T00:00:00Zulu",
            "2024-01-01T0:00:00Z",
            "2024-01-01T00:00:00+1",
            "T",
            "2024-01-01T00:00:00ä",
        ] {
            assert!(!is_date_time(bad), "{bad}");
        }
    }

    #[test]
    fn identifiers_are_those_of_c() {
        assert!(is_c_identifier("_a1"));
        for bad in ["", "1a", "a-b", "ä", "a b"] {
            assert!(!is_c_identifier(bad), "{bad}");
        }
    }
}
