//! Closed-loop poles and the shaper for them against those of an independent computation.

use serde_json::Value;
use swayless_control::*;
use swayless_shaping::Shaper;

pub fn reference() -> Value {
    serde_json::from_str(include_str!("data/anti_sway.json")).expect("JSON")
}

fn crane() -> Crane {
    Crane {
        pendulum: Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 },
        drive: Drive { natural_frequency: 3.7, damping_ratio: 0.75 },
    }
}

fn sway(gain: f64) -> ClosedLoop {
    closed_loop(&crane(), Feedback { sway_gain: gain, ..Feedback::default() }).expect("poles")
}

#[test]
fn poles_are_those_of_an_independent_computation() {
    let all = reference();
    let table = all["poles"].as_object().expect("gains");
    assert_eq!(table.len(), 8);
    for (gain, poles) in table {
        // The first is the trolley's place, which nothing holds.
        let found: Vec<Pole> = sway(gain.parse().expect("a gain")).poles().skip(1).collect();
        let poles = poles.as_array().expect("poles");
        assert_eq!(found.len(), poles.len());
        for (found, wanted) in found.iter().zip(poles) {
            let [frequency, damping_ratio] = [0, 1].map(|i| wanted[i].as_f64().expect("a number"));
            assert!((found.frequency / frequency - 1.0).abs() < 1e-9, "k = {gain}: {found:?} for {wanted}");
            assert!((found.damping_ratio - damping_ratio).abs() < 1e-9, "k = {gain}: {found:?} for {wanted}");
        }
    }
}

fn matches(shaper: &Shaper, wanted: &Value) {
    assert_eq!(shaper.impulses().len(), 4);
    for (i, impulse) in shaper.impulses().iter().enumerate() {
        let [time, amplitude] = ["t", "A"].map(|of| wanted[of][i].as_f64().expect("a number"));
        assert!((impulse.time - time).abs() < 1e-8 && (impulse.amplitude - amplitude).abs() < 1e-8, "{impulse:?}");
    }
}

#[test]
fn shapers_are_those_of_an_independent_computation() {
    for gain in ["0", "2"] {
        let modes = sway(gain.parse().expect("a gain")).modes().expect("modes");
        matches(&zero_vibration(modes), &reference()["shapers"][gain]);
    }
}

/// A single pendulum and a drive that is all but ideal: ζ = k/(2√(gL)).
#[test]
fn damping_of_one_pendulum_is_the_closed_form() {
    let pendulum = Pendulum { gravity: 9.81, hoist: 6.0, rigging: 3.0, mass_ratio: 0.0 };
    let crane = Crane { pendulum, drive: Drive { natural_frequency: 1e3, damping_ratio: 0.75 } };
    for gain in [0.5, 1.0, 3.0] {
        let feedback = Feedback { sway_gain: gain, ..Feedback::default() };
        let modes = closed_loop(&crane, feedback).expect("poles").modes().expect("modes");
        let (found, wanted) = (modes[0].expect("a mode").damping_ratio(), gain / (2.0 * (9.81_f64 * 6.0).sqrt()));
        // The drive lags by 1.5 ms, at 1.28 rad/s.
        assert!((found / wanted - 1.0).abs() < 0.01, "{found} for {wanted}");
        assert_eq!(modes[1], None);
    }
}

#[test]
fn a_loop_that_grows_is_told_from_one_that_does_not() {
    let is_stable = |feedback| closed_loop(&crane(), feedback).expect("poles").is_stable();
    assert!(is_stable(Feedback::default()));
    assert!(is_stable(Feedback { position_gain: 0.14, sway_gain: 3.0, lead_time: 0.4 }));
    assert!(!is_stable(Feedback { sway_gain: -0.1, ..Feedback::default() }));
    // The drive lags too much for so much of it.
    assert!(!is_stable(Feedback { sway_gain: 60.0, ..Feedback::default() }));
}
