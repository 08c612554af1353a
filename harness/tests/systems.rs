//! Systems that are wired wrongly fail with everything that is wrong; values go where they are meant to.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, its helpers too")]

mod common;
#[path = "common/mock.rs"]
mod mock;

use std::fs;
use std::sync::Arc;

use common::foreign;
use mock::{Mock, mock, rest};
use swayless::{CsvWriter, Error, InputSignals, Options, Recording, System, simulate};
use swayless_modeldesc::types::FmiVersion;

/// Inputs and outputs of many kinds, none of which feeds through.
fn part() -> Arc<Mock> {
    let variables = r#"
        <Float64 name="in.length" valueReference="0" causality="input" start="0" unit="m"/>
        <Float64 name="in.angle" valueReference="1" causality="input" start="0" unit="rad"/>
        <Float64 name="in.temperature" valueReference="2" causality="input" start="0" unit="degC"/>
        <Float64 name="in.plain" valueReference="3" causality="input" start="0"/>
        <Boolean name="in.switch" valueReference="4" causality="input" start="false"/>
        <Float64 name="out.mass" valueReference="10" causality="output" initial="exact" start="4" unit="kg"/>
        <Float64 name="out.degrees" valueReference="11" causality="output" initial="exact" start="180" unit="deg"/>
        <Float64 name="out.fahrenheit" valueReference="12" causality="output" initial="exact" start="50" unit="degF"/>
        <Float64 name="out.odd" valueReference="13" causality="output" initial="exact" start="1" unit="odd"/>
        <Float64 name="out.array" valueReference="14" causality="output" initial="exact" start="1"><Dimension start="2"/></Float64>
        <Boolean name="out.switch" valueReference="15" causality="output" initial="exact" start="true"/>
        <Float64 name="size" valueReference="20" causality="parameter" variability="fixed" start="1" min="0.5" max="9" unit="m"/>
        <Enumeration name="kind" valueReference="21" causality="parameter" variability="tunable" declaredType="Kind" start="1"/>
        <Boolean name="on" valueReference="22" causality="parameter" variability="tunable" start="true"/>
        <Float64 name="list" valueReference="23" causality="parameter" variability="tunable" start="1 2 3"><Dimension start="3"/></Float64>"#;
    let outputs: String = (10..=15).map(|r| format!("<Output valueReference=\"{r}\" dependencies=\"\"/>")).collect();
    mock("Part", variables, &outputs, |_| {}, rest)
}

fn two() -> System {
    let mut system = System::new("two");
    system.add_model("a", part());
    system.add_model("b", part());
    system
}

fn problems(system: &System) -> Vec<String> {
    system.check().unwrap_err().problems().iter().map(ToString::to_string).collect()
}

#[test]
fn units_are_converted_by_their_definitions() {
    let mut system = two();
    system.connect("a.out.degrees", "b.in.angle");
    system.connect("a.out.fahrenheit", "b.in.temperature");
    system.connect("a.out.mass", "b.in.plain");
    let mut recording = Recording::new();
    let inputs = ["angle", "temperature", "plain"].map(|name| format!("b.in.{name}"));
    let options = Options { output_variables: inputs.to_vec(), ..Options::default() };
    simulate(&system, &options, &mut recording).unwrap();
    let value = |name: &str| recording.column(name).unwrap()[0];
    assert!((value("b.in.angle") - std::f64::consts::PI).abs() < 1e-15);
    assert!((value("b.in.temperature") - 10.0).abs() < 1e-9);
    assert_eq!(value("b.in.plain"), 4.0);
    assert_eq!(recording.units[0].as_deref(), Some("rad"));
}

#[test]
fn everything_wrong_is_said_at_once() {
    let mut system = two();
    system.connect("a.out.mass", "b.in.length");
    system.connect("a.out.odd", "b.in.angle");
    system.connect("a.in.plain", "b.in.plain");
    system.connect("a.out.mas", "b.in.plain");
    system.connect("c.out.mass", "b.in.plain");
    system.connect("a.out.switch", "b.in.plain");
    system.connect("a.out.array", "b.in.plain");
    system.connect("a.out.array[3]", "b.in.plain");
    system.connect("a.out.mass[1]", "b.in.plain");
    system.set_start_value("a.sise", "1");
    let problems = problems(&system);
    let expected = [
        "`kg` cannot be converted to `m`: one is kg, the other m",
        "`odd` cannot be converted to `rad`: `odd` is not defined by base units",
        "`a.in.plain` is an input, but a connection leads from an output to an input",
        "`a` (mock.fmu) has no variable `out.mas`; did you mean `out.mass`?",
        "there is no instance `c`; did you mean `a`?",
        "Boolean cannot be connected to Float64",
        "Float64[2] cannot be connected to Float64",
        "has no element `out.array[3]`: the elements of `out.array` are [1] to [2]",
        "has no element `out.mass[1]`: `out.mass` is no array",
        "has no variable `sise`; did you mean `size`?",
    ];
    for text in expected {
        assert!(problems.iter().any(|problem| problem.contains(text)), "{text} is not in {problems:#?}");
    }
    assert_eq!(problems.len(), expected.len(), "{problems:#?}");
}

