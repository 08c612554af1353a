//! The checker: good descriptions have no problems, and each rule finds what breaks it.

use crate::samples::{pendulum, pendulum_with_arrays, pendulum_with_clocks};
use swayless_modeldesc::check::{check, read_and_check};
use swayless_modeldesc::types::*;

/// Wants exactly one problem, with this message, after a change of a good description.
#[track_caller]
fn one(mut description: ModelDescription, change: impl FnOnce(&mut ModelDescription), message: &str) {
    change(&mut description);
    let problems = check(&description);
    assert_eq!(problems.len(), 1, "{message}: {problems:#?}");
    assert!(problems[0].message.contains(message), "{message}: {}", problems[0]);
}

#[track_caller]
fn fmi2(change: impl FnOnce(&mut ModelDescription), message: &str) {
    one(pendulum(FmiVersion::V2), change, message);
}

#[track_caller]
fn fmi3(change: impl FnOnce(&mut ModelDescription), message: &str) {
    one(pendulum_with_arrays(), change, message);
}

/// Wants the problem in both versions.
#[track_caller]
fn both(change: impl Fn(&mut ModelDescription), message: &str) {
    fmi2(&change, message);
    fmi3(&change, message);
}

/// The variables of the samples by their names.
fn named<'a>(description: &'a mut ModelDescription, name: &str) -> &'a mut Variable {
    description.variables.iter_mut().find(|variable| variable.name == name).expect("a variable of the sample")
}

#[test]
fn good_descriptions_have_no_problems() {
    for description in
        [pendulum(FmiVersion::V2), pendulum(FmiVersion::V3), pendulum_with_arrays(), pendulum_with_clocks()]
    {
        assert_eq!(check(&description), []);
    }
    for golden in [
        include_bytes!("../golden/fmi2.xml").as_slice(),
        include_bytes!("../golden/fmi3.xml"),
        include_bytes!("../golden/fmi3_clocks.xml"),
    ] {
        assert_eq!(read_and_check(golden).unwrap().1, []);
    }
}

#[test]
fn problems_of_a_file_have_the_lines_of_what_they_are_about() {
    let text = include_str!("../golden/fmi3.xml")
        .replace("<Unit name=\"rad/s\">", "<Unit name=\"rad\">")
        .replace("name=\"Angle\" quantity=\"Angle\" unit=\"rad\"", "name=\"Angle\" quantity=\"Angle\" unit=\"m\"")
        .replace("stopTime=\"20.0\"", "stopTime=\"-20.0\"")
        .replace("<CoSimulation modelIdentifier=\"Pendulum\"", "<CoSimulation modelIdentifier=\"a-b\"");
    let (_, problems) = read_and_check(text.as_bytes()).unwrap();
    for (message, part) in [
        ("unit `rad` is there twice", "<Unit name=\"rad\">"),
        ("type `Angle` has the unit `m`", "<Float64Type"),
        ("`swing.angle` has the unit `m`", "name=\"swing.angle\""),
        ("`swing.push` has the unit `rad/s`", "name=\"swing.push\""),
        ("must be after the start", "<DefaultExperiment"),
        ("C identifier", "<CoSimulation"),
    ] {
        let problem = problems.iter().find(|p| p.message.contains(message)).expect(message);
        let line = text.lines().nth(problem.line - 1).unwrap();
        assert!(line.contains(part), "{problem} in {line}");
    }
    assert!(problems.is_sorted_by_key(|problem| problem.line));
}

#[test]
fn root() {
    both(|d| d.model_name.clear(), "`modelName` is empty");
    fmi2(|d| d.instantiation_token.clear(), "`guid` is empty");
    fmi3(|d| d.instantiation_token.clear(), "`instantiationToken` is empty");
    both(|d| d.generation_date_and_time = Some("yesterday".to_owned()), "must be a date and time");
    let mut empty = ModelDescription::new(FmiVersion::V2, "a", "b");
    empty.co_simulation = Some(Interface { model_identifier: "a".to_owned(), ..Interface::default() });
    assert!(check(&empty)[0].message.contains("no variables"));
}

