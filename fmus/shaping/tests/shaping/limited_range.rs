//! ALSI: reference values, the limit over the whole range, no shorter command, symmetry, and refusals.

use std::f64::consts::TAU;

use proptest::prelude::*;
use serde_json::Value;
use swayless_shaping::{
    Band, Limited, LimitedError, Ramp, Shaper, SpecifiedError, limited_insensitivity, ramped_vibration,
    specified_insensitivity,
};

use crate::{distance, mode};

/// ζ, ramp in periods, V, duration.
const DAMPED: [(f64, f64, f64, f64); 3] = [(0.1, 1.5, 0.05, 12.631), (0.02, 0.3, 0.05, 6.486), (0.1, 0.3, 0.1, 5.791)];

fn around(frequency: f64, insensitivity: f64) -> Band {
    Band::around(frequency, insensitivity).expect("an insensitivity in range")
}

fn ramp(share: f64) -> Ramp {
    // a bare ramp of the given share of the period at 1 rad/s
    Ramp::new(share * TAU, 1.0).expect("a ramp")
}

/// The highest vibration as a share of what is allowed, 1 meaning the limit.
fn highest(design: &Limited, range: Band, zeta: f64, ramp: Ramp, limit: f64) -> f64 {
    let share = |point: u32| {
        let mode = mode(range.lower + (range.upper - range.lower) * f64::from(point) / 2000.0, zeta);
        let bare = ramped_vibration(&Shaper::unshaped(), mode, ramp);
        ramped_vibration(design.shaper(), mode, ramp) / (limit * bare.hypot(0.005))
    };
    (0..=2000).map(share).fold(0.0, f64::max)
}

#[test]
fn durations_for_the_10_ton_crane() {
    let all: Value = serde_json::from_str(include_str!("data/limited.json")).unwrap();
    for row in all["ALSI"].as_array().unwrap() {
        let (range, ramp) =
            (around(TAU * 0.28, row["insensitivity"].as_f64().unwrap()), Ramp::new(0.358, 0.12).unwrap());
        let design = limited_insensitivity(range, 0.0, ramp, 0.05).unwrap();
        // the reference is on a grid of times and of frequencies
        assert!((design.duration() - row["duration"].as_f64().unwrap()).abs() < 1e-3, "{design:?} for {row}");
        assert_eq!(design.shaper().impulses().len(), row["impulses"].as_array().unwrap().len());
        assert!(highest(&design, range, 0.0, ramp, 0.05) <= 1.0 + 2e-9);
    }
}

#[test]
fn tends_to_specified_insensitivity() {
    for (zeta, width) in [(0.0, 0.3), (0.0, 0.5), (0.05, 0.3)] {
        let range = around(1.0, width);
        let si = specified_insensitivity(range, zeta, 0.05).unwrap();
        for share in [3e-3, 1e-3, 1e-4, 1e-9, 0.0] {
            let design = limited_insensitivity(range, zeta, ramp(share), 0.05).unwrap();
            // starts of pulses differ from impulses by half their length
            let difference = distance(design.shaper(), &si);
            assert!(difference < share + 1e-5, "ζ = {zeta}, I = {width}, {share} periods: {difference:e}");
        }
    }
}

/// Durations of linear programs on a grid of times, 1/500 of the command, and of 24 tangents to each cone, computed in Python.
#[test]
fn damped_durations() {
    for (zeta, share, limit, expected) in DAMPED {
        let range = around(1.0, 0.3);
        let design = limited_insensitivity(range, zeta, ramp(share), limit).unwrap();
        assert!(
            (design.duration() / expected - 1.0).abs() < 3e-3,
            "{} for ζ = {zeta}, {share} periods",
            design.duration()
        );
        assert!(highest(&design, range, zeta, ramp(share), limit) <= 1.0 + 2e-9);
        assert!(design.shaper().is_positive() && (design.shaper().sum() - 1.0).abs() < 1e-12);
    }
}

/// At the one frequency whose period it takes, the bare ramp leaves nothing and is the shortest command.
#[test]
fn the_bare_ramp_may_do() {
    for zeta in [0.0, 1e-6] {
        for share in [1.0, 2.0] {
            let design = limited_insensitivity(around(1.0, 0.0), zeta, ramp(share), 0.05).unwrap();
            assert_eq!(design.shaper().impulses().len(), 1);
            assert!((design.duration() - share * TAU).abs() < 1e-12);
            assert!(
                limited_insensitivity(around(1.0, 0.1), zeta, ramp(share), 0.05).unwrap().shaper().impulses().len() > 2
            );
        }
    }
}

/// Small changes of a command make short ramps, and a shaper that is designed for each change must have them all.
#[test]
fn short_ramps() {
    for (zeta, limit, width, angle) in [
        (0.0, 0.014925720313146706, 0.4526875803011269, 0.0013671302215375243),
        (0.0, 0.013808480643449061, 0.2173304694475694, 0.003401297068175452),
        (0.0, 0.011485035970803512, 0.12040656137603775, 0.002226566162060118),
        (0.02680031382905203, 0.026998060817108663, 0.31156107991559834, 0.03326503791592327),
        (0.09935289883992711, 0.021051265502873794, 0.5823465196083638, 0.0010317288419750634),
        // next to impulses
        (0.17782619361127777, 0.20292415123659144, 0.4286998223944084, 0.00042545605615217),
        (0.12219544152092239, 0.011226179510254921, 0.6407959873268823, 0.00028031490522073),
    ] {
        let (range, ramp) = (around(1.0, width), Ramp::new(angle, 1.0).unwrap());
        let design = limited_insensitivity(range, zeta, ramp, limit).unwrap();
        assert!(highest(&design, range, zeta, ramp, limit) <= 1.0 + 2e-9);
        assert!((design.shaper().sum() - 1.0).abs() < 1e-14);
        // pulses are nearly impulses: an end of the ramp more or less, and some share of the limit
        let impulses = specified_insensitivity(range, zeta, limit).unwrap();
        let longer = design.duration() - impulses.duration();
        assert!((0.0..angle).contains(&longer), "{longer}");
    }
}

