//! The model descriptions: complete, without problems, and with the dependencies that the equations have.

use swayless_export::abi::describe::{DOCUMENTATION, FMI2, FMI3, ICON, TERMINALS};
use swayless_modeldesc::check::check;
use swayless_modeldesc::read::read;
use swayless_modeldesc::terminals;
use swayless_modeldesc::types::{Causality, ModelDescription, Unknown, Variability};

use crate::host::describe;

fn both() -> [ModelDescription; 2] {
    [FMI2, FMI3].map(|item| read(&describe(item).unwrap()).unwrap().0)
}

#[test]
fn the_checker_finds_nothing() {
    for description in both() {
        assert_eq!(check(&description), Vec::new(), "FMI {}", description.fmi_version);
    }
}

#[test]
fn there_is_documentation_and_an_icon_and_nothing_else() {
    assert_eq!(describe(DOCUMENTATION).as_deref(), Some("# Ball"));
    assert_eq!(describe(ICON).as_deref(), Some("<svg/>"));
    assert_eq!(describe(c"nonsense"), None);
}

#[test]
fn terminals_are_where_they_take_or_give() {
    let [_, description] = both();
    let xml = describe(TERMINALS).unwrap();
    let (content, problems) = terminals::read_and_check(xml.as_bytes(), &description).unwrap();
    assert_eq!(problems, []);
    let found: Vec<_> = content
        .terminals
        .iter()
        .map(|terminal| {
            let members = terminal.members.iter().map(|m| (m.variable.as_str(), m.name.as_deref().unwrap()));
            let area = terminal.graphics.as_ref().unwrap().area;
            let kind = terminal.terminal_kind.as_deref().unwrap();
            (terminal.name.as_str(), kind, members.collect::<Vec<_>>(), (area.x1, area.x2))
        })
        .collect();
    assert_eq!(
        found,
        [
            ("below", "_swayless_push", vec![("push", "force"), ("floor", "floor")], (-120.0, -100.0)),
            ("above", "_swayless_ball", vec![("lies", "lies"), ("ticks", "ticks")], (100.0, 120.0)),
        ]
    );
}

fn names(description: &ModelDescription, unknown: &Unknown) -> Option<Vec<String>> {
    let name = |index: &usize| description.variables[*index].name.clone();
    unknown.dependencies.as_ref().map(|found| found.iter().map(name).collect())
}

#[test]
fn dependencies_are_those_of_the_equations() {
    for description in both() {
        let of = |unknowns: &[Unknown], name: &str| {
            let found = unknowns.iter().find(|u| description.variables[u.variable].name == name);
            names(&description, found.unwrap_or_else(|| panic!("{name}")))
        };
        let running = |name| of(&description.structure.outputs, name).unwrap();
        assert_eq!(running("height"), ["height"]);
        // Switched by a discrete variable that depends on everything, and directly on the push.
        assert_eq!(running("acceleration"), ["push"]);
        assert_eq!(running("clearance"), ["floor", "height"]);
        assert_eq!(running("energy"), ["height", "velocity"]);
        assert_eq!(running("bounces"), ["height"]);
        assert_eq!(running("lies"), ["push", "floor", "height", "velocity"]);
        assert_eq!(of(&description.structure.derivatives, "der(height)").unwrap(), ["velocity"]);
        assert_eq!(of(&description.structure.derivatives, "der(velocity)").unwrap(), ["push"]);
        let initial = |name| of(&description.structure.initial_unknowns, name);
        // What texts, truth values and integers do to equations is not traced.
        let energy = ["gravity", "ground", "label", "panics", "number", "height", "velocity"];
        assert_eq!(initial("energy").unwrap(), energy);
        assert_eq!(initial("der(velocity)").unwrap(), ["gravity", "ground", "label", "panics", "number", "push"]);
        assert_eq!(initial("clearance"), None, "the first event decides where the ground is");
    }
}

#[test]
fn variables_are_what_they_were_declared_as() {
    let [fmi2, fmi3] = both();
    for description in [&fmi2, &fmi3] {
        let of = |name: &str| description.variables.iter().find(|v| v.name == name).unwrap();
        let kind = |name: &str| (of(name).causality, of(name).variability);
        assert_eq!(kind("gravity"), (Causality::Parameter, Variability::Fixed));
        assert_eq!(kind("restitution"), (Causality::Parameter, Variability::Tunable));
        assert_eq!(kind("push"), (Causality::Input, Variability::Continuous));
        assert_eq!(kind("floor"), (Causality::Input, Variability::Discrete));
        assert_eq!(kind("height"), (Causality::Output, Variability::Continuous));
        assert_eq!(kind("velocity"), (Causality::Local, Variability::Continuous));
        assert_eq!(kind("bounces"), (Causality::Output, Variability::Discrete));
        assert_eq!(of("der(height)").derivative.map(|i| description.variables[i].name.as_str()), Some("height"));
        assert_eq!(of("der(height)").attributes.unit.as_deref(), Some("m/s"));
        assert_eq!(description.number_of_event_indicators, 1);
    }
    assert!(fmi2.variables.iter().any(|v| v.name == "weights[3]"));
    let array = fmi3.variables.iter().find(|v| v.name == "weights").unwrap();
    let element = fmi2.variables.iter().find(|v| v.name == "weights[1]").unwrap();
    assert_eq!(array.value_reference, element.value_reference);
    assert_eq!(fmi2.instantiation_token, fmi3.instantiation_token);
}
