//! Properties that hold for every description and for every text, however broken.

use crate::samples::without_lines;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use swayless_modeldesc::check::{check, read_and_check};
use swayless_modeldesc::read::read;
use swayless_modeldesc::ssp;
use swayless_modeldesc::types::*;
use swayless_modeldesc::write::write;

/// Any text that XML can hold, with its special characters more often than by chance.
fn text() -> impl Strategy<Value = String> {
    let character = prop_oneof![
        4 => select(vec!['a', 'ß', '😀', '<', '>', '&', '"', '\'', '\n', '\t', '\r', ' ', ';', ']']),
        1 => any::<char>().prop_filter("legal in XML", |c| {
            !matches!(*c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
        }),
    ];
    prop::collection::vec(character, 0..8).prop_map(String::from_iter)
}

fn maybe_text() -> impl Strategy<Value = Option<String>> {
    prop::option::of(text())
}

/// Any number; what is not a number is not equal to itself.
fn number() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("comparable", |value| !value.is_nan())
}

/// A whole number that a float holds exactly, in the range of a type.
fn whole(data_type: DataType, version: FmiVersion) -> impl Strategy<Value = i64> {
    const EXACT: i128 = 1 << 53;
    let (least, greatest) = data_type.integer_range(version).unwrap_or((0, 0));
    let clamp = |value: i128| i64::try_from(value.clamp(-EXACT, EXACT)).unwrap_or_default();
    clamp(least)..=clamp(greatest)
}

fn data_type(version: FmiVersion) -> impl Strategy<Value = DataType> {
    use DataType::*;
    select(match version {
        FmiVersion::V2 => vec![Float64, Int32, Boolean, String, Enumeration],
        FmiVersion::V3 => vec![
            Float32,
            Float64,
            Int8,
            UInt8,
            Int16,
            UInt16,
            Int32,
            UInt32,
            Int64,
            UInt64,
            Boolean,
            String,
            Binary,
            Enumeration,
            Clock,
        ],
    })
}

/// Attributes that a type has.
fn attributes(data_type: DataType, version: FmiVersion) -> BoxedStrategy<Attributes> {
    if data_type.is_float() {
        let option = || prop::option::of(number());
        (maybe_text(), maybe_text(), maybe_text(), any::<bool>(), any::<bool>(), option(), option(), option())
            .prop_map(|(quantity, unit, display_unit, relative_quantity, unbounded, min, max, nominal)| Attributes {
                quantity,
                unit,
                display_unit,
                relative_quantity,
                unbounded,
                min,
                max,
                nominal,
            })
            .boxed()
    } else if data_type.integer_range(version).is_some() {
        let bound = || prop::option::of(whole(data_type, version).prop_map(|value| value as f64));
        (maybe_text(), bound(), bound())
            .prop_map(|(quantity, min, max)| Attributes { quantity, min, max, ..Attributes::default() })
            .boxed()
    } else {
        Just(Attributes::default()).boxed()
    }
}

/// Start values, as many as the version allows.
fn start(data_type: DataType, version: FmiVersion) -> BoxedStrategy<Option<Start>> {
    let size = if version == FmiVersion::V2 { 1..2 } else { 1..4 };
    fn some<T: std::fmt::Debug + Clone + 'static>(
        value: impl Strategy<Value = T> + 'static,
        size: std::ops::Range<usize>,
        start: fn(Vec<T>) -> Start,
    ) -> BoxedStrategy<Option<Start>> {
        prop::option::of(prop::collection::vec(value, size).prop_map(start)).boxed()
    }
    match data_type {
        _ if data_type.is_float() => some(number(), size, Start::Float),
        DataType::Boolean => some(any::<bool>(), size, Start::Boolean),
        DataType::String => some(text(), size, Start::String),
        DataType::Binary => some(any::<Vec<u8>>(), size, Start::Binary),
        DataType::Clock => Just(None).boxed(),
        _ => {
            let (least, greatest) = data_type.integer_range(version).unwrap_or((0, 0));
            some(least..=greatest, size, Start::Integer)
        }
    }
}

