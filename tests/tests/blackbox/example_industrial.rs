//! What the example of the industrial crane shows, with drive, camera and laser in the loop: a move of 1.25 m that ends where it
//! should and leaves no swing, by a plan and with the shaper in the loop, and a push that is damped.

use std::collections::BTreeMap;

use swayless::{CsvWriter, Options, System, simulate};
use swayless_modeldesc::types::FmiVersion;

use crate::packaged::{self, repository};

const TARGET: f64 = 6.25;

/// The trolley less its target (mm), the hook's displacement (mm), and whether the controller says that it is done.
struct Course(Vec<(f64, f64, f64, bool)>);

fn run(starts: &[(&str, &str)], until: f64) -> Course {
    let path = repository().join("examples/industrial-crane/SystemStructure.ssd");
    let folder = packaged::all().folder(FmiVersion::V3);
    let mut system = System::open_with_fmus(path, &folder).unwrap_or_else(|error| panic!("{error}"));
    starts.iter().for_each(|(name, value)| system.set_start_value(*name, *value));
    let columns = [
        "crane.trolley.x",
        "crane.hook.displacement.radial",
        "trolley_controller.at_target",
        "trolley_controller.settled",
        "crane.at_limit",
    ];
    let options = Options {
        step_size: Some(0.02),
        stop_time: Some(until),
        output_variables: columns.map(str::to_owned).to_vec(),
        ..Options::default()
    };
    let mut csv = CsvWriter::new("memory", Vec::new());
    simulate(&system, &options, &mut csv).unwrap_or_else(|error| panic!("{error}"));
    let text = String::from_utf8(csv.into_inner().expect("memory")).expect("text");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let place: BTreeMap<&str, usize> = names.iter().enumerate().map(|(i, name)| (*name, i)).collect();
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let field = |name: &str| fields[place[name]];
        let number = |name: &str| field(name).parse::<f64>().expect("a number");
        let flag = |name: &str| matches!(field(name), "1" | "true");
        assert!(!flag("crane.at_limit"));
        let done = flag("trolley_controller.at_target") && flag("trolley_controller.settled");
        let hook = 1e3 * number("crane.hook.displacement.radial");
        (number("time"), 1e3 * (number("crane.trolley.x") - TARGET), hook, done)
    };
    Course(lines.map(row).collect())
}

/// What a move was like (mm, s).
#[derive(Debug)]
struct Move {
    error: f64,
    residual: f64,
    overshoot: f64,
    /// When trolley and hook are within 5 mm for good, and when the controller says so first.
    settled: f64,
    told: f64,
}

impl Course {
    fn between(&self, from: f64, to: f64) -> impl Iterator<Item = &(f64, f64, f64, bool)> {
        self.0.iter().filter(move |(time, ..)| (from..to).contains(time))
    }

    /// The hook's greatest displacement (mm).
    fn hook(&self, from: f64, to: f64) -> f64 {
        self.between(from, to).map(|(_, _, hook, _)| hook.abs()).fold(0.0, f64::max)
    }

    fn judge(&self) -> Move {
        let (end, error, ..) = self.0[self.0.len() - 1];
        let away = |row: &&(f64, f64, f64, bool)| row.1.abs().max(row.2.abs()) > 5.0;
        Move {
            error: error.abs(),
            residual: self.hook(end - 6.11, f64::INFINITY),
            overshoot: self.0.iter().map(|row| row.1).fold(0.0, f64::max),
            settled: self.0.iter().rev().find(away).map_or(0.0, |row| row.0),
            told: self.0.iter().find(|row| row.3).map_or(f64::INFINITY, |row| row.0),
        }
    }

    fn envelope(&self) -> [f64; 3] {
        [10.0, 20.0, 40.0].map(|time| self.hook(time, time + 6.11))
    }
}

const NO_PUSH: (&str, &str) = ("push.amplitude", "0");

#[test]
fn a_planned_move_is_exact_and_settles_in_ten_seconds() {
    let found = run(&[NO_PUSH], 20.0).judge();
    println!("planned: {found:.2?}");
    assert!(found.error < 5.0 && found.residual < 5.0 && found.overshoot < 20.0 && found.settled < 10.0, "{found:?}");
    assert!(found.told < 10.0, "{found:?}");
}

/// As much gain as the prediction allows.
const IN_LOOP: [(&str, &str); 2] = [("trolley_controller.form", "InLoop"), ("trolley_controller.position_gain", "1.5")];

#[test]
fn a_move_with_the_shaper_in_the_loop_is_exact_and_settles_in_ten_seconds() {
    let found = run(&[&[NO_PUSH], &IN_LOOP[..]].concat(), 20.0).judge();
    println!("in the loop: {found:.2?}");
    assert!(found.error < 5.0 && found.residual < 5.0 && found.overshoot < 20.0 && found.settled < 10.0, "{found:?}");
    assert!(found.told < 10.0, "{found:?}");
}

#[test]
fn without_a_prediction_a_move_takes_twenty_seconds_or_overshoots() {
    let plain = [NO_PUSH, ("trolley_controller.form", "PlainLoop")];
    let found = run(&plain, 40.0).judge();
    println!("without a prediction: {found:.2?}");
    assert!(found.error < 5.0 && found.residual < 5.0 && found.overshoot < 20.0, "{found:?}");
    assert!((15.0..30.0).contains(&found.settled), "{found:?}");
    let hasty = run(&[&plain[..], &[("trolley_controller.position_gain", "0.25")]].concat(), 40.0).judge();
    println!("with K_p = 0.25: {hasty:.2?}");
    assert!(hasty.overshoot > 100.0, "{hasty:?}");
}

/// Plain feedback with k = 2 of a swing that is seen at once leaves 242.4, 122.8 and 39.2 mm: so an independent simulation.
#[test]
fn a_push_decays_faster_than_with_plain_feedback_that_sees_at_once() {
    let pushed = [
        NO_PUSH,
        ("crane.hook.swing.radial_start", "0.1"),
        ("crane.payload.swing.radial_start", "0.1"),
        ("trolley_controller.mode", "Hold"),
    ];
    for more in [
        &[("trolley_controller.form", "Planned")][..],
        &IN_LOOP,
        &[("trolley_controller.form", "PlainLoop")],
        &[("trolley_controller.mode", "Manual")],
    ] {
        let course = run(&[&pushed[..], more].concat(), 47.0);
        let found = course.envelope();
        println!("{more:?}: {found:.1?} mm");
        assert!(found.iter().zip([242.4, 122.8, 39.2]).all(|(found, plain)| *found < plain), "{more:?}: {found:?} mm");
    }
}

#[test]
fn a_push_on_the_load_does_not_move_the_crane_for_good() {
    let course = run(&[], 60.0);
    let [most, left] = [course.hook(20.0, 40.0), course.hook(53.0, 60.0)];
    let (_, place, ..) = course.0[course.0.len() - 1];
    println!("{most:.0} mm, then {left:.1} mm; the trolley {place:.1} mm from its target");
    assert!(most > 200.0 && left < 0.08 * most, "{left} mm of {most} mm");
    assert!(place.abs() < 10.0, "{place} mm");
}
