//! Trains for two modes: references, all solutions and no others, degenerate ratios, series of shapers, refusals.

use std::f64::consts::TAU;

use proptest::prelude::*;
use serde_json::Value;
use swayless_shaping::{
    Kind, MAX_IMPULSES, MinimumImpulse, MinimumImpulseError, Mode, Shaper, ShaperError, convolve, minimum_impulse,
    minimum_impulse_solution, residual_vibration,
};

use crate::{designed, distance, mode, shaper};

pub fn table(name: &str) -> Vec<Value> {
    let all: Value = serde_json::from_str(include_str!("data/two_mode.json")).expect("JSON");
    all[name].as_array().expect("a table").clone()
}

pub fn number(row: &Value, name: &str) -> f64 {
    row[name].as_f64().expect("a number")
}

fn triple(row: &Value, name: &str) -> [f64; 3] {
    std::array::from_fn(|i| row[name][i].as_f64().expect("a number"))
}

fn undamped(ratio: f64) -> [Mode; 2] {
    [mode(TAU, 0.0), mode(TAU * ratio, 0.0)]
}

fn solutions(modes: [Mode; 2]) -> Vec<Shaper> {
    minimum_impulse(modes).expect("modes not too far apart").iter().collect()
}

fn highest_residual(shaper: &Shaper, modes: [Mode; 2]) -> f64 {
    modes.map(|mode| residual_vibration(shaper, mode.frequency(), mode.damping_ratio())).into_iter().fold(0.0, f64::max)
}

/// Σ|A|, which rounding is relative to.
fn size(shaper: &Shaper) -> f64 {
    shaper.impulses().iter().map(|impulse| impulse.amplitude.abs()).sum()
}

#[test]
fn the_comb_is_solved_as_by_linear_systems() {
    for row in table("comb") {
        let ratio = number(&row, "ratio");
        let spacing = 1.0 / (1.0 + ratio);
        let (amplitudes, places) = (triple(&row, "amplitudes"), [0.0, number(&row, "j"), number(&row, "k")]);
        let impulses = places.into_iter().zip(amplitudes).filter(|(_, amplitude)| amplitude.abs() > 1e-12);
        let expected: Vec<_> = impulses.map(|(place, amplitude)| (place * spacing, amplitude)).collect();
        let found = solutions(undamped(ratio));
        let near = |shaper: &&Shaper| {
            let pairs = shaper.impulses().iter().zip(&expected);
            shaper.impulses().len() == expected.len()
                && pairs.into_iter().all(|(a, b)| (a.time - b.0).abs() < 1e-12 && (a.amplitude - b.1).abs() < 1e-12)
        };
        assert_eq!(found.iter().filter(near).count(), 1, "{row}: {found:?}");
    }
}

#[test]
fn damped_trains_are_those_of_least_squares() {
    for row in table("damped") {
        let zeta = number(&row, "damping_ratio");
        let found = solutions([mode(TAU, zeta), mode(4.0 * TAU, zeta)]);
        let expected = if row["ceased"] == true {
            // where the branch was last seen, and its slope, are within this of where it would be
            let near = |shaper: &Shaper| (shaper.impulses()[1].time - 0.26).abs() < 0.05 && shaper.duration() < 0.7;
            assert!(!found.iter().any(near), "{row}: {found:?}");
            continue;
        } else {
            let (times, amplitudes) = (triple(&row, "times"), triple(&row, "amplitudes"));
            shaper([0, 1, 2].map(|i| (times[i], amplitudes[i])))
        };
        // residuals of 1e-15 on both sides, at a condition of up to a thousand
        assert_eq!(found.iter().filter(|found| distance(found, &expected) < 1e-12).count(), 1, "{row}: {found:?}");
    }
}

