//! What is refused, and that the refusal names the value and the range.

use swayless_shaping::{
    DesignError, Impulse, Kind, MAX_IMPULSES, Mode, ModeError, Shaper, ShaperError, design, insensitivity,
};

use crate::{designed, mode};

#[test]
fn modes() {
    for value in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::MAX, f64::MIN_POSITIVE] {
        let error = Mode::new(value, 0.1).unwrap_err();
        assert!(matches!(error, ModeError::Frequency { .. }), "{value}");
        assert!(error.to_string().contains(&value.to_string()) && error.to_string().contains("greater than 0"));
    }
    for value in [-1e-300, 1.0, 2.0, f64::NAN, f64::INFINITY] {
        let error = Mode::new(1.0, value).unwrap_err();
        assert!(matches!(error, ModeError::DampingRatio { .. }), "{value}");
        assert!(error.to_string().contains(&value.to_string()) && error.to_string().contains("less than 1"));
    }
}

#[test]
fn vibration_limits() {
    for value in [-0.01, 1.0, f64::NAN] {
        for kind in Kind::OF_A_MODE {
            let designed = design(kind, mode(1.0, 0.0), value);
            if !matches!(kind, Kind::EI | Kind::TwoHumpEI | Kind::ThreeHumpEI | Kind::UMEI) {
                assert!(designed.is_ok(), "{kind} works without a limit");
                continue;
            }
            let error = designed.unwrap_err();
            assert!(matches!(error, DesignError::VibrationLimit { .. }), "{kind}: {value}");
            assert!(error.to_string().contains(&value.to_string()));
        }
    }
}

#[test]
fn overdamped_beyond_resolution() {
    let error = design(Kind::UMZV, mode(1.0, 0.9999), 0.05).unwrap_err();
    assert!(error.to_string().contains("UMZV") && error.to_string().contains("0.9999"));
}

/// Next to where solutions end it depends on the way there which is found: what is named must have a design by the usual way.
#[test]
fn the_damping_that_is_named_has_a_design() {
    for (kind, zeta, limit) in [
        (Kind::EI, 0.4798564794277395, 0.13913829295322),
        (Kind::EI, 0.3212, 0.37956),
        (Kind::EI, 0.7613997174387181, 0.08603813691333247),
        (Kind::TwoHumpEI, 0.2749984882702156, 0.490570358894267),
        (Kind::ThreeHumpEI, 0.16675354288261907, 0.3304001267084628),
        (Kind::ThreeHumpEI, 0.41252934018957516, 0.3838782743449283),
    ] {
        let error = design(kind, mode(1.0, zeta), limit).unwrap_err();
        let DesignError::NoSolution { nearest_damping_ratio: Some(nearest), .. } = error else { panic!("{error}") };
        assert!(nearest < zeta && design(kind, mode(1.0, nearest), limit).is_ok(), "{error}");
    }
}

#[test]
fn impulse_trains() {
    let one = |time, amplitude| Impulse { time, amplitude };
    assert_eq!(Shaper::new(&[]), Err(ShaperError::Count { count: 0 }));
    let many: Vec<_> = (0..=MAX_IMPULSES).map(|index| one(index as f64, 1.0)).collect();
    assert_eq!(Shaper::new(&many), Err(ShaperError::Count { count: MAX_IMPULSES + 1 }));
    assert_eq!(Shaper::new(&many[1..]).unwrap().impulses(), &many[1..]);
    assert_eq!(Shaper::new(&[one(-1.0, 1.0)]), Err(ShaperError::Time { index: 0, value: -1.0 }));
    assert_eq!(Shaper::new(&[one(1.0, 1.0), one(1.0, 1.0)]), Err(ShaperError::Time { index: 1, value: 1.0 }));
    let error = Shaper::new(&[one(0.0, 1.0), one(1.0, f64::INFINITY)]).unwrap_err();
    assert_eq!(error, ShaperError::Amplitude { index: 1, value: f64::INFINITY });
    assert!(error.to_string().contains("impulse 1"));
}

#[test]
fn no_band_where_there_is_none() {
    let unshaped = designed(Kind::None, 1.0, 0.0);
    assert_eq!(insensitivity(&unshaped, mode(1.0, 0.0), 0.05), 0.0);
    assert_eq!(insensitivity(&unshaped, mode(1.0, 0.0), f64::NAN), 0.0);
    assert_eq!(insensitivity(&unshaped, mode(1.0, 0.0), 1.5), f64::INFINITY);
}