#[test]
fn interfaces() {
    both(
        |d| {
            d.co_simulation = None;
            d.model_exchange = None;
        },
        "offer at least one",
    );
    fn cs(change: impl Fn(&mut Interface)) -> impl Fn(&mut ModelDescription) {
        move |d| change(d.co_simulation.as_mut().expect("the sample offers it"))
    }
    both(cs(|i| i.model_identifier = "1a".to_owned()), "must be a C identifier");
    both(
        cs(|i| {
            i.can_serialize_fmu_state = true;
            i.can_get_and_set_fmu_state = false;
        }),
        "canGetAndSetFMUState",
    );
    fmi3(cs(|i| i.can_return_early_after_intermediate_update = true), "set providesIntermediateUpdate");
    fmi3(cs(|i| i.fixed_internal_step_size = Some(0.0)), "must be positive");
    fmi3(
        |d| {
            cs(|i| i.has_event_mode = false)(d);
            d.variables.push(clock());
        },
        "set hasEventMode",
    );
}

fn clock() -> Variable {
    Variable {
        clock: Some(Clock::new(IntervalVariability::Triggered)),
        ..Variable::new("clock", 100, DataType::Clock, Causality::Input, Variability::Discrete)
    }
}

#[test]
fn log_categories_and_experiment() {
    both(|d| d.log_categories.push(d.log_categories[0].clone()), "`logStatusError` is there twice");
    both(|d| d.log_categories[0].name.clear(), "a log category needs a name");
    fn experiment(change: impl Fn(&mut DefaultExperiment)) -> impl Fn(&mut ModelDescription) {
        move |d| change(d.default_experiment.as_mut().expect("the sample has one"))
    }
    both(experiment(|e| e.stop_time = Some(0.0)), "must be after the start at 0");
    both(experiment(|e| e.stop_time = Some(f64::INFINITY)), "must be finite");
    both(experiment(|e| e.start_time = Some(f64::NAN)), "`startTime` is NaN");
    both(experiment(|e| e.tolerance = Some(-1.0)), "`tolerance` is -1");
    both(experiment(|e| e.step_size = Some(0.0)), "`stepSize` is 0");
    both(experiment(|e| e.step_size = Some(21.0)), "longer than the whole experiment");
}

#[test]
fn units() {
    both(|d| d.units.push(d.units[0].clone()), "unit `rad` is there twice");
    both(|d| d.units.push(Unit::default()), "a unit needs a name");
    both(
        |d| {
            let unit = &mut d.units[0];
            unit.display_units.push(unit.display_units[0].clone());
        },
        "display unit `deg` twice",
    );
    both(|d| d.units[0].display_units[0].factor = 0.0, "its factor must not be 0");
    both(|d| d.units[1].base = Some(BaseUnit { exponents: [0; 8], factor: 0.0, offset: 0.0 }), "factor must not be 0");
    fmi3(
        |d| {
            d.units[0].display_units[0].inverse = true;
            d.units[0].display_units[0].offset = 1.0;
        },
        "is inverse and has an offset",
    );
    both(|d| named(d, "swing.push").attributes.unit = Some("N".to_owned()), "unit `N`, which is not defined");
    both(
        |d| named(d, "swing.push").attributes.display_unit = Some("rpm".to_owned()),
        "`rpm`, which its unit `rad/s` does not define",
    );
    fmi3(|d| named(d, "indicator").attributes.display_unit = Some("deg".to_owned()), "display unit `deg` but no unit");
    fmi3(|d| d.variables[1].aliases[0].display_unit = Some("rpm".to_owned()), "`theta` has the display unit `rpm`");
}