/// What a clock may say of its ticks.
fn ticks() -> impl Strategy<Value = Clock> {
    use IntervalVariability as I;
    let decimal = || prop::option::of(number());
    let counter = || prop::option::of(any::<u64>());
    (
        select(vec![I::Constant, I::Fixed, I::Tunable, I::Changing, I::Countdown, I::Triggered]),
        any::<[bool; 2]>(),
        prop::option::of(any::<u32>()),
        (decimal(), decimal(), counter(), counter(), counter()),
    )
        .prop_map(|(interval_variability, flags, priority, times)| Clock {
            interval_variability,
            can_be_deactivated: flags[0],
            priority,
            interval_decimal: times.0,
            shift_decimal: times.1,
            supports_fraction: flags[1],
            resolution: times.2,
            interval_counter: times.3,
            shift_counter: times.4,
        })
}

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
fn description() -> impl Strategy<Value = ModelDescription> {
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

/// A good document to break.
fn document() -> impl Strategy<Value = String> {
    select(vec![
        include_str!("../golden/fmi2.xml"),
        include_str!("../golden/fmi3.xml"),
        include_str!("../golden/fmi3_clocks.xml"),
        include_str!("../golden/crane_written.ssd"),
        include_str!("../golden/crane_by_hand.ssd"),
    ])
    .prop_map(str::to_owned)
}

/// Texts that parsers stumble over.
const NASTY: &[&str] = &[
    "<",
    ">",
    "/>",
    "\"",
    "&",
    "&amp;",
    "&#0;",
    "&#x110000;",
    "&x;",
    "<!DOCTYPE x [<!ENTITY x \"y\">]>",
    "<![CDATA[",
    "]]>",
    "<!--",
    "-->",
    "<?",
    "?>",
    "xmlns:x=''",
    "99999999999999999999999999999999999999999999",
    "-1",
    "1e999",
    "\u{feff}",
    "ä",
];

/// Cuts, doubles, moves and replaces parts of a text.
fn broken(mut text: String, changes: &[(u8, Index, Index, Index)]) -> String {
    for (kind, from, to, what) in changes {
        let boundaries: Vec<usize> = text.char_indices().map(|(at, _)| at).chain([text.len()]).collect();
        let (a, b) = (*from.get(&boundaries), *to.get(&boundaries));
        let nasty: &str = what.get::<&str>(NASTY);
        let near = boundaries.iter().copied().find(|at| *at > a + (b % 40)).unwrap_or(text.len());
        match kind % 6 {
            0 => text.truncate(a),
            1 => text.replace_range(a..near, ""),
            2 => {
                let part = text[a..near].to_owned();
                text.insert_str(b, &part);
            }
            3 => text.insert_str(a, nasty),
            4 => text.replace_range(a..near, nasty),
            _ => {
                // The value of an attribute, where most of the meaning is.
                let quote = text[a..].find("=\"").map_or(text.len(), |at| a + at + 2);
                let end = text[quote..].find('"').map_or(text.len(), |at| quote + at);
                text.replace_range(quote..end, nasty);
            }
        }
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn what_was_written_is_read(description in description()) {
        let written = write(&description).expect("what the version can say");
        let (again, problems) = read(&written).expect("well-formed");
        prop_assert_eq!(&problems, &[], "{}", written);
        prop_assert_eq!(without_lines(again), description);
    }

    #[test]
    fn nothing_makes_the_checker_panic(mut description in description(), index in any::<usize>()) {
        check(&description);
        // Nobody promises that indices of a description made by hand lead somewhere.
        for unknown in &mut description.structure.outputs {
            unknown.variable = index;
            unknown.dependencies = Some(vec![index]);
        }
        for variable in &mut description.variables {
            variable.derivative = Some(index);
            variable.previous = Some(index);
            variable.dimensions = vec![Dimension::Fixed(u64::MAX), Dimension::Variable(0), Dimension::Variable(9)];
        }
        check(&description);
    }

    #[test]
    fn broken_documents_make_nothing_panic(
        document in document(),
        changes in prop::collection::vec(any::<(u8, Index, Index, Index)>(), 1..5),
    ) {
        let text = broken(document, &changes);
        let _ = read_and_check(text.as_bytes());
        {
            if let Ok((system, _)) = ssp::read_system(&text) {
                ssp::check(&system);
                let _ = ssp::write_system(&system);
            }
            let _ = ssp::read_parameters(&text);
            let _ = ssp::read_mapping(&text);
        }
    }

    #[test]
    fn bytes_make_nothing_panic(bytes in any::<Vec<u8>>()) {
        let _ = read_and_check(&bytes);
    }
}