/// What is left of both modes at f₂ = 3f₁ without damping is ZV; damping ζ splits its last impulse in two, 2h apart, where to
/// first order h² = 4M, M = ½·T/2·ζ(ω₂ − ω₁)/(ω₂² − ω₁²) being the pair's second moment over 2.
#[test]
fn damping_splits_an_impulse() {
    for ratio in [3.0, 5.0, 7.0] {
        for (zeta, aside) in [(1e-8, 0.0), (1e-8, 1e-15), (1e-6, -1e-12), (1e-4, 0.0), (1e-4, -1e-8), (1e-4, 1e-8)] {
            let ratio = ratio * (1.0 + aside);
            let modes = [mode(TAU, zeta), mode(TAU * ratio, zeta)];
            let shaper = solutions(modes).into_iter().find(|shaper| (shaper.impulses()[1].time - 0.5).abs() < 0.02);
            let shaper = shaper.expect("a shaper near ZV");
            let half = 0.5 * (shaper.duration() - shaper.impulses()[1].time);
            let expected = (zeta / (TAU * (1.0 + ratio))).sqrt();
            assert!((half / expected - 1.0).abs() < 3.0 * zeta.sqrt(), "{ratio} {zeta}: {shaper:?}");
        }
    }
    // the first one, where the slower mode decays faster
    let near_zv = |slow, fast| {
        let found = solutions([mode(TAU, slow), mode(3.0 * TAU, fast)]).into_iter();
        found.into_iter().find(|shaper| (shaper.duration() - 0.5).abs() < 0.05).expect("a shaper near ZV")
    };
    assert!(near_zv(0.03, 0.0).impulses()[1].time < 0.1);
    assert!(near_zv(0.0, 0.03).impulses()[1].time > 0.4);
}

#[test]
fn equal_modes_have_zvd_first() {
    for zeta in [0.0, 1e-9, 0.01, 0.1, 0.3, 0.6] {
        let zvd = designed(Kind::ZVD, 1.7, zeta);
        for aside in [0.0, 1e-12, 1e-8] {
            let found = minimum_impulse_solution([mode(1.7, zeta), mode(1.7 * (1.0 + aside), zeta)], 1).unwrap();
            assert!(distance(&found, &zvd) < 1e-12 + 5.0 * aside, "ζ = {zeta}: {found:?}");
        }
    }
}

#[test]
fn ratios_at_which_other_shapers_come_out() {
    let first = |ratio| minimum_impulse_solution(undamped(ratio), 1).unwrap();
    for (ratio, kind) in [(1.0, Kind::ZVD), (3.0, Kind::ZV), (5.0, Kind::UMZV)] {
        assert!(distance(&first(ratio), &designed(kind, TAU, 0.0)) < 1e-14, "{ratio}: {:?}", first(ratio));
        // next to it, too, where amplitudes are quotients of small numbers
        for aside in [1e-15, 1e-13, 1e-9] {
            let near = first(ratio * (1.0 + aside));
            let lost = near.impulses().len() == 3 && kind == Kind::ZV; // the middle impulse is small, but there
            assert!(lost || distance(&near, &designed(kind, TAU, 0.0)) < 10.0 * aside + 1e-14, "{near:?}");
        }
    }
    assert!(first(2.9).is_positive() && !first(3.1).is_positive());
    assert!(first(4.9).impulses().iter().all(|impulse| impulse.amplitude.abs() < 1.0));
    assert!(first(5.1).impulses().iter().all(|impulse| impulse.amplitude.abs() > 1.0));
}

/// Any other train of three impulses: the closest of a fine grid of times and the amplitudes that cancel the first mode.
#[test]
fn there_are_no_other_solutions() {
    let modes = undamped(4.0);
    let list = solutions(modes);
    const STEPS: u32 = 400;
    for k in 1..STEPS {
        for j in 1..k {
            let [t2, t3] = [j, k].map(|step| f64::from(step) / f64::from(STEPS) * 1.2);
            let [(s2, c2), (s3, c3)] = [t2, t3].map(|time| (TAU * time).sin_cos());
            let amplitudes = [c2 * s3 - s2 * c3, -s3, s2];
            let sum: f64 = amplitudes.iter().sum();
            let size: f64 = amplitudes.iter().map(|amplitude| amplitude.abs()).sum();
            if size > 20.0 * sum.abs() || size < 0.05 {
                continue; // too large to be resolved by this grid, or free amplitudes
            }
            let train = shaper([0, 1, 2].map(|i| ([0.0, t2, t3][i], amplitudes[i] / sum)));
            // half a step of both times from a solution changes V by less than that
            let slope = 4.0 * TAU * size / sum.abs();
            if residual_vibration(&train, 4.0 * TAU, 0.0) < 0.05 * slope * 1.2 / f64::from(STEPS) {
                let near = list.iter().any(|known| {
                    let times = |shaper: &Shaper| [shaper.impulses()[1].time, shaper.duration()];
                    times(known).iter().zip([t2, t3]).all(|(a, b)| (a - b).abs() < 0.01)
                });
                assert!(near, "{train:?}");
            }
        }
    }
}

