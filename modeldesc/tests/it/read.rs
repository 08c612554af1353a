//! The reader: what was written is read again; what is broken is reported with its line, never with a panic.

use crate::samples::{pendulum, pendulum_with_arrays, without_lines};
use swayless_modeldesc::problem::Severity;
use swayless_modeldesc::read::{read, read_bytes};
use swayless_modeldesc::types::*;
use swayless_modeldesc::write::write;

#[test]
fn what_was_written_is_read() {
    for description in [pendulum(FmiVersion::V2), pendulum(FmiVersion::V3), pendulum_with_arrays()] {
        let (again, problems) = read(&write(&description).unwrap()).unwrap();
        assert_eq!(problems, []);
        assert_eq!(without_lines(again), description);
    }
}

#[test]
fn variables_and_unknowns_know_their_lines() {
    let text = include_str!("../golden/fmi3.xml");
    let (description, _) = read(text).unwrap();
    for variable in &description.variables {
        let line = text.lines().nth(variable.line - 1).unwrap();
        assert!(line.contains(&format!("name=\"{}\"", variable.name)), "{line}");
    }
    let unknown = &description.structure.event_indicators[0];
    assert!(text.lines().nth(unknown.line - 1).unwrap().contains("EventIndicator"));
}

const FMI2: &str = include_str!("../golden/fmi2.xml");
const FMI3: &str = include_str!("../golden/fmi3.xml");

/// Replaces a part of a good document, reads it, and wants one error, in the line of the change.
#[track_caller]
fn problem(good: &str, from: &str, to: &str, message: &str) -> ModelDescription {
    assert_eq!(good.matches(from).count(), 1, "{from}");
    let before = good.split(from).next().unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    let (description, problems) = read(&good.replace(from, to)).expect("well-formed");
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert!(problems[0].message.contains(message), "{}", problems[0]);
    assert_eq!(problems[0].line, line, "{}", problems[0]);
    description
}

#[test]
fn defaults_are_those_of_the_standard() {
    let (description, _) = read(
        "<fmiModelDescription fmiVersion='3.0' modelName='m' instantiationToken='t'><ModelVariables>
        <Float64 name='a' valueReference='1'/>
        <Int32 name='b' valueReference='2'/>
        <Boolean name='c' valueReference='3' causality='parameter' start='1'/>
        <Float64 name='d' valueReference='4' causality='input' start='1'/>
        <Clock name='e' valueReference='5' causality='input' intervalVariability='triggered'/>
        </ModelVariables><ModelStructure/></fmiModelDescription>",
    )
    .unwrap();
    use {Initial as I, Variability as V};
    let expected = [
        (Causality::Local, V::Continuous, Some(I::Calculated)),
        (Causality::Local, V::Discrete, Some(I::Calculated)),
        (Causality::Parameter, V::Fixed, Some(I::Exact)),
        (Causality::Input, V::Continuous, Some(I::Exact)),
        (Causality::Input, V::Discrete, None),
    ];
    let read: Vec<_> = description.variables.iter().map(|v| (v.causality, v.variability, v.initial)).collect();
    assert_eq!(read, expected);

    let (description, _) = read_bytes(
        b"\xef\xbb\xbf<fmiModelDescription fmiVersion='2.0' modelName='m' guid='t'><ModelVariables>
        <ScalarVariable name='a' valueReference='1' causality='output'><Real/></ScalarVariable>
        <ScalarVariable name='b' valueReference='2'><Integer/></ScalarVariable>
        </ModelVariables><ModelStructure/></fmiModelDescription>",
    )
    .unwrap();
    let read: Vec<_> = description.variables.iter().map(|v| (v.variability, v.initial)).collect();
    assert_eq!(read, [(V::Continuous, Some(I::Calculated)); 2]);
}

#[test]
fn the_interfaces_of_fmi2_may_stand_in_either_order() {
    let me = "<ModelExchange modelIdentifier=\"Pendulum\" providesDirectionalDerivative=\"true\"/>";
    let turned = FMI2.replace(me, "").replace("  <UnitDefinitions>", &format!("  {me}<UnitDefinitions>"));
    let (description, problems) = read(&turned).unwrap();
    assert_eq!(problems, []);
    assert!(description.model_exchange.is_some());
}

