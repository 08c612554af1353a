//! The master algorithms against closed forms, with slaves that are exact for held inputs.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, its helpers too")]

#[path = "common/mock.rs"]
mod mock;

use std::sync::Arc;

use mock::{Mock, Values, mock, rest};
use proptest::prelude::*;
use swayless::slave::{Failure, Status, Step};
use swayless::{AlgorithmKind, Error, InputSignals, Options, Recording, Summary, System, simulate};

const BOTH: [AlgorithmKind; 2] = [AlgorithmKind::Jacobi, AlgorithmKind::GaussSeidel];

fn options(algorithm: AlgorithmKind, stop_time: f64, step_size: f64) -> Options {
    Options { algorithm, stop_time: Some(stop_time), step_size: Some(step_size), ..Options::default() }
}

fn run(system: &System, options: &Options) -> (Summary, Recording) {
    let mut recording = Recording::new();
    let summary = simulate(system, options, &mut recording).unwrap();
    (summary, recording)
}

fn last(recording: &Recording, name: &str) -> f64 {
    *recording.column(name).unwrap().last().unwrap()
}

/// y = ½ u + 1, at once.
fn half() -> Arc<Mock> {
    let variables = r#"<Float64 name="u" valueReference="0" causality="input" start="0"/>
        <Float64 name="y" valueReference="1" causality="output"/>"#;
    let structure =
        r#"<Output valueReference="1" dependencies="0"/><InitialUnknown valueReference="1" dependencies="0"/>"#;
    let update = |values: &mut Values| {
        let y = 0.5 * values[&0][0] + 1.0;
        values.insert(1, vec![y]);
    };
    mock("Half", variables, structure, update, rest)
}

#[test]
fn a_broken_loop_finds_its_fixed_point_step_by_step() {
    // Around the loop y = ¼ y + 1½, with the fixed point 2: each step takes a quarter of the distance that is left.
    let mut system = System::new("loop");
    system.add_model("a", half());
    system.add_model("b", half());
    system.connect("a.y", "b.u");
    system.connect("b.y", "a.u");
    assert!(matches!(system.check(), Err(Error::AlgebraicLoop { .. })));
    system.set_break_loops(true);
    let options = Options { stop_time: Some(30.0), step_size: Some(1.0), ..Options::default() };
    let (_, recording) = run(&system, &options);
    assert_eq!((last(&recording, "a.y"), last(&recording, "b.y")), (2.0, 2.0));
    let errors: Vec<f64> = recording.column("a.y").unwrap().iter().map(|y| 2.0 - y).collect();
    assert!(errors.windows(2).take(10).all(|pair| (pair[1] - 0.25 * pair[0]).abs() < 1e-12), "{errors:?}");
}

/// A mass between a spring of stiffness 1 to the ground and one of stiffness 2 to `u`: x″ = −x − 2 (x − u), m = 1.
fn oscillator(start: f64) -> Arc<Mock> {
    let variables = format!(
        r#"<Float64 name="u" valueReference="0" causality="input" start="0" unit="m"/>
           <Float64 name="x" valueReference="1" causality="output" initial="exact" start="{start}" unit="m"/>
           <Float64 name="v" valueReference="2" causality="local" initial="exact" start="0"/>"#
    );
    mock(
        "Oscillator",
        &variables,
        r#"<Output valueReference="1" dependencies=""/>"#,
        |_| {},
        |values, _, h| {
            let (u, x, v) = (values[&0][0], values[&1][0], values[&2][0]);
            let omega = 3f64.sqrt();
            let center = 2.0 / 3.0 * u;
            let (sin, cos) = (omega * h).sin_cos();
            let (amplitude, rate) = (x - center, v / omega);
            values.insert(1, vec![center + amplitude * cos + rate * sin]);
            values.insert(2, vec![omega * (rate * cos - amplitude * sin)]);
            Ok(Step::Completed)
        },
    )
}

fn oscillators() -> System {
    let mut system = System::new("oscillators");
    system.add_model("a", oscillator(1.0));
    system.add_model("b", oscillator(0.0));
    system.connect("a.x", "b.u");
    system.connect("b.x", "a.u");
    system
}

