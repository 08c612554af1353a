//! What remains behind drives: reference values, simulated drives, and the conditions under which limits do no harm.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};
use proptest::prelude::*;
use serde_json::Value;
use swayless_shaping::{
    CompensatedForm, Drive, DriveError, Impulse, Kind, Mode, NotInterchangeable, Ramp, Shaper, command_duration,
    compensated, interchangeable, limited, longest_ramp, predict, ramped_vibration, residual_amplitude,
    residual_vibration,
};

use crate::{designed, mode, shaper};

const SPEED: f64 = 0.358;
const LIMIT: Drive = Drive::RateLimit { acceleration: 0.12 };

fn data(name: &str) -> Value {
    let all: Value = serde_json::from_str(include_str!("data/limited.json")).expect("JSON");
    all[name].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn crane() -> (Mode, Ramp) {
    (mode(TAU * 0.28, 0.0), Ramp::new(SPEED, 0.12).expect("a ramp"))
}

/// The 10-ton crane's shapers by their names; SI as the reference has it.
fn named(name: &str) -> Shaper {
    let (crane, ramp) = crane();
    match name {
        "None" => Shaper::unshaped(),
        "ZV" => designed(Kind::ZV, crane.frequency(), 0.0),
        "ZVD" => designed(Kind::ZVD, crane.frequency(), 0.0),
        "EI" => designed(Kind::EI, crane.frequency(), 0.0),
        "ALZVD" => limited(crane, ramp, 0.0).expect("a design").shaper().clone(),
        "ALEI" => limited(crane, ramp, 0.05).expect("a design").shaper().clone(),
        _ => {
            let insensitivity: f64 = name.strip_prefix("SI ").expect("SI").parse().expect("a number");
            let rows = data("SI");
            let row = rows
                .as_array()
                .expect("a list")
                .iter()
                .find(|row| number(&row["insensitivity"]) == insensitivity)
                .expect("a row");
            let impulse = |pair: &Value| Impulse { time: number(&pair[0]), amplitude: number(&pair[1]) };
            Shaper::new(&row["impulses"].as_array().expect("a list").iter().map(impulse).collect::<Vec<_>>())
                .expect("a shaper")
        }
    }
}

fn left(shaper: &Shaper, hertz: f64, drive: Drive) -> f64 {
    predict(shaper, mode(TAU * hertz, 0.0), drive, SPEED).expect("a drive").shaped
}

/// With this limit ZVD leaves half as much again as no shaping at all; ALZVD and ALEI do what they are for.
#[test]
fn residuals_of_the_10_ton_crane() {
    for row in data("shapers").as_array().unwrap() {
        let shaper = named(row["name"].as_str().unwrap());
        let at_design = left(&shaper, 0.28, LIMIT);
        assert!((at_design - number(&row["at_design"])).abs() < 1e-6 * number(&row["at_design"]) + 1e-15, "{row}");
        let mean = (0..200).map(|n| left(&shaper, 0.24 + 0.08 / 199.0 * f64::from(n), LIMIT)).sum::<f64>() / 200.0;
        assert!((mean / number(&row["mean"]) - 1.0).abs() < 1e-6, "{mean} for {row}");
    }
    let curves = data("curves");
    for (index, hertz) in curves["frequency"].as_array().unwrap().iter().enumerate() {
        let hertz = number(hertz);
        for name in ["None", "ZV", "ZVD", "EI", "ALZVD", "ALEI"] {
            let (value, expected) = (left(&named(name), hertz, LIMIT), number(&curves[name][index]));
            assert!((value - expected).abs() < 1e-6 * expected + 1e-15, "{name} at {hertz} Hz: {value}");
        }
        let expected = number(&curves["step"][index]);
        assert!((left(&Shaper::unshaped(), hertz, Drive::Ideal) / expected - 1.0).abs() < 1e-12);
    }
    let (crane, _) = crane();
    assert!(predict(&named("ZVD"), crane, LIMIT, SPEED).unwrap().ratio() > 1.5);
    assert!(predict(&named("ALEI"), crane, LIMIT, SPEED).unwrap().ratio() < 0.050_000_1);
}

/// Fig. 5.5: shapers get worse with α = ωv_f/a up to where their ramps meet.
#[test]
fn degradation_up_to_where_ramps_meet() {
    let (crane, _) = crane();
    for row in data("degradation").as_array().unwrap() {
        let shaper = named(row["name"].as_str().unwrap());
        let limit = longest_ramp(&shaper) * crane.frequency();
        assert!((limit / number(&row["limit"]) - 1.0).abs() < 1e-6, "{limit} for {row}");
        let at = |alpha: f64| ramped_vibration(&shaper, crane, Ramp::new(alpha / crane.frequency(), 1.0).unwrap());
        assert!((at(limit) / number(&row["at_limit"]) - 1.0).abs() < 1e-6, "{row}");
        for point in row["points"].as_array().unwrap() {
            let (value, expected) = (at(number(&point[0])), number(&point[1]));
            assert!((value - expected).abs() < 1e-6 * expected + 1e-9, "{value} for {point} of {row}");
        }
        assert!((at(0.0) - residual_vibration(&shaper, crane.frequency(), 0.0)).abs() < 1e-15);
    }
}

/// What pulses at 0.17 m/s leave under a drive with these time constants (mm), by the shaper's name.
fn pulse(taus: [f64; 2], duration: f64) -> impl Fn(&str) -> f64 {
    let load = mode((9.81_f64 / 0.84).sqrt(), 0.0);
    let [a, b] = taus;
    let drive = Drive::FirstOrder { acceleration_time_constant: a, braking_time_constant: b };
    let design = compensated(load, a, b, CompensatedForm::ClosedForm).expect("a design");
    move |name| {
        let one = match name {
            "UMZV" => designed(Kind::UMZV, load.frequency(), 0.0),
            "ZV" => designed(Kind::ZV, load.frequency(), 0.0),
            _ => Shaper::unshaped(),
        };
        let (up, down) = if name == "UMZVc" { (&design.accelerating, &design.braking) } else { (&one, &one) };
        let train = |shaper: &Shaper, start: f64, change: f64| -> Vec<(f64, f64)> {
            shaper.impulses().iter().map(|impulse| (start + impulse.time, change * impulse.amplitude)).collect()
        };
        let mut changes = [train(up, 0.0, 0.17), train(down, duration, -0.17)].concat();
        changes.sort_by(|a, b| a.0.total_cmp(&b.0));
        1e3 * residual_amplitude(changes, load, drive, 0.0).expect("a drive")
    }
}

/// The cases of 5.2 once more, now by the prediction: pulses of 3 s.
#[test]
fn unequal_time_constants() {
    let all: Value = serde_json::from_str(include_str!("data/compensated.json")).unwrap();
    for row in all["closed"].as_array().unwrap() {
        let left = pulse(["tau_a", "tau_b"].map(|name| number(&row[name])), 3.0);
        for name in ["UMZVc", "UMZV", "ZV", "None"] {
            let (left, expected) = (left(name), number(&row["pulse"][name]));
            assert!((left - expected).abs() < 1e-6 * expected + 1e-10, "{name}: {left} for {row}");
        }
    }
}

/// Figs. 5.19, 5.24 and 5.28: pulses that are short or long, and those between, whose ends meet.
#[test]
fn pulses_of_any_duration() {
    let all: Value = serde_json::from_str(include_str!("data/pulses.json")).unwrap();
    for case in all["cases"].as_array().unwrap() {
        for row in case["rows"].as_array().unwrap() {
            let left = pulse(["tau_a", "tau_b"].map(|name| number(&case[name])), number(&row[0]));
            for (i, name) in all["columns"].as_array().unwrap().iter().enumerate().skip(1) {
                let (left, expected) = (left(name.as_str().unwrap()), number(&row[i]));
                assert!((left - expected).abs() < 1e-6 * expected + 1e-10, "{name}: {left} for {row}");
            }
        }
    }
}

/// Nothing is left behind the drive that UMZVc was made for, started and stopped.
#[test]
fn compensated_trains_behind_their_drive() {
    for zeta in [0.0, 0.1] {
        let load = mode(2.0, zeta);
        let drive = Drive::FirstOrder { acceleration_time_constant: 0.3, braking_time_constant: 0.1 };
        let design = compensated(load, 0.3, 0.1, CompensatedForm::ExactRamp).unwrap();
        assert!(predict(&design.accelerating, load, drive, -0.5).unwrap().ratio() < 1e-12);
        let down = design.braking.impulses().iter().map(|impulse| (impulse.time, -impulse.amplitude));
        assert!(residual_amplitude(down, load, drive, 1.0).unwrap() < 1e-12);
    }
}

/// A linear drive and a shaper may be exchanged, so the ratio is V; and the bare answer is that of a system of four states.
#[test]
fn a_second_order_drive_changes_nothing_but_the_scale() {
    let (load, drive) = (mode(1.1, 0.05), Drive::SecondOrder { frequency: 3.7, damping_ratio: 0.75 });
    for kind in [Kind::ZV, Kind::EI, Kind::UMZV] {
        let shaper = designed(kind, 1.0, 0.02);
        let ratio = predict(&shaper, load, drive, 0.7).unwrap().ratio();
        assert!((ratio - residual_vibration(&shaper, 1.1, 0.05)).abs() < 1e-14, "{kind}");
    }
    let (omega, zeta, w, z) = (1.1_f64, 0.05_f64, 3.7_f64, 0.75_f64);
    #[rustfmt::skip]
    let system = DMatrix::from_row_slice(4, 4, &[
        0.0, 1.0, 0.0, 0.0,
        -omega * omega, -2.0 * zeta * omega, 0.0, -1.0,
        0.0, 0.0, 0.0, 1.0,
        0.0, 0.0, -w * w, -2.0 * z * w,
    ]);
    let settle = 12.0; // e^{−33} of the drive's transient is left then
    // v counted from where it ends
    let end = (system * settle).exp() * DVector::from_vec(vec![0.0, 0.0, -0.7, 0.0]);
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let amplitude = end[0].hypot((end[1] + zeta * omega * end[0]) / damped) * (zeta * omega * settle).exp();
    let bare = predict(&Shaper::unshaped(), load, drive, 0.7).unwrap().bare;
    assert!((bare / amplitude - 1.0).abs() < 1e-11, "{bare} {amplitude}");
}

#[test]
fn theorem_1() {
    let unity = designed(Kind::UMZV, 1.0, 0.0);
    let of = |share: f64| Ramp::new(share * TAU, 1.0).unwrap();
    // UMZV's impulses are T/6 apart
    assert_eq!(interchangeable(&unity, of(0.1666)), Ok(()));
    assert!((ramped_vibration(&unity, mode(1.0, 0.0), of(0.1666))) < 1e-14);
    let error = interchangeable(&unity, of(0.167)).unwrap_err();
    let NotInterchangeable::Overlap { index, longest_ramp: most, .. } = error else { panic!("{error}") };
    assert!(index == 0 && (most - TAU / 6.0).abs() < 1e-12, "{error}");
    let error = interchangeable(&designed(Kind::ZVD, 1.0, 0.0), of(0.1)).unwrap_err();
    assert_eq!(error, NotInterchangeable::Amplitude { index: 1, value: 0.5, first: 0.25 });
    assert!(error.to_string().contains("impulse 1") && error.to_string().contains("0.25"));
    let zv = designed(Kind::ZV, 1.0, 0.0);
    assert_eq!(interchangeable(&zv, of(0.999)), Ok(()));
    assert!((command_duration(&zv, of(0.5)) - 0.75 * TAU).abs() < 1e-12);
    assert_eq!(longest_ramp(&Shaper::unshaped()), f64::INFINITY);
}

#[test]
fn drives_that_are_none() {
    let refused = |drive| predict(&Shaper::unshaped(), mode(1.0, 0.0), drive, 1.0).unwrap_err();
    for value in [0.0, -1.0, f64::NAN] {
        let error = refused(Drive::RateLimit { acceleration: value });
        assert!(matches!(error, DriveError::Acceleration { .. }) && error.to_string().contains(&value.to_string()));
        let error = refused(Drive::SecondOrder { frequency: value, damping_ratio: 0.5 });
        assert!(matches!(error, DriveError::SecondOrder(_)) && error.to_string().contains(&value.to_string()));
    }
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        for (a, b) in [(value, 1.0), (1.0, value)] {
            let error = refused(Drive::FirstOrder { acceleration_time_constant: a, braking_time_constant: b });
            assert!(matches!(error, DriveError::TimeConstant { .. }) && error.to_string().contains(&value.to_string()));
        }
    }
    assert!(matches!(
        refused(Drive::SecondOrder { frequency: 1.0, damping_ratio: f64::NAN }),
        DriveError::SecondOrder(_)
    ));
    // an overdamped drive is one
    let slow = Drive::SecondOrder { frequency: 1.0, damping_ratio: 3.0 };
    assert!(predict(&Shaper::unshaped(), mode(1.0, 0.0), slow, 1.0).unwrap().bare < 0.2);
}

