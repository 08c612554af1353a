//! SI over several ranges: references, the limit in every range, no shorter train, and Table 5.2 with all its shapers.

use std::f64::consts::TAU;

use proptest::prelude::*;
use swayless_shaping::{
    Band, Kind, Shaper, SpecifiedError, convolve, highest_vibration, insensitivity, minimum_impulse,
    specified_insensitivity, specified_insensitivity_of,
};

use crate::two_modes::{number, table};
use crate::{LIMIT, designed, distance, mode};

fn around(frequency: f64, insensitivity: f64) -> Band {
    Band::around(frequency, insensitivity).expect("an insensitivity in range")
}

fn both(ratio: f64, insensitivity: f64, damping_ratios: [f64; 2]) -> [(Band, f64); 2] {
    let [slow, fast] = damping_ratios;
    [(around(TAU, insensitivity), slow), (around(TAU * ratio, insensitivity), fast)]
}

fn si(ranges: &[(Band, f64)], limit: f64) -> Shaper {
    specified_insensitivity_of(ranges, limit).expect("a design that exists")
}

fn highest(shaper: &Shaper, ranges: &[(Band, f64)]) -> f64 {
    let of = |(band, zeta): &(Band, f64)| highest_vibration(shaper, *zeta, band.lower..=band.upper).vibration;
    ranges.iter().map(of).fold(0.0, f64::max)
}

#[test]
fn trains_are_those_of_the_program_on_a_grid() {
    for row in table("specified") {
        let shaper = si(&both(4.0, number(&row, "insensitivity"), [0.0; 2]), LIMIT);
        // a grid of times only adds to the duration, and bisection ends above it
        let longer = number(&row, "duration") - shaper.duration();
        assert!((0.0..3e-4).contains(&longer), "{longer:e} {row}");
        let (times, amplitudes) = (row["times"].as_array().unwrap(), row["amplitudes"].as_array().unwrap());
        assert_eq!(times.len(), shaper.impulses().len(), "{row}");
        for ((impulse, time), amplitude) in shaper.impulses().iter().zip(times).zip(amplitudes) {
            // an impulse between two times of the grid lies at their mean there
            assert!((impulse.time - time.as_f64().unwrap()).abs() < 2e-3, "{shaper:?} {row}");
            assert!((impulse.amplitude - amplitude.as_f64().unwrap()).abs() < 5e-3, "{shaper:?} {row}");
        }
    }
}

/// Table 5.2, and more of its kind, for modes of 1 Hz and 4 Hz.
#[test]
fn widths_and_heights_are_those_of_scans() {
    let [slow, fast] = [TAU, 4.0 * TAU];
    let series = |kind| convolve(&designed(kind, slow, 0.0), &designed(kind, fast, 0.0)).unwrap();
    let minimum: Vec<Shaper> = minimum_impulse([mode(slow, 0.0), mode(fast, 0.0)]).unwrap().iter().collect();
    for row in table("table") {
        let (shaper, exact) = match row["shaper"].as_str().unwrap() {
            "short" => (minimum[0].clone(), true),
            "medium" => (minimum[1].clone(), true),
            "medium mirrored" => (minimum[2].clone(), true),
            "thirds" => (minimum[3].clone(), true),
            "long" => (minimum[5].clone(), true),
            "convolved ZV" => (series(Kind::ZV), true),
            "convolved ZVD" => (series(Kind::ZVD), true),
            "convolved EI" => (series(Kind::EI), true),
            _ => (si(&both(4.0, 0.4, [0.0; 2]), LIMIT), false),
        };
        // SI's reference is a train on a grid of times
        let tolerance = if exact { 1e-6 } else { 5e-4 };
        let close = |value: f64, name: &str, tolerance: f64| {
            let expected = number(&row, name);
            assert!((value - expected).abs() <= tolerance, "{value} is not {expected}, {name} of {row}");
        };
        close(shaper.duration(), "duration", tolerance);
        close(insensitivity(&shaper, mode(slow, 0.0), 0.0502), "insensitivity_1_Hz", tolerance);
        close(insensitivity(&shaper, mode(fast, 0.0), 0.0502), "insensitivity_4_Hz", tolerance);
        // the reference's maximum is one of samples
        close(highest_vibration(&shaper, 0.0, 0.2 * slow..=6.0 * slow).vibration, "highest", 1e-4);
        let (times, amplitudes) = (row["times"].as_array().unwrap(), row["amplitudes"].as_array().unwrap());
        assert_eq!(times.len(), shaper.impulses().len(), "{row}");
        for ((impulse, time), amplitude) in shaper.impulses().iter().zip(times).zip(amplitudes) {
            assert!((impulse.time - time.as_f64().unwrap()).abs() < tolerance, "{shaper:?} {row}");
            assert!((impulse.amplitude - amplitude.as_f64().unwrap()).abs() < tolerance, "{shaper:?} {row}");
        }
    }
}

