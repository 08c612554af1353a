//! ALZVD and ALEI: reference values, optimality, limits, what must hold for every ramp, and refusals.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, DMatrix};
use proptest::prelude::*;
use serde_json::Value;
use swayless_shaping::{Kind, Limited, LimitedError, Mode, Ramp, limited};

use crate::{designed, distance, mode};

fn data() -> Value {
    serde_json::from_str(include_str!("data/limited.json")).expect("JSON")
}

/// ∫e^{σt}dt over the pulses, σ = ζω + jω_d, times e^{−ζωt_e}: what the mode keeps when the last has ended, at ω = `factor` times the
/// mode's.
fn answer(pulses: impl Iterator<Item = [f64; 2]>, mode: Mode, factor: f64) -> Complex<f64> {
    let zeta = mode.damping_ratio();
    let sigma = Complex::new(zeta, (1.0 - zeta * zeta).sqrt()) * (mode.frequency() * factor);
    let pulses: Vec<_> = pulses.collect();
    let end = pulses.last().expect("a pulse")[1];
    pulses.iter().map(|[on, off]| ((sigma * (off - end)).exp() - (sigma * (on - end)).exp()) / sigma).sum()
}

/// The same as a share of what the bare ramp leaves at its own end.
fn ratio(design: &Limited, ramp: Ramp, mode: Mode, factor: f64) -> f64 {
    let bare = answer(std::iter::once([0.0, ramp.time()]), mode, factor).norm();
    answer(design.switch_times(), mode, factor).norm() / bare
}

fn of(mode: Mode, share: f64, limit: f64) -> (Limited, Ramp) {
    // a ramp of the given share of the period
    let ramp = Ramp::new(share * mode.period(), 1.0).expect("a ramp");
    (limited(mode, ramp, limit).expect("a design that exists"), ramp)
}

#[test]
fn switch_times_of_the_10_ton_crane() {
    let (crane, ramp) = (mode(TAU * 0.28, 0.0), Ramp::new(0.358, 0.12).unwrap());
    for (name, limit) in [("ALZVD", 0.0), ("ALEI", 0.05)] {
        let design = limited(crane, ramp, limit).unwrap();
        let times: Vec<_> = design.switch_times().flatten().collect();
        for (time, expected) in times.iter().zip(data()["switch_times"][name].as_array().unwrap()) {
            // the reference's cost, a sum of squares, is below 1e-30
            assert!((time - expected.as_f64().unwrap()).abs() < 1e-13, "{name}: {times:?}");
        }
        assert_eq!((times.len(), design.duration()), (6, times[5]));
        // one condition is met to rounding over the bare ramp's sin(ωv_f/2a) = 0.5
        assert!((ratio(&design, ramp, crane, 1.0) - limit).abs() < 1e-14);
    }
}

/// Whether no command between 0 and the acceleration limit is shorter, by linear programming's duality. The commands that leave
/// nothing and no slope are those with ∫u = T and ∫u gₖ = 0 for four functions g. If a sum φ = λ + Σμₖgₖ is positive exactly while
/// such a design accelerates, ∫₀ᵈ u φ ≤ ∫₀ᵈ max(0, φ) < ∫ design φ = λT for any d before the design's end: no u ends there.
fn is_shortest(design: &Limited, mode: Mode) -> bool {
    let switches: Vec<f64> = design.switch_times().flatten().map(|time| time * mode.damped_frequency()).collect();
    let (end, r) = (switches[5], mode.damping_ratio() / (1.0 - mode.damping_ratio().powi(2)).sqrt());
    let functions = |x: f64| {
        let (sin, cos) = x.sin_cos();
        let size = (r * (x - end)).exp();
        [1.0, size * cos, size * sin, size * x * cos, size * x * sin]
    };
    // φ is 0 where the design switches, from the second time to the last but one
    let rows = DMatrix::from_fn(5, 5, |row, column| if row < 4 { functions(switches[row + 1])[column] } else { 0.0 });
    let svd = rows.svd(false, true);
    let null = svd.v_t.expect("asked for").row(4).clone_owned();
    let phi = |x: f64| functions(x).iter().zip(null.iter()).map(|(f, c)| f * c).sum::<f64>();
    let sign = phi(0.0).signum();
    (0..=2000).map(|point| end * f64::from(point) / 2000.0).all(|x| {
        let near = switches[1..5].iter().any(|switch| (x - switch).abs() < 1e-3 * end);
        let on = switches.chunks(2).any(|pulse| pulse[0] <= x && x <= pulse[1]);
        near || (phi(x) * sign > 0.0) == on
    })
}

