//! `ModelVariables`.

use swayless_modeldesc::types::{
    Alias, Attributes, Causality, DataType, Dimension, FmiVersion, Initial, Start, Variability, Variable,
};

use super::clocks::{clocks, clocks_of};
use crate::declaration::{Declaration, Kind};
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::sizes::Sizes;
use crate::token::Variant;
use crate::variables::{Value, Variables};

/// A variable of the description with the numbers of its scalars.
pub struct Entry {
    pub block: Block,
    pub first: usize,
    pub count: usize,
    pub variable: Variable,
}

/// All variables, in the order of their numbers.
pub fn entries<M: Model>(version: FmiVersion, variant: Variant) -> Vec<Entry> {
    let sizes = Sizes::of::<M>(&Variables::start());
    let mut entries = vec![Entry { block: Block::Time, first: 0, count: 1, variable: time() }];
    for block in [Block::Parameters, Block::Inputs, Block::States, Block::Derivatives, Block::Outputs, Block::Discrete]
    {
        let source = if block == Block::Derivatives { Block::States } else { block };
        for declaration in Layout::<M>::declarations(source) {
            let first = Layout::<M>::first(block) + declaration.first;
            if version == FmiVersion::V2 && declaration.kind == Kind::Size {
                // FMI 2.0 has arrays of their default length only.
                continue;
            }
            let whole = version == FmiVersion::V3 || declaration.dimension.is_none();
            let length = sizes.as_ref().map_or(declaration.count(), |sizes| sizes.extent(first, declaration.count()));
            let parts = if whole { 1 } else { length };
            let count = if whole { declaration.count() } else { 1 };
            for part in 0..parts {
                let name = if whole { declaration.name.clone() } else { format!("{}[{}]", declaration.name, part + 1) };
                let start = start::<M>(block, declaration.first + part, if whole { length } else { 1 });
                let mut variable = variable(block, &declaration, name, start, first + part, whole);
                if let Some(parameter) = declaration.length.filter(|_| whole) {
                    variable.dimensions = lengths(&variable, parameter, &entries);
                }
                variable.intermediate_update &= version == FmiVersion::V3;
                variable.clocks = clocks_of::<M>(&declaration, variant);
                let alias = alias(&declaration, &variable, block);
                if version == FmiVersion::V3 {
                    variable.aliases.extend(alias);
                    entries.push(Entry { block, first: first + part, count, variable });
                } else {
                    let other = alias.map(|alias| Variable {
                        name: if whole { alias.name } else { format!("{}[{}]", alias.name, part + 1) },
                        description: alias.description,
                        causality: Causality::Local,
                        initial: Initial::default_for(Causality::Local, variable.variability),
                        start: None,
                        reinit: false,
                        ..variable.clone()
                    });
                    entries.push(Entry { block, first: first + part, count, variable });
                    entries.extend(other.map(|variable| Entry { block, first: first + part, count, variable }));
                }
            }
        }
    }
    for index in 0..Layout::<M>::INDICATOR_COUNT {
        let first = Layout::<M>::INDICATORS + index;
        let variable = Variable {
            description: Some("A change between positive and not positive is a state event".to_string()),
            initial: Some(Initial::Calculated),
            ..blank(Layout::<M>::name(Block::Indicators, index), first, DataType::Float64)
        };
        entries.push(Entry { block: Block::Indicators, first, count: 1, variable });
    }
    if variant == Variant::Clocked {
        entries.extend(clocks::<M>());
    }
    // A derivative names its state by position.
    let positions: Vec<(usize, usize)> = entries
        .iter()
        .enumerate()
        .filter(|(_, entry)| entry.block == Block::States)
        .map(|(position, entry)| (entry.first, position))
        .collect();
    for entry in entries.iter_mut().filter(|entry| entry.block == Block::Derivatives) {
        let state = entry.first - Layout::<M>::STATE_COUNT;
        entry.variable.derivative = positions.iter().find(|(first, _)| *first == state).map(|(_, position)| *position);
    }
    entries
}

fn blank(name: String, number: usize, data_type: DataType) -> Variable {
    // A model has far fewer variables than a value reference can tell apart.
    let number = u32::try_from(number).unwrap_or(u32::MAX);
    Variable::new(name, number, data_type, Causality::Local, Variability::Continuous)
}

fn time() -> Variable {
    Variable {
        description: Some("Simulation time".to_string()),
        causality: Causality::Independent,
        attributes: Attributes { unit: Some("s".to_string()), ..Attributes::default() },
        declared_type: Some("Time".to_string()),
        ..blank("time".to_string(), 0, DataType::Float64)
    }
}