#[test]
fn types() {
    both(|d| d.type_definitions.push(d.type_definitions[0].clone()), "type `Angle` is there twice");
    both(
        |d| d.type_definitions.push(TypeDefinition { name: String::new(), ..d.type_definitions[0].clone() }),
        "a type needs a name",
    );
    both(
        |d| d.type_definitions.push(TypeDefinition { name: "parts".to_owned(), ..d.type_definitions[0].clone() }),
        "has the name of a variable",
    );
    both(
        |d| {
            d.type_definitions.push(TypeDefinition {
                name: "Empty".to_owned(),
                items: Vec::new(),
                ..d.type_definitions[1].clone()
            });
        },
        "`Empty` has no items",
    );
    both(|d| d.type_definitions[1].items[0].name = "Payload".to_owned(), "has the item `Payload` twice");
    both(|d| d.type_definitions[1].items[0].value = 2, "has the value 2 of another");
    both(
        |d| {
            d.type_definitions.push(TypeDefinition {
                name: "Other".to_owned(),
                attributes: Attributes { unit: Some("N".to_owned()), ..Attributes::default() },
                ..d.type_definitions[0].clone()
            });
        },
        "type `Other` has the unit `N`",
    );
    fmi2(|d| named(d, "swing.angle").declared_type = Some("Angel".to_owned()), "`Angel`, which is not defined");
    both(
        |d| {
            d.type_definitions[0].data_type = DataType::Boolean;
            named(d, "swing.angle").declared_type = Some("Angle".to_owned());
        },
        "is a Float64 but its type `Angle` is for Boolean",
    );
    both(|d| named(d, "kind").declared_type = None, "needs a `declaredType`");
}

#[test]
fn bounds() {
    both(|d| named(d, "swing.push").attributes.nominal = Some(0.0), "nominal value 0");
    both(
        |d| {
            let attributes = &mut named(d, "der(swing.angle)").attributes;
            (attributes.min, attributes.max) = (Some(1.0), Some(-1.0));
        },
        "min 1 above max -1",
    );
    both(|d| named(d, "der(swing.angle)").attributes.min = Some(f64::NAN), "not a number");
    both(|d| named(d, "swing.push").attributes.min = Some(1.0), "starts at 0, outside of its range from 1");
    both(|d| named(d, "parts").attributes.max = Some(2.0), "starts at 3, outside");
    both(|d| named(d, "swing.push").start = Some(Start::Float(vec![f64::NAN])), "not a finite number");
    // Bounds of the declared type hold, too.
    both(|d| d.type_definitions[0].attributes.max = Some(0.05), "`swing.angle` starts at 0.1, outside");
}

#[test]
fn names() {
    both(|d| named(d, "parts").name = "file".to_owned(), "`file` is there twice");
    fmi3(|d| d.variables[1].aliases[0].name = "file".to_owned(), "`file` is there twice");
    both(|d| named(d, "parts").name = "a b".to_owned(), "not a structured name");
    both(|d| named(d, "parts").name.clear(), "a variable needs a name");
    both(
        |d| {
            d.variable_naming_convention = NamingConvention::Flat;
            named(d, "parts").name = "a\nb".to_owned();
        },
        "line break or a tab",
    );
}

#[test]
fn causality_variability_and_initial() {
    both(|d| named(d, "enabled").variability = Variability::Discrete, "cannot be both causality=parameter");
    both(|d| named(d, "parts").initial = Some(Initial::Approx), "must have initial=exact");
    both(|d| named(d, "parts").initial = None, "has no `initial`");
    both(|d| named(d, "time").initial = Some(Initial::Exact), "must have no `initial`");
    let discrete = |d: &mut ModelDescription| {
        d.variables.push(Variable::new("b", 50, DataType::Boolean, Causality::Local, Variability::Continuous));
    };
    both(discrete, "is a Boolean and cannot be continuous");
    fmi2(|d| named(d, "parts").causality = Causality::StructuralParameter, "FMI 2.0 does not know");
    fmi3(|d| d.variables.push(Variable { causality: Causality::Parameter, ..clock() }), "the clock `clock` must be");
    both(|d| named(d, "parts").can_handle_multiple_set_per_time_instant = false, "is no input");
    fmi3(|d| named(d, "parts").intermediate_update = true, "must not have `intermediateUpdate`");
}

