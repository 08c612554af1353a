//! Writing a `modelDescription.xml`.
//!
//! The same description always gives the same bytes. What the version it is written for cannot say is an error, never
//! left out: a description that was written is the description that will be read.

mod error;
mod fmi2;
mod fmi3;

pub use error::WriteError;

use crate::types::*;
use crate::xml_out::{Document, Element, float, join};

/// Writes a description as `modelDescription.xml` of its version: FMI 2.0 (standard 2.0.5, section 2.2) or FMI 3.0
/// (standard 3.0.2, section 2.4).
///
/// Capability flags that the version does not know are not written. In FMI 2.0 a model has only a number of event
/// indicators, so [`ModelStructure::event_indicators`] is not written there; `initial` is not written where the
/// standard leaves no choice (inputs and the independent variable).
///
/// # Errors
///
/// [`WriteError`] when the description holds what its version cannot say (in FMI 2.0: arrays, aliases, types other than
/// Float64, Int32, Boolean, String and Enumeration, …), an index beyond the variables, a start value of another type
/// than its variable, or a character which XML cannot hold.
pub fn write(description: &ModelDescription) -> Result<String, WriteError> {
    if description.variables.is_empty() {
        return Err(WriteError::NoVariables);
    }
    let mut document = Document::new();
    match description.fmi_version {
        FmiVersion::V2 => fmi2::write(&mut document, description)?,
        FmiVersion::V3 => fmi3::write(&mut document, description)?,
    }
    Ok(document.finish()?)
}

/// The attributes of the root that both versions share, in the standard's order.
fn root(description: &ModelDescription, version: &str, token: &str) -> Element {
    Element::new("fmiModelDescription")
        .text("fmiVersion", version)
        .text("modelName", &description.model_name)
        .text(token, &description.instantiation_token)
        .maybe("description", description.description.as_deref())
        .maybe("author", description.author.as_deref())
        .maybe("version", description.version.as_deref())
        .maybe("copyright", description.copyright.as_deref())
        .maybe("license", description.license.as_deref())
        .maybe("generationTool", description.generation_tool.as_deref())
        .maybe("generationDateAndTime", description.generation_date_and_time.as_deref())
        .maybe(
            "variableNamingConvention",
            match description.variable_naming_convention {
                NamingConvention::Flat => None,
                NamingConvention::Structured => Some("structured"),
            },
        )
}

fn units(document: &mut Document, units: &[Unit]) {
    document.list("UnitDefinitions", units, |document, unit| {
        let element = Element::new("Unit").text("name", &unit.name);
        if unit.base.is_none() && unit.display_units.is_empty() {
            return document.empty(element);
        }
        document.open(element);
        if let Some(base) = &unit.base {
            document.empty(base_unit("BaseUnit", base));
        }
        for display in &unit.display_units {
            let element = Element::new("DisplayUnit").text("name", &display.name);
            document.empty(conversion(element, display.factor, display.offset).flag("inverse", display.inverse));
        }
        document.close();
    });
}

/// `BaseUnit`, which SSP writes in the same way under its own name.
pub(crate) fn base_unit(name: &'static str, base: &BaseUnit) -> Element {
    let mut element = Element::new(name);
    for (symbol, exponent) in BaseUnit::SYMBOLS.into_iter().zip(base.exponents) {
        element = element.unless_default(symbol, exponent, 0);
    }
    conversion(element, base.factor, base.offset)
}

fn conversion(mut element: Element, factor: f64, offset: f64) -> Element {
    if factor != 1.0 {
        element = element.float("factor", factor);
    }
    if offset != 0.0 {
        element = element.float("offset", offset);
    }
    element
}

fn log_categories(document: &mut Document, categories: &[LogCategory]) {
    document.list("LogCategories", categories, |document, category| {
        document.empty(
            Element::new("Category").text("name", &category.name).maybe("description", category.description.as_deref()),
        );
    });
}

fn default_experiment(document: &mut Document, experiment: Option<&DefaultExperiment>) {
    if let Some(experiment) = experiment {
        document.empty(
            Element::new("DefaultExperiment")
                .maybe_float("startTime", experiment.start_time)
                .maybe_float("stopTime", experiment.stop_time)
                .maybe_float("tolerance", experiment.tolerance)
                .maybe_float("stepSize", experiment.step_size),
        );
    }
}

