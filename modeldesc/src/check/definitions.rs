//! Units and types.

use super::Scope;
use super::lines::Part;
use crate::problem::Report;
use crate::types::*;
use std::collections::HashSet;

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    units(scope, report);
    types(scope, report);
}

fn units(scope: &Scope<'_>, report: &mut Report) {
    let mut seen = HashSet::new();
    for unit in &scope.description.units {
        let name = &unit.name;
        let line = scope.lines.line(Part::Unit, name);
        if name.is_empty() {
            report.error(line, "a unit needs a name");
        } else if !seen.insert(name) {
            let line = scope.lines.last(Part::Unit, name);
            report.error(line, format!("the unit `{name}` is there twice; remove one of them"));
        }
        if let Some(base) = &unit.base
            && !is_conversion(base.factor, base.offset)
        {
            report.error(line, format!("the unit `{name}` cannot be converted; its factor must not be 0"));
        }
        let mut displays = HashSet::new();
        for display in &unit.display_units {
            if !displays.insert(&display.name) {
                report.error(line, format!("the unit `{name}` has the display unit `{}` twice", display.name));
            }
            if !is_conversion(display.factor, display.offset) {
                report.error(
                    line,
                    format!("the display unit `{}` cannot be converted; its factor must not be 0", display.name),
                );
            }
            if display.inverse && display.offset != 0.0 {
                report.error(line, format!("the display unit `{}` is inverse and has an offset", display.name));
            }
        }
    }
}

fn is_conversion(factor: f64, offset: f64) -> bool {
    factor != 0.0 && factor.is_finite() && offset.is_finite()
}

fn types(scope: &Scope<'_>, report: &mut Report) {
    let variables: HashSet<&str> = scope.description.variables.iter().map(|v| v.name.as_str()).collect();
    let mut seen = HashSet::new();
    for definition in &scope.description.type_definitions {
        let name = &definition.name;
        let line = scope.lines.line(Part::Type, name);
        if name.is_empty() {
            report.error(line, "a type needs a name");
        } else if !seen.insert(name) {
            let line = scope.lines.last(Part::Type, name);
            report.error(line, format!("the type `{name}` is there twice; remove one of them"));
        }
        if variables.contains(name.as_str()) {
            report.error(line, format!("the type `{name}` has the name of a variable; rename one of them"));
        }
        attributes(scope, &definition.attributes, &format!("type `{name}`"), line, report);
        if definition.data_type == DataType::Enumeration {
            items(definition, line, report);
        }
    }
}

/// Names and values of items correspond one to one.
fn items(definition: &TypeDefinition, line: usize, report: &mut Report) {
    let name = &definition.name;
    if definition.items.is_empty() {
        report.error(line, format!("the enumeration `{name}` has no items; give it at least one"));
    }
    let (mut names, mut values) = (HashSet::new(), HashSet::new());
    for item in &definition.items {
        if !names.insert(&item.name) {
            report.error(line, format!("the enumeration `{name}` has the item `{}` twice", item.name));
        }
        if !values.insert(item.value) {
            report.error(
                line,
                format!("the item `{}` of the enumeration `{name}` has the value {} of another", item.name, item.value),
            );
        }
    }
}

/// Unit, display unit, bounds and nominal value, of a type or a variable.
pub(super) fn attributes(scope: &Scope<'_>, attributes: &Attributes, owner: &str, line: usize, report: &mut Report) {
    let unit = attributes.unit.as_deref().map(|name| {
        let unit = scope.unit(name);
        if unit.is_none() {
            report.error(line, format!("{owner} has the unit `{name}`, which is not defined in UnitDefinitions"));
        }
        unit
    });
    if let Some(display) = &attributes.display_unit {
        display_unit(unit, display, owner, line, report);
    }
    if let (Some(min), Some(max)) = (attributes.min, attributes.max)
        && min > max
    {
        report.error(line, format!("{owner} has min {min} above max {max}"));
    }
    if attributes.min.is_some_and(f64::is_nan) || attributes.max.is_some_and(f64::is_nan) {
        report.error(line, format!("{owner} has a bound that is not a number"));
    }
    if let Some(nominal) = attributes.nominal
        && !(nominal > 0.0 && nominal.is_finite())
    {
        let message = format!("{owner} has the nominal value {nominal}, which must be positive");
        // FMI 3.0 says so only of what the FMU returns at run time.
        match scope.description.fmi_version {
            FmiVersion::V2 => report.error(line, message),
            FmiVersion::V3 => report.warning(line, message),
        }
    }
}

/// A display unit needs a unit that defines it. A unit that is not defined itself has been reported.
pub(super) fn display_unit(unit: Option<Option<&Unit>>, display: &str, owner: &str, line: usize, report: &mut Report) {
    match unit {
        None => report.error(line, format!("{owner} has the display unit `{display}` but no unit")),
        Some(Some(unit)) if unit.display_units.iter().all(|known| known.name != display) => report.error(
            line,
            format!("{owner} has the display unit `{display}`, which its unit `{}` does not define", unit.name),
        ),
        _ => {}
    }
}
