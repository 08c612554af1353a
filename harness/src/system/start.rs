//! Start values: from text to the values of a variable.

use std::str::FromStr;

use swayless_modeldesc::types::{Causality, DataType, Initial, Start as Declared, Variability, Variable};

use super::names::{Kind, Names, Port};
use super::wiring::describe;
use super::{StartValue, units};
use crate::error::{Error, Result};

/// Values of a variable, of the kind that its type has.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Values {
    Float(Vec<f64>),
    Integer(Vec<i64>),
    Boolean(Vec<bool>),
    String(Vec<String>),
}

/// A start value of a whole variable.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Start {
    /// The variable, never an element.
    pub port: Port,
    /// Its values.
    pub values: Values,
    /// As it was given, for messages.
    pub text: String,
    /// The file and line where it, or the last of its elements, was given, if in one.
    pub place: Option<String>,
}

/// Turns a start value as it was given into values, and adds it to the earlier ones: elements of one array become one
/// start value of the whole.
pub(crate) fn resolve(names: &Names, start: &StartValue, earlier: &mut Vec<Start>) -> Result<()> {
    let place = match &start.place {
        Some(place) => place.clone(),
        None => format!("start value {} = {}", start.variable, start.value),
    };
    let port = names.find(&start.variable, &place)?;
    let variable = names.variable(port);
    let wrong = |reason: String| Error::StartValue {
        place: start.place.clone(),
        variable: names.name(port),
        value: start.value.clone(),
        reason,
    };
    settable(variable).map_err(&wrong)?;
    let size = names.size(port);
    let fields: Vec<&str> = match (size, variable.data_type) {
        (1, _) => vec![start.value.as_str()],
        _ => start.value.split_whitespace().collect(),
    };
    if fields.len() != size && fields.len() != 1 {
        return Err(wrong(format!("it has {} values, the variable has {size}", fields.len())));
    }
    let scale = unit(names, port, start)?;
    let items = items(names, port);
    let mut values = match Kind::of(variable.data_type) {
        Some(Kind::Float) => Values::Float(
            all(&fields, |text| {
                let value: f64 = number(text, "a number")?;
                Ok(scale.map_or(value, |(factor, offset)| factor * value + offset))
            })
            .map_err(&wrong)?,
        ),
        Some(Kind::Integer) => {
            Values::Integer(all(&fields, |text| integer(text, variable.data_type, items)).map_err(&wrong)?)
        }
        Some(Kind::Boolean) => Values::Boolean(all(&fields, boolean).map_err(&wrong)?),
        Some(Kind::String) => Values::String(fields.iter().map(|&text| text.to_owned()).collect()),
        None => return Err(wrong(format!("a {:?} takes no start value here", variable.data_type))),
    };
    if let Values::Float(floats) = &mut values {
        check_range(names, port, floats).map_err(&wrong)?;
    }
    let whole = Port { element: None, ..port };
    let before = earlier.iter().position(|other| other.port == whole).map(|at| earlier.remove(at));
    let (values, text) = match (port.element, before) {
        (None, _) => (repeat(values, size), start.value.clone()),
        (Some(element), Some(Start { values: before, text, .. })) => {
            (replace(before, element, values), format!("{text} {}", start.value))
        }
        (Some(element), None) => {
            let length = names.length(port.instance, port.variable);
            (replace(declared(variable, length), element, values), start.value.clone())
        }
    };
    earlier.push(Start { port: whole, values, text, place: start.place.clone() });
    Ok(())
}

/// Only what the standard lets an importer set before a run.
fn settable(variable: &Variable) -> Result<(), String> {
    if variable.variability == Variability::Constant {
        return Err("it is a constant".to_owned());
    }
    let exact = matches!(variable.initial, Some(Initial::Exact | Initial::Approx));
    match variable.causality {
        Causality::Input | Causality::Parameter | Causality::StructuralParameter => Ok(()),
        Causality::Output | Causality::Local if exact => Ok(()),
        causality => Err(format!("it is {} that the FMU calculates", describe(causality))),
    }
}

/// A value beyond the declared bounds is refused here, where the bounds are known.
fn check_range(names: &Names, port: Port, values: &[f64]) -> Result<(), String> {
    let variable = names.variable(port);
    let unit = names.unit(port).map(|unit| format!(" {unit}")).unwrap_or_default();
    let (min, max) = (variable.attributes.min, variable.attributes.max);
    for &value in values {
        if let Some(min) = min.filter(|&min| value < min) {
            return Err(format!("{value}{unit} is below the minimum {min}{unit}"));
        }
        if let Some(max) = max.filter(|&max| value > max) {
            return Err(format!("{value}{unit} is above the maximum {max}{unit}"));
        }
    }
    Ok(())
}

