//! Any description, whether it makes sense or not.

use proptest::prelude::*;
use proptest::sample::select;
use swayless_modeldesc::types::*;

use crate::any_value::{attributes, data_type, maybe_text, number, start, text, ticks};

/// A dimension; `Variable(0)` has to be there.
fn dimension() -> impl Strategy<Value = Dimension> {
    prop_oneof![(1..5_u64).prop_map(Dimension::Fixed), Just(Dimension::Variable(0))]
}

/// A variable; whether it makes sense is another question.
fn variable(version: FmiVersion) -> impl Strategy<Value = Variable> {
    use {Causality as C, Variability as V};
    let causality = move || {
        let mut known = vec![C::Parameter, C::CalculatedParameter, C::Input, C::Output, C::Local, C::Independent];
        known.extend((version == FmiVersion::V3).then_some(C::StructuralParameter));
        select(known)
    };
    let variability = select(vec![V::Constant, V::Fixed, V::Tunable, V::Discrete, V::Continuous]);
    data_type(version).prop_flat_map(move |data_type| {
        (
            (text(), maybe_text(), causality(), variability.clone(), any::<bool>(), text()),
            attributes(data_type, version),
            start(data_type, version),
            (any::<bool>(), any::<bool>(), prop::collection::vec(dimension(), 0..3)),
            prop::collection::vec((text(), maybe_text(), maybe_text()), 0..2),
            prop::option::of(select(vec![Initial::Exact, Initial::Approx, Initial::Calculated])),
            (ticks(), prop::collection::vec(any::<u32>(), 0..3)),
        )
            .prop_map(move |(names, attributes, start, flags, aliases, initial, (ticks, clocks))| {
                let (name, description, causality, variability, multiple, declared) = names;
                let new = version == FmiVersion::V3;
                let mut variable = Variable::new(name, 0, data_type, causality, variability);
                let is_clock = data_type == DataType::Clock;
                variable.clock = is_clock.then_some(ticks);
                if !matches!(causality, C::Input | C::Independent) && initial.is_some() && !is_clock {
                    variable.initial = initial;
                }
                variable.declared_type = (data_type == DataType::Enumeration || flags.0).then_some(declared);
                variable.reinit = data_type.is_float() && flags.0;
                variable.intermediate_update = new && flags.1 && !is_clock;
                variable.can_handle_multiple_set_per_time_instant = multiple;
                if new {
                    variable.dimensions = if is_clock { Vec::new() } else { flags.2 };
                    variable.clocks = clocks;
                    variable.aliases = aliases
                        .into_iter()
                        .map(|(name, description, display)| Alias {
                            name,
                            description,
                            display_unit: display.filter(|_| data_type.is_float()),
                        })
                        .collect();
                }
                Variable { description, attributes, start, ..variable }
            })
    })
}

/// Entries of the model structure for some number of variables.
fn unknowns(variables: usize) -> impl Strategy<Value = Vec<Unknown>> {
    use DependencyKind::*;
    let kind = select(vec![Dependent, Constant, Fixed, Tunable, Discrete]);
    let dependencies = prop::option::of(prop::collection::vec((0..variables, kind), 0..4));
    let unknown = (0..variables, dependencies, any::<bool>()).prop_map(|(variable, dependencies, with_kinds)| {
        let (dependencies, kinds): (Option<Vec<usize>>, Option<Vec<DependencyKind>>) =
            dependencies.map(|list| list.into_iter().unzip()).unzip();
        Unknown { variable, dependencies, dependencies_kind: kinds.filter(|_| with_kinds), line: 0 }
    });
    prop::collection::vec(unknown, 0..4)
}

fn definitions(version: FmiVersion) -> impl Strategy<Value = (Vec<Unit>, Vec<TypeDefinition>)> {
    let display = (text(), number(), number(), any::<bool>()).prop_map(move |(name, factor, offset, inverse)| {
        DisplayUnit { name, factor, offset, inverse: inverse && version == FmiVersion::V3 }
    });
    let base = (any::<[i32; 8]>(), number(), number()).prop_map(|(exponents, factor, offset)| BaseUnit {
        exponents,
        factor,
        offset,
    });
    let unit = (text(), prop::option::of(base), prop::collection::vec(display, 0..2))
        .prop_map(|(name, base, display_units)| Unit { name, base, display_units });
    let item = || {
        (text(), any::<i32>(), maybe_text()).prop_map(|(name, value, description)| Item {
            name,
            value: value.into(),
            description,
        })
    };
    let definition = data_type(version).prop_flat_map(move |data_type| {
        (text(), maybe_text(), attributes(data_type, version), prop::collection::vec(item(), 1..3), ticks()).prop_map(
            move |(name, description, mut attributes, items, ticks)| {
                let enumeration = data_type == DataType::Enumeration;
                if enumeration && version == FmiVersion::V2 {
                    (attributes.min, attributes.max) = (None, None);
                }
                let items = if enumeration { items } else { Vec::new() };
                let clock = (data_type == DataType::Clock).then_some(ticks);
                TypeDefinition { name, description, data_type, attributes, items, clock }
            },
        )
    });
    (prop::collection::vec(unit, 0..3), prop::collection::vec(definition, 0..3))
}

