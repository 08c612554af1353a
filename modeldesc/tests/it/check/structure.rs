//! The model structure: its lists and dependencies.

use super::*;

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