#[test]
fn no_command_within_the_limit_is_shorter() {
    for zeta in [0.0, 0.01, 0.05, 0.1] {
        let mode = mode(1.3, zeta);
        for share in [0.01, 0.3, 0.8354, 0.95, 1.0, 1.05, 1.4, 1.6, 1.97] {
            assert!(is_shortest(&of(mode, share, 0.0).0, mode), "ζ = {zeta}, {share} periods");
        }
        // and that this can tell: beyond two periods there are shorter ones
        assert!(!is_shortest(&of(mode, 2.1, 0.0).0, mode));
    }
}

#[test]
fn tends_to_the_unlimited_shapers() {
    for zeta in [0.0, 0.01, 0.1, 0.2] {
        let (mode, zvd) = (mode(0.7, zeta), designed(Kind::ZVD, 0.7, zeta));
        for share in [1e-2, 1e-3, 1e-6, 1e-12, 1e-300, 0.0] {
            let (design, _) = of(mode, share, 0.0);
            // the impulses stand for the starts of the pulses: times differ by A₂ − A₁ of half the ramp
            assert!(distance(design.shaper(), &zvd) < 0.3 * share + 1e-14, "ζ = {zeta}, {share}");
        }
    }
    let ei = designed(Kind::EI, 0.7, 0.0);
    for share in [1e-2, 1e-3, 1e-6, 1e-300, 0.0] {
        assert!(distance(of(mode(0.7, 0.0), share, 0.05).0.shaper(), &ei) < 0.3 * share + 1e-14, "{share}");
    }
    let unlimited = limited(mode(0.7, 0.1), Ramp::new(1.0, f64::INFINITY).unwrap(), 0.0).unwrap();
    assert_eq!(*unlimited.shaper(), designed(Kind::ZVD, 0.7, 0.1));
    // and ALEI to ALZVD
    let (zvd, ei) = (of(mode(0.7, 0.1), 0.8, 0.0).0, of(mode(0.7, 0.1), 0.8, 1e-9).0);
    assert!(distance(zvd.shaper(), ei.shaper()) < 1e-8);
}

/// Where the bare ramp is as long as the period it leaves nothing, and a share of that is nothing; the designs on either side
/// meet there all the same.
#[test]
fn nothing_happens_at_a_ramp_of_one_period() {
    for zeta in [0.0, 0.05] {
        let [before, at, after] = [1.0 - 1e-7, 1.0, 1.0 + 1e-7].map(|share| of(mode(1.0, zeta), share, 0.05).0);
        assert!(distance(before.shaper(), at.shaper()) < 1e-6 && distance(after.shaper(), at.shaper()) < 1e-6);
    }
}

#[test]
fn refusals_name_what_works() {
    for value in [0.0, -1.0, f64::NAN] {
        let error = Ramp::new(1.0, value).unwrap_err();
        assert!(matches!(error, LimitedError::Acceleration { .. }) && error.to_string().contains(&value.to_string()));
    }
    for (speed, acceleration) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (1.0, 1e-310)] {
        let error = Ramp::new(speed, acceleration).unwrap_err();
        assert!(matches!(error, LimitedError::Speed { .. }) && error.to_string().contains(&speed.to_string()));
    }
    for value in [-0.1, 1.0, f64::NAN] {
        let error = limited(mode(1.0, 0.0), Ramp::new(1.0, 1.0).unwrap(), value).unwrap_err();
        assert!(matches!(error, LimitedError::VibrationLimit { .. }) && error.to_string().contains(&value.to_string()));
    }
    // what is said to have a solution has one
    let of =
        |zeta, speed, acceleration, limit| limited(mode(1.0, zeta), Ramp::new(speed, acceleration).unwrap(), limit);
    let error = of(0.0, 20.0, 1.0, 0.05).unwrap_err();
    let LimitedError::TooSlow { feasible_share, .. } = error else { panic!("{error}") };
    assert!(feasible_share > 0.9 && of(0.0, 20.0 * feasible_share, 1.0, 0.05).is_ok(), "{error}");
    assert!(of(0.0, 20.0, 1.0 / feasible_share, 0.05).is_ok() && error.to_string().contains("20 m/s"));
    let error = of(0.2, 12.0, 1.0, 0.05).unwrap_err();
    let LimitedError::NoPulses { feasible_share, .. } = error else { panic!("{error}") };
    assert!(feasible_share > 0.5 && of(0.2, 12.0 * feasible_share, 1.0, 0.05).is_ok(), "{error}");
    let error = of(0.8, 1.0, 1.0, 0.3).unwrap_err();
    let LimitedError::Damping { feasible_limit, .. } = error else { panic!("{error}") };
    assert!(feasible_limit > 0.0 && of(0.8, 0.0, 1.0, feasible_limit).is_ok(), "{error}");
}

fn dampings() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.0..0.15_f64]
}