/// Every combination against the table as the standard prints it, row by row.
#[test]
fn the_table_of_initial_is_the_standards() {
    use {Causality as C, Variability as V};
    let columns =
        [C::StructuralParameter, C::Parameter, C::CalculatedParameter, C::Input, C::Output, C::Local, C::Independent];
    // e, c, a for exact, calculated, approx, the default first.
    let rows = [
        (V::Constant, ["", "", "", "", "e", "e", ""]),
        (V::Fixed, ["e", "e", "ca", "", "", "ca", ""]),
        (V::Tunable, ["e", "e", "ca", "", "", "ca", ""]),
        (V::Discrete, ["", "", "", "e", "cea", "cea", ""]),
        (V::Continuous, ["", "", "", "e", "cea", "cea", ""]),
    ];
    for (variability, cells) in rows {
        for (causality, cell) in columns.into_iter().zip(cells) {
            let letters: String =
                Initial::allowed_for(causality, variability).iter().map(|initial| &initial.as_str()[..1]).collect();
            assert_eq!(letters, cell, "{causality:?} {variability:?}");
        }
    }
}

#[test]
fn start_values() {
    for name in ["swing.push", "parts", "swing.angle"] {
        both(|d| named(d, name).start = None, "needs a start value");
    }
    fmi3(|d| named(d, "n").start = None, "needs a start value");
    both(
        |d| d.variables.push(Variable::new("c", 50, DataType::Float64, Causality::Local, Variability::Constant)),
        "`c` needs a start value",
    );
    both(|d| named(d, "time").start = Some(Start::Float(vec![0.0])), "is independent and must not have a start");
    both(
        |d| named(d, "der(swing.angle)").start = Some(Start::Float(vec![0.0])),
        "initial=calculated and must not have a start",
    );
    both(|d| named(d, "enabled").start = Some(Start::Integer(vec![1])), "is not a Boolean");
    both(|d| named(d, "kind").start = Some(Start::Integer(vec![3])), "is no item of `Kind`");
    fmi3(|d| named(d, "modes").start = Some(Start::Float(vec![1.0, 2.0])), "has 6 elements but 2 start values");
    both(|d| named(d, "parts").start = Some(Start::Integer(vec![1, 2])), "has 1 elements but 2 start values");
    fmi2(
        |d| {
            named(d, "parts").attributes.max = None;
            named(d, "parts").start = Some(Start::Integer(vec![1 << 40]));
        },
        "which a Int32 cannot hold",
    );
    let mut one_for_all = pendulum_with_arrays();
    named(&mut one_for_all, "modes").start = Some(Start::Float(vec![1.0]));
    assert_eq!(check(&one_for_all), []);
}

#[test]
fn value_references() {
    fmi3(|d| named(d, "parts").value_reference = 5, "has the value reference 5 of `parts`");
    let alias = |start: bool, variability, unit: Option<&str>| {
        let mut alias = Variable::new("alias", 3, DataType::Float64, Causality::Local, variability);
        alias.attributes.unit = unit.map(str::to_owned);
        if start {
            alias.initial = Some(Initial::Exact);
            alias.start = Some(Start::Float(vec![0.0]));
        }
        move |d: &mut ModelDescription| d.variables.push(alias)
    };
    let mut good = pendulum(FmiVersion::V2);
    alias(false, Variability::Continuous, Some("rad/s"))(&mut good);
    assert_eq!(check(&good), []);
    fmi2(alias(true, Variability::Continuous, Some("rad/s")), "both a start value");
    fmi2(alias(true, Variability::Constant, Some("rad/s")), "only one of them is constant");
    fmi2(alias(false, Variability::Continuous, Some("rad")), "different units");
    fmi2(
        |d| {
            for (name, value) in [("c1", 1.0), ("c2", 2.0)] {
                d.variables.push(Variable {
                    start: Some(Start::Float(vec![value])),
                    ..Variable::new(name, 50, DataType::Float64, Causality::Local, Variability::Constant)
                });
            }
        },
        "start at different values",
    );
}

#[test]
fn the_independent_variable() {
    fmi3(
        |d| {
            d.variables.push(Variable::new(
                "t",
                50,
                DataType::Float64,
                Causality::Independent,
                Variability::Continuous,
            ));
        },
        "both independent",
    );
    fmi3(
        |d| {
            let time = named(d, "time");
            (time.causality, time.initial) = (Causality::Local, Some(Initial::Calculated));
        },
        "there is no independent variable",
    );
    fmi3(|d| named(d, "time").dimensions = vec![Dimension::Fixed(1)], "must be a scalar");
    let mut integer = pendulum(FmiVersion::V2);
    named(&mut integer, "time").data_type = DataType::Int32;
    assert!(check(&integer).iter().any(|p| p.message.contains("`time` must be a float")));
}