#[test]
fn an_input_takes_one_source() {
    let mut system = two();
    system.connect("a.out.mass", "b.in.plain");
    system.connect("b.out.mass", "b.in.plain");
    system.set_input_signals(InputSignals::read("in.csv", b"time,b.in.plain\n0,1\n").unwrap());
    let [problem] = &problems(&system)[..] else { panic!() };
    let text = "`b.in.plain` has 3 sources: a.out.mass, b.out.mass, column `b.in.plain` of in.csv";
    assert!(problem.contains(text), "{problem}");
}

#[test]
fn start_values_are_checked_and_understood() {
    let good = [
        ("a.size", "2.5"),
        ("a.kind", "ZV"),
        ("b.kind", "1"),
        ("a.on", "false"),
        ("a.list", "4 5 6"),
        ("b.list[2]", "9"),
        ("a.in.length", "3"),
    ];
    let mut system = two();
    good.iter().for_each(|&(name, value)| system.set_start_value(name, value));
    let names = ["a.size", "a.kind", "b.kind", "a.on", "a.list", "b.list", "a.in.length"].map(str::to_owned);
    let mut recording = Recording::new();
    let options = Options { output_variables: names.to_vec(), ..Options::default() };
    simulate(&system, &options, &mut recording).unwrap();
    let first: Vec<f64> = recording.columns.iter().map(|column| column[0]).collect();
    assert_eq!(first, [2.5, 2.0, 1.0, 0.0, 4.0, 5.0, 6.0, 1.0, 9.0, 3.0, 3.0]);

    for (name, value, text) in [
        ("a.size", "wide", "`wide` is not a number"),
        ("a.size", "0.1", "0.1 m is below the minimum 0.5 m"),
        ("a.size", "10", "10 m is above the maximum 9 m"),
        ("a.kind", "ZW", "`ZW` is none of its items: None, ZV; did you mean `ZV`?"),
        ("a.kind", "7", "7 is none of its items: None, ZV"),
        ("a.on", "perhaps", "`perhaps` is neither true nor false"),
        ("a.list", "1 2", "it has 2 values, the variable has 3"),
        ("time", "1", "there is no instance `time`"),
        ("a.time", "1", "the independent variable that the FMU calculates"),
    ] {
        let mut system = two();
        system.set_start_value(name, value);
        let problems = problems(&system);
        assert!(problems.len() == 1 && problems[0].contains(text), "{problems:?}");
    }
}

#[test]
fn algebraic_loops_are_named_and_apparent_ones_are_none() {
    let variables = r#"
        <Float64 name="u" valueReference="0" causality="input" start="0"/>
        <Float64 name="w" valueReference="1" causality="input" start="0"/>
        <Float64 name="y" valueReference="2" causality="output"/>
        <Float64 name="z" valueReference="3" causality="output"/>"#;
    let declared = r#"<Output valueReference="2" dependencies="0"/><Output valueReference="3" dependencies="1"/>
        <InitialUnknown valueReference="2" dependencies="0"/><InitialUnknown valueReference="3" dependencies="1"/>"#;
    let silent = r#"<Output valueReference="2"/><Output valueReference="3"/>
        <InitialUnknown valueReference="2"/><InitialUnknown valueReference="3"/>"#;
    let system = |structure| {
        let mut system = System::new("circle");
        system.add_model("a", mock("Through", variables, structure, |_| {}, rest));
        system.add_model("b", mock("Through", variables, structure, |_| {}, rest));
        // a.u → a.y → b.u → b.y → a.w → a.z: through a twice, but by different ways.
        system.connect("a.y", "b.u");
        system.connect("b.y", "a.w");
        system
    };
    system(declared).check().unwrap();
    // Who says nothing says that everything depends on everything.
    match system(silent).check().unwrap_err() {
        Error::AlgebraicLoop { variables } => assert_eq!(variables.len(), 4),
        other => panic!("{other}"),
    }
    let mut broken = system(silent);
    broken.set_break_loops(true);
    broken.check().unwrap();
    assert_eq!(broken.late_connections().unwrap(), ["b.y → a.w"]);
    assert_eq!(system(declared).late_connections().unwrap(), [""; 0]);
    let mut closed = system(declared);
    closed.connect("a.z", "a.u");
    let text = closed.check().unwrap_err().to_string();
    for name in ["`a.u` → ", "`a.y`", "`b.u`", "`b.y`", "`a.w`", "`a.z`"] {
        assert!(text.contains(name), "{text}");
    }
}