/// A description that its version can say.
pub fn description() -> impl Strategy<Value = ModelDescription> {
    select(vec![FmiVersion::V2, FmiVersion::V3]).prop_flat_map(|version| {
        let variables = prop::collection::vec(variable(version), 1..5);
        (variables, definitions(version)).prop_flat_map(move |(variables, definitions)| {
            let count = variables.len();
            (
                prop::array::uniform5(unknowns(count)),
                prop::collection::vec(prop::option::of((0..count, 0..count)), count),
                prop::collection::vec(maybe_text(), 9),
                prop::array::uniform4(prop::option::of(number())),
                any::<[bool; 16]>(),
                any::<u32>(),
            )
                .prop_map(move |(lists, derivatives, texts, times, flags, number)| {
                    let mut md = ModelDescription::new(version, "m", "t");
                    let [outputs, states, unknowns, indicators, clocked] = lists;
                    let mut texts = texts.into_iter();
                    let mut next = || texts.next().flatten();
                    md.description = next();
                    md.author = next();
                    md.version = next();
                    md.copyright = next();
                    md.license = next();
                    md.generation_tool = next();
                    md.generation_date_and_time = next();
                    let new = version == FmiVersion::V3;
                    md.co_simulation = Some(co_simulation(version, next(), &flags, number));
                    md.model_exchange = flags[9].then(|| Interface {
                        needs_completed_integrator_step: flags[8],
                        provides_evaluate_discrete_states: flags[10] && new,
                        ..interface(version, next(), &flags)
                    });
                    md.scheduled_execution = (new && flags[11]).then(|| interface(version, next(), &flags));
                    let [start_time, stop_time, tolerance, step_size] = times;
                    md.default_experiment = Some(DefaultExperiment { start_time, stop_time, tolerance, step_size });
                    (md.units, md.type_definitions) = definitions.clone();
                    md.variables = variables.clone();
                    for (reference, (variable, derivative)) in md.variables.iter_mut().zip(derivatives).enumerate() {
                        variable.value_reference = u32::try_from(reference).unwrap_or_default();
                        let is_clock = variable.data_type == DataType::Clock;
                        variable.derivative =
                            derivative.map(|(state, _)| state).filter(|_| variable.data_type.is_float());
                        variable.previous =
                            derivative.map(|(_, before)| before).filter(|_| version == FmiVersion::V3 && !is_clock);
                    }
                    md.structure.outputs = outputs;
                    md.structure.derivatives = states;
                    md.structure.initial_unknowns = unknowns;
                    if version == FmiVersion::V3 {
                        md.structure.event_indicators = indicators;
                        md.structure.clocked_states = clocked;
                    }
                    md.number_of_event_indicators = match version {
                        FmiVersion::V2 => usize::try_from(number % 1000).unwrap_or_default(),
                        FmiVersion::V3 => md.structure.event_indicators.len(),
                    };
                    md
                })
        })
    })
}

/// What all interfaces have.
fn interface(version: FmiVersion, name: Option<String>, flags: &[bool; 16]) -> Interface {
    let new = version == FmiVersion::V3;
    Interface {
        model_identifier: name.unwrap_or_default(),
        needs_execution_tool: flags[0],
        can_be_instantiated_only_once_per_process: flags[1],
        can_not_use_memory_management_functions: flags[2] && !new,
        can_get_and_set_fmu_state: flags[3],
        can_serialize_fmu_state: flags[4],
        provides_directional_derivatives: flags[5],
        provides_adjoint_derivatives: flags[6] && new,
        provides_per_element_dependencies: flags[12] && new,
        ..Interface::default()
    }
}

fn co_simulation(version: FmiVersion, name: Option<String>, flags: &[bool; 16], number: u32) -> Interface {
    let new = version == FmiVersion::V3;
    Interface {
        can_handle_variable_communication_step_size: flags[7],
        fixed_internal_step_size: new.then_some(0.25),
        can_interpolate_inputs: flags[8] && !new,
        max_output_derivative_order: number,
        recommended_intermediate_input_smoothness: if new { number.cast_signed() } else { 0 },
        can_run_asynchronuously: flags[13] && !new,
        provides_intermediate_update: flags[13] && new,
        might_return_early_from_do_step: flags[14] && new,
        can_return_early_after_intermediate_update: flags[15] && new,
        has_event_mode: flags[8] && new,
        provides_evaluate_discrete_states: flags[9] && new,
        ..interface(version, name, flags)
    }
}