#[test]
fn derivatives() {
    // Without it, `swing.angle` is no state, and dependencies on it are no longer known.
    let mut without = pendulum(FmiVersion::V2);
    named(&mut without, "der(swing.angle)").derivative = None;
    assert!(check(&without).iter().any(|p| p.message.contains("has no attribute `derivative`")));
    both(|d| named(d, "swing.push").derivative = Some(99), "which does not exist");
    both(|d| named(d, "swing.push").derivative = Some(3), "is its own derivative");
    both(|d| named(d, "swing.push").derivative = Some(4), "but `parts` is no continuous float");
    both(|d| named(d, "swing.push").reinit = true, "must not have `reinit`");
    fmi3(|d| named(d, "der(swing.angle)").dimensions = vec![Dimension::Fixed(2)], "differ in size");
    both(
        |d| {
            named(d, "der(swing.angle)").derivative = Some(3);
            let structure = &mut d.structure;
            for unknown in [&mut structure.outputs[0], &mut structure.derivatives[0]] {
                (unknown.dependencies, unknown.dependencies_kind) = (None, None);
            }
        },
        "`swing.push` must be a local variable or an output",
    );
}

#[test]
fn dimensions() {
    fmi3(|d| named(d, "n").dimensions = vec![Dimension::Fixed(1)], "must be a scalar");
    fmi3(
        |d| {
            named(d, "names").dimensions = vec![Dimension::Fixed(0)];
            named(d, "names").start = Some(Start::String(vec![String::new()]));
        },
        "a dimension of size 0",
    );
    fmi3(|d| named(d, "modes").dimensions[1] = Dimension::Variable(99), "99, which no variable has");
    fmi3(
        |d| {
            named(d, "modes").dimensions[1] = Dimension::Variable(4);
        },
        "a dimension of `modes` is `parts`",
    );
    fmi3(
        |d| {
            named(d, "n").start = Some(Start::Integer(vec![0]));
            named(d, "modes").start = Some(Start::Float(vec![1.0]));
        },
        "dimension `n`, which starts at 0",
    );
}

/// Wants exactly one problem, with this message, after a change of what ticks.
#[track_caller]
fn ticking(change: impl FnOnce(&mut ModelDescription), message: &str) {
    one(pendulum_with_clocks(), change, message);
}

/// A change of what one of the clocks says.
fn says(name: &'static str, change: impl Fn(&mut Clock)) -> impl Fn(&mut ModelDescription) {
    move |d| change(named(d, name).clock.as_mut().expect("a clock of the sample"))
}

#[test]
fn clocked_variables() {
    ticking(|d| named(d, "count.before").clocks = vec![1], "which is no clock");
    ticking(|d| named(d, "count.before").clocks = vec![100, 100], "value reference 100 twice");
    ticking(|d| named(d, "ticks.out").clocks = vec![106], "is its own clock");
    ticking(|d| named(d, "indicator").clocks = vec![100], "must be discrete or tunable");
    ticking(
        |d| {
            d.scheduled_execution = None;
            named(d, "ticks.out").causality = Causality::Local;
            named(d, "count").causality = Causality::Output;
            named(d, "count").clocks = vec![106];
            let count = d.structure.outputs[1].variable + 1;
            d.structure.outputs[1] = Unknown { variable: count, ..Unknown::default() };
            d.variables.iter_mut().filter_map(|v| v.clock.as_mut()).for_each(|clock| clock.priority = None);
        },
        "has the local clock `ticks.out` but is not local itself",
    );
    ticking(
        |d| {
            named(d, "count").clocks.clear();
            d.structure.clocked_states.clear();
            d.structure.clocked_states.push(Unknown { variable: 21, ..Unknown::default() });
            named(d, "count.before").previous = Some(20);
            named(d, "count").previous = None;
            named(d, "count").clocks = vec![100];
            named(d, "count.before").variability = Variability::Tunable;
        },
        "has a previous value and must be discrete",
    );
    ticking(|d| d.structure.clocked_states.clear(), "is missing among the clocked states");
    ticking(|d| named(d, "count").previous = None, "needs the attributes `clocks` and `previous`");
    ticking(|d| named(d, "count").previous = Some(999), "does not exist");
    ticking(|d| named(d, "count").previous = Some(20), "is its own previous value");
    ticking(|d| named(d, "count").previous = Some(5), "must be of its type");
    ticking(
        |d| {
            let copy = Variable { name: "copy".to_owned(), value_reference: 109, ..named(d, "count").clone() };
            d.structure.clocked_states.push(Unknown { variable: d.variables.len(), ..Unknown::default() });
            d.variables.push(copy);
        },
        "also that of another variable",
    );
}

