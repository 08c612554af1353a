//! Checking a model description: everything that the standard demands beyond the form of the document.
//!
//! The rules are those of FMI 2.0.5 section 2.2 and FMI 3.0.2 section 2.4 together with what established checkers make
//! of them. Where the standard leaves room, or where importers merely stumble, the problem is a warning.

mod clocks;
mod definitions;
mod document;
mod lines;
mod names;
mod references;
mod structure;
mod values;
mod variables;

use crate::problem::{Problem, ReadError, Report};
use crate::types::*;
use crate::xml_in;
use lines::Lines;
use std::collections::HashMap;

/// All problems of a description, in the order of its lines as far as it knows them: variables and the entries of the
/// model structure do, and [`read_and_check`] also knows the rest.
pub fn check(description: &ModelDescription) -> Vec<Problem> {
    let mut report = Report::default();
    check_with(description, &Lines::default(), &mut report);
    report.into_problems()
}

/// Reads a model description from the bytes of its file and checks it: the problems of form and of meaning together, in
/// the order of the lines.
///
/// # Errors
///
/// As of [`read_bytes`](crate::read::read_bytes).
pub fn read_and_check(bytes: &[u8]) -> Result<(ModelDescription, Vec<Problem>), ReadError> {
    let text = xml_in::decode(bytes)?;
    let (description, problems) = crate::read::read(&text)?;
    let lines = Lines::of(&xml_in::parse(&text, &mut Report::default())?);
    let mut report = Report::from(problems);
    check_with(&description, &lines, &mut report);
    Ok((description, report.into_problems()))
}

fn check_with(description: &ModelDescription, lines: &Lines, report: &mut Report) {
    let scope = &Scope::new(description, lines);
    document::check(scope, report);
    definitions::check(scope, report);
    names::check(scope, report);
    for variable in &description.variables {
        variables::check(scope, variable, report);
        values::check(scope, variable, report);
    }
    references::check(scope, report);
    clocks::check(scope, report);
    structure::check(scope, report);
}

/// What is checked, and where its parts stand.
struct Scope<'a> {
    description: &'a ModelDescription,
    lines: &'a Lines,
    references: HashMap<u32, &'a Variable>,
    types: HashMap<&'a str, &'a TypeDefinition>,
    units: HashMap<&'a str, &'a Unit>,
}

impl<'a> Scope<'a> {
    fn new(description: &'a ModelDescription, lines: &'a Lines) -> Self {
        let mut references = HashMap::with_capacity(description.variables.len());
        for variable in &description.variables {
            references.entry(variable.value_reference).or_insert(variable);
        }
        let types = description.type_definitions.iter().map(|t| (t.name.as_str(), t)).collect();
        let units = description.units.iter().map(|u| (u.name.as_str(), u)).collect();
        Self { description, lines, references, types, units }
    }

    fn is(&self, version: FmiVersion) -> bool {
        self.description.fmi_version == version
    }

    /// A variable by its index.
    fn variable(&self, index: usize) -> Option<&'a Variable> {
        self.description.variables.get(index)
    }

    /// A variable by its value reference.
    fn by_reference(&self, reference: u32) -> Option<&'a Variable> {
        self.references.get(&reference).copied()
    }

    /// A unit by its name.
    fn unit(&self, name: &str) -> Option<&'a Unit> {
        self.units.get(name).copied()
    }

    /// The type that a variable declares.
    fn declared_type(&self, variable: &Variable) -> Option<&'a TypeDefinition> {
        self.types.get(variable.declared_type.as_deref()?).copied()
    }

    /// What a clock says of its ticks: itself where it does, else its type.
    fn clock(&self, variable: &Variable) -> Option<Clock> {
        let declared = self.declared_type(variable).and_then(|definition| definition.clock);
        let (Some(own), Some(declared)) = (variable.clock, declared) else { return variable.clock.or(declared) };
        Some(Clock {
            interval_variability: own.interval_variability,
            can_be_deactivated: own.can_be_deactivated || declared.can_be_deactivated,
            priority: own.priority.or(declared.priority),
            interval_decimal: own.interval_decimal.or(declared.interval_decimal),
            shift_decimal: own.shift_decimal.or(declared.shift_decimal),
            supports_fraction: own.supports_fraction || declared.supports_fraction,
            resolution: own.resolution.or(declared.resolution),
            interval_counter: own.interval_counter.or(declared.interval_counter),
            shift_counter: own.shift_counter.or(declared.shift_counter),
        })
    }

    /// A variable's own attributes where it has them, else those of its type.
    fn attributes(&self, variable: &Variable) -> Attributes {
        let own = &variable.attributes;
        let Some(declared) = self.declared_type(variable).map(|definition| &definition.attributes) else {
            return own.clone();
        };
        Attributes {
            quantity: own.quantity.clone().or_else(|| declared.quantity.clone()),
            unit: own.unit.clone().or_else(|| declared.unit.clone()),
            display_unit: own.display_unit.clone().or_else(|| declared.display_unit.clone()),
            relative_quantity: own.relative_quantity || declared.relative_quantity,
            unbounded: own.unbounded || declared.unbounded,
            min: own.min.or(declared.min),
            max: own.max.or(declared.max),
            nominal: own.nominal.or(declared.nominal),
        }
    }
}