#[test]
fn broken_forms_are_reported_in_their_line() {
    problem(FMI2, "modelName=\"Pendulum\" ", "", "needs the attribute `modelName`");
    problem(FMI2, "stopTime=\"20.0\"", "stopTime=\"20,0\"", "`stopTime` of `DefaultExperiment` is `20,0`");
    problem(FMI2, "stopTime=\"20.0\"", "stopTime=\"1e999\"", "must be a number");
    problem(FMI2, "<Item name=\"Hook\" value=\"1\"/>", "<Item name=\"Hook\" value=\"9999999999\"/>", "must be from");
    problem(FMI2, "<Category name=\"logStatusError\"/>", "<Category name=\"a\"/>text", "must not hold text");
    problem(FMI2, "<Category name=\"logStatusError\"/>", "<Category name=\"a\"/><X/>", "`X` does not belong");
    problem(FMI2, "<Integer min=\"0\"", "<Integer unit=\"m\" min=\"0\"", "no attribute `unit`");
    problem(FMI2, "<Boolean start=\"true\"/>", "<Boolean start=\"yes\"/>", "must be true or false");
    problem(FMI2, "<Boolean start=\"true\"/>", "<Boolean start=\"true false\"/>", "must be one value");
    problem(FMI2, "max=\"10\"", "max=\"3000000000\"", "must be from");
    problem(
        FMI2,
        "<Enumeration declaredType=\"Kind\" start",
        "<Enumeration start",
        "needs the attribute `declaredType`",
    );
    problem(FMI2, "causality=\"input\"", "causality=\"input\" initial=\"exact\"", "must not have `initial`");
    problem(FMI2, "causality=\"input\"", "causality=\"structuralParameter\"", "does not know");
    problem(FMI2, "<Boolean start=\"true\"/>", "<Boolean start=\"true\"/><Integer/>", "more than one type");
    problem(FMI2, "<Boolean start=\"true\"/>", "<Boolean start=\"true\"/><Float64/>", "`Float64` does not belong");
    problem(FMI3, "<Start value=\"00FF1A\"/>", "<Start/>", "needs the attribute `value`");
    problem(FMI3, "causality=\"structuralParameter\"", "causality=\"in\"", "must be one of structuralParameter,");
    problem(FMI3, "<Start value=\"00FF1A\"/>", "<Start value=\"00FF1\"/>", "hexadecimal");
    problem(FMI3, "<Dimension valueReference=\"8\"/>", "<Dimension/>", "either `start` or `valueReference`");
    problem(FMI3, "<Float64Type ", "<Float65Type ", "not a type");
    problem(FMI3, "hasEventMode=\"true\"", "hasEventMod=\"true\"", "nobody will heed it");
    problem(
        FMI3,
        "<Output valueReference=\"1\" dependencies=\"1\"",
        "<Output valueReference=\"1\" dependencies=\"z\"",
        "whole number",
    );
    problem(FMI3, "dependenciesKind=\"constant\"", "dependenciesKind=\"some\"", "must hold dependent, constant");
}

#[test]
fn clocks_are_reported_in_their_line() {
    let clocks = include_str!("../golden/fmi3_clocks.xml");
    let kind = "one of constant, fixed, tunable, changing, countdown, triggered";
    let description = problem(clocks, "intervalVariability=\"countdown\"", "intervalVariability=\"calculated\"", kind);
    assert!(description.variables.iter().any(|v| v.name == "ticks.countdown" && v.clock.is_none()));
    problem(clocks, "intervalVariability=\"countdown\"", "", "needs the attribute `intervalVariability`");
    problem(clocks, "priority=\"4\"", "priority=\"-4\"", "must be a whole number");
    problem(clocks, "priority=\"4\"", "initial=\"exact\"", "has no attribute `initial`");
    problem(clocks, "priority=\"4\"", "start=\"true\"", "has no attribute `start`");
}

