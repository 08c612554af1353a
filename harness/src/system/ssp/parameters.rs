//! Start values from parameter bindings, parameter sets and parameter mappings.

use std::path::{Path, PathBuf};

use swayless_modeldesc::ssp::{
    self, Element, MappingEntry, Parameter, ParameterBinding, ParameterMapping, ParameterSet, Source, SourceBase,
    Transformation, Unit, Value,
};

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
    let (parameters, file) = match &binding.values {
        Source::Inline(parameters) => (parameters.clone(), None),
        Source::File { source, base } => {
            let file = find(reader, binding, source, *base)?;
            let xml = text(&file).map_err(|error| reader.named(binding.line, "parameter set", error))?;
            (set(&file, &xml)?, Some(file))
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
    for parameter in &parameters.parameters {
        let name = format!("{}{}", binding.prefix, parameter.name);
        let place = match &file {
            Some(file) => in_file(file, parameter),
            None => reader.place(parameter.line),
        };
        let folder = file.as_deref().and_then(Path::parent).unwrap_or(&reader.folder);
        // What a unit means is said by the parameter set, else by the system description; the FMU's own definition
        // comes last.
        let units = parameters.units.iter().chain(&reader.description.units);
        let plain = start_value(parameter, format!("{path}{name}"), units, folder, place);
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

/// The start values of a parameter set in a file, under the names that it gives them.
pub(in crate::system) fn of_file(file: &Path) -> Result<Vec<StartValue>> {
    let parameters = set(file, &text(file)?)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let value = |parameter: &Parameter| {
        start_value(parameter, parameter.name.clone(), &parameters.units, folder, in_file(file, parameter))
    };
    Ok(parameters.parameters.iter().map(value).collect())
}

fn set(file: &Path, xml: &str) -> Result<ParameterSet> {
    document(file, ssp::read_parameters(xml), |_| Vec::new())
}

fn in_file(file: &Path, parameter: &Parameter) -> String {
    format!("{}:{}", file.display(), parameter.line)
}

/// The start value of a parameter, whose unit is defined in `units` and whose file lies in `folder`.
fn start_value<'a>(
    parameter: &Parameter,
    variable: String,
    units: impl IntoIterator<Item = &'a Unit>,
    folder: &Path,
    place: String,
) -> StartValue {
    let unit = parameter.unit.clone();
    let definition = units.into_iter().find(|known| Some(&known.name) == unit.as_ref());
    StartValue {
        variable,
        value: written(&parameter.value, folder),
        unit_definition: definition.map(|known| known.base),
        unit,
        place: Some(place),
    }
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