fn ratios() -> impl Strategy<Value = f64> {
    prop_oneof![
        1.0..10.0_f64,
        10.0..50.0_f64,
        (1..24_u32, 1..12_u32).prop_map(|(p, q)| f64::from(p.max(q)) / f64::from(p.min(q)))
    ]
}

proptest! {
    #[test]
    fn undamped_solutions_leave_nothing(ratio in ratios(), exponent in -3.0..3.0_f64, swap in any::<bool>()) {
        let slow = 10.0_f64.powf(exponent);
        let mut modes = [mode(slow, 0.0), mode(slow * ratio, 0.0)];
        if swap {
            modes.reverse();
        }
        let found = solutions(modes);
        prop_assert!(!found.is_empty() && found.len() <= MinimumImpulse::MOST);
        for (index, shaper) in found.iter().enumerate() {
            let size = size(shaper);
            prop_assert!(highest_residual(shaper, modes) <= 1e-13 * (10.0 + size * size), "{} {:?}", ratio, shaper);
            prop_assert!((shaper.sum() - 1.0).abs() <= 1e-15 * (10.0 + size));
            prop_assert_eq!(shaper.impulses()[0].time, 0.0);
            prop_assert!(shaper.impulses().len() <= 3 && shaper.duration() * slow <= 2.0 * TAU * (1.0 + 2e-9));
            prop_assert_eq!(&minimum_impulse_solution(modes, index + 1).unwrap(), shaper);
            // mirror images are solutions, too; of the last ones the list may hold one of two
            let mirror: Vec<_> = shaper.impulses().iter().rev().map(|impulse| {
                swayless_shaping::Impulse { time: shaper.duration() - impulse.time, ..*impulse }
            }).collect();
            let mirror = Shaper::new(&mirror).unwrap();
            let last = shaper.duration() >= found[found.len() - 1].duration() * (1.0 - 1e-9);
            prop_assert!(last || found.iter().any(|other| distance(other, &mirror) < 1e-8 * size), "{} {:?}", ratio, shaper);
        }
        prop_assert!(found.windows(2).all(|pair| pair[0].duration() <= pair[1].duration() * (1.0 + 1e-9)));
        for (index, shaper) in found.iter().enumerate() {
            prop_assert!(found[..index].iter().all(|other| distance(other, shaper) > 1e-9));
        }
        // the shortest of all
        prop_assert!((found[0].duration() - 2.0 * TAU / (slow + slow * ratio)).abs() <= 1e-14 * found[0].duration());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn convolution_is_linear_and_knows_no_order(kinds in proptest::sample::subsequence(Kind::OF_A_MODE.to_vec(), 2),
                                                 ratio in 0.2..5.0_f64, zeta in 0.0..0.2_f64) {
        let (a, b) = (designed(kinds[0], 1.0, zeta), designed(kinds[1], ratio, zeta));
        let product = convolve(&a, &b).unwrap();
        prop_assert!(distance(&product, &convolve(&b, &a).unwrap()) < 1e-15);
        prop_assert!((product.sum() - a.sum() * b.sum()).abs() < 1e-14);
        prop_assert!((product.duration() - a.duration() - b.duration()).abs() <= 1e-14 * product.duration());
        prop_assert_eq!(product.is_positive(), a.is_positive() && b.is_positive());
        // at every frequency V is the product of both
        for frequency in [0.0, 0.3, 1.0, ratio, 7.0] {
            let v = |shaper| residual_vibration(shaper, frequency, zeta);
            prop_assert!((v(&product) - v(&a) * v(&b)).abs() < 1e-13);
        }
        let doubled: Vec<_> = b.impulses().iter().map(|impulse| {
            swayless_shaping::Impulse { amplitude: 2.0 * impulse.amplitude, ..*impulse }
        }).collect();
        let twice = convolve(&a, &Shaper::new(&doubled).unwrap()).unwrap();
        for (one, two) in product.impulses().iter().zip(twice.impulses()) {
            prop_assert_eq!((one.time, 2.0 * one.amplitude), (two.time, two.amplitude));
        }
    }

    #[test]
    fn damped_solutions_leave_nothing(ratio in ratios(), exponent in -3.0..3.0_f64,
                                      zeta in (0.0..0.3_f64, 0.0..0.3_f64), alike in any::<bool>()) {
        let slow = 10.0_f64.powf(exponent);
        let modes = [mode(slow * ratio, zeta.0), mode(slow, if alike { zeta.0 } else { zeta.1 })];
        let found = solutions(modes);
        prop_assert!(found.len() <= MinimumImpulse::MOST);
        for index in [1, 2, 5].into_iter().filter(|index| *index <= found.len()) {
            prop_assert_eq!(&minimum_impulse_solution(modes, index).unwrap(), &found[index - 1]);
        }
        for (index, shaper) in found.iter().enumerate() {
            prop_assert!(highest_residual(shaper, modes) <= 1e-14 * (10.0 + size(shaper)), "{} {:?}", ratio, shaper);
            prop_assert!((shaper.sum() - 1.0).abs() <= 1e-15 * (10.0 + size(shaper)));
            prop_assert_eq!(shaper.impulses()[0].time, 0.0);
            prop_assert!(found[..index].iter().all(|other| distance(other, shaper) > 1e-9));
        }
        prop_assert!(found.windows(2).all(|pair| pair[0].duration() <= pair[1].duration() * (1.0 + 1e-9)));
    }

    /// As damping vanishes, so does what it changes.
    #[test]
    fn little_damping_changes_little(ratio in 1.0..10.0_f64) {
        let flat = |shaper: &Shaper| shaper.impulses().iter().any(|impulse| impulse.amplitude.abs() < 0.03);
        let found = solutions([mode(1.0, 1e-7), mode(ratio, 1e-7)]);
        for shaper in solutions(undamped(ratio).map(|undamped| mode(undamped.frequency() / TAU, 0.0))) {
            prop_assume!(!flat(&shaper) && size(&shaper) < 20.0);
            prop_assert!(found.iter().any(|other| distance(other, &shaper) < 1e-3), "{:?}", shaper);
        }
    }
}

#[test]
fn convolution_of_zero_vibration_shapers_gives_those_of_higher_order() {
    for (zeta, frequency) in [(0.0, 1.0), (0.0, 0.7), (0.1, 3.3)] {
        let zv = designed(Kind::ZV, frequency, zeta);
        let mut product = Shaper::unshaped();
        for kind in [Kind::ZV, Kind::ZVD, Kind::ZVDD, Kind::ZVDDD] {
            product = convolve(&product, &zv).unwrap();
            assert!(distance(&product, &designed(kind, frequency, zeta)) < 1e-15, "{kind}: {product:?}");
        }
        // nine places in common
        let whole = convolve(&product, &product).unwrap();
        assert_eq!(whole.impulses().len(), 9, "{whole:?}");
    }
}

#[test]
fn convolution_is_refused_beyond_the_capacity() {
    let train = |count: i32, step: f64| {
        let impulses = (0..count).map(|i| swayless_shaping::Impulse { time: f64::from(i) * step, amplitude: 0.5 });
        Shaper::new(&impulses.collect::<Vec<_>>()).unwrap()
    };
    assert_eq!(convolve(&train(5, 1.0), &train(5, 10.0)).unwrap().impulses().len(), 25);
    assert_eq!(convolve(&train(4, 1.0), &train(8, 10.0)).unwrap().impulses().len(), MAX_IMPULSES);
    assert_eq!(convolve(&train(3, 1.0), &train(11, 10.0)), Err(ShaperError::Count { count: 33 }));
    assert_eq!(convolve(&train(32, 1.0), &train(32, 100.0)), Err(ShaperError::Count { count: 1024 }));
    let far = train(2, f64::MAX);
    assert!(matches!(convolve(&far, &far), Err(ShaperError::Time { .. })));
}

/// With so much damping a train's last impulse may be next to nothing: without it, at the end of the others, the vibration is not.
#[test]
fn a_last_impulse_is_not_left_out() {
    let modes = [mode(1.440294451185972, 0.868680462824934), mode(0.7201472255054657, 0.9052109228283731)];
    for train in solutions(modes) {
        assert!(highest_residual(&train, modes) < 1e-12, "{train:?}");
    }
}

#[test]
fn refusals() {
    let count = solutions(undamped(4.0)).len();
    for index in [0, count + 1, usize::MAX] {
        let error = minimum_impulse_solution(undamped(4.0), index).unwrap_err();
        assert_eq!(error, MinimumImpulseError::Solution { index, count });
        assert!(error.to_string().contains(&format!("{index}: minimum impulses have {count}")));
    }
    let error = minimum_impulse(undamped(51.0)).unwrap_err();
    assert!(matches!(error, MinimumImpulseError::Apart { .. }) && error.to_string().contains("51 times as fast"));
}
