//! `swayless shaper` from outside.

mod drives;
mod requests;
mod shown;
mod words;

use std::collections::BTreeMap;

use serde_json::Value;

use crate::exits;

fn json(arguments: &[&str]) -> Value {
    let (stdout, _) = exits(&[&["shaper", "--json"], arguments].concat(), 0);
    serde_json::from_str(&stdout).expect("JSON")
}

/// The shapers of an answer by kind.
fn shapers(answer: &Value) -> BTreeMap<&str, &Value> {
    let list = answer["shapers"].as_array().expect("a list");
    list.iter().map(|shaper| (shaper["kind"].as_str().expect("a name"), shaper)).collect()
}

fn number(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer} is no number in {value:#}"))
}

#[track_caller]
fn close(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} within {tolerance:e}");
}

/// Durations in periods and insensitivities at 5 %, undamped, as the literature prints them (Singhose's tables).
const PUBLISHED: [(&str, f64, f64); 10] = [
    ("ZV", 0.5, 0.0637),
    ("ZVD", 1.0, 0.2871),
    ("ZVDD", 1.5, 0.4804),
    ("ZVDDD", 2.0, 0.6271),
    ("EI", 1.0, 0.3995),
    ("TwoHumpEI", 1.5, 0.7245),
    ("ThreeHumpEI", 2.0, 0.9639),
    ("SI", 1.002, 0.4),
    ("UMZV", 0.3333, 0.0551),
    ("UMZVD", 0.7325, 0.2586),
];

#[test]
fn the_published_numbers_come_out() {
    let answer = json(&["--hertz", "0.5"]);
    let shapers = shapers(&answer);
    for (kind, periods, insensitivity) in PUBLISHED {
        let shaper = shapers[kind];
        // to the digits printed; the table of SI has three
        close(0.5 * number(shaper, "/delay"), periods, if kind == "SI" { 5e-4 } else { 5e-5 });
        close(number(shaper, "/modes/0/insensitivity"), insensitivity, 5e-5);
        let impulses = shaper["impulses"].as_array().unwrap();
        close(impulses.iter().map(|impulse| number(impulse, "/amplitude")).sum(), 1.0, 1e-12);
        assert_eq!(impulses.last().map(|impulse| number(impulse, "/time")), Some(number(shaper, "/delay")));
    }
    close(number(&answer, "/modes/0/period"), 2.0, 1e-12);
    assert_eq!(number(shapers["UMZV"], "/gain"), 3.0);
    assert_eq!(shapers["UMZV"]["exceeds_command"], true);
    assert_eq!(shapers["ZV"]["exceeds_command"], false);
}

#[test]
fn the_table_says_what_the_json_says() {
    let arguments = ["--length", "10", "--damping", "0.02", "--range", "7..12"];
    let answer = json(&arguments);
    let (stdout, stderr) = exits(&[&["shaper"], &arguments[..]].concat(), 0);
    assert_eq!(stderr, "");
    for (kind, shaper) in shapers(&answer) {
        let row = stdout.lines().find(|line| line.split_whitespace().next() == Some(kind)).expect("a row");
        let cells: Vec<&str> = row.split_whitespace().filter(|cell| !["s", "%"].contains(cell)).collect();
        let cell = |place: usize| cells[place].parse::<f64>().expect("a number");
        // four significant digits of the delay, three of V, four decimals of the insensitivity
        close(cell(1), number(shaper, "/delay"), 5.1e-4 * number(shaper, "/delay"));
        assert_eq!(cell(3) as usize, shaper["impulses"].as_array().unwrap().len(), "{row}");
        close(0.01 * cell(4), number(shaper, "/modes/0/residual"), 5.1e-3 * number(shaper, "/modes/0/residual") + 1e-9);
        close(0.01 * cell(5), number(shaper, "/modes/0/worst/residual"), 5.1e-3);
        close(cell(6), number(shaper, "/modes/0/insensitivity"), 5.1e-5);
    }
    for refused in answer["refused"].as_array().unwrap() {
        assert!(stdout.contains(refused["reason"].as_str().unwrap()));
    }
    let in_one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(in_one_line(&stdout).contains(&in_one_line(answer["recommendation"]["text"].as_str().unwrap())));
}

