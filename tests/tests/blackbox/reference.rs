//! `BoomCrane` against trajectories that were integrated independently.
//!
//! `data/boom_payload.json` holds solutions of the thesis's equations for the payload (2.13–2.14, corrected) in two
//! orders of the swing angles and of a Cartesian model with a multiplier, which agree within 2e-10 m. Joints move on
//! quintics from rest to rest; angles are in the order "β, then φ", which is our `swing.tangential`, `swing.radial`.

use serde_json::Value as Json;

use crate::instance::{Instance, Set};
use crate::packaged;

/// Communication step (s). The rates are held at each step's average, so that the joints are exact at every
/// communication point; what is left is an error of second order.
const STEP: f64 = 1e-3;
const ANGLE: f64 = 1e-6;
const POSITION: f64 = 1e-6;
/// Of the tension per mass (m/s²).
const TENSION: f64 = 1e-5;

/// A joint: a number where it rests, `[t0, t1, from, to]` where it moves.
pub struct Joint(pub [f64; 4]);

impl Joint {
    fn of(definition: &Json, name: &str) -> Self {
        let number = |json: &Json| json.as_f64().expect("a number");
        match &definition[name] {
            Json::Array(parts) => Self(std::array::from_fn(|i| number(&parts[i]))),
            fixed => Self([0.0, 1.0, number(fixed), number(fixed)]),
        }
    }

    /// The quintic from rest to rest.
    pub fn at(&self, time: f64) -> f64 {
        let [begin, end, from, to] = self.0;
        let s = ((time - begin) / (end - begin)).clamp(0.0, 1.0);
        from + (to - from) * s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s)
    }

    /// Its rate and acceleration.
    pub fn rates(&self, time: f64) -> [f64; 2] {
        let [begin, end, from, to] = self.0;
        let s = ((time - begin) / (end - begin)).clamp(0.0, 1.0);
        let scale = (to - from) / (end - begin);
        [scale * 30.0 * (s * (1.0 - s)).powi(2), scale / (end - begin) * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s)]
    }
}

#[test]
fn boom_crane_follows_the_reference_trajectories() {
    let reference = packaged::data("boom_payload.json");
    let scenarios = reference["scenarios"].as_object().expect("scenarios");
    assert_eq!(scenarios.len(), 3);
    for (name, scenario) in scenarios {
        let [angle, position, tension] =
            largest_differences(&scenario["def"], scenario["rows"].as_array().expect("rows"));
        println!("{name}: within {angle:.1e} rad, {position:.1e} m, {tension:.1e} m/s²");
        assert!(angle <= ANGLE, "{name}: angles differ by {angle:e} rad");
        assert!(position <= POSITION, "{name}: the payload is off by {position:e} m");
        assert!(tension <= TENSION, "{name}: the tension per mass is off by {tension:e} m/s²");
    }
}

fn largest_differences(definition: &Json, rows: &[Json]) -> [f64; 3] {
    let joints = [
        ("base.velocity.x", "base.acceleration.x", "base.x", Joint::of(definition, "x")),
        ("base.velocity.y", "base.acceleration.y", "base.y", Joint::of(definition, "y")),
        ("base.yaw_rate", "base.yaw_acceleration", "base.yaw", Joint::of(definition, "psi")),
        ("slew.rate", "slew.acceleration", "slew.angle", Joint::of(definition, "theta")),
        ("luff.rate", "luff.acceleration", "luff.angle", Joint::of(definition, "gamma")),
        ("hoist.rate", "hoist.acceleration", "hoist.length", Joint::of(definition, "l")),
    ];
    let fixed = |name: &str| Set::Real(definition[name].as_f64().expect("a fixed number"));
    let start = |i: usize| Set::Real(definition["ic"][i].as_f64().expect("a start value"));
    let mut values = vec![
        ("boom.offset", fixed("a")),
        ("boom.height", fixed("h")),
        ("boom.length", fixed("r")),
        ("payload.mass", Set::Real(1.0)),
        ("swing.tangential_start", start(0)),
        ("swing.radial_start", start(1)),
        ("swing.tangential_rate_start", start(2)),
        ("swing.radial_rate_start", start(3)),
    ];
    values.extend(joints.iter().map(|(_, _, state, joint)| (*state, Set::Real(joint.at(0.0)))));
    let mut crane = Instance::started("BoomCrane", STEP, &values);

    let [mut angle, mut position, mut tension] = [0.0_f64; 3];
    for row in rows {
        let wanted = |i: usize| row[i].as_f64().expect("a number");
        while crane.time() + 0.5 * STEP < wanted(0) {
            let (now, next) = (crane.time(), crane.time() + STEP);
            for (rate, _, _, joint) in &joints {
                crane.set(rate, (joint.at(next) - joint.at(now)) / STEP).expect("a rate");
            }
            crane.step();
        }
        let swing = [crane.get("swing.tangential") - wanted(1), crane.get("swing.radial") - wanted(2)];
        angle = swing.iter().fold(angle, |worst, d| worst.max(d.abs()));
        let payload = crane.get3(["payload.x", "payload.y", "payload.z"]);
        position = (0..3).fold(position, |worst, i| worst.max((payload[i] - wanted(7 + i)).abs()));
        // The tension is that of the moment, not of a step.
        for (rate, acceleration, _, joint) in &joints {
            let [first, second] = joint.rates(wanted(0));
            crane.set(rate, first).expect("a rate");
            crane.set(acceleration, second).expect("an acceleration");
        }
        tension = tension.max((crane.get("tension") - wanted(10)).abs());
    }
    [angle, position, tension]
}
