//! Clocks and clocked variables.

use super::*;

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