#[test]
fn coupled_oscillators_converge_with_first_order() {
    // In phase with ω = 1, against each other with ω = √5.
    let exact = |t: f64| (t.cos() + (5f64.sqrt() * t).cos()) / 2.0;
    for algorithm in BOTH {
        let error = |h: f64| {
            let (_, recording) = run(&oscillators(), &options(algorithm, 5.0, h));
            let x = recording.column("a.x").unwrap();
            recording.times.iter().zip(x).map(|(&t, x)| (x - exact(t)).abs()).fold(0.0, f64::max)
        };
        let errors = [1e-2, 5e-3, 2.5e-3, 1.25e-3].map(error);
        println!("{algorithm}: {errors:?}");
        assert!(errors[3] < 0.01, "{errors:?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((0.9..1.1).contains(&order), "{algorithm}: order {order}, errors {errors:?}");
        }
    }
}

fn ramp() -> Arc<Mock> {
    mock(
        "Ramp",
        r#"<Float64 name="y" valueReference="0" causality="output" initial="exact" start="0"/>"#,
        r#"<Output valueReference="0" dependencies=""/>"#,
        |_| {},
        |values, t, h| {
            values.insert(0, vec![t + h]);
            Ok(Step::Completed)
        },
    )
}

fn double() -> Arc<Mock> {
    mock(
        "Double",
        r#"<Float64 name="u" valueReference="0" causality="input" start="0"/>
           <Float64 name="y" valueReference="1" causality="output"/>"#,
        r#"<Output valueReference="1" dependencies="0"/><InitialUnknown valueReference="1" dependencies="0"/>"#,
        |values| {
            values.insert(1, vec![2.0 * values[&0][0]]);
        },
        rest,
    )
}

fn sum() -> Arc<Mock> {
    mock(
        "Sum",
        r#"<Float64 name="u" valueReference="0" causality="input" start="0"/>
           <Float64 name="x" valueReference="1" causality="output" initial="exact" start="0"/>"#,
        r#"<Output valueReference="1" dependencies=""/>"#,
        |_| {},
        |values, _, h| {
            values.insert(1, vec![values[&1][0] + h * values[&0][0]]);
            Ok(Step::Completed)
        },
    )
}

/// Declared against the flow, so that the order has to come from the connections.
fn chain() -> System {
    let mut system = System::new("chain");
    system.add_model("sum", sum());
    system.add_model("double", double());
    system.add_model("ramp", ramp());
    system.connect("double.y", "sum.u");
    system.connect("ramp.y", "double.u");
    system
}

#[test]
fn a_chain_is_delayed_by_jacobi_and_not_by_gauss_seidel() {
    let (h, n) = (0.125, 16.0);
    let x = |algorithm| last(&run(&chain(), &options(algorithm, h * n, h)).1, "sum.x");
    assert_eq!(x(AlgorithmKind::GaussSeidel), h * h * n * (n + 1.0));
    assert_eq!(x(AlgorithmKind::Jacobi), h * h * (n - 1.0) * (n - 2.0));
}

#[test]
fn each_step_makes_one_call_of_each_kind_in_the_order_of_the_flow() {
    let (sum, double, ramp) = (sum(), double(), ramp());
    let mut system = System::new("chain");
    system.add_model("sum", sum.clone());
    system.add_model("double", double);
    system.add_model("ramp", ramp);
    system.connect("double.y", "sum.u");
    system.connect("ramp.y", "double.u");
    simulate(&system, &options(AlgorithmKind::GaussSeidel, 1.0, 0.5), &mut ()).unwrap();
    let calls = sum.log.lock().unwrap().clone();
    // Its output leads nowhere, so it is never got.
    assert_eq!(calls, ["sum set", "sum set", "sum step", "sum set", "sum step", "sum terminate", "sum free"]);
}

#[test]
fn feed_through_is_consistent_right_after_initialization() {
    let mut system = System::new("twice");
    system.add_model("second", double());
    system.add_model("first", double());
    system.add_model("source", oscillator(3.0));
    system.connect("first.y", "second.u");
    let identity = |from: &str, to: &str| swayless::system::Connection {
        from: from.to_owned(),
        to: to.to_owned(),
        factor: -1.0,
        offset: 0.5,
        convert_units: true,
        place: String::new(),
    };
    system.add_connection(identity("source.x", "first.u"));
    for algorithm in BOTH {
        let (_, recording) = run(&system, &options(algorithm, 0.1, 0.1));
        assert_eq!(recording.column("first.y").unwrap()[0], 2.0 * (0.5 - 3.0));
        assert_eq!(recording.column("second.y").unwrap()[0], 4.0 * (0.5 - 3.0));
    }
}

