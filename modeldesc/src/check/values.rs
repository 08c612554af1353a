//! Start values: there when they must be, absent when they must not be, as many as the variable has elements, in range.

use super::Scope;
use crate::problem::Report;
use crate::types::*;

pub(super) fn check(scope: &Scope<'_>, variable: &Variable, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    if variable.data_type == DataType::Clock {
        return;
    }
    let forbidden = variable.causality == Causality::Independent || variable.initial == Some(Initial::Calculated);
    let required = matches!(variable.initial, Some(Initial::Exact | Initial::Approx))
        || matches!(variable.causality, Causality::Input | Causality::Parameter | Causality::StructuralParameter)
        || variable.variability == Variability::Constant;
    let Some(start) = &variable.start else {
        if required && !forbidden {
            report.error(line, format!("`{name}` needs a start value"));
        }
        return;
    };
    if forbidden {
        let why = if variable.causality == Causality::Independent { "independent" } else { "initial=calculated" };
        report.error(line, format!("`{name}` is {why} and must not have a start value; remove it"));
        return;
    }
    if !is_of_type(start, variable.data_type) {
        report.error(line, format!("the start value of `{name}` is not a {}", variable.data_type.as_str()));
        return;
    }
    count(scope, variable, start, report);
    range(scope, variable, start, report);
}

fn is_of_type(start: &Start, data_type: DataType) -> bool {
    match start {
        Start::Float(_) => data_type.is_float(),
        Start::Integer(_) => data_type.integer_range(FmiVersion::V3).is_some(),
        Start::Boolean(_) => data_type == DataType::Boolean,
        Start::String(_) => data_type == DataType::String,
        Start::Binary(_) => data_type == DataType::Binary,
    }
}

/// How many values there are.
fn length(start: &Start) -> usize {
    match start {
        Start::Float(values) => values.len(),
        Start::Integer(values) => values.len(),
        Start::Boolean(values) => values.len(),
        Start::String(values) => values.len(),
        Start::Binary(values) => values.len(),
    }
}

/// One value, or one for each element. A size that is not known has been reported elsewhere.
fn count(scope: &Scope<'_>, variable: &Variable, start: &Start, report: &mut Report) {
    let elements = variable.dimensions.iter().try_fold(1_u64, |product, dimension| {
        let size = match dimension {
            Dimension::Fixed(size) => *size,
            Dimension::Variable(reference) => initial_size(scope, *reference)?,
        };
        product.checked_mul(size)
    });
    let values = length(start);
    let Some(elements) = elements else { return };
    if values != 1 && u64::try_from(values).ok() != Some(elements) {
        report.error(
            variable.line,
            format!("`{}` has {elements} elements but {values} start values; give one for each, or one", variable.name),
        );
    }
}

/// The start value of what holds the size of a dimension.
pub(super) fn initial_size(scope: &Scope<'_>, reference: u32) -> Option<u64> {
    match &scope.by_reference(reference)?.start {
        Some(Start::Integer(values)) => u64::try_from(*values.first()?).ok(),
        _ => None,
    }
}

fn range(scope: &Scope<'_>, variable: &Variable, start: &Start, report: &mut Report) {
    let line = variable.line;
    let name = &variable.name;
    let attributes = scope.attributes(variable);
    let (min, max) = (attributes.min.unwrap_or(f64::NEG_INFINITY), attributes.max.unwrap_or(f64::INFINITY));
    let outside = |value: f64| value < min || value > max;
    match start {
        Start::Float(values) => {
            if let Some(value) = values.iter().find(|value| outside(**value)) {
                report.error(line, format!("`{name}` starts at {value}, outside of its range from {min} to {max}"));
            }
            if values.iter().any(|value| !value.is_finite()) {
                report.warning(line, format!("`{name}` starts at a value that is not a finite number"));
            }
        }
        Start::Integer(values) => {
            if let Some(value) = values.iter().find(|value| outside(**value as f64)) {
                report.error(line, format!("`{name}` starts at {value}, outside of its range from {min} to {max}"));
            }
            if let Some((least, greatest)) = variable.data_type.integer_range(scope.description.fmi_version)
                && let Some(value) = values.iter().find(|value| !(least..=greatest).contains(*value))
            {
                report.error(
                    line,
                    format!("`{name}` starts at {value}, which a {} cannot hold", variable.data_type.as_str()),
                );
            }
            if let Some(definition) = scope.declared_type(variable)
                && definition.data_type == DataType::Enumeration
                && let Some(value) =
                    values.iter().find(|value| definition.items.iter().all(|item| i128::from(item.value) != **value))
            {
                report.error(line, format!("`{name}` starts at {value}, which is no item of `{}`", definition.name));
            }
        }
        Start::Boolean(_) | Start::String(_) | Start::Binary(_) => {}
    }
}
