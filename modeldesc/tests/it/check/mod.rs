//! The checker: good descriptions have no problems, and each rule finds what breaks it.

mod clocks;
mod structure;
mod variables;

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
        include_bytes!("../../golden/fmi2.xml").as_slice(),
        include_bytes!("../../golden/fmi3.xml"),
        include_bytes!("../../golden/fmi3_clocks.xml"),
    ] {
        assert_eq!(read_and_check(golden).unwrap().1, []);
    }
}

#[test]
fn problems_of_a_file_have_the_lines_of_what_they_are_about() {
    let text = include_str!("../../golden/fmi3.xml")
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