/// ∫v̇ e^{σ(t−t_e)}dt/ω_d of a drive stepped through time, v taken as straight between steps.
fn stepped(changes: &[(f64, f64)], mode: Mode, end: f64, settle: f64, rate: impl Fn(f64, f64) -> f64) -> f64 {
    let sigma = Complex::new(mode.damping_ratio() * mode.frequency(), mode.damped_frequency());
    let (mut velocity, mut sum) = (0.0, Complex::new(0.0, 0.0));
    let steps = 200_000;
    let step = settle / f64::from(steps);
    for n in 0..steps {
        let time = step * (f64::from(n) + 0.5);
        let command: f64 = changes.iter().filter(|(at, _)| *at <= time).map(|(_, by)| by).sum();
        let next = rate(velocity, command) * step;
        let by = if next.abs() > (command - velocity).abs() { command - velocity } else { next };
        sum += (sigma * (time - end)).exp() * by;
        velocity += by;
    }
    sum.norm() / mode.damped_frequency()
}

fn changes() -> impl Strategy<Value = Vec<(f64, f64)>> {
    proptest::collection::vec((0.05..1.0_f64, -1.0..1.0_f64), 1..6).prop_map(|gaps| {
        let mut now = 0.0;
        gaps.into_iter()
            .map(|(gap, by)| {
                now += gap;
                (now, by)
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// Ramps that meet, and reversals, against drives that are stepped.
    #[test]
    fn drives_are_what_they_are_stepped_through_time(changes in changes(), zeta in 0.0..0.1_f64) {
        let mode = mode(1.7, zeta);
        let last = changes[changes.len() - 1].0;
        let a = 0.8;
        let limit = residual_amplitude(changes.iter().copied(), mode, Drive::RateLimit { acceleration: a }, 0.0).unwrap();
        // where the last ramp ends, by the limiter's own rule
        let (mut velocity, mut command, mut end) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (index, (time, by)) in changes.iter().enumerate() {
            command += by;
            let until = changes.get(index + 1).map_or(f64::INFINITY, |next| next.0);
            let ramp = ((command - velocity).abs() / a).min(until - time);
            velocity += (command - velocity).signum() * ramp * a;
            end = time + ramp;
        }
        let expected = stepped(&changes, mode, end, end + 0.1, |v, u| a * (u - v).signum());
        // steps of 1e-5 s at up to 5 changes of slope
        prop_assert!((limit - expected).abs() < 1e-4, "{} {}", limit, expected);

        let (up, down) = (0.3, 0.1);
        let drive = Drive::FirstOrder { acceleration_time_constant: up, braking_time_constant: down };
        let first = residual_amplitude(changes.iter().copied(), mode, drive, 0.0).unwrap();
        let expected = stepped(&changes, mode, last, last + 9.0, |v, u| {
            (u - v) / if v * u < 0.0 || u.abs() < v.abs() { down } else { up }
        });
        prop_assert!((first - expected).abs() < 1e-3, "{} {}", first, expected);
    }

    /// (5.15) is what a limiter does as long as no ramps meet.
    #[test]
    fn ramps_add_up_until_they_meet(zeta in 0.0..0.2_f64, share in 0.0..1.0_f64, factor in 0.5..2.0_f64,
                                    kind in proptest::sample::select(Kind::OF_A_MODE.to_vec())) {
        let shaper = designed(kind, 1.0, zeta);
        let ramp = Ramp::new((share * longest_ramp(&shaper)).min(20.0), 1.0).unwrap();
        let mode = mode(factor, zeta);
        let limiter = predict(&shaper, mode, Drive::RateLimit { acceleration: 1.0 }, ramp.speed()).unwrap().shaped;
        let ideal = ramp.speed() / mode.damped_frequency();
        prop_assert!((limiter - ideal * ramped_vibration(&shaper, mode, ramp)).abs() < 1e-12 * ideal.max(1.0));
    }

    #[test]
    fn an_ideal_drive_leaves_what_the_shaper_leaves(zeta in 0.0..0.3_f64, factor in 0.1..5.0_f64) {
        let shaper = designed(Kind::EI, 1.0, 0.1);
        let mode = mode(factor, zeta);
        let expected = residual_vibration(&shaper, factor, zeta);
        for drive in [
            Drive::Ideal,
            Drive::RateLimit { acceleration: f64::INFINITY },
            Drive::FirstOrder { acceleration_time_constant: 0.0, braking_time_constant: 0.0 },
            Drive::FirstOrder { acceleration_time_constant: 0.5, braking_time_constant: 0.5 },
        ] {
            let ratio = predict(&shaper, mode, drive, 2.0).unwrap().ratio();
            prop_assert!((ratio - expected).abs() < 1e-12, "{:?}: {} {}", drive, ratio, expected);
        }
    }
}

#[test]
fn a_reversal_without_braking_time_jumps_to_standstill() {
    let (load, up) = (mode(1.3, 0.0), 0.4);
    let of = |down| Drive::FirstOrder { acceleration_time_constant: up, braking_time_constant: down };
    let left = |down| residual_amplitude([(0.0, -3.0)], load, of(down), 1.0).unwrap();
    assert!((left(0.0) - left(1e-9)).abs() < 1e-8);
    let by_hand = (Complex::new(-1.0, 0.0) - 2.0 / Complex::new(1.0, -up * 1.3)).norm() / 1.3;
    assert!((left(0.0) - by_hand).abs() < 1e-14);
    assert_eq!(residual_amplitude([], load, of(0.1), 1.0).unwrap(), 0.0);
    let one = shaper([(0.0, 1.0)]);
    assert_eq!(predict(&one, load, of(0.1), 1.0).unwrap().ratio(), 1.0);
}
