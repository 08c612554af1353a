//! The one door: it gives what the functions behind it give, and says what to change where it gives nothing.

use swayless_shaping::{
    Band, CompensatedForm, Designer, Kind, Quantity, Ramp, Specification, compensated, convolve, design, limited,
    limited_insensitivity, minimum_impulse_solution, specified_insensitivity, specified_insensitivity_of,
};

use crate::{distance, mode};

#[test]
fn a_specification_gives_the_design_of_its_kind() {
    for kind in Kind::OF_A_MODE {
        let wanted = Specification { vibration_limit: 0.1, ..Specification::new(kind, mode(1.3, 0.02)) };
        assert_eq!(*wanted.design().unwrap().shaper(), design(kind, mode(1.3, 0.02), 0.1).unwrap(), "{kind}");
    }
}

#[test]
fn si_is_designed_around_the_mode() {
    let wanted = Specification { insensitivity: 0.3, ..Specification::new(Kind::SI, mode(1.7, 0.01)) };
    let direct = specified_insensitivity(Band::around(1.7, 0.3).unwrap(), 0.01, 0.05).unwrap();
    assert!(distance(wanted.design().unwrap().shaper(), &direct) < 1e-8);
}

#[test]
fn limited_shapers_are_designed_for_a_step() {
    for (kind, limit) in [(Kind::ALZVD, 0.0), (Kind::ALEI, 0.05)] {
        let wanted = Specification {
            acceleration_limit: 0.12,
            velocity_limit: 0.358,
            ..Specification::new(kind, mode(1.76, 0.01))
        };
        let design = wanted.design().unwrap();
        let direct = limited(mode(1.76, 0.01), Ramp::new(0.358, 0.12).unwrap(), limit).unwrap();
        assert_eq!(design.shaper(), direct.shaper());
        assert!(!design.adds_up() && design.braking().is_none());
    }
}

/// What every change relies on: all of it is passed on. And only trains made for a drive may not overlap.
#[test]
fn trains_of_every_kind_pass_all_on() {
    for kind in Kind::ALL {
        let second =
            matches!(kind, Kind::Convolved | Kind::MinimumImpulse | Kind::MultiModeSI).then(|| mode(3.1, 0.02));
        let wanted = Specification {
            modes: [Some(mode(1.3, 0.01)), second],
            acceleration_limit: 0.5,
            acceleration_time_constant: 0.2,
            braking_time_constant: 0.1,
            ..Specification::new(kind, mode(1.3, 0.01))
        };
        let design = wanted.design().unwrap();
        for train in [Some(design.shaper()), design.braking()].into_iter().flatten() {
            assert!((train.sum() - 1.0).abs() < 1e-13, "{kind}: {:e}", train.sum() - 1.0);
        }
        assert_eq!(design.braking().is_some(), kind == Kind::UMZVc);
        assert_eq!(design.adds_up(), !kind.name().starts_with("AL") && kind != Kind::UMZVc, "{kind}");
    }
}

#[test]
fn alsi_is_designed_around_the_mode_for_a_step() {
    let wanted = Specification {
        insensitivity: 0.3,
        acceleration_limit: 0.12,
        velocity_limit: 0.358,
        ..Specification::new(Kind::ALSI, mode(1.76, 0.0))
    };
    let (range, ramp) = (Band::around(1.76, 0.3).unwrap(), Ramp::new(0.358, 0.12).unwrap());
    let direct = limited_insensitivity(range, 0.0, ramp, 0.05).unwrap();
    let design = wanted.design().unwrap();
    assert_eq!(design.shaper(), direct.shaper());
    assert!(!design.adds_up());
    assert_eq!(Designer::default().design(&wanted).unwrap(), design);
    let refused = |wanted: Specification| wanted.design().unwrap_err().quantity();
    assert_eq!(refused(Specification { velocity_limit: 100.0, ..wanted }), Quantity::VelocityLimit);
    assert_eq!(refused(Specification { acceleration_limit: 0.0, ..wanted }), Quantity::AccelerationLimit);
    assert_eq!(refused(Specification { insensitivity: 2.0, ..wanted }), Quantity::Insensitivity);
    assert_eq!(refused(Specification { vibration_limit: 0.0, ..wanted }), Quantity::VibrationLimit);
}

#[test]
fn umzvc_has_both_trains() {
    let wanted = Specification {
        acceleration_time_constant: 0.2,
        braking_time_constant: 0.065,
        ..Specification::new(Kind::UMZVc, mode(3.4, 0.01))
    };
    let design = wanted.design().unwrap();
    let both = compensated(mode(3.4, 0.01), 0.2, 0.065, CompensatedForm::ExactRamp).unwrap();
    assert_eq!((design.shaper(), design.braking()), (&both.accelerating, Some(&both.braking)));
    assert!(!design.adds_up());
    assert_eq!(design.duration(), both.accelerating.duration().max(both.braking.duration()));
}

