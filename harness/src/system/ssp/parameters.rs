//! Start values from parameter bindings, parameter sets and parameter mappings.

use std::path::{Path, PathBuf};

use swayless_modeldesc::ssp::{
    self, Element, MappingEntry, Parameter, ParameterBinding, ParameterMapping, ParameterSet, Source, SourceBase,
    Transformation, Value,
};
use swayless_modeldesc::types::BaseUnit;

use super::{Reader, document};
use crate::error::{Error, Result};
use crate::system::StartValue;

/// Applies the bindings of a system and of everything inside. The innermost come first, since outer ones take precedence;
/// of those in one place, later ones do.
pub(super) fn bindings(reader: &mut Reader, system: &ssp::System, path: &str) {
    for element in &system.elements {
        let inner = format!("{path}{}.", element.name());
        match element {
            Element::System(system) => bindings(reader, system, &inner),
            Element::Component(component) => {
                component.parameter_bindings.iter().for_each(|binding| apply(reader, binding, &inner));
            }
        }
    }
    system.parameter_bindings.iter().for_each(|binding| apply(reader, binding, path));
}

fn apply(reader: &mut Reader, binding: &ParameterBinding, path: &str) {
    match values(reader, binding, path) {
        Ok(values) => values.into_iter().for_each(|value| reader.system.add_start_value(value)),
        Err(error) => reader.errors.push(error),
    }
}

/// The start values of a binding.
fn values(reader: &Reader, binding: &ParameterBinding, path: &str) -> Result<Vec<StartValue>> {
    let (set, file) = match &binding.values {
        Source::Inline(set) => (set.clone(), None),
        Source::File { source, base } => {
            let file = find(reader, binding, source, *base)?;
            let xml = text(&file).map_err(|error| reader.named(binding.line, "parameter set", error))?;
            let set: ParameterSet = document(&file, ssp::read_parameters(&xml), |_| Vec::new())?;
            (set, Some(file))
        }
    };
    let mapping = match &binding.mapping {
        None => None,
        Some(Source::Inline(mapping)) => Some(mapping.clone()),
        Some(Source::File { source, base }) => {
            let file = find(reader, binding, source, *base)?;
            let xml = text(&file).map_err(|error| reader.named(binding.line, "parameter mapping", error))?;
            let mapping: ParameterMapping = document(&file, ssp::read_mapping(&xml), |_| Vec::new())?;
            Some(mapping)
        }
    };
    let mut values = Vec::new();
    for parameter in &set.parameters {
        let name = format!("{}{}", binding.prefix, parameter.name);
        let place = match &file {
            Some(file) => format!("{}:{}", file.display(), parameter.line),
            None => reader.place(parameter.line),
        };
        let folder = file.as_deref().and_then(Path::parent).unwrap_or(&reader.folder);
        let plain = StartValue {
            variable: format!("{path}{name}"),
            value: written(&parameter.value, folder),
            unit: parameter.unit.clone(),
            unit_definition: parameter.unit.as_deref().and_then(|unit| definition(reader, &set, unit)),
            place: Some(place),
        };
        match &mapping {
            None => values.push(plain),
            Some(mapping) => {
                for entry in mapping.entries.iter().filter(|entry| entry.source == name) {
                    values.push(mapped(reader, parameter, entry, path, &plain)?);
                }
            }
        }
    }
    Ok(values)
}

/// A value under another name, perhaps transformed.
fn mapped(
    reader: &Reader,
    parameter: &Parameter,
    entry: &MappingEntry,
    path: &str,
    plain: &StartValue,
) -> Result<StartValue> {
    let mut value = StartValue { variable: format!("{path}{}", entry.target), ..plain.clone() };
    if entry.suppress_unit_conversion {
        value.unit = None;
    }
    match (&entry.transformation, &parameter.value) {
        (None, _) => {}
        (Some(Transformation::Linear { factor, offset }), Value::Float(numbers)) => {
            let numbers = numbers.iter().map(|number| (factor * number + offset).to_string());
            value.value = numbers.collect::<Vec<_>>().join(" ");
        }
        (Some(_), _) => {
            let text = format!("the mapping of `{}` has a transformation that is not supported here", entry.source);
            return Err(reader.wrong(entry.line, text));
        }
    }
    Ok(value)
}

/// The value as text. A string that begins with `./` or `../` names a file beside the document that gives it; the FMU, which
/// does not know that place, gets the whole path.
fn written(value: &Value, folder: &Path) -> String {
    match value {
        Value::String(texts) if texts.len() == 1 && (texts[0].starts_with("./") || texts[0].starts_with("../")) => {
            let path = folder.join(&texts[0]);
            path.canonicalize().unwrap_or(path).to_string_lossy().into_owned()
        }
        value => value.to_string(),
    }
}

/// What a unit means: by the parameter set, else by the system description. The FMU's own definition comes last.
fn definition(reader: &Reader, set: &ParameterSet, name: &str) -> Option<BaseUnit> {
    let units = set.units.iter().chain(&reader.description.units);
    units.into_iter().find(|unit| unit.name == name).map(|unit| unit.base)
}

fn find(reader: &Reader, binding: &ParameterBinding, source: &str, base: SourceBase) -> Result<PathBuf> {
    if base == SourceBase::Component {
        let text = "a source relative to the component is not supported; place the file beside the description";
        return Err(reader.wrong(binding.line, text.to_owned()));
    }
    reader.path(source).map_err(|text| reader.wrong(binding.line, text))
}

fn text(file: &Path) -> Result<String> {
    std::fs::read_to_string(file).map_err(|source| Error::io("read", file, source))
}