#[test]
fn clocks() {
    ticking(|d| named(d, "ticks.out").start = Some(Start::Boolean(vec![true])), "must not have a start value");
    ticking(
        says("ticks.out", |c| c.interval_variability = IntervalVariability::Countdown),
        "no input and must have intervalVariability=triggered, not countdown",
    );
    ticking(says("ticks.out", |c| c.can_be_deactivated = true), "nobody can deactivate it");
    ticking(says("ticks.changing", |c| c.priority = None), "`ticks.changing` needs a `priority`");
    ticking(says("ticks.out", |c| c.priority = Some(3)), "`ticks.out` has a `priority`, which some importers refuse");
    ticking(
        |d| {
            d.scheduled_execution = None;
            for variable in d.variables.iter_mut().filter(|variable| variable.name != "ticks.triggered") {
                variable.clock.iter_mut().for_each(|clock| clock.priority = None);
            }
        },
        "only ScheduledExecution heeds",
    );
    ticking(
        |d| {
            named(d, "ticks.out").causality = Causality::Local;
            d.structure.outputs.truncate(1);
        },
        "which ScheduledExecution does not allow",
    );
    fmi3(
        |d| {
            d.scheduled_execution = Some(Interface { model_identifier: "Pendulum".to_owned(), ..Interface::default() });
        },
        "nothing to activate",
    );
}

#[test]
fn intervals_of_clocks() {
    for name in ["ticks.changing", "ticks.countdown", "ticks.triggered"] {
        ticking(says(name, |c| c.interval_decimal = Some(1.0)), "has `intervalDecimal` but is");
        ticking(says(name, |c| c.shift_decimal = Some(0.0)), "has `shiftDecimal` but is");
        ticking(says(name, |c| c.resolution = Some(1)), "has `resolution` but is");
        ticking(says(name, |c| c.interval_counter = Some(1)), "has `intervalCounter` but is");
        ticking(says(name, |c| c.shift_counter = Some(0)), "has `shiftCounter` but is");
    }
    ticking(says("ticks.tunable", |c| c.interval_decimal = Some(0.0)), "is 0 but must be positive");
    ticking(says("ticks.tunable", |c| c.interval_decimal = Some(f64::INFINITY)), "is inf but must be positive");
    ticking(says("ticks.tunable", |c| c.shift_decimal = Some(-1.0)), "must not be negative");
    ticking(says("ticks.tunable", |c| c.resolution = Some(0)), "`resolution` of the clock `ticks.tunable` is 0");
    ticking(says("ticks.constant", |c| c.interval_decimal = None), "is constant and needs `intervalDecimal`");
    ticking(says("ticks.constant", |c| c.interval_counter = None), "needs `intervalCounter`");
    ticking(says("ticks.constant", |c| c.resolution = None), "needs `resolution`");
    ticking(says("ticks.constant", |c| c.supports_fraction = false), "set `supportsFraction` or remove them");
    ticking(
        says("ticks.constant", |c| c.interval_counter = Some(3)),
        "interval of the clock `ticks.constant` is 0.5 but also 3/4",
    );
    ticking(
        says("ticks.constant", |c| c.shift_counter = Some(2)),
        "shift of the clock `ticks.constant` is 0.25 but also 2/4",
    );
    ticking(
        says("ticks.tunable", |c| {
            c.supports_fraction = true;
            c.resolution = Some(5);
            c.shift_counter = Some(2);
        }),
        "`shiftCounter` without `intervalCounter`",
    );
    // What the declared type says holds as well, and is told once.
    let of_type = |change: fn(&mut Clock)| {
        move |d: &mut ModelDescription| change(d.type_definitions[2].clock.as_mut().expect("a clock type"))
    };
    ticking(of_type(|c| c.interval_counter = Some(7)), "interval of the clock `ticks.fixed` is 0.1 but also 7/10");
    ticking(of_type(|c| c.interval_counter = None), "`ticks.fixed` supports fractions and needs `intervalCounter`");
    let mut nobody = pendulum_with_clocks();
    of_type(|c| c.shift_decimal = Some(-1.0))(&mut nobody);
    nobody.variables.retain(|variable| variable.name == "time");
    nobody.structure = ModelStructure::default();
    assert!(
        check(&nobody).iter().any(|p| p.message.contains("the clock type `Sampling` is -1")),
        "{:?}",
        check(&nobody)
    );
}

