//! The writer, against golden files that were checked by eye and by the standards' schemas.

use crate::samples::{pendulum, pendulum_with_arrays, pendulum_with_clocks};
use swayless_modeldesc::types::*;
use swayless_modeldesc::write::{WriteError, write};

#[track_caller]
fn golden(description: &ModelDescription, file: &str, expected: &str) {
    let written = write(description).expect("a good description");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let path = format!("{}/tests/golden/{file}", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(path, &written).expect("the source folder is writable");
    }
    assert_eq!(written, expected, "{file}; set UPDATE_GOLDEN to accept and then look at the difference");
}

#[test]
fn fmi2_is_written_as_expected() {
    golden(&pendulum(FmiVersion::V2), "fmi2.xml", include_str!("../golden/fmi2.xml"));
}

#[test]
fn fmi3_is_written_as_expected() {
    golden(&pendulum_with_arrays(), "fmi3.xml", include_str!("../golden/fmi3.xml"));
}

#[test]
fn clocks_are_written_as_expected() {
    golden(&pendulum_with_clocks(), "fmi3_clocks.xml", include_str!("../golden/fmi3_clocks.xml"));
}

#[test]
fn clocks_say_when_they_tick_and_nothing_that_only_values_have() {
    let refused = |change: fn(&mut Variable), part: &str| {
        let mut description = pendulum_with_clocks();
        let clock = description.variables.iter_mut().find(|variable| variable.name == "ticks.out");
        change(clock.expect("a clock of the sample"));
        let error = write(&description).expect_err("what a clock cannot say");
        assert!(error.to_string().contains(part), "{error}");
    };
    refused(|clock| clock.clock = None, "clock `ticks.out`, without its interval");
    refused(|clock| clock.dimensions = vec![Dimension::Fixed(1)], "dimensions of the clock");
    refused(|clock| clock.previous = Some(1), "previous of the clock");
    refused(|clock| clock.derivative = Some(1), "derivative of the clock");
    refused(|clock| clock.initial = Some(Initial::Exact), "initial of the clock");
    refused(|clock| clock.intermediate_update = true, "intermediateUpdate of the clock");
    refused(|clock| clock.reinit = true, "reinit of the clock");
    refused(|clock| clock.start = Some(Start::Boolean(vec![true])), "the start value of `ticks.out`");
    let alias = Alias { name: "a".to_owned(), description: None, display_unit: Some("deg".to_owned()) };
    let mut description = pendulum_with_clocks();
    description.variables[4].aliases = vec![alias];
    assert!(matches!(write(&description), Err(WriteError::Attributes { .. })));
}

/// The error of writing the FMI 2.0 pendulum after a change.
fn refusal(change: impl FnOnce(&mut ModelDescription)) -> WriteError {
    let mut description = pendulum(FmiVersion::V2);
    change(&mut description);
    write(&description).expect_err("what FMI 2.0 cannot say")
}

#[test]
fn what_fmi2_cannot_say_is_refused_by_name() {
    let cases: [(WriteError, &str); 8] = [
        (refusal(|d| d.variables[3].dimensions = vec![Dimension::Fixed(1)]), "dimensions of `swing.push`"),
        (refusal(|d| d.variables[4].data_type = DataType::UInt8), "type UInt8 of `parts`"),
        (
            refusal(|d| {
                d.variables[3].aliases = vec![Alias { name: "a".to_owned(), description: None, display_unit: None }];
            }),
            "aliases of `swing.push`",
        ),
        (refusal(|d| d.units[0].display_units[0].inverse = true), "inverse display unit `deg`"),
        (refusal(|d| d.scheduled_execution = Some(Interface::default())), "scheduled execution"),
        (refusal(|d| d.variables[3].clocks = vec![1]), "clocks of `swing.push`"),
        (refusal(|d| d.variables[4].causality = Causality::StructuralParameter), "structuralParameter of `parts`"),
        (refusal(|d| d.type_definitions[1].attributes.max = Some(2.0)), "bounds of the enumeration type `Kind`"),
    ];
    for (error, part) in cases {
        assert!(matches!(error, WriteError::NotInVersion { .. }), "{error}");
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
fn what_contradicts_itself_is_refused() {
    assert_eq!(refusal(|d| d.variables.clear()), WriteError::NoVariables);
    assert!(matches!(refusal(|d| d.structure.outputs[0].variable = 99), WriteError::NoSuchVariable { index: 99, .. }));
    assert!(matches!(refusal(|d| d.variables[2].derivative = Some(8)), WriteError::NoSuchVariable { index: 8, .. }));
    for start in [
        Start::Float(vec![1.0]),
        Start::Integer(vec![1, 2]),
        Start::Integer(vec![1 << 40]),
        Start::String(vec!["1".to_owned()]),
    ] {
        let error = refusal(|d| d.variables[4].start = Some(start));
        assert!(matches!(error, WriteError::StartType { .. }), "{error}");
    }
    for change in [|a: &mut Attributes| a.unit = Some("m".to_owned()), |a: &mut Attributes| a.min = Some(0.5)] {
        let error = refusal(|d| change(&mut d.variables[4].attributes));
        assert!(matches!(error, WriteError::Attributes { .. }), "{error}");
    }
    assert!(matches!(
        refusal(|d| d.variables[4].clock = Some(Clock::new(IntervalVariability::Triggered))),
        WriteError::Attributes { .. }
    ));
    assert!(matches!(
        refusal(|d| d.author = Some("\u{0}".to_owned())),
        WriteError::IllegalCharacter { character: '\0', .. }
    ));
}
