//! Finds variables by name: `instance.variable`, or `variable` alone when the system is a single FMU.

use std::collections::HashMap;

use swayless_modeldesc::types::{Causality, DataType, Dimension, ModelDescription, Start, Variable};

use super::{Instance, System};
use crate::error::{Error, Result, Suggestion};

/// The largest array that is taken.
const LARGEST: usize = 1 << 24;

/// A variable of an instance, or one element of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Port {
    /// The instance, as an index into the system's.
    pub instance: usize,
    /// The variable, as an index into the description's.
    pub variable: usize,
    /// The element in row-major order from 0, if one is meant.
    pub element: Option<usize>,
}

/// What kind of number a type is, as far as memory is concerned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Kind {
    Float,
    Integer,
    Boolean,
    String,
}

impl Kind {
    /// Of a type; binaries and clocks have none, and no part in a run.
    pub(crate) fn of(data_type: DataType) -> Option<Self> {
        match data_type {
            DataType::Float32 | DataType::Float64 => Some(Self::Float),
            DataType::Boolean => Some(Self::Boolean),
            DataType::String => Some(Self::String),
            DataType::Binary | DataType::Clock => None,
            _ => Some(Self::Integer),
        }
    }
}

/// The names of a system's variables, and how large the variables are.
pub(crate) struct Names<'a> {
    instances: &'a [Instance],
    variables: Vec<HashMap<&'a str, usize>>,
    dimensions: Vec<Vec<Vec<usize>>>,
}

impl<'a> Names<'a> {
    /// Of a system, with the start values that it gives to structural parameters.
    pub(crate) fn of(system: &'a System) -> Self {
        let instances = &system.instances;
        let variables = instances
            .iter()
            .map(|instance| {
                let variables = instance.model.description().variables.iter().enumerate();
                let names = variables.flat_map(|(index, variable)| {
                    let aliases = variable.aliases.iter().map(|alias| alias.name.as_str());
                    aliases.chain([variable.name.as_str()]).map(move |name| (name, index))
                });
                names.collect()
            })
            .collect();
        let mut names = Self { instances, variables, dimensions: Vec::new() };
        names.dimensions = (0..instances.len()).map(|index| names.sizes(index, system)).collect();
        names
    }

    /// The dimensions of all variables of an instance.
    fn sizes(&self, instance: usize, system: &System) -> Vec<Vec<usize>> {
        let description = self.instances[instance].model.description();
        let structural = |reference: u32| -> usize {
            let found = description.variables.iter().position(|variable| variable.value_reference == reference);
            let given = system.start_values.iter().rev().find_map(|start| {
                let single = || (self.count() == 1).then_some((0, start.variable.as_str()));
                let (at, name) = self.split(&start.variable).or_else(single)?;
                (at == instance && self.variables[at].get(name).copied() == found).then(|| start.value.parse().ok())?
            });
            let declared = found.and_then(|index| match &description.variables[index].start {
                Some(Start::Integer(values)) => values.first().and_then(|&value| usize::try_from(value).ok()),
                _ => None,
            });
            given.or(declared).unwrap_or(0)
        };
        let size = |dimension: &Dimension| match *dimension {
            Dimension::Fixed(size) => usize::try_from(size).unwrap_or(usize::MAX),
            Dimension::Variable(reference) => structural(reference),
        };
        description.variables.iter().map(|variable| variable.dimensions.iter().map(size).collect()).collect()
    }

