//! The model description, from the declarations and the traced structure.

use std::collections::BTreeSet;

use swayless_modeldesc::types::{
    Attributes, BaseUnit, Causality, DataType, DefaultExperiment, Dimension, DisplayUnit, FmiVersion, Initial,
    Interface, Item, LogCategory, ModelDescription, ModelStructure, NamingConvention, Start, TypeDefinition,
    Unit as UnitDefinition, Unknown, Variability, Variable,
};

use crate::declaration::{Declaration, Kind};
use crate::instance::TOLERANCE;
use crate::layout::{Block, Layout};
use crate::log::Category;
use crate::model::Model;
use crate::structure::Structure;
use crate::token;
use crate::unit::Unit;
use crate::variables::{Value, Variables};

/// A variable of the description with the numbers of its scalars.
struct Entry {
    block: Block,
    first: usize,
    count: usize,
    variable: Variable,
}

/// The description of a model for a version of the standard.
pub fn of<M: Model>(version: FmiVersion) -> ModelDescription {
    let entries = entries::<M>(version);
    let structure = structure::<M>(&entries);
    let units: Vec<Unit> = units(&entries);
    let interface = Interface {
        model_identifier: M::INFO.name.to_string(),
        can_not_use_memory_management_functions: true,
        ..Interface::default()
    };
    ModelDescription {
        fmi_version: version,
        model_name: M::INFO.name.to_string(),
        instantiation_token: token::of::<M>(),
        description: Some(M::INFO.description.to_string()),
        author: Some(env!("CARGO_PKG_AUTHORS").to_string()),
        version: Some(env!("CARGO_PKG_VERSION").to_string()),
        copyright: None,
        license: Some(env!("CARGO_PKG_LICENSE").to_string()),
        generation_tool: Some(format!("Swayless {}", env!("CARGO_PKG_VERSION"))),
        // Left out, so that equal sources give equal bytes.
        generation_date_and_time: None,
        variable_naming_convention: NamingConvention::Structured,
        co_simulation: Some(Interface { can_handle_variable_communication_step_size: true, ..interface.clone() }),
        model_exchange: Some(interface),
        scheduled_execution: None,
        type_definitions: types::<M>(&units),
        units: units.into_iter().map(unit_definition).collect(),
        log_categories: Category::ALL
            .iter()
            .map(|(name, description)| LogCategory {
                name: (*name).to_string(),
                description: Some((*description).to_string()),
            })
            .collect(),
        default_experiment: Some(DefaultExperiment {
            start_time: Some(0.0),
            stop_time: Some(M::INFO.stop_time),
            tolerance: Some(TOLERANCE),
            step_size: Some(M::INFO.step_size),
        }),
        number_of_event_indicators: Layout::<M>::INDICATOR_COUNT,
        variables: entries.into_iter().map(|entry| entry.variable).collect(),
        structure,
    }
}

