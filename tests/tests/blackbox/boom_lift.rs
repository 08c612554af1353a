//! `BoomLift` against where its joints must have taken it. That its derivatives are those of (3.23) is tested in Python.

use std::f64::consts::FRAC_PI_4;

use crate::instance::{Instance, Set};

const LENGTH: f64 = 12.0;

/// (r + ρ)(cos γ cos θ, cos γ sin θ, sin γ), above the boom's foot at 1.5 m.
fn tip(slew: f64, luff: f64, extension: f64) -> [f64; 3] {
    let reach = LENGTH + extension;
    [reach * luff.cos() * slew.cos(), reach * luff.cos() * slew.sin(), 1.5 + reach * luff.sin()]
}

/// Steady rates: the joints are where rate times time takes them, up to a limit, and the tip is where they say.
#[test]
fn joints_run_to_their_limits_and_carry_the_tip() {
    let starts = [("boom.height", 1.5), ("luff.angle_max", 1.2), ("extension.length_max", 3.0)];
    for [slew, luff, extension] in [[0.3, 0.1, 0.25], [-0.2, -0.09, 0.5], [0.0, 0.05, -0.1]] {
        let rates =
            [("slew.rate", slew), ("luff.rate", luff), ("extension.rate", extension), ("extension.length", 1.0)];
        let values: Vec<_> = starts.iter().chain(&rates).map(|(name, value)| (*name, Set::Real(*value))).collect();
        // Limits are met in the middle of steps.
        let mut lift = Instance::started("BoomLift", 0.77, &values);
        while lift.time() < 15.0 {
            lift.step();
            let t = lift.time();
            let [luff, extension] = [(FRAC_PI_4 + luff * t).clamp(0.0, 1.2), (1.0 + extension * t).clamp(0.0, 3.0)];
            let joints = lift.get3(["slew.angle", "luff.angle", "extension.length"]);
            let wanted = [slew * t, luff, extension];
            assert!((0..3).all(|i| (joints[i] - wanted[i]).abs() < 1e-12), "at {t} s: {joints:?}, not {wanted:?}");
            let (found, wanted) = (lift.get3(["tip.x", "tip.y", "tip.z"]), tip(slew * t, luff, extension));
            assert!((0..3).all(|i| (found[i] - wanted[i]).abs() < 1e-11), "at {t} s: {found:?}, not {wanted:?}");
            let held = [0.0, 1.2].contains(&luff) || [0.0, 3.0].contains(&extension);
            assert_eq!(lift.get_switch("at_limit"), held, "at {t} s");
        }
    }
}

#[test]
fn a_start_beyond_a_limit_is_refused_by_name() {
    let mut lift = Instance::new("BoomLift", swayless_modeldesc::types::FmiVersion::V3, 0.1);
    lift.set("extension.length", -0.1).expect("a value");
    lift.set("luff.angle", 1.55).expect("a value");
    let failure = lift.initialize(None).expect_err("a refusal");
    let text = format!("{:?}", failure.messages);
    for wrong in ["luff.angle is 1.55", "extension.length is -0.1"] {
        assert!(text.contains(wrong), "{text}");
    }
}