    /// The instance that a name begins with, and the rest. Of several, whose names may contain dots, the longest.
    fn split<'n>(&self, name: &'n str) -> Option<(usize, &'n str)> {
        let found = self.instances.iter().enumerate().filter_map(|(index, instance)| {
            let rest = name.strip_prefix(instance.name.as_str())?.strip_prefix('.')?;
            Some((index, rest))
        });
        found.min_by_key(|(_, rest)| rest.len())
    }

    /// Finds a variable or an element of an array; `place` says in an error where it was named.
    pub(crate) fn find(&self, name: &str, place: &str) -> Result<Port> {
        let (instance, rest) = match self.split(name) {
            Some(found) => found,
            None if self.instances.len() == 1 => (0, name),
            None => return Err(self.no_instance(name, place)),
        };
        let found = self.find_in(instance, rest);
        // A single FMU may have a variable that begins with the FMU's own name.
        let found = found.or_else(|| (self.instances.len() == 1).then(|| self.find_in(0, name))?);
        if let Some(port) = found
            && self.length(port.instance, port.variable) > LARGEST
        {
            let length = self.length(port.instance, port.variable);
            let problem = format!("`{rest}` has {length} elements; the harness takes at most {LARGEST}");
            let path = self.instances[port.instance].model.path().to_owned();
            return Err(Error::InvalidDescription { path, problems: vec![problem] });
        }
        found.ok_or_else(|| self.no_variable(instance, rest, place))
    }

    fn no_variable(&self, instance: usize, name: &str, place: &str) -> Error {
        let of = &self.instances[instance];
        let (place, of) = (place.to_owned(), format!("`{}` ({})", of.name, of.model.path().display()));
        let variables = &self.variables[instance];
        let array = name.strip_suffix(']').and_then(|name| variables.get_key_value(name.rsplit_once('[')?.0));
        if let Some((&array, &variable)) = array {
            let reason = extent(array, self.dimensions(instance, variable));
            return Error::UnknownElement { place, of, name: name.to_owned(), reason };
        }
        let suggestion = Suggestion::find(name, variables.keys().copied());
        Error::UnknownVariable { place, of, name: name.to_owned(), suggestion }
    }

    fn find_in(&self, instance: usize, name: &str) -> Option<Port> {
        let variables = self.variables.get(instance)?;
        if let Some(&variable) = variables.get(name) {
            return Some(Port { instance, variable, element: None });
        }
        let (array, indices) = name.strip_suffix(']')?.rsplit_once('[')?;
        let &variable = variables.get(array)?;
        let dimensions = &self.dimensions[instance][variable];
        let indices: Vec<usize> = indices.split(',').map(|index| index.trim().parse().ok()).collect::<Option<_>>()?;
        let inside = indices.iter().zip(dimensions).all(|(&index, &size)| (1..=size).contains(&index));
        (inside && indices.len() == dimensions.len() && !dimensions.is_empty()).then(|| {
            let element = indices.iter().zip(dimensions).fold(0, |at, (&index, &size)| at * size + index - 1);
            Port { instance, variable, element: Some(element) }
        })
    }

    fn no_instance(&self, full: &str, place: &str) -> Error {
        let name = full.split_once('.').map_or(full, |(instance, _)| instance);
        // Who gives a variable's name without its instance is told the whole one.
        let having = (0..self.count()).filter(|&instance| self.find_in(instance, full).is_some());
        let whole: Vec<String> = having.map(|instance| format!("{}.{full}", self.instances[instance].name)).collect();
        let suggestion = match whole.is_empty() {
            true => Suggestion::find(name, self.instances.iter().map(|instance| instance.name.as_str())),
            false => Suggestion(Some(whole.join("` or `"))),
        };
        Error::UnknownInstance { place: place.to_owned(), name: name.to_owned(), suggestion }
    }

    /// The number of instances.
    pub(crate) fn count(&self) -> usize {
        self.instances.len()
    }

    /// The description of an instance's model.
    pub(crate) fn description(&self, instance: usize) -> &'a ModelDescription {
        self.instances[instance].model.description()
    }

    /// The variable of a port.
    pub(crate) fn variable(&self, port: Port) -> &'a Variable {
        &self.description(port.instance).variables[port.variable]
    }

    /// The dimensions of a variable, none for a scalar.
    pub(crate) fn dimensions(&self, instance: usize, variable: usize) -> &[usize] {
        &self.dimensions[instance][variable]
    }

    /// The number of elements of a whole variable.
    pub(crate) fn length(&self, instance: usize, variable: usize) -> usize {
        self.dimensions(instance, variable).iter().fold(1, |length, &size| length.saturating_mul(size))
    }

    /// The number of values that a port stands for.
    pub(crate) fn size(&self, port: Port) -> usize {
        if port.element.is_some() { 1 } else { self.length(port.instance, port.variable) }
    }

    /// `instance.variable`, with the indices of the element.
    pub(crate) fn name(&self, port: Port) -> String {
        let name = format!("{}.{}", self.instances[port.instance].name, self.variable(port).name);
        let Some(mut element) = port.element else { return name };
        let mut indices = Vec::new();
        for &size in self.dimensions(port.instance, port.variable).iter().rev() {
            indices.insert(0, (element % size + 1).to_string());
            element /= size;
        }
        format!("{name}[{}]", indices.join(","))
    }

    /// The unit of a variable, its own or its declared type's.
    pub(crate) fn unit(&self, port: Port) -> Option<&'a str> {
        let variable = self.variable(port);
        let declared = || {
            let name = variable.declared_type.as_deref()?;
            let types = &self.description(port.instance).type_definitions;
            types.iter().find(|definition| definition.name == name)?.attributes.unit.as_deref()
        };
        variable.attributes.unit.as_deref().or_else(declared)
    }

    /// All outputs that can be recorded.
    pub(crate) fn outputs(&self) -> Vec<Port> {
        let ports = (0..self.instances.len()).flat_map(|instance| {
            let variables = self.description(instance).variables.iter().enumerate();
            let outputs = variables.filter(|(_, variable)| {
                variable.causality == Causality::Output && Kind::of(variable.data_type).is_some()
            });
            outputs.map(move |(variable, _)| Port { instance, variable, element: None })
        });
        ports.collect()
    }
}

/// Which elements an array has.
fn extent(array: &str, dimensions: &[usize]) -> String {
    if dimensions.is_empty() {
        return format!("`{array}` is no array");
    }
    let first = vec!["1"; dimensions.len()].join(",");
    let last = dimensions.iter().map(usize::to_string).collect::<Vec<_>>().join(",");
    match dimensions.contains(&0) {
        true => format!("`{array}` is empty"),
        false => format!("the elements of `{array}` are [{first}] to [{last}]"),
    }
}