#[test]
fn options_that_make_no_sense_are_refused() {
    let system = two();
    let base = Options::default();
    for options in [
        Options { stop_time: Some(0.0), ..base.clone() },
        Options { stop_time: Some(f64::NAN), ..base.clone() },
        Options { step_size: Some(0.0), ..base.clone() },
        Options { step_size: Some(-1.0), ..base.clone() },
        Options { step_size: Some(1e-300), ..base.clone() },
        Options { step_size: Some(1e-18), start_time: Some(1.0), ..base.clone() },
        Options { tolerance: Some(0.0), ..base.clone() },
        Options { output_interval: Some(0.0), ..base.clone() },
        Options { output_interval: Some(f64::INFINITY), ..base.clone() },
    ] {
        let error = simulate(&system, &options, &mut ()).unwrap_err();
        assert!(error.is_usage(), "{options:?}: {error}");
    }
    assert!(simulate(&System::new("empty"), &base, &mut ()).unwrap_err().is_usage());
    let options = Options { output_variables: vec!["a.out.mas".to_owned()], ..base };
    let text = simulate(&system, &options, &mut Recording::new()).unwrap_err().to_string();
    assert!(text.contains("did you mean `out.mass`?"), "{text}");
    let options = Options { output_variables: vec!["out.mass".to_owned()], ..options };
    let text = simulate(&system, &options, &mut Recording::new()).unwrap_err().to_string();
    assert!(text.contains("did you mean `a.out.mass` or `b.out.mass`?"), "{text}");
}

#[test]
fn what_is_asked_for_twice_is_one_column() {
    let names = ["a.out.array[2]", "a.out.mass", "a.out.array", "a.out.mass"].map(str::to_owned);
    let options = Options { output_variables: names.to_vec(), ..Options::default() };
    let mut recording = Recording::new();
    simulate(&two(), &options, &mut recording).unwrap();
    assert_eq!(recording.names, ["a.out.array[2]", "a.out.mass", "a.out.array[1]"]);
}

#[test]
fn arrays_are_as_long_as_their_structural_parameter_says() {
    let variables = r#"
        <UInt64 name="n" valueReference="0" causality="structuralParameter" variability="fixed" start="3"/>
        <Float64 name="u" valueReference="1" causality="input" start="1 2 3"><Dimension valueReference="0"/></Float64>
        <Float64 name="y" valueReference="2" causality="output" initial="exact" start="7 8 9"><Dimension valueReference="0"/></Float64>
        <Clock name="tick" valueReference="3" causality="output" intervalVariability="triggered"/>"#;
    let structure = r#"<Output valueReference="2" dependencies=""/><Output valueReference="3" dependencies=""/>"#;
    let mut system = System::new("arrays");
    for name in ["a", "b", "c"] {
        system.add_model(name, mock("Array", variables, structure, |_| {}, rest));
    }
    system.connect("a.y", "b.u");
    system.connect("a.y[3]", "c.u[1]");
    system.set_start_value("c.u[2]", "5");
    let run = |system: &System, names: &[&str]| {
        let output_variables = names.iter().map(|&name| name.to_owned()).collect();
        let mut recording = Recording::new();
        simulate(system, &Options { output_variables, ..Options::default() }, &mut recording).map(|_| recording)
    };
    let recording = run(&system, &["b.u", "c.u"]).unwrap();
    let first: Vec<f64> = recording.columns.iter().map(|column| column[0]).collect();
    assert_eq!(recording.names[3..], ["c.u[1]", "c.u[2]", "c.u[3]"]);
    assert_eq!(first, [7.0, 8.0, 9.0, 9.0, 5.0, 3.0]);
    // A clock is nobody's column, and all outputs do without it.
    assert_eq!(run(&system, &[]).unwrap().names.len(), 9);
    assert!(run(&system, &["a.tick"]).unwrap_err().to_string().contains("`a.tick` is Clock"));
    // Of a single FMU the instance need not be named.
    let mut single = System::new("single");
    single.add_model("it", mock("Array", variables, structure, |_| {}, rest));
    single.set_start_value("n", "5");
    single.set_start_value("u", "1 2 3 4 5");
    single.check().unwrap();
    // Arrays of different lengths do not go together.
    system.set_start_value("b.n", "2");
    let problems = problems(&system);
    assert!(
        problems.len() == 1 && problems[0].contains("Float64[3] cannot be connected to Float64[2]"),
        "{problems:?}"
    );
}

