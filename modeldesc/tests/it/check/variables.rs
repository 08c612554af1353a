//! Variables: what goes with what, start values, references, dimensions.

use super::*;

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
