//! Resolves and checks a system's connections, start values and input signals; all problems are found at once.

use std::collections::HashMap;
use std::sync::Arc;

use swayless_modeldesc::types::{Causality, Variability};

use super::names::{Kind, Names, Port};
use super::start::{Start, resolve};
use super::{Connection, System, units};
use crate::error::{Error, Result};
use crate::graph::Flow;
use crate::importer::co_simulation;
use crate::signals::InputSignals;

/// A connection between ports of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Link {
    /// The output.
    pub from: Port,
    /// The input.
    pub to: Port,
    /// How many values it carries.
    pub size: usize,
    /// `to = factor · from + offset`, conversion of units and transformation together; `None` copies bit by bit.
    pub scale: Option<(f64, f64)>,
}

/// A column of the input signals and the input that it drives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drive {
    /// The column.
    pub column: usize,
    /// The input, always a single value.
    pub to: Port,
    /// Whether the values between two rows are interpolated.
    pub interpolated: bool,
}

/// A system whose every name is resolved and every connection checked.
pub(crate) struct Wiring<'a> {
    pub names: Names<'a>,
    pub links: Vec<Link>,
    pub starts: Vec<Start>,
    pub drives: Vec<Drive>,
    pub signals: Option<Arc<InputSignals>>,
    pub flow: Flow,
}

impl<'a> Wiring<'a> {
    /// Resolves a system.
    pub(crate) fn of(system: &'a System) -> Result<Self> {
        let names = Names::of(system);
        let mut errors = Vec::new();
        for (index, instance) in system.instances.iter().enumerate() {
            if system.instances[..index].iter().any(|other| other.name == instance.name) {
                errors.push(Error::DuplicateInstance { name: instance.name.clone() });
            }
            let runs = co_simulation(instance.model.path(), instance.model.description());
            errors.extend(runs.err());
        }
        let mut sources: HashMap<Port, Vec<String>> = HashMap::new();
        let mut links = Vec::new();
        for connection in &system.connections {
            let Some(link) = link(&names, connection, &mut errors) else { continue };
            for element in elements(&names, link.to) {
                sources.entry(element).or_default().push(connection.from.clone());
            }
            links.push(link);
        }
        let mut starts = Vec::new();
        for start in &system.start_values {
            resolve(&names, start, &mut starts).unwrap_or_else(|error| errors.push(error));
        }
        let mut drives = Vec::new();
        if let Some(signals) = &system.signals {
            let columns = signals.names.iter().enumerate().flat_map(|(column, name)| {
                let behind = system.connectors.get(name).cloned().unwrap_or_else(|| vec![name.clone()]);
                behind.into_iter().map(move |name| (column, name))
            });
            for (column, name) in columns {
                match drive(&names, signals, column, &name) {
                    Ok(drive) => {
                        let source = format!("column `{name}` of {}", signals.path.display());
                        sources.entry(drive.to).or_default().push(source);
                        drives.push(drive);
                    }
                    Err(error) => errors.push(error),
                }
            }
        }
        let mut crowded: Vec<_> = sources.into_iter().filter(|(_, sources)| sources.len() > 1).collect();
        crowded.sort_by_key(|&(port, _)| port);
        errors
            .extend(crowded.into_iter().map(|(port, sources)| Error::SeveralSources { to: names.name(port), sources }));
        let flow = Flow::of(&names, &links, system.break_loops).map_err(|error| errors.push(error));
        Error::all(errors)?;
        // An error of the flow has just been returned with the others.
        let flow = flow.unwrap_or_default();
        Ok(Self { names, links, starts, drives, signals: system.signals.clone(), flow })
    }
}

/// The scalars that a port consists of, as ports; a scalar variable is its own.
fn elements(names: &Names, port: Port) -> Vec<Port> {
    let scalar = names.dimensions(port.instance, port.variable).is_empty();
    if scalar || port.element.is_some() {
        return vec![port];
    }
    (0..names.size(port)).map(|element| Port { element: Some(element), ..port }).collect()
}

/// Resolves a connection, or reports what is wrong with it.
fn link(names: &Names, connection: &Connection, errors: &mut Vec<Error>) -> Option<Link> {
    let ends = [&connection.from, &connection.to].map(|name| names.find(name, &connection.place));
    let (from, to) = match ends {
        [Ok(from), Ok(to)] => (from, to),
        ends => {
            errors.extend(ends.into_iter().filter_map(Result::err));
            return None;
        }
    };
    check(names, connection, from, to).map_err(|error| errors.push(error)).ok()
}