#[test]
fn time_is_multiplied_and_never_summed_up() {
    let (summary, recording) = run(&chain(), &options(AlgorithmKind::Jacobi, 30.0, 0.1));
    assert_eq!((summary.steps, summary.stop_time), (300, 30.0));
    for (n, &t) in recording.times.iter().enumerate().take(300) {
        assert_eq!(t, n as f64 * 0.1);
    }
    assert_eq!(recording.times[300], 30.0);
}

#[test]
fn a_last_step_may_be_shorter() {
    let (summary, recording) = run(&chain(), &options(AlgorithmKind::GaussSeidel, 1.0, 0.3));
    assert_eq!(summary.steps, 4);
    assert_eq!(*recording.times.last().unwrap(), 1.0);
    assert_eq!(last(&recording, "ramp.y"), 1.0);
}

#[test]
fn samples_keep_to_the_output_interval() {
    let mut options = options(AlgorithmKind::GaussSeidel, 1.0, 0.01);
    options.output_interval = Some(0.25);
    options.output_variables = vec!["sum.x".to_owned(), "sum.u".to_owned()];
    let (_, recording) = run(&chain(), &options);
    assert_eq!(recording.times, [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(recording.names, ["sum.x", "sum.u"]);
    // An input is recorded as it follows from the outputs of the same instant.
    assert_eq!(recording.column("sum.u").unwrap(), [0.0, 0.5, 1.0, 1.5, 2.0]);
    options.output_interval = Some(0.015);
    assert!(matches!(simulate(&chain(), &options, &mut ()), Err(Error::Option(_))));
}

#[test]
fn signals_drive_inputs() {
    let mut system = System::new("one");
    system.add_model("sum", sum());
    system.set_input_signals(InputSignals::read("in.csv", b"time,u\n0,0\n1,1\n1,5\n2,5\n").unwrap());
    let (_, recording) = run(
        &system,
        &Options {
            output_variables: vec!["u".to_owned(), "sum.x".to_owned()],
            ..options(AlgorithmKind::Jacobi, 3.0, 0.5)
        },
    );
    assert_eq!(recording.column("sum.u").unwrap(), [0.0, 0.5, 5.0, 5.0, 5.0, 5.0, 5.0]);
    assert_eq!(last(&recording, "sum.x"), 0.5 * (0.0 + 0.5 + 5.0 * 4.0));
}

#[test]
fn arrays_are_connected_whole_and_by_elements() {
    let variables = r#"
        <Float64 name="u" valueReference="0" causality="input" start="1 2 3"><Dimension start="3"/></Float64>
        <Float64 name="y" valueReference="1" causality="output"><Dimension start="3"/></Float64>"#;
    let structure =
        r#"<Output valueReference="1" dependencies="0"/><InitialUnknown valueReference="1" dependencies="0"/>"#;
    let copy = |values: &mut Values| {
        values.insert(1, values[&0].clone());
    };
    let array = || mock("Array", variables, structure, copy, rest);
    let mut system = System::new("arrays");
    system.add_model("ramp", ramp());
    system.add_model("a", array());
    system.add_model("b", array());
    system.connect("ramp.y", "a.u[2]");
    system.connect("a.y", "b.u");
    system.set_start_value("a.u[3]", "7");
    let (_, recording) = run(&system, &options(AlgorithmKind::GaussSeidel, 1.0, 0.5));
    assert_eq!(["b.y[1]", "b.y[2]", "b.y[3]"].map(|name| last(&recording, name)), [1.0, 1.0, 7.0]);
}

#[test]
fn types_are_carried_over_and_integers_widen_to_floats() {
    let source = mock(
        "Source",
        r#"<Int32 name="n" valueReference="0" causality="output" initial="exact" start="3"/>
           <Boolean name="b" valueReference="1" causality="output" initial="exact" start="true"/>"#,
        r#"<Output valueReference="0" dependencies=""/><Output valueReference="1" dependencies=""/>"#,
        |_| {},
        rest,
    );
    let sink = mock(
        "Sink",
        r#"<Float64 name="x" valueReference="0" causality="input" start="0"/>
           <Int64 name="n" valueReference="1" causality="input" start="0"/>
           <Boolean name="b" valueReference="2" causality="input" start="false"/>"#,
        "",
        |_| {},
        rest,
    );
    let mut system = System::new("types");
    system.add_model("source", source);
    system.add_model("sink", sink);
    system.connect("source.n", "sink.x");
    system.connect("source.n", "sink.n");
    system.connect("source.b", "sink.b");
    let mut options = options(AlgorithmKind::GaussSeidel, 1.0, 0.5);
    options.output_variables = ["x", "n", "b"].map(|name| format!("sink.{name}")).to_vec();
    let (_, recording) = run(&system, &options);
    assert_eq!(["sink.x", "sink.n", "sink.b"].map(|name| last(&recording, name)), [3.0, 3.0, 1.0]);
}

#[test]
fn nan_stops_the_run_at_its_source() {
    let bad = mock(
        "Bad",
        r#"<Float64 name="y" valueReference="0" causality="output" initial="exact" start="0"/>"#,
        r#"<Output valueReference="0" dependencies=""/>"#,
        |_| {},
        |values, t, _| {
            values.insert(0, vec![if t > 0.6 { f64::NAN } else { t }]);
            Ok(Step::Completed)
        },
    );
    for algorithm in BOTH {
        let mut system = System::new("bad");
        system.add_model("bad", bad.clone());
        system.add_model("sum", sum());
        system.connect("bad.y", "sum.u");
        match simulate(&system, &options(algorithm, 2.0, 0.25), &mut ()) {
            Err(Error::NotANumber { variable, .. }) => assert_eq!(variable, "bad.y"),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_failed_step_names_all_and_frees_all() {
    let failing = mock(
        "Failing",
        "",
        "",
        |_| {},
        |_, t, _| match t {
            t if t < 0.5 => Ok(Step::Completed),
            _ => Err(Failure::new("fmi3DoStep", Status::Discard, "the rope broke")),
        },
    );
    let well = sum();
    let mut system = System::new("failing");
    system.add_model("well", well.clone());
    system.add_model("crane", failing.clone());
    let error = simulate(&system, &options(AlgorithmKind::Jacobi, 1.0, 0.25), &mut ()).unwrap_err();
    let text = error.to_string();
    for part in ["`crane`", "t = 0.5 s", "0.25 s", "fmi3DoStep returned Discard", "the rope broke"] {
        assert!(text.contains(part), "{text}");
    }
    assert_eq!(well.log.lock().unwrap().last().unwrap(), "well free");
    assert!(well.log.lock().unwrap().contains(&"well terminate".to_owned()));
}

#[test]
fn an_instance_may_end_the_run() {
    let ending = mock(
        "Ending",
        "",
        "",
        |_| {},
        |_, t, h| match t {
            t if t < 0.5 => Ok(Step::Completed),
            t => Ok(Step::Terminated(t + h)),
        },
    );
    let mut system = System::new("ending");
    system.add_model("end", ending);
    system.add_model("sum", sum());
    let (summary, recording) = run(&system, &options(AlgorithmKind::GaussSeidel, 9.0, 0.25));
    assert_eq!((summary.stop_time, summary.steps), (0.75, 3));
    assert_eq!(summary.terminated_by.as_deref(), Some("end"));
    assert_eq!(*recording.times.last().unwrap(), 0.75);
}

proptest! {
    /// Whatever the step, Gauss–Seidel and Jacobi agree with the sums that define them, and runs repeat bit by bit.
    #[test]
    fn runs_repeat(step in 0.01..0.5f64, steps in 1..40u32) {
        let stop = step * f64::from(steps);
        for algorithm in BOTH {
            let first = run(&oscillators(), &options(algorithm, stop, step)).1;
            let second = run(&oscillators(), &options(algorithm, stop, step)).1;
            prop_assert_eq!(&first, &second);
            prop_assert_eq!(first.times.len(), steps as usize + 1);
        }
    }
}