proptest! {
    #[test]
    fn what_a_refusal_names_has_a_design(zeta in 0.0..0.95_f64, share in 0.0..4.0_f64, limit in prop_oneof![Just(0.0), 0.0..0.6_f64]) {
        let ramp = |factor: f64| Ramp::new(share * TAU * factor, 1.0).unwrap();
        let design = |factor, limit| limited(mode(1.0, zeta), ramp(factor), limit);
        match design(1.0, limit) {
            Err(LimitedError::TooSlow { feasible_share, .. } | LimitedError::NoPulses { feasible_share, .. }) => {
                prop_assert!((0.0..1.0).contains(&feasible_share));
                prop_assert!(feasible_share == 0.0 || design(feasible_share, limit).is_ok(), "{feasible_share}");
            }
            Err(LimitedError::Damping { feasible_limit, .. }) => {
                prop_assert!((0.0..limit).contains(&feasible_limit));
                prop_assert!(design(0.0, feasible_limit).is_ok(), "{feasible_limit}");
            }
            other => prop_assert!(other.is_ok(), "{other:?}"),
        }
    }

    #[test]
    fn leaves_what_is_allowed_and_no_slope(exponent in -3.0..3.0_f64, zeta in dampings(), share in 0.0..2.0_f64,
                                           limit in prop_oneof![Just(0.0), 0.0..0.15_f64]) {
        let mode = mode(10.0_f64.powf(exponent), zeta);
        let (design, ramp) = of(mode, share, limit);
        let bare = |factor| answer(std::iter::once([0.0, ramp.time()]), mode, factor).norm();
        let left = |factor| answer(design.switch_times(), mode, factor).norm();
        // unlike the design's, these integrals cancel for short ramps
        let rounding = 1e-13 / mode.frequency();
        prop_assert!((left(1.0) - limit * bare(1.0)).abs() < 10.0 * rounding);
        // a slope over 1e-4 of the frequency; its error is a third derivative of about 100 times 1e-8
        let step = 1e-4;
        if limit == 0.0 {
            let slope = answer(design.switch_times(), mode, 1.0 + step) - answer(design.switch_times(), mode, 1.0 - step);
            prop_assert!(slope.norm() < step * step * 1e2 * bare(1.0).max(ramp.time() * 0.1) + 10.0 * rounding);
        } else if bare(1.0) > 0.1 * ramp.time() {
            let slope = left(1.0 + step) / bare(1.0 + step) - left(1.0 - step) / bare(1.0 - step);
            prop_assert!(slope.abs() < step * step + 100.0 * rounding / bare(1.0), "{}", slope);
        }
    }

    #[test]
    fn designs_are_sound(exponent in -3.0..3.0_f64, zeta in dampings(), share in 0.0..2.0_f64,
                         limit in prop_oneof![Just(0.0), 0.0..0.15_f64]) {
        let mode = mode(10.0_f64.powf(exponent), zeta);
        let (design, ramp) = of(mode, share, limit);
        let shaper = design.shaper();
        prop_assert!((shaper.sum() - 1.0).abs() < 1e-14 && shaper.is_positive() && shaper.impulses()[0].time == 0.0);
        let times: Vec<_> = design.switch_times().flatten().collect();
        prop_assert!(times.is_sorted_by(|a, b| a < b) || share < 1e-12);
        if zeta == 0.0 {
            for (early, late) in times.iter().zip(times.iter().rev()) {
                prop_assert!((early + late - times[5]).abs() < 1e-13 * times[5]);
            }
        }
        // only ωv_f/a counts
        let unit = Mode::new(1.0, zeta).unwrap();
        let other = limited(unit, Ramp::new(-3.0 * ramp.time() * mode.frequency(), 3.0).unwrap(), limit).unwrap();
        for (a, b) in shaper.impulses().iter().zip(other.shaper().impulses()) {
            prop_assert!((a.time * mode.frequency() - b.time).abs() < 1e-10 && (a.amplitude - b.amplitude).abs() < 1e-10);
        }
    }

    #[test]
    fn nothing_from_outside_panics(frequency in any::<f64>(), zeta in 0.0..1.0_f64, speed in any::<f64>(),
                                   acceleration in any::<f64>(), limit in 0.0..1.0_f64, share in 0.0..3.1_f64) {
        if let (Ok(mode), Ok(ramp)) = (Mode::new(frequency, zeta), Ramp::new(speed, acceleration)) {
            let _ = limited(mode, ramp, limit);
        }
        let mode = Mode::new(1.0, zeta).unwrap();
        if let Ok(design) = limited(mode, Ramp::new(share * TAU, 1.0).unwrap(), limit) {
            prop_assert!(design.shaper().is_positive() && design.duration() < 20.0 * PI);
        }
    }
}