fn check(names: &Names, connection: &Connection, from: Port, to: Port) -> Result<Link> {
    let (output, input) = (names.variable(from), names.variable(to));
    let (from_name, to_name) = (names.name(from), names.name(to));
    let wrong = match (output.causality, input.causality) {
        (Causality::Output, Causality::Input) => None,
        (Causality::Output, causality) => Some((&to_name, causality)),
        (causality, _) => Some((&from_name, causality)),
    };
    if let Some((name, causality)) = wrong {
        let (wrong, causality) = (name.clone(), describe(causality).to_owned());
        return Err(Error::Direction { from: from_name, to: to_name, wrong, causality });
    }
    let kinds = (Kind::of(output.data_type), Kind::of(input.data_type));
    let sizes = (names.size(from), names.size(to));
    let compatible = match kinds {
        (Some(a), Some(b)) => a == b || (a, b) == (Kind::Integer, Kind::Float),
        _ => false,
    };
    if !compatible || sizes.0 != sizes.1 {
        let describe = |port: Port| match names.size(port) {
            1 => format!("{:?}", names.variable(port).data_type),
            size => format!("{:?}[{size}]", names.variable(port).data_type),
        };
        let (from_type, to_type) = (describe(from), describe(to));
        return Err(Error::TypeMismatch { from: from_name, to: to_name, from_type, to_type });
    }
    let scale = scale(names, connection, from, to)?;
    if scale.is_some() && kinds.1 != Some(Kind::Float) {
        let (from_type, to_type) =
            (format!("{:?} with a transformation", output.data_type), format!("{:?}", input.data_type));
        return Err(Error::TypeMismatch { from: from_name, to: to_name, from_type, to_type });
    }
    Ok(Link { from, to, size: sizes.0, scale })
}

/// Conversion of units and transformation as one.
fn scale(names: &Names, connection: &Connection, from: Port, to: Port) -> Result<Option<(f64, f64)>> {
    let transformation = (connection.factor, connection.offset);
    let converted = match (names.unit(from), names.unit(to)) {
        (Some(a), Some(b)) if connection.convert_units => {
            let relative = names.variable(from).attributes.relative_quantity;
            let defined = |name, port: Port| (name, units::definition(names.description(port.instance), name));
            units::conversion(defined(a, from), defined(b, to), relative).map_err(|units::Mismatch(reason)| {
                Error::UnitMismatch {
                    from: names.name(from),
                    to: names.name(to),
                    from_unit: a.to_owned(),
                    to_unit: b.to_owned(),
                    reason,
                }
            })?
        }
        // A unit on one side only is a number that fits everywhere.
        _ => None,
    };
    Ok(match (converted, transformation) {
        (converted, (1.0, 0.0)) => converted,
        (None, transformation) => Some(transformation),
        (Some((factor, offset)), (times, plus)) => Some((times * factor, times * offset + plus)),
    })
}

/// Resolves a column of the input signals.
fn drive(names: &Names, signals: &InputSignals, column: usize, name: &str) -> Result<Drive> {
    let place = format!("{}:1", signals.path.display());
    let wrong = |reason: String| Error::Signals { path: signals.path.clone(), line: 1, reason };
    let to = names.find(name, &place)?;
    let variable = names.variable(to);
    if variable.causality != Causality::Input {
        let causality = describe(variable.causality);
        return Err(wrong(format!(
            "`{name}` is {causality}, but only inputs can be driven; a parameter takes a start value"
        )));
    }
    if names.size(to) != 1 {
        return Err(wrong(format!("`{name}` is an array; drive its elements `{name}[1]` …")));
    }
    match Kind::of(variable.data_type) {
        Some(Kind::Float) => {}
        Some(Kind::Integer | Kind::Boolean) => {
            if signals.columns[column].iter().any(|value| value.fract() != 0.0) {
                let data_type = variable.data_type;
                return Err(wrong(format!("`{name}` is {data_type:?}, but the column has values that are not whole")));
            }
        }
        _ => {
            return Err(wrong(format!("`{name}` is {:?}, which a column of numbers cannot drive", variable.data_type)));
        }
    }
    Ok(Drive { column, to, interpolated: variable.variability == Variability::Continuous })
}

/// A causality in a sentence.
pub(super) fn describe(causality: Causality) -> &'static str {
    match causality {
        Causality::StructuralParameter => "a structural parameter",
        Causality::Parameter => "a parameter",
        Causality::CalculatedParameter => "a calculated parameter",
        Causality::Input => "an input",
        Causality::Output => "an output",
        Causality::Local => "a local variable",
        Causality::Independent => "the independent variable",
    }
}