#[test]
fn results_are_streamed_without_loss() {
    let mut system = System::new("foreign");
    system.add_fmu("it", foreign(FmiVersion::V3)).unwrap();
    system.set_start_value("x_start", "0.1");
    system.set_start_value("rate", "0.2");
    system.set_start_value("label", "one, \"two\"");
    let names = ["it.x", "it.counter", "it.moving", "it.label"].map(str::to_owned);
    let options = Options { output_variables: names.to_vec(), stop_time: Some(1.0), ..Options::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.csv");
    let (mut csv, mut recording) = (CsvWriter::create(&path).unwrap(), Recording::new());
    let mut observers: Vec<&mut dyn swayless::Observer> = vec![&mut csv, &mut recording];
    simulate(&system, &options, &mut observers).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    let expected = "time,it.x,it.counter,it.moving,it.label\n\
        0,0.1,0,1,\"one, \"\"two\"\"\"\n\
        0.5,0.2,1,1,\"one, \"\"two\"\"\"\n\
        1,0.30000000000000004,2,1,\"one, \"\"two\"\"\"\n";
    assert_eq!(text, expected);
    assert_eq!(recording.names, ["it.x", "it.counter", "it.moving"]);
    assert_eq!(recording.column("it.x").unwrap()[2], 0.30000000000000004);
}

#[test]
fn a_refused_parameter_is_named_with_the_fmus_words() {
    for version in [FmiVersion::V2, FmiVersion::V3] {
        let system = |value: &str| {
            let mut system = System::open(foreign(version)).unwrap();
            system.set_start_value("x_start", value);
            simulate(&system, &Options::default(), &mut ())
        };
        system("1").unwrap();
        let error = system("-1").unwrap_err();
        assert!(matches!(error, Error::Refused { .. }));
        let text = error.to_string();
        assert!(text.contains("Foreign.x_start = -1 was refused") && text.contains("is below 0"), "{text}");
    }
}

#[test]
fn instances_are_ordered_by_what_feeds_through() {
    let variables = r#"
        <Float64 name="u" valueReference="0" causality="input" start="0"/>
        <Float64 name="w" valueReference="1" causality="input" start="0"/>
        <Float64 name="y" valueReference="2" causality="output" initial="exact" start="0"/>"#;
    let holding = || mock("Holding", variables, r#"<Output valueReference="2" dependencies=""/>"#, |_| {}, rest);
    let passing = || mock("Passing", variables, r#"<Output valueReference="2" dependencies="0"/>"#, |_| {}, rest);
    // A plant in a loop with a controller that passes its measurement on: the plant begins, whoever is named first.
    for swapped in [false, true] {
        let mut system = System::new("loop");
        let mut parts = vec![("controller", passing()), ("plant", holding()), ("source", holding())];
        if swapped {
            parts.reverse();
        }
        parts.into_iter().for_each(|(name, part)| system.add_model(name, part));
        system.connect("plant.y", "controller.u");
        system.connect("controller.y", "plant.u");
        system.connect("source.y", "controller.w");
        assert_eq!(system.order().unwrap(), ["source", "plant", "controller"]);
    }
    // Where nothing feeds through the order is the one in which the instances were added.
    let mut system = System::new("circle");
    ["c", "a", "b"].into_iter().for_each(|name| system.add_model(name, holding()));
    [("a.y", "b.u"), ("b.y", "c.u"), ("c.y", "a.u")].into_iter().for_each(|(from, to)| system.connect(from, to));
    assert_eq!(system.order().unwrap(), ["c", "a", "b"]);
}