#[test]
fn the_lists_of_the_structure() {
    both(|d| d.structure.outputs.clear(), "`swing.angle` is missing among the outputs");
    both(
        |d| d.structure.outputs.push(Unknown { variable: 3, ..Unknown::default() }),
        "`swing.push` is among the outputs",
    );
    both(|d| d.structure.outputs.push(d.structure.outputs[0].clone()), "`swing.angle` is listed twice");
    both(|d| d.structure.outputs.push(Unknown { variable: 99, ..Unknown::default() }), "does not exist");
    both(|d| d.structure.initial_unknowns.clear(), "`der(swing.angle)` is missing among the initial unknowns");
    both(
        |d| d.structure.initial_unknowns.push(Unknown { variable: 1, ..Unknown::default() }),
        "`swing.angle` is among the initial unknowns",
    );
    both(
        |d| {
            d.variables.push(Variable::new(
                "sum",
                50,
                DataType::Float64,
                Causality::CalculatedParameter,
                Variability::Fixed,
            ));
        },
        "`sum` is missing among the initial unknowns",
    );
    // A state or an output that is calculated must be listed, too.
    both(
        |d| {
            named(d, "swing.angle").initial = Some(Initial::Calculated);
            named(d, "swing.angle").start = None;
            d.structure.initial_unknowns[0].dependencies = None;
            d.structure.initial_unknowns[0].dependencies_kind = None;
        },
        "`swing.angle` is missing among the initial unknowns",
    );
    fmi3(|d| d.structure.event_indicators[0].variable = 4, "the event indicator `parts` must be a continuous float");
    fmi3(|d| d.number_of_event_indicators = 2, "should be 2 event indicators but 1");
}

#[test]
fn dependencies() {
    both(|d| d.structure.outputs[0].dependencies = None, "`dependenciesKind` but no `dependencies`");
    both(|d| d.structure.initial_unknowns[0].dependencies = Some(vec![1]), "1 dependencies but 2 kinds");
    both(
        |d| d.structure.initial_unknowns[0].dependencies_kind = Some(vec![DependencyKind::Tunable; 2]),
        "cannot have the dependency kind tunable",
    );
    both(|d| d.structure.derivatives[0].dependencies = Some(vec![99]), "depends on variable 99");
    both(|d| d.structure.derivatives[0].dependencies = Some(vec![1, 1]), "depends twice on `swing.angle`");
    both(|d| d.structure.derivatives[0].dependencies = Some(vec![2]), "which is itself computed");
    both(
        |d| {
            d.structure.initial_unknowns[0].dependencies = Some(vec![2]);
            d.structure.initial_unknowns[0].dependencies_kind = None;
        },
        "which is itself computed",
    );
    both(
        |d| {
            let index = d.variables.len();
            d.variables.push(Variable {
                initial: Some(Initial::Exact),
                start: Some(Start::Boolean(vec![false])),
                ..Variable::new("limit", 50, DataType::Boolean, Causality::Output, Variability::Discrete)
            });
            d.structure.outputs.push(Unknown {
                variable: index,
                dependencies: Some(vec![1]),
                dependencies_kind: Some(vec![DependencyKind::Constant]),
                line: 0,
            });
        },
        "is no float and cannot have the dependency kind constant",
    );
}