/// The conversion from the unit of the value to the unit of the variable.
fn unit(names: &Names, port: Port, start: &StartValue) -> Result<Option<(f64, f64)>> {
    let (Some(from), Some(to)) = (start.unit.as_deref(), names.unit(port)) else { return Ok(None) };
    let model = names.description(port.instance);
    let definition = start.unit_definition.or_else(|| units::definition(model, from));
    units::conversion((from, definition), (to, units::definition(model, to)), false).map_err(
        |units::Mismatch(reason)| Error::StartValue {
            place: start.place.clone(),
            variable: names.name(port),
            value: format!("{} {from}", start.value),
            reason: format!("`{from}` cannot be converted to `{to}`: {reason}"),
        },
    )
}

type Items<'a> = &'a [swayless_modeldesc::types::Item];

fn items<'a>(names: &Names<'a>, port: Port) -> Items<'a> {
    let declared = names.variable(port).declared_type.as_deref();
    let types = &names.description(port.instance).type_definitions;
    types.iter().find(|definition| Some(definition.name.as_str()) == declared).map_or(&[], |found| &found.items)
}

fn all<T>(fields: &[&str], parse: impl Fn(&str) -> Result<T, String>) -> Result<Vec<T>, String> {
    fields.iter().map(|field| parse(field.trim())).collect()
}

fn number<T: FromStr>(text: &str, what: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("`{text}` is not {what}"))
}

fn integer(text: &str, data_type: DataType, items: Items) -> Result<i64, String> {
    if let Some(item) = items.iter().find(|item| item.name == text) {
        return Ok(item.value);
    }
    let number = match data_type {
        DataType::UInt64 => number(text, "a UInt64").map(u64::cast_signed),
        _ => number(text, "an integer"),
    };
    let listed: Vec<&str> = items.iter().map(|item| item.name.as_str()).collect();
    match number {
        Ok(value) if data_type == DataType::Enumeration && !items.is_empty() => {
            match items.iter().any(|item| item.value == value) {
                true => Ok(value),
                false => Err(format!("{value} is none of its items: {}", listed.join(", "))),
            }
        }
        Err(_) if data_type == DataType::Enumeration => {
            let suggestion = crate::error::Suggestion::find(text, listed.iter().copied());
            Err(format!("`{text}` is none of its items: {}{suggestion}", listed.join(", ")))
        }
        number => number,
    }
}

fn boolean(text: &str) -> Result<bool, String> {
    match text {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        _ => Err(format!("`{text}` is neither true nor false")),
    }
}

/// The declared start of a whole variable, as many values as it has elements.
pub(crate) fn declared(variable: &Variable, length: usize) -> Values {
    let values = match &variable.start {
        Some(Declared::Float(values)) => Values::Float(values.clone()),
        Some(Declared::Integer(values)) => Values::Integer(values.iter().map(|&value| value as i64).collect()),
        Some(Declared::Boolean(values)) => Values::Boolean(values.clone()),
        Some(Declared::String(values)) => Values::String(values.clone()),
        Some(Declared::Binary(_)) | None => match Kind::of(variable.data_type) {
            Some(Kind::Integer) => Values::Integer(Vec::new()),
            Some(Kind::Boolean) => Values::Boolean(Vec::new()),
            Some(Kind::String) => Values::String(Vec::new()),
            Some(Kind::Float) | None => Values::Float(Vec::new()),
        },
    };
    repeat(values, length)
}

/// One value for each element: one stands for all, none for zero.
fn repeat(values: Values, length: usize) -> Values {
    fn fill<T: Clone + Default>(mut values: Vec<T>, length: usize) -> Vec<T> {
        let last = if values.len() == 1 { values[0].clone() } else { T::default() };
        values.resize(length, last);
        values
    }
    match values {
        Values::Float(values) => Values::Float(fill(values, length)),
        Values::Integer(values) => Values::Integer(fill(values, length)),
        Values::Boolean(values) => Values::Boolean(fill(values, length)),
        Values::String(values) => Values::String(fill(values, length)),
    }
}

/// Replaces one element.
fn replace(whole: Values, element: usize, by: Values) -> Values {
    fn put<T>(mut whole: Vec<T>, element: usize, by: Vec<T>) -> Vec<T> {
        if let (Some(place), Some(value)) = (whole.get_mut(element), by.into_iter().next()) {
            *place = value;
        }
        whole
    }
    match (whole, by) {
        (Values::Float(whole), Values::Float(by)) => Values::Float(put(whole, element, by)),
        (Values::Integer(whole), Values::Integer(by)) => Values::Integer(put(whole, element, by)),
        (Values::Boolean(whole), Values::Boolean(by)) => Values::Boolean(put(whole, element, by)),
        (Values::String(whole), Values::String(by)) => Values::String(put(whole, element, by)),
        (whole, _) => whole,
    }
}
