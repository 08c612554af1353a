//! `PositionController`: what it commands on a crane as it believes it to be; modes, targets, limits, and what it takes as it
//! is not. What it does on a real one is in `example_industrial`.

use swayless_modeldesc::types::FmiVersion;

use crate::instance::{Instance, Set};

const STEP: f64 = 0.02;
const ACCELERATION: f64 = 0.63;

fn controller(values: &[(&str, Set<'_>)]) -> Instance {
    let seen = [("hook.valid", Set::Switch(true)), ("position.valid", Set::Switch(true))];
    Instance::started("PositionController", STEP, &[&seen, values].concat())
}

/// An axis that follows its command at once, with a hook that hangs still. Where it is after so many steps (m).
fn run(controller: &mut Instance, mut place: f64, steps: usize) -> f64 {
    let mut before = controller.get("velocity");
    for _ in 0..steps {
        controller.set("crane.position", place).expect("a place");
        controller.step();
        let velocity = controller.get("velocity");
        assert!(velocity.abs() <= 0.75, "{velocity} m/s");
        assert!((velocity - before).abs() <= ACCELERATION * STEP * (1.0 + 1e-9), "from {before} to {velocity} m/s");
        before = velocity;
        place += velocity * STEP;
    }
    place
}

/// With sway feedback off, so that the hook that hangs still is not missed.
const STILL: [(&str, Set<'_>); 2] = [("sway_gain", Set::Real(0.0)), ("sample_time", Set::Real(0.0))];

#[test]
fn it_goes_to_stored_targets_and_to_others_and_holds() {
    let places: Vec<f64> = (0..16).map(|i| 10.0 + f64::from(i)).collect();
    for (form, gain) in [("Planned", 0.14), ("InLoop", 1.5), ("PlainLoop", 0.14)] {
        let mut controller = Instance::new("PositionController", FmiVersion::V3, STEP);
        controller.set_all("stored_target", &places);
        for (name, value) in STILL {
            controller.set(name, value).expect("a value");
        }
        controller.set("form", form).expect("a form");
        controller.set("position_gain", gain).expect("a gain");
        for name in ["hook.valid", "position.valid"] {
            controller.set(name, true).expect("a truth value");
        }
        controller.set("mode", "GoTo").expect("a mode");
        controller.set("target.index", 3).expect("an index");
        controller.set("crane.position", 11.0).expect("a place");
        controller.initialize(None).expect("initialization");
        let place = run(&mut controller, 11.0, 2000);
        assert!((place - 12.0).abs() < 1e-3, "{form}: {place} m");
        assert!(controller.get_switch("at_target") && controller.get_switch("valid"), "{form}");
        controller.set("target.index", 0).expect("an index");
        controller.set("target.position", 10.5).expect("a place");
        let place = run(&mut controller, place, 2000);
        assert!((place - 10.5).abs() < 1e-3, "{form}: {place} m");
        // Somebody moves it away by 0.1 m: it comes back, in `Hold` as well.
        controller.set("mode", "Hold").expect("a mode");
        let place = run(&mut controller, place, 400);
        let back = run(&mut controller, place + 0.1, 2500);
        assert!((back - place).abs() < 2e-3, "{form}: {back} m for {place} m");
        assert!(!controller.get_switch("at_target"), "only a target is reached");
    }
}

/// With no target and nothing seen the velocity is the operator's, shaped: it arrives when the last impulse does, 4.37 s
/// later, as four steps of a quarter each for the modes of thesis (6.3).
#[test]
fn manual_commands_are_shaped_for_both_modes() {
    let mut controller = Instance::started(
        "PositionController",
        STEP,
        &[("acceleration_limit", 1e3.into()), ("manual.velocity", 0.4.into())],
    );
    // ω = 1.028441 and 2.384677 rad/s: half periods of 3.054713 and 1.317408 s.
    for (until, wanted) in [(1.30, 0.1), (3.04, 0.2), (4.36, 0.3), (6.0, 0.4)] {
        while controller.time() < until {
            controller.step();
        }
        let found = controller.get("velocity");
        assert!((found - wanted).abs() < 1e-12, "{found} m/s at {until} s");
    }
    assert!(controller.get_switch("valid"));
}

#[test]
fn what_cannot_be_is_flagged_and_does_no_harm() {
    let cases: [(&str, Set<'_>); 6] = [
        ("target.index", 17.into()),
        ("target.index", i32::MIN.into()),
        ("target.position", 1e300.into()),
        ("hoist.length", (-1e300).into()),
        ("hook.displacement", 9.0.into()),
        ("crane.position", f64::MAX.into()),
    ];
    for (name, value) in cases {
        let mut controller = controller(&[("mode", "GoTo".into())]);
        controller.step();
        assert!(controller.get_switch("valid"), "{name}");
        controller.set(name, value).expect("any finite number");
        for _ in 0..500 {
            controller.step();
            assert!(!controller.get_switch("valid"), "{name}");
            assert!(controller.get("velocity").abs() < 1e-9, "{name}: {} m/s", controller.get("velocity"));
        }
    }
}

/// So much gain that drive and hook swing up: thesis 6.2.3 has the poles.
#[test]
fn a_loop_that_would_grow_is_told() {
    let mut controller = controller(&[("sway_gain", 60.0.into()), ("lead_time", 0.0.into())]);
    controller.step();
    assert!(!controller.get_switch("valid"));
    controller.set("sway_gain", 3.0).expect("tunable");
    controller.step();
    assert!(controller.get_switch("valid"));
}

/// With the prediction the loop knows of no delay: a gain that would swing up with the shaper's delay (more than
/// π/2 a delay, 0.7 1/s) takes the trolley to its target without overshoot, within the time of braking and shaper.
#[test]
fn the_prediction_takes_the_shapers_delay_out_of_the_loop() {
    let run_to = |form: &str| {
        let mut controller = controller(
            &[
                &STILL[..],
                &[("form", form.into()), ("position_gain", 1.5.into()), ("drive.natural_frequency", 1e3.into())],
                &[("mode", "GoTo".into()), ("target.position", 1.25.into())],
            ]
            .concat(),
        );
        let (mut place, mut farthest) = (0.0, 0.0_f64);
        for _ in 0..450 {
            place = run(&mut controller, place, 1);
            farthest = farthest.max(place);
        }
        (place, farthest)
    };
    let (place, farthest) = run_to("InLoop");
    assert!((place - 1.25).abs() < 5e-3 && farthest < 1.251, "{place} m by {farthest} m");
    let (_, farthest) = run_to("PlainLoop");
    assert!(farthest > 1.5, "{farthest} m");
}

/// Switched off while it moves, it comes to rest as fast as it may, and when it is on again it goes on from where it is.
#[test]
fn switched_off_it_runs_out() {
    let mut controller = controller(&STILL);
    controller.set("manual.velocity", 0.6).expect("a velocity");
    let place = run(&mut controller, 0.0, 400);
    assert!((controller.get("velocity") - 0.6).abs() < 1e-9);
    controller.set("enabled", false).expect("a truth value");
    // 0.6/0.63 s, in steps of 0.02 s.
    let place = run(&mut controller, place, 48);
    assert_eq!(controller.get("velocity"), 0.0);
    let place = run(&mut controller, place, 100);
    controller.set("mode", "Hold").expect("a mode");
    controller.set("enabled", true).expect("a truth value");
    let held = run(&mut controller, place, 500);
    assert!((held - place).abs() < 0.02, "{held} m for {place} m");
}