fn items(document: &mut Document, items: &[Item]) {
    for item in items {
        document.empty(
            Element::new("Item")
                .text("name", &item.name)
                .text("value", &item.value.to_string())
                .maybe("description", item.description.as_deref()),
        );
    }
}

/// The attributes that a type and a variable share. `place` names them in an error.
fn attributes(
    element: Element,
    data_type: DataType,
    attributes: &Attributes,
    version: FmiVersion,
    place: &str,
) -> Result<Element, WriteError> {
    let has_quantity = data_type.is_float() || data_type.integer_range(version).is_some();
    let only_with_bounds = attributes.quantity.is_some() || attributes.min.is_some() || attributes.max.is_some();
    let only_floats = attributes.unit.is_some()
        || attributes.display_unit.is_some()
        || attributes.relative_quantity
        || attributes.unbounded
        || attributes.nominal.is_some();
    if (only_with_bounds && !has_quantity) || (only_floats && !data_type.is_float()) {
        return Err(WriteError::Attributes { place: place.to_owned(), data_type });
    }
    let bound = |value: Option<f64>| -> Result<Option<String>, WriteError> {
        let Some(value) = value else { return Ok(None) };
        match data_type.integer_range(version) {
            None => Ok(Some(float(value))),
            // Beyond 2^53 a float may round to just past the range of 64 bits.
            Some((least, greatest)) if value.fract() == 0.0 => {
                Ok(Some((value as i128).clamp(least, greatest).to_string()))
            }
            Some(_) => Err(WriteError::Attributes { place: place.to_owned(), data_type }),
        }
    };
    Ok(element
        .maybe("quantity", attributes.quantity.as_deref())
        .maybe("unit", attributes.unit.as_deref())
        .maybe("displayUnit", attributes.display_unit.as_deref())
        .flag("relativeQuantity", attributes.relative_quantity)
        .flag("unbounded", attributes.unbounded)
        .maybe("min", bound(attributes.min)?.as_deref())
        .maybe("max", bound(attributes.max)?.as_deref())
        .maybe_float("nominal", attributes.nominal))
}

/// A start value as a list, or an error if it is not of the variable's type.
fn start(variable: &Variable, version: FmiVersion) -> Result<Option<String>, WriteError> {
    let wrong = || WriteError::StartType { variable: variable.name.clone(), data_type: variable.data_type };
    match &variable.start {
        None => Ok(None),
        Some(Start::Float(values)) if variable.data_type.is_float() => Ok(Some(join(values, |v| float(*v)))),
        Some(Start::Integer(values)) => match variable.data_type.integer_range(version) {
            Some((least, greatest)) if values.iter().all(|v| (least..=greatest).contains(v)) => {
                Ok(Some(join(values, i128::to_string)))
            }
            _ => Err(wrong()),
        },
        Some(Start::Boolean(values)) if variable.data_type == DataType::Boolean => {
            Ok(Some(join(values, bool::to_string)))
        }
        _ => Err(wrong()),
    }
}

/// The attributes of a variable that both versions share and write first.
fn variable_head(element: Element, variable: &Variable) -> Element {
    // Neither version asks an input for it, and FMI 2.0 forbids it.
    let initial = match variable.causality {
        Causality::Input | Causality::Independent => None,
        _ => variable.initial,
    };
    let element = element
        .text("name", &variable.name)
        .text("valueReference", &variable.value_reference.to_string())
        .maybe("description", variable.description.as_deref())
        .text("causality", variable.causality.as_str())
        .text("variability", variable.variability.as_str())
        .maybe("initial", initial.map(Initial::as_str));
    if variable.can_handle_multiple_set_per_time_instant {
        element
    } else {
        element.text("canHandleMultipleSetPerTimeInstant", "false")
    }
}

/// An entry of `ModelStructure`; `reference` gives what the version calls a variable by.
fn unknown(
    name: &'static str,
    key: &str,
    unknown: &Unknown,
    reference: impl Fn(usize) -> Result<String, WriteError>,
) -> Result<Element, WriteError> {
    let mut element = Element::new(name).text(key, &reference(unknown.variable)?);
    if let Some(dependencies) = &unknown.dependencies {
        let references: Vec<String> = dependencies.iter().map(|index| reference(*index)).collect::<Result<_, _>>()?;
        element = element.text("dependencies", &references.join(" "));
    }
    if let Some(kinds) = &unknown.dependencies_kind {
        element = element.text("dependenciesKind", &join(kinds, |k| k.as_str().to_owned()));
    }
    Ok(element)
}
