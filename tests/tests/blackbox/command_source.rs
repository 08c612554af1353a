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

/// (1, K)/(1 + K) at 0 and half a damped period, which here is 3/4 s: of either step, of both, of none.
#[test]
fn partly_shaped() {
    let zeta: f64 = 0.1;
    let frequency = std::f64::consts::PI / 0.75 / (1.0 - zeta * zeta).sqrt();
    let first = 1.0 / (1.0 + (-zeta * std::f64::consts::PI / (1.0 - zeta * zeta).sqrt()).exp());
    for (start, stop) in [(false, true), (true, false), (true, true), (false, false)] {
        let more = [
            ("mode.frequency", frequency.into()),
            ("mode.damping_ratio", zeta.into()),
            ("shaped.start", start.into()),
            ("shaped.stop", stop.into()),
            // The times in the middle between two communication points, so that rounding does not matter.
            ("start_time", (1.5 + 1.0 / 128.0).into()),
        ];
        let half = |shaped: bool, since: f64| match since {
            since if since < 0.0 => 0.0,
            since if since < 0.75 && shaped => first,
            _ => 1.0,
        };
        gives(&shaped("PartlyShaped", &more), |t| {
            0.7 * (half(start, t - 1.5 - 1.0 / 128.0) - half(stop, t - 3.75 - 1.0 / 128.0))
        });
    }
}

/// Each for a quarter of its own period; after two the hoist is at rest.
#[test]
fn hoist_pulses_alternate_and_leave_the_hoist_at_rest() {
    let gravity: f64 = 9.81;
    for amplitude in [2.0_f64, -1.5] {
        let values: [(&str, Set<'_>); 5] = [
            ("kind", "HoistPulses".into()),
            ("amplitude", amplitude.into()),
            ("start_time", 0.5.into()),
            ("mode.frequency", 2.0.into()),
            ("pulse.count", 5.into()),
        ];
        let mut source = Instance::started("CommandSource", 1e-3, &values);
        let (mut lengths, mut values, mut last) = (Vec::new(), Vec::new(), 0.0);
        while source.time() < 6.0 {
            source.step();
            let value = source.get("command");
            if value != last {
                values.push(value);
                lengths.push(source.time());
            }
            last = value;
        }
        let lengths: Vec<f64> = lengths.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert_eq!((values.len(), values[5], values[0]), (6, 0.0, amplitude));
        assert_eq!((values[2], values[4], values[3]), (values[0], values[0], values[1]));
        for (value, length) in values.iter().zip(&lengths) {
            let quarter = std::f64::consts::FRAC_PI_2 / (2.0 * (1.0 + value / gravity).sqrt());
            assert!((length - quarter).abs() <= 1e-3 + 1e-9, "{length} s, not {quarter} s");
        }
        // The velocities that the pulses give take each other back.
        let quarter = |value: f64| value / (1.0 + value / gravity).sqrt();
        assert!((quarter(values[0]) + quarter(values[1])).abs() < 1e-12, "{values:?}");
    }
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