#[test]
fn what_a_designer_remembers_does_not_show() {
    let mut designer = Designer::default();
    for (kind, insensitivity, frequency) in [
        (Kind::SI, 0.3, 1.0),
        (Kind::SI, 0.3, 0.7),
        (Kind::ZVD, 0.3, 0.7),
        (Kind::SI, 0.5, 0.7),
        (Kind::SI, 2.0, 0.7),
        (Kind::SI, 0.3, 2.9),
    ] {
        let wanted = Specification { insensitivity, ..Specification::new(kind, mode(frequency, 0.01)) };
        assert_eq!(designer.design(&wanted), wanted.design());
        assert_eq!(designer.design(&wanted), wanted.design(), "again");
    }
}

#[test]
fn kinds_for_two_modes_need_both() {
    let at = |frequency| mode(frequency, 0.0);
    let modes = [at(1.0), at(3.7)];
    let of = |kind| Specification { modes: modes.map(Some), ..Specification::new(kind, modes[0]) };
    let wanted = Specification { base_kinds: [Kind::EI, Kind::SI], ..of(Kind::Convolved) };
    let si = Specification::new(Kind::SI, modes[1]).design().unwrap();
    let series = convolve(&design(Kind::EI, modes[0], 0.05).unwrap(), si.shaper()).unwrap();
    assert_eq!(*wanted.design().unwrap().shaper(), series);
    let wanted = Specification { solution: 3, ..of(Kind::MinimumImpulse) };
    assert_eq!(*wanted.design().unwrap().shaper(), minimum_impulse_solution(modes, 3).unwrap());
    let wanted = Specification { insensitivity: 0.2, ..of(Kind::MultiModeSI) };
    let ranges = modes.map(|mode| (Band::around(mode.frequency(), 0.2).unwrap(), 0.0));
    assert_eq!(*wanted.design().unwrap().shaper(), specified_insensitivity_of(&ranges, 0.05).unwrap());
    let (faster, mut designer) = (modes.map(|mode| at(1.7 * mode.frequency())), Designer::default());
    for modes in [modes.map(Some), faster.map(Some)] {
        let wanted = Specification { modes, ..wanted };
        assert_eq!(designer.design(&wanted), wanted.design());
    }

    for kind in [Kind::Convolved, Kind::MinimumImpulse, Kind::MultiModeSI] {
        let wanted = of(kind);
        let refused = |wanted: Specification| wanted.design().unwrap_err().quantity();
        assert_eq!(refused(Specification { modes: [wanted.modes[0], None], ..wanted }), Quantity::Frequency(1));
        let sluggish = [mode(1.0, 0.0), mode(1.0, 0.99)].map(Some);
        let bases = Specification { base_kinds: [Kind::UMZVD; 2], modes: sluggish, ..of(Kind::Convolved) };
        assert_eq!(refused(bases), Quantity::DampingRatio(1));
        for (index, base_kinds) in [[kind, Kind::ZV], [Kind::ZV, kind]].into_iter().enumerate() {
            let nested = Specification { base_kinds, ..of(Kind::Convolved) };
            assert_eq!(refused(nested), Quantity::BaseKind(index));
        }
        assert_eq!(refused(Specification { solution: 99, ..of(Kind::MinimumImpulse) }), Quantity::Solution);
    }
}

#[test]
fn a_refusal_says_what_to_change() {
    let first = Specification::new(Kind::ZV, mode(1.0, 0.0));
    let cases = [
        (Specification { modes: [None; 2], ..first }, Quantity::Frequency(0)),
        (Specification { modes: [first.modes[0]; 2], ..first }, Quantity::Frequency(1)),
        (Specification { kind: Kind::EI, vibration_limit: 1.0, ..first }, Quantity::VibrationLimit),
        (Specification { kind: Kind::SI, vibration_limit: 0.0, ..first }, Quantity::VibrationLimit),
        (Specification { kind: Kind::SI, insensitivity: 2.0, ..first }, Quantity::Insensitivity),
        (Specification { kind: Kind::UMZVc, braking_time_constant: -1.0, ..first }, Quantity::BrakingTimeConstant),
        (
            Specification { kind: Kind::UMZVc, acceleration_time_constant: 4.0, ..first },
            Quantity::AccelerationTimeConstant,
        ),
        (
            Specification { kind: Kind::UMZVc, ..Specification::new(Kind::UMZVc, mode(1.0, 0.998)) },
            Quantity::DampingRatio(0),
        ),
        (
            Specification { kind: Kind::UMZVD, ..Specification::new(Kind::UMZVD, mode(1.0, 0.99)) },
            Quantity::DampingRatio(0),
        ),
    ];
    for (wanted, quantity) in cases {
        let error = wanted.design().unwrap_err();
        assert_eq!(error.quantity(), quantity, "{error}");
    }
}