#[test]
fn order_number_and_emptiness_of_elements_are_reported() {
    let (_, problems) = read(
        "<fmiModelDescription fmiVersion='3.0' modelName='m' instantiationToken='t'>
        <ModelStructure/>
        <ModelVariables/>
        <UnitDefinitions/>
        <UnitDefinitions><Unit name='m'/></UnitDefinitions>
        </fmiModelDescription>",
    )
    .unwrap();
    let problems: Vec<String> = problems.iter().map(ToString::to_string).collect();
    assert_eq!(
        problems,
        [
            "line 3: error: `ModelVariables` must stand before `ModelStructure`",
            "line 3: error: `ModelVariables` must not be empty",
            "line 4: error: `UnitDefinitions` must stand before `ModelStructure`",
            "line 4: error: `UnitDefinitions` needs the element `Unit`",
            "line 5: error: `UnitDefinitions` must stand before `ModelStructure`",
            "line 5: error: `UnitDefinitions` stands twice in `fmiModelDescription`",
        ]
    );
}

#[test]
fn a_variable_of_no_type_keeps_its_place() {
    let (description, problems) = read(&FMI2.replace("<Boolean start=\"true\"/>", "")).unwrap();
    assert!(problems[0].message.contains("needs one of the elements Real, Integer"), "{}", problems[0]);
    assert_eq!(description.variables.len(), pendulum(FmiVersion::V2).variables.len());
}

#[test]
fn what_is_no_variable_or_type_is_reported() {
    let (description, problems) = read(
        "<fmiModelDescription fmiVersion='3.0' modelName='m' instantiationToken='t'>
        <TypeDefinitions/>
        <ModelVariables><Float128 name='a' valueReference='1'/></ModelVariables>
        <ModelStructure/></fmiModelDescription>",
    )
    .unwrap();
    assert_eq!(description.variables, []);
    let problems: Vec<String> = problems.iter().map(ToString::to_string).collect();
    assert_eq!(
        problems,
        [
            "line 2: error: `TypeDefinitions` must not be empty; remove it",
            "line 3: error: `Float128` is not a type of variable; remove it",
        ]
    );
}

#[test]
fn references_that_lead_nowhere_are_reported_and_left_out() {
    let description = problem(FMI2, "derivative=\"2\"", "derivative=\"99\"", "`derivative` refers to index 99");
    assert_eq!(description.variables[2].derivative, None);
    let description = problem(FMI2, "derivative=\"2\"", "derivative=\"0\"", "index 0");
    assert_eq!(description.variables[2].derivative, None);
    let description =
        problem(FMI3, "<EventIndicator valueReference=\"12\"", "<EventIndicator valueReference=\"77\"", "77");
    assert_eq!(description.structure.event_indicators, []);
    // An unknown that depends on something unknown may depend on anything.
    let description = problem(FMI3, "dependencies=\"1\" dep", "dependencies=\"77\" dep", "value reference 77");
    assert_eq!(description.structure.outputs[0].dependencies, None);
    assert_eq!(description.structure.outputs[0].dependencies_kind, None);
}

#[test]
fn what_is_no_model_description_is_an_error() {
    for (text, part) in [
        ("<a/>", "must be `fmiModelDescription`"),
        ("<fmiModelDescription/>", "only FMI 2.0 and FMI 3.0"),
        ("<fmiModelDescription fmiVersion='1.0'/>", "`1.0`"),
        ("<fmiModelDescription fmiVersion='2.0'", "well-formed"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.message.contains(part), "{error}");
        assert_eq!(error.line, 1);
    }
    let error = read_bytes(b"<fmiModelDescription\n\xff/>").unwrap_err();
    assert_eq!((error.line, error.message.contains("UTF-8")), (2, true));
}

#[test]
fn a_later_minor_version_is_read_with_a_warning() {
    let (_, problems) = read(&FMI3.replace("fmiVersion=\"3.0\"", "fmiVersion=\"3.1\"")).unwrap();
    assert_eq!(problems[0].severity, Severity::Warning);
}
