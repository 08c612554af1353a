//! `CommandSource`: exact values at every communication point.

use crate::instance::{Instance, Set};
use crate::packaged::repository;

/// Compares the command at every step of 1/64 s, so that communication points and instants are exact numbers.
#[track_caller]
fn gives(values: &[(&str, Set<'_>)], wanted: impl Fn(f64) -> f64) {
    let mut source = Instance::started("CommandSource", 1.0 / 64.0, values);
    for _ in 0..640 {
        let (t, found) = (source.time(), source.get("command"));
        assert!((found - wanted(t)).abs() <= 4.0 * f64::EPSILON, "at {t} s: {found}, not {}", wanted(t));
        source.step();
    }
}

fn shaped<'a>(kind: &'a str, more: &[(&'a str, Set<'a>)]) -> Vec<(&'a str, Set<'a>)> {
    let common =
        [("kind", kind.into()), ("amplitude", 0.7.into()), ("start_time", 1.5.into()), ("duration", 2.25.into())];
    common.into_iter().chain(more.iter().copied()).collect()
}

#[test]
fn constant() {
    gives(&shaped("Constant", &[]), |_| 0.7);
}

#[test]
fn step() {
    gives(&shaped("Step", &[]), |t| if t < 1.5 { 0.0 } else { 0.7 });
}

#[test]
fn pulse() {
    gives(&shaped("Pulse", &[]), |t| if (1.5..3.75).contains(&t) { 0.7 } else { 0.0 });
}

#[test]
fn trapezoid() {
    let ramp = 0.5;
    gives(&shaped("Trapezoid", &[("ramp_time", ramp.into())]), |t| {
        let (up, down) = ((t - 1.5) / ramp, 1.0 - (t - 3.75) / ramp);
        0.7 * up.min(down).clamp(0.0, 1.0)
    });
    // Without ramps it is a pulse.
    gives(&shaped("Trapezoid", &[("ramp_time", 0.0.into())]), |t| if (1.5..3.75).contains(&t) { 0.7 } else { 0.0 });
}

/// `data/command.csv`: times and values.
const ROWS: [(f64, f64); 5] = [(0.0, 0.0), (0.5, 1.0), (1.25, 0.4), (3.0, -0.6), (7.125, 0.0)];

#[test]
fn playback_holds_or_interpolates() {
    let file = repository().join("tests/data/command.csv");
    let file = file.to_str().expect("a path in UTF-8");
    let with = |interpolation| {
        [
            ("kind", Set::Text("Playback")),
            ("file", file.into()),
            ("column", "command".into()),
            ("interpolation", Set::Text(interpolation)),
            ("start_time", 0.25.into()),
        ]
    };
    let begun = |t: f64| ROWS.iter().rposition(|(time, _)| *time <= t - 0.25);
    gives(&with("Hold"), |t| ROWS[begun(t).unwrap_or(0)].1);
    gives(&with("Linear"), |t| {
        let Some(i) = begun(t) else { return ROWS[0].1 };
        let ((t0, v0), Some((t1, v1))) = (ROWS[i], ROWS.get(i + 1)) else { return ROWS[i].1 };
        v0 + (v1 - v0) * (t - 0.25 - t0) / (t1 - t0)
    });
}

#[test]
fn a_missing_file_or_column_is_named() {
    let file = repository().join("tests/data/command.csv");
    let message = |values: &[(&str, Set<'_>)]| {
        let mut source = Instance::new("CommandSource", swayless_modeldesc::types::FmiVersion::V2, 0.1);
        values.iter().for_each(|(name, value)| source.set(name, *value).expect("a value"));
        let failure = source.initialize(None).expect_err("no file, no start");
        failure.messages.iter().map(|m| m.text.clone()).collect::<String>()
    };
    let playback = ("kind", Set::Text("Playback"));
    assert!(message(&[playback]).contains("file"));
    let text = message(&[playback, ("file", "no/such.csv".into())]);
    assert!(text.contains("no/such.csv"), "{text}");
    let file = file.to_str().expect("a path in UTF-8");
    let text = message(&[playback, ("file", file.into()), ("column", "slew".into())]);
    assert!(text.contains("column") && text.contains("slew") && text.contains("command"), "{text}");
}