#[test]
fn ranges_that_overlap_are_one() {
    let one = |lower, upper, zeta| (Band { lower, upper }, zeta);
    for zeta in [0.0, 0.02] {
        let whole = specified_insensitivity(Band { lower: 1.0, upper: 1.6 }, zeta, LIMIT).unwrap();
        for ranges in [
            vec![one(1.0, 1.6, zeta)],
            vec![one(1.0, 1.6, zeta); 3],
            vec![one(1.2, 1.6, zeta), one(1.0, 1.2, zeta)],
            vec![one(1.3, 1.6, zeta), one(1.0, 1.5, zeta), one(1.1, 1.2, zeta)],
        ] {
            assert_eq!(si(&ranges, LIMIT), whole);
        }
    }
    // the one with less damping, or another kind of it, may add nothing
    let ranges = [one(1.0, 1.6, 0.02), one(1.2, 1.4, 0.021)];
    assert!((si(&ranges, LIMIT).duration() - si(&ranges[..1], LIMIT).duration()).abs() < 1e-2);
}

#[test]
fn ranges_far_apart() {
    for zetas in [[0.0; 2], [0.01, 0.01], [0.0, 0.05]] {
        let ranges = both(20.0, 0.2, zetas);
        let shaper = si(&ranges, LIMIT);
        assert!(
            highest(&shaper, &ranges) <= LIMIT * (1.0 + 2e-9) && shaper.duration() > si(&ranges[..1], LIMIT).duration()
        );
    }
    let apart = [1.0, 64.0].map(|frequency| (around(frequency, 0.0), 0.0));
    let error = specified_insensitivity_of(&apart, LIMIT).unwrap_err();
    assert_eq!(error, SpecifiedError::Apart { ratio: 64.0, most: 50.0 });
    assert!(error.to_string().contains("64 times") && error.to_string().contains("50 times"));
}

/// There the pair of impulses next to the centre has met, but for rounding.
#[test]
fn a_pair_that_has_met_is_one_impulse() {
    let slow = Band { lower: 5.319_765_473_051_025, upper: 7.246_605_141_308_147 };
    let fast = Band { lower: 86.411_269_010_024_33, upper: 91.617_696_693_753_27 };
    let ranges = [(slow, 0.0), (fast, 0.0)];
    for limit in [0.2344, 0.234_534_498_778_369_7, 0.2346] {
        let shaper = si(&ranges, limit);
        assert!(highest(&shaper, &ranges) <= limit * (1.0 + 2e-9));
    }
}

/// Three ranges, and a third that the others imply.
#[test]
fn more_ranges_than_two() {
    let ranges = [(around(1.0, 0.2), 0.0), (around(2.2, 0.2), 0.01), (around(5.0, 0.3), 0.02)];
    let shaper = si(&ranges, LIMIT);
    assert!(highest(&shaper, &ranges) <= LIMIT * (1.0 + 2e-9) && shaper.is_positive());
    let inside = [ranges[0], ranges[1], ranges[2], (around(2.2, 0.1), 0.01)];
    assert_eq!(si(&inside, LIMIT), shaper);
}

#[test]
fn refusals() {
    assert_eq!(specified_insensitivity_of(&[], LIMIT).unwrap_err(), SpecifiedError::NoRange);
    let reversed = [(around(1.0, 0.1), 0.0), (Band { lower: 2.0, upper: 1.9 }, 0.0)];
    assert!(matches!(specified_insensitivity_of(&reversed, LIMIT), Err(SpecifiedError::Reversed { lower: 2.0, .. })));
    let damped = [(around(1.0, 0.1), 0.0), (around(1.0, 0.1), 1.0)];
    assert!(matches!(specified_insensitivity_of(&damped, LIMIT), Err(SpecifiedError::Mode(_))));
}