#[test]
fn modes_come_from_lengths_frequencies_or_hertz() {
    let of_length = json(&["--length", "10", "--gravity", "10", "--range", "4..40", "--kind", "ZV"]);
    close(number(&of_length, "/modes/0/frequency"), 1.0, 1e-15);
    close(number(&of_length, "/modes/0/range/low"), 0.5, 1e-15);
    close(number(&of_length, "/modes/0/range/high"), (10.0_f64 / 4.0).sqrt(), 1e-15);
    let turn = std::f64::consts::TAU;
    let hertz = json(&["--hertz", "0.5", "--range", "0.4..0.6", "--kind", "ZV"]);
    close(number(&hertz, "/modes/0/range/low"), 0.4 * turn, 1e-12);
    let radians = json(&["--frequency", &format!("{}", 0.5 * turn), "--insensitivity", "0.4", "--kind", "ZV"]);
    close(number(&radians, "/modes/0/range/low"), number(&hertz, "/modes/0/range/low"), 1e-12);
    close(number(&radians, "/shapers/0/delay"), number(&hertz, "/shapers/0/delay"), 1e-12);
    // (6.3) for a hook on 8 m with half its mass on 3 m below it
    let double = json(&[
        "--length",
        "8",
        "--rigging-length",
        "3",
        "--mass-ratio",
        "0.5",
        "--range",
        "6..9",
        "--kind",
        "Convolved",
    ]);
    close(number(&double, "/modes/0/frequency"), 1.0284, 5e-5);
    close(number(&double, "/modes/1/frequency"), 2.3847, 5e-5);
    let hook_alone = json(&["--length", "8", "--rigging-length", "3", "--mass-ratio", "0", "--kind", "ZV"]);
    assert_eq!(hook_alone["modes"], json(&["--length", "8", "--kind", "ZV"])["modes"]);
    let of_9 = json(&["--length", "9", "--rigging-length", "3", "--mass-ratio", "0.5", "--kind", "Convolved"]);
    assert_eq!(number(&double, "/modes/1/range/low"), number(&of_9, "/modes/1/frequency"));
}

#[test]
fn the_worst_of_the_range_is_where_it_is_said_to_be() {
    // V of ZV, undamped: |cos(πω/2ω₀)|, highest at the end that is farther away.
    let answer = json(&["--frequency", "2", "--range", "1.8..2.1", "--kind", "ZV"]);
    let worst = &answer["shapers"][0]["modes"][0]["worst"];
    close(number(worst, "/frequency"), 1.8, 1e-12);
    close(number(worst, "/residual"), (0.25 * std::f64::consts::PI * 1.8).cos(), 1e-12);
}

/// SI within `Convolved` is for the range, as SI alone is.
#[test]
fn convolved_specified_insensitivities_keep_the_limit_over_both_ranges() {
    for insensitivity in ["0.1", "0.6"] {
        let modes = ["--frequency", "1", "--frequency", "4.4", "--insensitivity", insensitivity];
        let answer = json(&[&modes[..], &["--base-kind", "SI", "--kind", "Convolved"]].concat());
        let shaper = &answer["shapers"][0];
        for mode in [0, 1] {
            assert!(number(shaper, &format!("/modes/{mode}/worst/residual")) <= 0.05 + 1e-6);
        }
        close(number(shaper, "/parameters/insensitivity"), insensitivity.parse().unwrap(), 1e-12);
        // no longer than each for itself
        let alone = |frequency: &str| {
            let mode = ["--frequency", frequency, "--insensitivity", insensitivity, "--kind", "SI"];
            number(&json(&mode), "/shapers/0/duration")
        };
        close(number(shaper, "/duration"), alone("1") + alone("4.4"), 1e-9);
    }
    // Beside another kind only that of SI counts, and the other stays at its mode.
    let ranges = ["--frequency", "1", "--frequency", "4.4", "--range", "0.9..1.3", "--range", "4.3..4.7"];
    let mixed = ["--kind", "Convolved", "--base-kind", "ZVD", "--base-kind", "SI"];
    let answer = json(&[&ranges[..], &mixed].concat());
    let parameters = &answer["shapers"][0]["parameters"];
    close(number(parameters, "/mode.frequency[1]"), 1.0, 1e-12);
    close(number(parameters, "/mode.frequency[2]"), 4.5, 1e-12);
    close(number(parameters, "/insensitivity"), 0.4 / 4.5, 1e-9);
}
