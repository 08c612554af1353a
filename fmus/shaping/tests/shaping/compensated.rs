//! UMZVc: reference values, a simulated drive and load, limits, and refusals.

use std::f64::consts::TAU;

use nalgebra::{Matrix4, Vector4};
use proptest::prelude::*;
use serde_json::Value;
use swayless_shaping::{
    Compensated, CompensatedError, CompensatedForm, Kind, Mode, PulseLength, Shaper, TimeConstant, compensated,
    compensation_exists, pulse_length,
};

use crate::{designed, distance, mode};

const SPEED: f64 = 0.17;

fn table(name: &str) -> Vec<Value> {
    let all: Value = serde_json::from_str(include_str!("data/compensated.json")).expect("JSON");
    all[name].as_array().expect("a table").clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn load() -> Mode {
    mode((9.81_f64 / 0.84).sqrt(), 0.0)
}

fn both(row: &Value, form: CompensatedForm) -> Compensated {
    compensated(load(), number(&row["tau_a"]), number(&row["tau_b"]), form).expect("a design that exists")
}

/// The load's amplitude when the drive has followed changes (time, by how much) of the commanded speed from a given speed.
/// Load and drive are carried on together by matrix exponentials: ÿ + 2ζωẏ + ω²y = −v̇, v̇ = (u − v)/τ.
fn simulated(mode: Mode, taus: [f64; 2], start: f64, changes: &[(f64, f64)]) -> f64 {
    let (omega, zeta) = (mode.frequency(), mode.damping_ratio());
    let (mut command, mut now) = (start, changes[0].0);
    let mut state = Vector4::new(0.0, 0.0, start, 1.0); // y, ẏ, v, 1
    let mut carry = |command: f64, time: f64| {
        let tau = if (command - state.z) * state.z >= 0.0 { taus[0] } else { taus[1] };
        #[rustfmt::skip]
        let system = Matrix4::new(
            0.0, 1.0, 0.0, 0.0,
            -omega * omega, -2.0 * zeta * omega, 1.0 / tau, -command / tau,
            0.0, 0.0, -1.0 / tau, command / tau,
            0.0, 0.0, 0.0, 0.0,
        );
        state = (system * time).exp() * state;
        state
    };
    for (time, change) in changes {
        if *time > now {
            carry(command, time - now);
        }
        now = *time;
        command += change;
    }
    // until the drive is where it should be, to e⁻⁴⁰; so much is lost to damping meanwhile
    let settle = 40.0 * taus[0].max(taus[1]);
    let end = carry(command, settle);
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    end.x.hypot((end.y + zeta * omega * end.x) / damped) * (zeta * omega * settle).exp()
}

fn train(shaper: &Shaper, start: f64, change: f64) -> Vec<(f64, f64)> {
    shaper.impulses().iter().map(|impulse| (start + impulse.time, change * impulse.amplitude)).collect()
}

/// What a pulse of 3 s leaves, in millimetres.
fn pulse(taus: [f64; 2], up: &Shaper, down: &Shaper) -> f64 {
    let changes = [train(up, 0.0, SPEED), train(down, 3.0, -SPEED)].concat();
    1e3 * simulated(load(), taus, 0.0, &changes)
}

#[test]
fn closed_form_times_and_what_they_leave_of_a_pulse() {
    for row in table("closed") {
        let Compensated { accelerating, braking } = both(&row, CompensatedForm::ClosedForm);
        for (train, expected) in [(&accelerating, &row["accelerating"]), (&braking, &row["braking"])] {
            for index in [0, 1] {
                let time = train.impulses()[index + 1].time;
                assert!((time - number(&expected[index])).abs() < 1e-14, "{time} for {row}");
            }
        }
        let taus = [number(&row["tau_a"]), number(&row["tau_b"])];
        let one = |kind| designed(kind, load().frequency(), 0.0);
        let unity = one(Kind::UMZV);
        let zv = one(Kind::ZV);
        let bare = Shaper::unshaped();
        for (name, up, down) in
            [("UMZVc", &accelerating, &braking), ("UMZV", &unity, &unity), ("ZV", &zv, &zv), ("None", &bare, &bare)]
        {
            let (left, expected) = (pulse(taus, up, down), number(&row["pulse"][name]));
            // the exponentials of 4 × 4 matrices are good to 1e-13 of a swing of 90 mm
            assert!((left - expected).abs() < 1e-9 + 1e-6 * expected, "{name}: {left} for {row}");
        }
    }
}

#[test]
fn complete_ramps_are_told_from_others() {
    for row in table("closed") {
        let design = both(&row, CompensatedForm::ClosedForm);
        let complete = design.ramps_complete(number(&row["tau_a"]), number(&row["tau_b"]));
        let flags = |name: &str| [row[name][0].as_bool().unwrap(), row[name][1].as_bool().unwrap()];
        let [first, second] = [0, 1].map(|ramp| [complete.accelerating[ramp], complete.braking[ramp]]);
        assert_eq!([first, second], [flags("complete_first"), flags("complete_second")], "{row}");
        assert_eq!(complete.all(), first == [true; 2] && second == [true; 2]);
    }
}

#[test]
fn exact_times() {
    for row in table("exact") {
        let exact = both(&row, CompensatedForm::ExactRamp);
        let closed = both(&row, CompensatedForm::ClosedForm);
        let taus = [number(&row["tau_a"]), number(&row["tau_b"])];
        for (index, (exact, closed, expected)) in [
            (&exact.accelerating, &closed.accelerating, &row["accelerating"]),
            (&exact.braking, &closed.braking, &row["braking"]),
        ]
        .into_iter()
        .enumerate()
        {
            for index in [0, 1] {
                let time = exact.impulses()[index + 1].time;
                // the reference's residual is up to 1e-9
                assert!((time - number(&expected[index])).abs() < 1e-8, "{time} for {row}");
            }
            let (start, change) = [(0.0, SPEED), (SPEED, -SPEED)][index];
            let left = |shaper| 1e3 * simulated(load(), taus, start, &train(shaper, 0.0, change));
            assert!(left(exact) < 1e-9, "{row}");
            let expected = number(&row["closed_leaves"][index]);
            assert!((left(closed) - expected).abs() < 1e-6 * expected, "{row}");
        }
    }
}

#[test]
fn equal_time_constants_are_unity_magnitude() {
    for zeta in [0.0, 0.1] {
        let mode = mode(2.0, zeta);
        for tau in [0.0, 0.3] {
            let Compensated { accelerating, braking } =
                compensated(mode, tau, tau, CompensatedForm::ExactRamp).unwrap();
            assert_eq!(accelerating, designed(Kind::UMZV, 2.0, zeta));
            assert_eq!(accelerating, braking);
        }
        // and nothing jumps next to that
        let near = compensated(mode, 1e-9, 0.0, CompensatedForm::ExactRamp).unwrap();
        assert!(distance(&near.accelerating, &designed(Kind::UMZV, 2.0, zeta)) < 1e-8);
    }
    let closed = compensated(mode(2.0, 0.0), 0.0, 0.0, CompensatedForm::ClosedForm).unwrap();
    assert_eq!(closed.braking, designed(Kind::UMZV, 2.0, 0.0));
}

/// (5.32): with no braking time at all, τ_a may be √3/ω, that is 0.2757 T.
#[test]
fn closed_form_ends_where_no_triangle_closes() {
    let most = 3.0_f64.sqrt() / TAU; // for T = 1
    let one = mode(TAU, 0.0);
    assert!(compensation_exists(one, most * 0.999, 0.0) && !compensation_exists(one, most * 1.001, 0.0));
    assert!(!compensation_exists(one, 0.0, most * 1.001) && compensation_exists(one, 5.0, 5.0));
    let refused = |a, b| compensated(one, a, b, CompensatedForm::ClosedForm).unwrap_err();
    for (error, which) in
        [(refused(0.4, 0.01), TimeConstant::Acceleration), (refused(0.01, 0.4), TimeConstant::Braking)]
    {
        let CompensatedError::Unequal { which: told, value, longest } = error else { panic!("{error}") };
        assert_eq!((told, value), (which, 0.4));
        assert!(error.to_string().contains("0.4 s") && error.to_string().contains(&longest.to_string()));
        let taus = if which == TimeConstant::Acceleration { [longest, 0.01] } else { [0.01, longest] };
        let [a, b] = taus.map(|tau| if tau == longest { tau * (1.0 - 1e-12) } else { tau });
        assert!(compensated(one, a, b, CompensatedForm::ClosedForm).is_ok());
        // the exact ramps need no such condition
        assert!(compensated(one, 0.4, 0.01, CompensatedForm::ExactRamp).is_ok());
    }
}

#[test]
fn refusals_name_what_is_wrong() {
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        for (a, b, which) in [(value, 0.1, TimeConstant::Acceleration), (0.1, value, TimeConstant::Braking)] {
            let error = compensated(mode(1.0, 0.0), a, b, CompensatedForm::default()).unwrap_err();
            assert!(matches!(error, CompensatedError::TimeConstant { which: told, .. } if told == which));
            assert!(error.to_string().contains(&value.to_string()), "{error}");
        }
    }
    let error = compensated(mode(1.0, 0.9999), 0.1, 0.2, CompensatedForm::default()).unwrap_err();
    assert!(matches!(error, CompensatedError::Unity(_)));
    // With no braking time constant at all the speed drops at t₂; t₃ falls onto t₂ = π/2ω where the first ramp alone has the
    // size of the last, ωτ_a(1 − e^{−t₂/τ_a}) = 1
    let error = compensated(mode(1.0, 0.0), 2.0, 0.0, CompensatedForm::ExactRamp).unwrap_err();
    let CompensatedError::NotFound { feasible_share, .. } = error else { panic!("{error}") };
    let most = 2.0 * feasible_share;
    assert!((most * (1.0 - (-std::f64::consts::FRAC_PI_2 / most).exp()) - 1.0).abs() < 1e-3, "{most}");
    assert!(compensated(mode(1.0, 0.0), 2.0 * feasible_share, 0.0, CompensatedForm::ExactRamp).is_ok());
}