fn cases() -> impl Strategy<Value = ([(Band, f64); 2], f64)> {
    let dampings = prop_oneof![Just([0.0; 2]), [0.0..0.1_f64, 0.0..0.1_f64]];
    (1.0..6.0_f64, 0.0..0.5_f64, dampings, 0.03..0.3_f64)
        .prop_map(|(ratio, width, zetas, limit)| (both(ratio, width, zetas), limit))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    #[test]
    fn never_above_the_limit((ranges, limit) in cases(), exponent in -3.0..3.0_f64) {
        let shaper = si(&ranges, limit);
        prop_assert!(highest(&shaper, &ranges) <= limit * (1.0 + 2e-9));
        prop_assert!(shaper.is_positive() && (shaper.sum() - 1.0).abs() < 1e-12 && shaper.impulses()[0].time == 0.0);
        if ranges.iter().all(|(_, zeta)| *zeta == 0.0) {
            for (first, last) in shaper.impulses().iter().zip(shaper.impulses().iter().rev()) {
                prop_assert!((first.time + last.time - shaper.duration()).abs() < 1e-13 * shaper.duration());
                prop_assert!(first.amplitude == last.amplitude);
            }
        }
        // no range comes first, and no frequency is special
        let factor = 10.0_f64.powf(exponent);
        let scaled = |(Band { lower, upper }, zeta)| (Band { lower: lower * factor, upper: upper * factor }, zeta);
        let other = si(&[scaled(ranges[1]), scaled(ranges[0])], limit).duration() * factor;
        prop_assert!((other / shaper.duration() - 1.0).abs() < 1e-8);
    }

    #[test]
    fn more_to_ask_never_takes_less_time((ranges, limit) in cases(), more in 0.001..0.2_f64) {
        let duration = si(&ranges, limit).duration() * (1.0 - 1e-8);
        prop_assert!(duration >= si(&ranges[..1], limit).duration() * (1.0 - 2e-8));
        prop_assert!(duration >= si(&ranges[1..], limit).duration() * (1.0 - 2e-8));
        let [slow, (band, zeta)] = ranges;
        let wider = Band { upper: band.upper + more, ..band };
        prop_assert!(si(&[slow, (wider, zeta)], limit).duration() >= duration);
        prop_assert!(si(&ranges, limit * (1.0 - more)).duration() >= duration);
    }

    /// Any other positive train as short as that, or shorter, leaves more somewhere.
    #[test]
    fn no_other_train_is_better((ranges, limit) in cases(), shrink in 0.9..0.9999_f64,
                                moves in proptest::collection::vec(-0.05..0.05_f64, 32)) {
        let mut others: Vec<_> = si(&ranges, limit).impulses().to_vec();
        for (impulse, by) in others.iter_mut().zip(&moves) {
            impulse.time *= shrink;
            impulse.amplitude *= 1.0 + by;
        }
        let sum: f64 = others.iter().map(|impulse| impulse.amplitude).sum();
        others.iter_mut().for_each(|impulse| impulse.amplitude /= sum);
        prop_assert!(highest(&Shaper::new(&others).unwrap(), &ranges) > limit);
    }
}

/// Damped designs are another program, over complex responses and without symmetry; at next to no damping both agree.
#[test]
fn vanishing_damping_leads_to_the_symmetric_train() {
    for width in [0.05, 0.2, 0.4] {
        let [damped, undamped] = [1e-6, 0.0].map(|zeta| si(&both(4.0, width, [0.0, zeta]), LIMIT).duration());
        assert!((damped / undamped - 1.0).abs() < 1e-3, "I = {width}: {damped} {undamped}");
    }
}

#[test]
fn a_damped_trains_mode_may_have_none() {
    let ranges = both(4.0, 0.1, [0.0, 0.1]);
    let shaper = si(&ranges, LIMIT);
    assert!(distance(&shaper, &si(&both(4.0, 0.1, [0.0; 2]), LIMIT)) > 1e-3);
}
