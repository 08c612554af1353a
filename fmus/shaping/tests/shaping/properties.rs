//! What holds for every mode, every kind and every limit.

use proptest::prelude::*;
use swayless_shaping::{
    Band, DesignError, Kind, Mode, band, design, highest_vibration, insensitivity, residual_vibration,
    sensitivity_curve,
};

use crate::{distance, mode, shaper};

fn kinds() -> impl Strategy<Value = Kind> {
    proptest::sample::select(Kind::OF_A_MODE.to_vec())
}

fn modes() -> impl Strategy<Value = Mode> {
    // frequencies over 12 decades; every tenth mode undamped
    (-6.0..6.0_f64, prop_oneof![9 => 0.0..0.3_f64, 1 => Just(0.0)])
        .prop_map(|(exponent, zeta)| mode(10.0_f64.powf(exponent), zeta))
}

/// Where a kind with humps has no solution any more, the mode with the nearest damping that is said to have one.
fn feasible(kind: Kind, wanted: Mode, limit: f64) -> Mode {
    match design(kind, wanted, limit) {
        Err(DesignError::NoSolution { nearest_damping_ratio: Some(nearest), .. }) => {
            assert!(nearest > 0.1 && nearest < wanted.damping_ratio(), "{kind}: {nearest}");
            mode(wanted.frequency(), nearest)
        }
        _ => wanted,
    }
}

proptest! {
    #[test]
    fn designs_are_sound(kind in kinds(), mode in modes(), limit in 0.0..0.2_f64) {
        let mode = feasible(kind, mode, limit);
        let shaper = design(kind, mode, limit).unwrap();
        prop_assert!((shaper.sum() - 1.0).abs() <= 1e-14);
        prop_assert_eq!(shaper.impulses()[0].time, 0.0);
        prop_assert!(shaper.impulses().is_sorted_by(|a, b| a.time < b.time));
        prop_assert_eq!(shaper.is_positive(), !matches!(kind, Kind::UMZV | Kind::UMZVD | Kind::UMEI));
        let expected = match kind {
            Kind::None => 1.0,
            Kind::EI | Kind::ThreeHumpEI | Kind::UMEI => limit,
            _ => 0.0,
        };
        let at_design = residual_vibration(&shaper, mode.frequency(), mode.damping_ratio());
        prop_assert!((at_design - expected).abs() <= 1e-12, "{} {}", at_design, expected);
    }

    #[test]
    fn time_scales_with_the_period(kind in kinds(), mode in modes(), limit in 0.0..0.2_f64) {
        let mode = feasible(kind, mode, limit);
        let unit = Mode::new(1.0, mode.damping_ratio()).unwrap();
        let (scaled, unit) = (design(kind, mode, limit).unwrap(), design(kind, unit, limit).unwrap());
        let times = scaled.impulses().iter().map(|impulse| (impulse.time * mode.frequency(), impulse.amplitude));
        for ((time, amplitude), expected) in times.zip(unit.impulses()) {
            prop_assert!((time - expected.time).abs() < 1e-13 * unit.duration().max(1.0));
            prop_assert!((amplitude - expected.amplitude).abs() < 1e-13);
        }
    }

    #[test]
    fn positive_shapers_never_amplify(kind in kinds(), mode in modes(), factor in 0.0..10.0_f64, zeta in 0.0..0.9_f64) {
        let mode = feasible(kind, mode, 0.05);
        let shaper = design(kind, mode, 0.05).unwrap();
        let most = if shaper.is_positive() { 1.0 } else { shaper.impulses().len() as f64 };
        prop_assert!(residual_vibration(&shaper, factor * mode.frequency(), zeta) <= most + 1e-12);
    }

    #[test]
    fn bands_hold_what_they_promise(kind in kinds(), mode in modes(), level in 0.051..0.5_f64) {
        let mode = feasible(kind, mode, 0.05);
        let shaper = design(kind, mode, 0.05).unwrap();
        let Some(Band { lower, upper }) = band(&shaper, mode, level) else {
            prop_assert_eq!(kind, Kind::None);
            return Ok(());
        };
        let zeta = mode.damping_ratio();
        prop_assert!(lower <= mode.frequency() && mode.frequency() <= upper);
        let end = upper.min(20.0 * mode.frequency());
        for point in sensitivity_curve(&shaper, zeta, lower..=end, 300) {
            prop_assert!(point.vibration <= level * (1.0 + 2e-9) + 2e-12, "{:?}", point);
        }
        for edge in [lower, upper] {
            if edge > 0.0 && edge.is_finite() {
                prop_assert!((residual_vibration(&shaper, edge, zeta) - level).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn bands_grow_with_the_level(kind in kinds(), mode in modes(), level in 0.0..0.5_f64, more in 0.0..0.5_f64) {
        let mode = feasible(kind, mode, 0.05);
        let shaper = design(kind, mode, 0.05).unwrap();
        prop_assert!(insensitivity(&shaper, mode, level) <= insensitivity(&shaper, mode, level + more));
    }

    #[test]
    fn no_place_of_a_range_is_above_its_highest(
        kind in kinds(), mode in modes(), zeta in 0.0..0.5_f64, low in 0.0..2.0_f64, width in 0.0..2.0_f64,
    ) {
        let shaper = design(kind, feasible(kind, mode, 0.05), 0.05).unwrap();
        let range = low * mode.frequency()..=(low + width) * mode.frequency();
        let highest = highest_vibration(&shaper, zeta, range.clone());
        prop_assert!(range.contains(&highest.frequency));
        prop_assert_eq!(highest.vibration, residual_vibration(&shaper, highest.frequency, zeta));
        for at in sensitivity_curve(&shaper, zeta, range, 333) {
            prop_assert!(at.vibration <= highest.vibration + 1e-12, "{at:?} is above {highest:?}");
        }
    }

    #[test]
    fn designs_repeat_to_the_bit(kind in kinds(), mode in modes(), limit in 0.0..0.2_f64) {
        prop_assert_eq!(design(kind, mode, limit), design(kind, mode, limit));
    }

    #[test]
    fn nothing_from_outside_panics(kind in kinds(), frequency in any::<f64>(), zeta in any::<f64>(), share in 0.0..1.0_f64,
                                   limit in any::<f64>(), level in any::<f64>()) {
        for zeta in [zeta, share, 1.0 - share * 1e-15] {
            if let Ok(mode) = Mode::new(frequency, zeta) && let Ok(shaper) = design(kind, mode, limit) {
                prop_assert!(distance(&shaper, &shaper) == 0.0 && shaper.duration().is_finite());
                prop_assert!(insensitivity(&shaper, mode, level) >= 0.0);
            }
        }
    }
}

#[test]
fn a_curve_has_both_its_ends() {
    let any = shaper([(0.0, 0.25), (1.0, 0.75)]);
    let curve: Vec<_> = sensitivity_curve(&any, 0.0, 0.1..=0.7, 4).collect();
    assert_eq!((curve.len(), curve[0].frequency, curve[3].frequency), (4, 0.1, 0.7));
    assert_eq!(curve[2].vibration, residual_vibration(&any, curve[2].frequency, 0.0));
    assert_eq!(sensitivity_curve(&any, 0.0, 0.1..=0.7, 1).next().map(|point| point.frequency), Some(0.1));
    assert_eq!(sensitivity_curve(&any, 0.0, 0.1..=0.7, 0).len(), 0);
}
