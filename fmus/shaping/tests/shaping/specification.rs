//! The one door: it gives what the functions behind it give, and says what to change where it gives nothing.

use swayless_shaping::{Band, Designer, Kind, Quantity, Specification, design, specified_insensitivity};

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
fn a_refusal_says_what_to_change() {
    let first = Specification::new(Kind::ZV, mode(1.0, 0.0));
    let cases = [
        (Specification { modes: [None; 2], ..first }, Quantity::Frequency(0)),
        (Specification { modes: [first.modes[0]; 2], ..first }, Quantity::Frequency(1)),
        (Specification { kind: Kind::EI, vibration_limit: 1.0, ..first }, Quantity::VibrationLimit),
        (Specification { kind: Kind::SI, vibration_limit: 0.0, ..first }, Quantity::VibrationLimit),
        (Specification { kind: Kind::SI, insensitivity: 2.0, ..first }, Quantity::Insensitivity),
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
