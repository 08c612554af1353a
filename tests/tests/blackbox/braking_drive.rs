//! `BrakingDrive` against the exact solution from event to event, and against the swing that pulses leave under it.
//!
//! `data/braking_drive.json` has the residuals of a payload at 0.84 m under a trolley that is driven at 0.17 m/s for
//! some time, as shaped commands leave them; they were computed from event to event as well.

use std::f64::consts::TAU;

use serde_json::Value as Json;

use crate::instance::{Instance, Set, noise};
use crate::packaged::repository;
use crate::pendulum::Pendulum;

const ACCELERATING: f64 = 0.2;
const BRAKING: f64 = 0.065;

/// A drive with these time constants.
fn started(step: f64, accelerating: f64, braking: f64) -> Instance {
    let values = [("acceleration_time_constant", accelerating), ("braking_time_constant", braking)];
    Instance::started("BrakingDrive", step, &values.map(|(name, value)| (name, Set::Real(value))))
}

/// The axis as exponentials from event to event.
#[derive(Debug, Clone, Copy)]
struct Axis {
    velocity: f64,
    position: f64,
    constant: f64,
    target: f64,
}

impl Axis {
    const AT_REST: Self = Self { velocity: 0.0, position: 0.0, constant: ACCELERATING, target: 0.0 };

    fn command(&mut self, target: f64) {
        self.target = target;
        let grows = self.velocity * (target - self.velocity) >= 0.0;
        self.constant = if grows { ACCELERATING } else { BRAKING };
    }

    fn decay(&mut self, duration: f64) {
        let away = self.velocity - self.target;
        let left = (-duration / self.constant).exp();
        self.position += self.target * duration + away * self.constant * (1.0 - left);
        self.velocity = self.target + away * left;
    }

    fn advance(&mut self, duration: f64) {
        let mut rest = duration;
        if self.velocity * self.target < 0.0 {
            let stops = self.constant * ((self.target - self.velocity) / self.target).ln();
            if stops <= rest {
                self.decay(stops);
                self.velocity = 0.0;
                self.constant = ACCELERATING;
                rest -= stops;
            }
        }
        self.decay(rest);
    }
}

#[test]
fn random_commands_give_the_exact_solution() {
    let (mut drive, mut axis, mut random) = (started(0.03, ACCELERATING, BRAKING), Axis::AT_REST, noise());
    let mut reversals = 0;
    for _ in 0..300 {
        let command = match random() {
            rest if rest < -0.7 => 0.0,
            _ => random(),
        };
        drive.set("command", command).expect("a command");
        axis.command(command);
        reversals += u32::from(axis.velocity * command < 0.0);
        for _ in 0..=(random().abs() * 20.0) as u32 {
            drive.step();
            axis.advance(0.03);
            let (velocity, position) = (drive.get("velocity"), drive.get("position"));
            let t = drive.time();
            assert!((velocity - axis.velocity).abs() < 1e-10, "at {t} s: velocity {velocity}, exact {axis:?}");
            assert!((position - axis.position).abs() < 1e-9, "at {t} s: position {position}, exact {axis:?}");
            let acceleration = (axis.target - axis.velocity) / axis.constant;
            assert!((drive.get("acceleration") - acceleration).abs() < 2e-9, "at {t} s: acceleration");
        }
    }
    assert!(reversals > 50, "{reversals} reversals");
}

/// A step that ends where the axis turns back finds it at rest, not merely slow.
#[test]
fn the_axis_turns_back_from_exactly_0() {
    for (before, command) in [(1.0, -0.5), (-0.2, 0.7), (0.3, -1e-300)] {
        let mut drive = started(4.0, ACCELERATING, BRAKING);
        drive.set("command", before).expect("a command");
        drive.step();
        drive.set("command", command).expect("a command");
        let stops = BRAKING * ((command - drive.get("velocity")) / command).ln();
        drive.slave.do_step(4.0, stops).expect("a step");
        assert_eq!(drive.get("velocity"), 0.0, "from {before} to {command}");
    }
}

/// Impulses: times and amplitudes.
type Shaper = [(f64, f64)];

/// What a pulse becomes: the shaper's impulses at its begin, those for braking at its end.
fn shaped(pulse: f64, velocity: f64, up: &Shaper, down: &Shaper) -> Vec<(f64, f64)> {
    let begin = up.iter().map(|&(time, amplitude)| (time, amplitude * velocity));
    let end = down.iter().map(|&(time, amplitude)| (pulse + time, -amplitude * velocity));
    let mut changes: Vec<_> = begin.chain(end).collect();
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut sum = 0.0;
    let commands = changes.into_iter().map(|(time, change)| {
        sum += change;
        // The sum of what cancels is nothing, not a rounding error with a sign.
        (time, if sum.abs() < 1e-12 { 0.0 } else { sum })
    });
    commands.collect()
}

#[test]
fn pulses_leave_the_swing_that_theory_says() {
    let text = std::fs::read_to_string(repository().join("tests/data/braking_drive.json")).expect("the reference");
    let json: Json = serde_json::from_str(&text).expect("JSON");
    let number = |value: &Json| value.as_f64().expect("a number");
    let (length, gravity, velocity) = (number(&json["length"]), number(&json["gravity"]), number(&json["velocity"]));
    let period = TAU * (length / gravity).sqrt();
    for case in json["cases"].as_array().expect("cases") {
        let times = |which: &str| {
            let times = case["UMZVc impulse times"][which].as_array().expect("times");
            [(number(&times[0]), 1.0), (number(&times[1]), -1.0), (number(&times[2]), 1.0)]
        };
        let umzv = [(0.0, 1.0), (period / 6.0, -1.0), (period / 3.0, 1.0)];
        let zv = [(0.0, 0.5), (0.5 * period, 0.5)];
        let (up, down) = (times("accelerating"), times("braking"));
        let shapers: [(&str, &Shaper, &Shaper); 4] = [
            ("unshaped", &[(0.0, 1.0)], &[(0.0, 1.0)]),
            ("ZV", &zv, &zv),
            ("UMZV", &umzv, &umzv),
            ("UMZVc", &up, &down),
        ];
        for row in case["residuals_mm"].as_array().expect("rows") {
            for (name, up, down) in shapers {
                let constants = ["acceleration_time_constant", "braking_time_constant"].map(|key| number(&case[key]));
                let mut drive = started(1.0, constants[0], constants[1]);
                let payload = Pendulum::new(length, gravity);
                let commands = shaped(number(&row["pulse"]), velocity, up, down);
                let found = 1e3 * payload.residual(&mut drive, &commands, constants[1]);
                let wanted = number(&row[name]);
                println!("{constants:?}, {} s, {name}: {found:.7} mm, reference {wanted:.7} mm", row["pulse"]);
                assert!((found - wanted).abs() < 5e-7, "{constants:?}, {row}, {name}: {found} mm");
            }
        }
    }
}

#[test]
fn commands_beyond_the_limit_are_cut() {
    let values = [("velocity_limit", Set::Real(0.5))];
    let mut drive = Instance::started("BrakingDrive", 0.01, &values);
    for (command, velocity, saturated) in [(0.4, 0.4, false), (1e308, 0.5, true), (-7.0, -0.5, true), (0.0, 0.0, false)]
    {
        drive.set("command", command).expect("a command");
        drive.run_to(drive.time() + 8.0);
        assert!((drive.get("velocity") - velocity).abs() < 1e-9, "{command}: {}", drive.get("velocity"));
        assert_eq!(drive.get_switch("saturated"), saturated, "{command}");
    }
}