#[test]
fn bare_ramps_that_leave_next_to_nothing() {
    // the second is next to where a gap of the size of 1e-5 appears in the middle of the command
    for (width, share, limit) in [
        (0.0453863, 0.9192757, 0.1174157),
        (0.2149269, 1.106273124912222, 0.18044940884250396),
        (0.3081776, 0.8628013, 0.1481072),
    ] {
        let range = around(1.0, width);
        let design = limited_insensitivity(range, 0.0, ramp(share), limit).unwrap();
        assert!(highest(&design, range, 0.0, ramp(share), limit) <= 1.0 + 2e-9);
        let wider = limited_insensitivity(around(1.0, 1.01 * width), 0.0, ramp(share), limit).unwrap();
        assert!(wider.duration() > design.duration());
    }
}

/// Low limits around a frequency of which the bare ramp leaves nothing: its two sides have humps of opposite sign next to each other.
#[test]
fn low_limits_for_ramps_of_about_a_period() {
    for (zeta, limit, width, angle) in [
        (0.0, 0.005964377216606548, 0.4173508786077789, 5.258745481547845),
        (0.0, 0.01205988619105332, 0.7983605100164696, 7.18482708836134),
        (0.0, 0.0069337242342259724, 0.12356429149317533, 6.289177691447302),
    ] {
        let (range, ramp) = (around(1.0, width), Ramp::new(angle, 1.0).unwrap());
        let design = limited_insensitivity(range, zeta, ramp, limit).unwrap();
        assert!(highest(&design, range, zeta, ramp, limit) <= 1.0 + 2e-9);
    }
}

#[test]
fn refusals() {
    let refused = |lower, upper, zeta, share, limit| {
        limited_insensitivity(Band { lower, upper }, zeta, ramp(share), limit).unwrap_err()
    };
    assert!(matches!(refused(0.0, 1.0, 0.0, 0.5, 0.05), LimitedError::Range(SpecifiedError::Mode(_))));
    assert!(matches!(refused(1.0, 2.0, 1.0, 0.5, 0.05), LimitedError::Range(SpecifiedError::Mode(_))));
    assert!(matches!(refused(2.0, 1.0, 0.0, 0.5, 0.05), LimitedError::Range(SpecifiedError::Reversed { .. })));
    for value in [0.0, 1.0, f64::NAN] {
        let error = refused(1.0, 1.1, 0.0, 0.5, value);
        assert!(matches!(error, LimitedError::Range(SpecifiedError::VibrationLimit { .. })));
        assert!(error.to_string().contains(&value.to_string()));
    }
    assert!(matches!(refused(1.0, 1.1, 0.0, 0.5, 1e-9), LimitedError::Range(SpecifiedError::TooWide)));
    let error = refused(1.0, 1.0, 0.0, 3.5, 0.05);
    let LimitedError::TooSlow { feasible_share, .. } = error else { panic!("{error}") };
    assert!(limited_insensitivity(around(1.0, 0.1), 0.0, ramp(3.5 * feasible_share), 0.05).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn never_above_the_limit(exponent in -3.0..3.0_f64, width in 0.0..0.35_f64, share in 0.1..1.5_f64, limit in 0.03..0.2_f64) {
        let omega = 10.0_f64.powf(exponent);
        let (range, ramp) = (around(omega, width), Ramp::new(-share * TAU / omega, 1.0).unwrap());
        let design = limited_insensitivity(range, 0.0, ramp, limit).unwrap();
        prop_assert!(highest(&design, range, 0.0, ramp, limit) <= 1.0 + 2e-9);
        prop_assert!(design.shaper().is_positive() && (design.shaper().sum() - 1.0).abs() < 1e-12);
        let times: Vec<_> = design.switch_times().flatten().collect();
        prop_assert!(times[0] == 0.0 && times.is_sorted_by(|a, b| a < b));
        for (early, late) in times.iter().zip(times.iter().rev()) {
            prop_assert!((early + late - design.duration()).abs() < 1e-12 * design.duration());
        }
        // more to ask never takes less time, and other commands as short as that leave more
        let wider = Band { upper: range.upper * 1.01, ..range };
        let longer = limited_insensitivity(wider, 0.0, ramp, limit).unwrap();
        prop_assert!(longer.duration() >= design.duration() * (1.0 - 1e-8));
        let mut others = design.shaper().impulses().to_vec();
        others.iter_mut().for_each(|impulse| impulse.time *= 0.999);
        let other = Shaper::new(&others).unwrap();
        let over = |factor: f64| {
            let mode = mode(range.lower + (range.upper - range.lower) * factor, 0.0);
            let bare = ramped_vibration(&Shaper::unshaped(), mode, ramp);
            ramped_vibration(&other, mode, ramp) > limit * bare.hypot(0.005)
        };
        prop_assert!((0..=200).any(|point| over(f64::from(point) / 200.0)));
    }
}