/// Both trains must exist for what is named, and where it is a bound, rounding must not put it outside.
#[test]
fn the_time_constants_that_are_named_have_a_design() {
    for (zeta, a, b) in [(0.0, 0.0, 590.8), (0.15, 0.0, 3.11), (0.0, 2.644, 0.0), (0.2, 0.0006, 2239.0)] {
        let error = compensated(mode(1.0, zeta), a, b, CompensatedForm::ExactRamp).unwrap_err();
        let CompensatedError::NotFound { feasible_share: share, .. } = error else { panic!("{error}") };
        let less = compensated(mode(1.0, zeta), a * share, b * share, CompensatedForm::ExactRamp);
        assert!(share > 0.0 && less.is_ok(), "{error}");
    }
    for (a, b) in [(78.21697833250359, 1.204423842096674), (4.617702689080338, 4542.891313963797), (2.4177, 0.218)] {
        let error = compensated(mode(1.0, 0.0), a, b, CompensatedForm::ClosedForm).unwrap_err();
        let CompensatedError::Unequal { which, longest, .. } = error else { panic!("{error}") };
        let (a, b) = if which == TimeConstant::Acceleration { (longest, b) } else { (a, longest) };
        assert!(compensated(mode(1.0, 0.0), a, b, CompensatedForm::ClosedForm).is_ok(), "{error}");
    }
}

