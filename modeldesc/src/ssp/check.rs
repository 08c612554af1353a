//! What a system description must fulfil beyond its form.

use super::source::source_path;
use super::types::*;
use crate::problem::{Problem, Report};
use std::collections::{HashMap, HashSet};

/// All problems of a system description in the order of its lines: names that are not unique, connections whose ends do
/// not exist or do not go together, inputs with several sources, units and enumerations that are not defined, sources
/// that are no files (SSP 2.0, sections 4 and 5). What stands in other files is not looked at.
pub fn check(description: &SystemStructureDescription) -> Vec<Problem> {
    let mut report = Report::default();
    let mut checker = Checker {
        units: description.units.iter().map(|unit| unit.name.as_str()).collect(),
        enumerations: description.enumerations.iter().map(|e| e.name.as_str()).collect(),
        report: &mut report,
    };
    checker.definitions(&description.units, &description.enumerations);
    checker.system(&description.system);
    if let Some(experiment) = &description.default_experiment
        && let (Some(start), Some(stop)) = (experiment.start_time, experiment.stop_time)
        && stop < start
    {
        report.error(0, format!("the default experiment stops at {stop} s, before it starts at {start} s"));
    }
    report.into_problems()
}

struct Checker<'a> {
    units: HashSet<&'a str>,
    enumerations: HashSet<&'a str>,
    report: &'a mut Report,
}

impl Checker<'_> {
    fn definitions(&mut self, units: &[Unit], enumerations: &[Enumeration]) {
        self.unique("unit", units.iter().map(|unit| (unit.name.as_str(), unit.line)));
        self.unique("enumeration", enumerations.iter().map(|e| (e.name.as_str(), 0)));
        for enumeration in enumerations {
            let what = format!("item of `{}`", enumeration.name);
            self.unique(&what, enumeration.items.iter().map(|item| (item.name.as_str(), 0)));
        }
    }

    /// Reports every name that stands twice, in the line of the second.
    fn unique<'n>(&mut self, what: &str, names: impl Iterator<Item = (&'n str, usize)>) {
        let mut seen = HashSet::new();
        for (name, line) in names {
            if !seen.insert(name) {
                self.report.error(line, format!("the {what} `{name}` is there twice; rename one of them"));
            }
        }
    }

    fn system(&mut self, system: &System) {
        self.unique("element", system.elements.iter().map(|element| (element.name(), element.line())));
        self.connectors(&system.connectors);
        self.bindings(&system.parameter_bindings);
        for element in &system.elements {
            if element.name().is_empty() {
                self.report.error(element.line(), "an element needs a name that is not empty");
            }
            match element {
                Element::System(inner) => self.system(inner),
                Element::Component(component) => {
                    self.connectors(&component.connectors);
                    self.bindings(&component.parameter_bindings);
                    if let Err(error) = source_path(&component.source) {
                        self.report.error(component.line, format!("component `{}`: {error}", component.name));
                    }
                }
            }
        }
        self.connections(system);
    }

    fn connectors(&mut self, connectors: &[Connector]) {
        self.unique("connector", connectors.iter().map(|connector| (connector.name.as_str(), connector.line)));
        for connector in connectors {
            let Some(connector_type) = &connector.connector_type else { continue };
            if let Some(unit) = connector_type.unit.as_deref().filter(|unit| !self.units.contains(unit)) {
                self.report.error(
                    connector.line,
                    format!("the unit `{unit}` of the connector `{}` is not defined; add it to Units", connector.name),
                );
            }
            if let Some(name) = connector_type.enumeration.as_deref().filter(|name| !self.enumerations.contains(name)) {
                self.report.error(
                    connector.line,
                    format!(
                        "the enumeration `{name}` of the connector `{}` is not defined; add it to Enumerations",
                        connector.name
                    ),
                );
            }
        }
    }

    fn bindings(&mut self, bindings: &[ParameterBinding]) {
        for binding in bindings {
            match &binding.values {
                Source::Inline(set) => self.parameter_set(set),
                Source::File { source, .. } => {
                    if let Err(error) = source_path(source) {
                        self.report.error(binding.line, format!("parameter binding: {error}"));
                    }
                }
            }
            if let Some(Source::File { source, .. }) = &binding.mapping
                && let Err(error) = source_path(source)
            {
                self.report.error(binding.line, format!("parameter mapping: {error}"));
            }
        }
    }

    /// The units and enumerations of a set are its own.
    fn parameter_set(&mut self, set: &ParameterSet) {
        let mut inner = Checker {
            units: set.units.iter().map(|unit| unit.name.as_str()).collect(),
            enumerations: set.enumerations.iter().map(|e| e.name.as_str()).collect(),
            report: self.report,
        };
        inner.definitions(&set.units, &set.enumerations);
        inner.unique("parameter", set.parameters.iter().map(|p| (p.name.as_str(), p.line)));
        for parameter in &set.parameters {
            if let Some(unit) = parameter.unit.as_deref().filter(|unit| !inner.units.contains(unit)) {
                inner.report.error(
                    parameter.line,
                    format!(
                        "the unit `{unit}` of the parameter `{}` is not defined; add it to the set's Units",
                        parameter.name
                    ),
                );
            }
            if let Some(name) = parameter.enumeration.as_deref().filter(|name| !inner.enumerations.contains(name)) {
                inner.report.error(
                    parameter.line,
                    format!(
                        "the enumeration `{name}` of the parameter `{}` is not defined; add it to the set's Enumerations",
                        parameter.name
                    ),
                );
            }
        }
    }

    fn connections(&mut self, system: &System) {
        let mut sources: HashMap<(Option<&str>, &str, &[u64]), usize> = HashMap::new();
        for connection in &system.connections {
            let flow = match system.flow(connection) {
                Ok(flow) => flow,
                Err(error) => {
                    let place = format!("connection from `{}` to `{}`", connection.start, connection.end);
                    self.report.error(connection.line, format!("{place}: {error}"));
                    continue;
                }
            };
            let to = flow.to;
            let key = (to.element.as_deref(), to.connector.as_str(), to.indices.as_slice());
            if let Some(first) = sources.insert(key, connection.line) {
                self.report.error(
                    connection.line,
                    format!("`{to}` already has a source, in line {first}; remove one of the connections"),
                );
            }
        }
    }
}