fn entries<M: Model>(version: FmiVersion) -> Vec<Entry> {
    let mut entries = vec![Entry { block: Block::Time, first: 0, count: 1, variable: time() }];
    for block in [Block::Parameters, Block::Inputs, Block::States, Block::Derivatives, Block::Outputs, Block::Discrete]
    {
        let source = if block == Block::Derivatives { Block::States } else { block };
        for declaration in Layout::<M>::declarations(source) {
            let first = Layout::<M>::first(block) + declaration.first;
            let whole = version == FmiVersion::V3 || declaration.dimension.is_none();
            let parts = if whole { 1 } else { declaration.count() };
            let count = declaration.count() / parts;
            for part in 0..parts {
                let name = if whole { declaration.name.clone() } else { format!("{}[{}]", declaration.name, part + 1) };
                let start = start::<M>(block, declaration.first + part, count);
                let variable = variable(block, &declaration, name, start, first + part, whole);
                entries.push(Entry { block, first: first + part, count, variable });
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
        Block::Parameters if declaration.tunable => (Causality::Parameter, Variability::Tunable, Some(Initial::Exact)),
        Block::Parameters => (Causality::Parameter, Variability::Fixed, Some(Initial::Exact)),
        Block::Inputs => (Causality::Input, changing, Some(Initial::Exact)),
        Block::States if declaration.calculated => (shown, Variability::Continuous, Some(Initial::Calculated)),
        Block::States => (shown, Variability::Continuous, Some(Initial::Exact)),
        Block::Derivatives => (Causality::Local, Variability::Continuous, Some(Initial::Calculated)),
        Block::Outputs => (Causality::Output, Variability::Continuous, Some(Initial::Calculated)),
        Block::Discrete => (shown, Variability::Discrete, Some(Initial::Calculated)),
        Block::Indicators => (Causality::Local, Variability::Continuous, Some(Initial::Calculated)),
    };
    let derivative = block == Block::Derivatives;
    let unit = match declaration.unit {
        Some(unit) if derivative => unit.per_second(),
        other => other,
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
    variable
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
        Block::Time | Block::Derivatives | Block::Outputs | Block::Discrete | Block::Indicators => {
            Start::Float(Vec::new())
        }
    }
}

fn structure<M: Model>(entries: &[Entry]) -> ModelStructure {
    let traced = Structure::of::<M>();
    // The positions of variables by the numbers of their scalars.
    let position =
        |number: usize| entries.iter().position(|entry| (entry.first..entry.first + entry.count).contains(&number));
    let unknown = |place: usize, dependencies: Option<BTreeSet<usize>>| Unknown {
        variable: place,
        dependencies: dependencies.map(|set| set.into_iter().collect()),
        ..Unknown::default()
    };
    let running = |place: usize, entry: &Entry| {
        let numbers: BTreeSet<usize> = if entry.block == Block::States {
            (entry.first..entry.first + entry.count).collect()
        } else {
            (entry.first..entry.first + entry.count).flat_map(|number| traced.running(number)).copied().collect()
        };
        unknown(place, Some(numbers.into_iter().filter_map(position).collect()))
    };
    let initial = |place: usize, entry: &Entry| {
        let mut all = Some(BTreeSet::new());
        for number in entry.first..entry.first + entry.count {
            match (traced.initial(number), &mut all) {
                (Some(numbers), Some(set)) => set.extend(
                    // A calculated state is an unknown itself, not something to depend on.
                    numbers
                        .iter()
                        .filter_map(|number| position(*number))
                        .filter(|place| entries[*place].variable.initial != Some(Initial::Calculated)),
                ),
                _ => all = None,
            }
        }
        unknown(place, all)
    };
    let places = || entries.iter().enumerate();
    let is_output = |entry: &Entry| entry.variable.causality == Causality::Output;
    let is_unknown = |entry: &Entry| {
        let exposed = is_output(entry) || matches!(entry.block, Block::States | Block::Derivatives);
        exposed && entry.variable.initial == Some(Initial::Calculated)
    };
    ModelStructure {
        outputs: places().filter(|(_, e)| is_output(e)).map(|(i, e)| running(i, e)).collect(),
        derivatives: places().filter(|(_, e)| e.block == Block::Derivatives).map(|(i, e)| running(i, e)).collect(),
        initial_unknowns: places().filter(|(_, e)| is_unknown(e)).map(|(i, e)| initial(i, e)).collect(),
        clocked_states: Vec::new(),
        // What an indicator depends on is not said, since it changes with the discrete state.
        event_indicators: places()
            .filter(|(_, e)| e.block == Block::Indicators)
            .map(|(i, _)| unknown(i, None))
            .collect(),
    }
}

/// The units used, in the order of the table.
fn units(entries: &[Entry]) -> Vec<Unit> {
    let used = |unit: &&Unit| entries.iter().any(|e| e.variable.attributes.unit.as_deref() == Some(unit.symbol));
    crate::UNITS.iter().filter(used).copied().collect()
}

fn unit_definition(unit: Unit) -> UnitDefinition {
    UnitDefinition {
        name: unit.symbol.to_string(),
        base: Some(BaseUnit { exponents: unit.exponents, factor: 1.0, offset: 0.0 }),
        display_units: unit
            .display
            .iter()
            .map(|(name, factor)| DisplayUnit {
                name: (*name).to_string(),
                factor: *factor,
                offset: 0.0,
                inverse: false,
            })
            .collect(),
    }
}

/// A type for each unit used, and the enumerations.
fn types<M: Model>(units: &[Unit]) -> Vec<TypeDefinition> {
    let quantities = units.iter().map(|unit| TypeDefinition {
        name: unit.quantity.to_string(),
        description: None,
        data_type: DataType::Float64,
        attributes: Attributes {
            quantity: Some(unit.quantity.to_string()),
            unit: Some(unit.symbol.to_string()),
            display_unit: unit.display.first().map(|(name, _)| (*name).to_string()),
            ..Attributes::default()
        },
        items: Vec::new(),
    });
    quantities.chain(enumerations::<M>()).collect()
}

/// The enumerations of all variables, each once.
fn enumerations<M: Model>() -> Vec<TypeDefinition> {
    let mut found: Vec<TypeDefinition> = Vec::new();
    for block in [Block::Parameters, Block::Inputs, Block::Discrete] {
        for declaration in Layout::<M>::declarations(block) {
            let Kind::Enumeration { name, items } = declaration.kind else { continue };
            if found.iter().any(|known| known.name == name) {
                continue;
            }
            let items = items.iter().zip(1..).map(|((name, description), value)| Item {
                name: (*name).to_string(),
                value,
                description: Some((*description).to_string()),
            });
            found.push(TypeDefinition {
                name: name.to_string(),
                description: None,
                data_type: DataType::Enumeration,
                attributes: Attributes::default(),
                items: items.collect(),
            });
        }
    }
    found
}