/// The braking time constant of figs 5.24 and 5.28, and the limits they are marked with.
#[test]
fn pulses_are_short_or_long_or_interfere() {
    let unity = designed(Kind::UMZV, load().frequency(), 0.0);
    let zv = designed(Kind::ZV, load().frequency(), 0.0);
    let of = |shaper, duration| pulse_length(shaper, duration, 0.2, 0.065);
    for (shaper, duration, expected) in [
        (&zv, 0.7242, PulseLength::Short),
        (&zv, 0.7243, PulseLength::Interfering),
        (&zv, 1.5192, PulseLength::Interfering),
        (&zv, 1.5193, PulseLength::Long),
        (&unity, 1.2128, PulseLength::Interfering),
        (&unity, 1.2129, PulseLength::Long),
    ] {
        assert_eq!(of(shaper, duration), expected, "{duration}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Both directions, whatever the time constants, with and without damping.
    #[test]
    fn exact_ramps_leave_nothing(up in -2.0..1.0_f64, down in -2.0..1.0_f64, zeta in prop_oneof![Just(0.0), 0.0..0.1_f64],
                                 exponent in -2.0..2.0_f64) {
        let mode = mode(10.0_f64.powf(exponent), zeta);
        let taus = [up, down].map(|exponent| 10.0_f64.powf(exponent) / mode.frequency());
        let design = compensated(mode, taus[0], taus[1], CompensatedForm::ExactRamp);
        let Compensated { accelerating, braking } = design.unwrap();
        for (shaper, start, change) in [(&accelerating, 0.0, 1.0), (&braking, 1.0, -1.0)] {
            prop_assert!((shaper.sum() - 1.0).abs() < 1e-15);
            // a drive slower than the load's decay hides what is left
            if zeta == 0.0 {
                let left = mode.frequency() * simulated(mode, taus, start, &train(shaper, 0.0, change));
                prop_assert!(left < 1e-9, "{left:e}");
            }
        }
    }

    #[test]
    fn nothing_from_outside_panics(frequency in any::<f64>(), zeta in 0.0..1.0_f64, up in any::<f64>(), down in any::<f64>()) {
        for (frequency, scale) in [(frequency, 1.0), (1.0, 1e-300), (1.0, 1.0)] {
            let Ok(mode) = Mode::new(frequency, zeta) else { continue };
            for form in [CompensatedForm::ExactRamp, CompensatedForm::ClosedForm] {
                let _ = compensated(mode, (up * scale).abs(), (down * scale).abs(), form);
            }
        }
    }
}