fn variable(
    block: Block,
    declaration: &Declaration,
    name: String,
    start: Start,
    number: usize,
    whole: bool,
) -> Variable {
    let data_type = match declaration.kind {
        Kind::Real => DataType::Float64,
        Kind::Integer => DataType::Int32,
        Kind::Size => DataType::UInt64,
        Kind::Boolean => DataType::Boolean,
        Kind::Text => DataType::String,
        Kind::Enumeration { .. } => DataType::Enumeration,
    };
    let changing = if declaration.discrete || declaration.kind != Kind::Real {
        Variability::Discrete
    } else {
        Variability::Continuous
    };
    let shown = if declaration.output { Causality::Output } else { Causality::Local };
    let (causality, variability, initial) = match block {
        Block::Time => (Causality::Independent, Variability::Continuous, None),
        Block::Parameters if declaration.kind == Kind::Size => {
            let variability = if declaration.tunable { Variability::Tunable } else { Variability::Fixed };
            (Causality::StructuralParameter, variability, Some(Initial::Exact))
        }
        Block::Parameters if declaration.tunable => (Causality::Parameter, Variability::Tunable, Some(Initial::Exact)),
        Block::Parameters => (Causality::Parameter, Variability::Fixed, Some(Initial::Exact)),
        Block::Inputs => (Causality::Input, changing, Some(Initial::Exact)),
        Block::States if declaration.calculated => (shown, Variability::Continuous, Some(Initial::Calculated)),
        Block::States => (shown, Variability::Continuous, Some(Initial::Exact)),
        Block::Derivatives => (Causality::Local, Variability::Continuous, Some(Initial::Calculated)),
        Block::Outputs => (Causality::Output, Variability::Continuous, Some(Initial::Calculated)),
        Block::Discrete => (shown, Variability::Discrete, Some(Initial::Calculated)),
        Block::Indicators | Block::Clocks => (Causality::Local, Variability::Continuous, Some(Initial::Calculated)),
    };
    let derivative = block == Block::Derivatives;
    let unit = match declaration.unit {
        Some(unit) if derivative => unit.per_second(),
        other => other.copied(),
    };
    let mut variable = Variable {
        description: Some(if derivative {
            format!("Time derivative of {}", declaration.name)
        } else {
            declaration.description.to_string()
        }),
        causality,
        variability,
        initial,
        declared_type: match declaration.kind {
            Kind::Enumeration { name, .. } => Some(name.to_string()),
            _ => unit.map(|unit| unit.quantity.to_string()),
        },
        start: (initial == Some(Initial::Exact)).then_some(start),
        // An event may change any state; that none does cannot be told from outside.
        reinit: block == Block::States,
        dimensions: match declaration.dimension {
            Some(length) if whole => vec![Dimension::Fixed(length as u64)],
            _ => Vec::new(),
        },
        ..blank(if derivative { format!("der({name})") } else { name }, number, data_type)
    };
    if !derivative {
        variable.attributes.min = declaration.min;
        variable.attributes.max = declaration.max;
        variable.attributes.nominal = declaration.nominal;
    }
    variable.attributes.unit = unit.map(|unit| unit.symbol.to_string());
    variable.intermediate_update =
        variability == Variability::Continuous && matches!(causality, Causality::Input | Causality::Output);
    variable
}

/// The dimension of an array whose length is a structural parameter.
fn lengths(variable: &Variable, parameter: &str, entries: &[Entry]) -> Vec<Dimension> {
    let found = entries.iter().find(|entry| entry.variable.name == parameter);
    match found {
        Some(entry) => vec![Dimension::Variable(entry.variable.value_reference)],
        // `check` of the description tells that the name leads nowhere.
        None => variable.dimensions.clone(),
    }
}

/// The other name of a variable, with the groups around it.
fn alias(declaration: &Declaration, variable: &Variable, block: Block) -> Option<Alias> {
    let own = declaration.alias.filter(|_| block != Block::Derivatives)?;
    let group = declaration.name.rfind('.').map_or("", |dot| &declaration.name[..=dot]);
    let name = format!("{group}{own}");
    Some(Alias { name, description: Some(format!("Another name of {}", variable.name)), display_unit: None })
}

/// The start values of some scalars of a block.
fn start<M: Model>(block: Block, first: usize, count: usize) -> Start {
    fn of(values: &impl Variables<f64>, first: usize, count: usize) -> Start {
        let range = first..first + count;
        match values.get(first) {
            Value::Real(_) => Start::Float(
                range.filter_map(|i| if let Value::Real(value) = values.get(i) { Some(value) } else { None }).collect(),
            ),
            Value::Boolean(_) => Start::Boolean(range.map(|i| values.get(i) == Value::Boolean(true)).collect()),
            Value::Text(_) => Start::String(
                range
                    .map(|i| if let Value::Text(value) = values.get(i) { value.to_string() } else { String::new() })
                    .collect(),
            ),
            Value::Size(value) => Start::Integer(vec![value.into()]),
            Value::Integer(_) | Value::Enumeration(_) => Start::Integer(
                range
                    .map(|i| match values.get(i) {
                        Value::Integer(value) | Value::Enumeration(value) => value.into(),
                        _ => 0,
                    })
                    .collect(),
            ),
        }
    }
    match block {
        Block::Parameters => of(&<M::Parameters<f64> as Variables<f64>>::start(), first, count),
        Block::Inputs => of(&<M::Inputs<f64> as Variables<f64>>::start(), first, count),
        Block::States => of(&<M::States<f64> as Variables<f64>>::start(), first, count),
        Block::Time | Block::Derivatives | Block::Outputs | Block::Discrete | Block::Indicators | Block::Clocks => {
            Start::Float(Vec::new())
        }
    }
}
