//! `TowerCrane` against closed forms, a conservation law, and the boom crane with its boom horizontal.

use std::f64::consts::FRAC_PI_2;

use crate::boom_crane::{energy, off_the_closed_form};
use crate::instance::{Instance, Set};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 20.0;

fn started(name: &str, step: f64, values: &[(&str, f64)]) -> Instance {
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, Set::Real(*value))).collect();
    Instance::started(name, step, &values)
}

fn crane(step: f64, values: &[(&str, f64)]) -> Instance {
    started("TowerCrane", step, values)
}

#[test]
fn a_velocity_step_answers_as_the_closed_form() {
    const SPEED: f64 = 1e-4;
    let steps = [("trolley.rate", SPEED, "swing.radial"), ("slew.rate", SPEED / RADIUS, "swing.tangential")];
    for (input, rate, angle) in steps {
        for before_start in [rate, 0.0] {
            let mut crane = crane(0.01, &[(input, before_start)]);
            crane.set(input, rate).expect("a rate");
            let worst = off_the_closed_form(&mut crane, angle, SPEED);
            println!("step of {input}: within {worst:.1e} of the peak");
            // Slewing moves the trolley along a circle: that is of second order in SPEED.
            assert!(worst <= 1e-6, "{input}: off by {worst:e} of the peak");
        }
    }
}

#[test]
fn free_swing_keeps_its_energy() {
    let start = [("swing.radial_start", 0.7), ("swing.tangential_start", -0.4), ("swing.tangential_rate_start", 0.3)];
    let mut crane = crane(0.1, &start);
    let first = energy(&mut crane);
    while crane.time() < 60.0 {
        crane.step();
        let drift = (energy(&mut crane) - first).abs();
        assert!(drift <= 1e-9, "at {} s: energy drifts by {drift:e} m·g·ℓ", crane.time());
    }
}

/// Steady slewing carries the payload round as a conical pendulum, at rest in the turning frame: g tan φ = Ω² (R + ℓ sin φ).
#[test]
fn steady_slewing_is_a_conical_pendulum() {
    for (rate, length) in [(0.2_f64, 10.0_f64), (-0.35, 10.0), (0.1, 60.0)] {
        let mut angle = 0.0_f64;
        for _ in 0..200 {
            // Each round is nearer by Ω²ℓ/g, an eighth at most.
            angle = (rate * rate * (RADIUS + length * angle.sin()) / GRAVITY).atan();
        }
        // Started with the payload's speed on its circle, which counts from the resting trolley: ℓ cos φ β̇.
        let around = rate * (RADIUS + length * angle.sin()) / (length * angle.cos());
        let mut crane = crane(
            0.1,
            &[
                ("hoist.length", length),
                ("swing.radial_start", angle),
                ("swing.tangential_rate_start", around),
                ("slew.rate", rate),
            ],
        );
        while crane.time() < 60.0 {
            let found = crane.get3(["swing.radial", "swing.tangential", "swing.tangential_rate"]);
            let off = (found[0] - angle).abs().max(found[1].abs()).max(found[2].abs());
            assert!(off < 1e-9, "{rate} rad/s, {length} m, at {} s: off by {off:e}", crane.time());
            crane.step();
        }
        assert!((crane.get("slew.angle") - 60.0 * rate).abs() < 1e-11);
    }
}

/// A horizontal boom that telescopes is a jib with a trolley.
#[test]
fn a_horizontal_boom_is_a_jib() {
    let common = [("swing.damping", 0.05), ("swing.radial_start", 0.1), ("hoist.length", 8.0), ("slew.angle", 0.4)];
    let mut tower = crane(0.02, &[&common[..], &[("jib.height", 30.0), ("trolley.radius", 18.0)]].concat());
    let boom = [("boom.height", 30.0), ("boom.length", 18.0), ("luff.angle", 0.0)];
    let mut boom = started("BoomCrane", 0.02, &[&common[..], &boom].concat());
    while tower.time() < 20.0 {
        let t = tower.time();
        let (slew, out, hoist) = (0.15 * (0.6 * t).sin(), 0.8 * (0.5 * t).cos(), 0.3 * (0.9 * t).sin());
        for (crane, radius) in [(&mut tower, "trolley.rate"), (&mut boom, "boom.rate")] {
            for (name, value) in [("slew.rate", slew), (radius, out), ("hoist.rate", hoist), ("wind.y", 300.0)] {
                crane.set(name, value).expect("a value");
            }
            crane.step();
        }
        let trolley = tower.get3(["trolley.x", "trolley.y", "trolley.z"]);
        let tip = boom.get3(["tip.x", "tip.y", "tip.z"]);
        assert!((0..3).all(|i| (trolley[i] - tip[i]).abs() < 1e-10), "at {t} s: {trolley:?} and {tip:?}");
        for name in ["payload.x", "payload.y", "payload.z", "swing.radial", "swing.tangential", "swing.amplitude"] {
            let (a, b) = (tower.get(name), boom.get(name));
            assert!((a - b).abs() < 1e-8, "{name} at {t} s: {a} and {b}");
        }
    }
}

/// Wind is a force in the world: with the jib along y, wind along y is radial and wind along x comes from ahead.
#[test]
fn wind_pushes_the_payload_to_the_static_angle() {
    let mut crane =
        crane(0.1, &[("slew.angle", FRAC_PI_2), ("swing.damping", 1.0), ("wind.x", 1500.0), ("wind.y", -700.0)]);
    crane.run_to(80.0);
    let weight = 1000.0 * GRAVITY;
    let total = weight.hypot(1500.0).hypot(700.0);
    assert!((crane.get("swing.radial") + (700.0 / total).asin()).abs() < 1e-9);
    assert!((crane.get("swing.tangential") + (1500.0 / weight).atan()).abs() < 1e-9);
    let [x, y, z] = crane.get3(["payload.x", "payload.y", "payload.z"]);
    let wanted = [15_000.0 / total, RADIUS - 7000.0 / total, 40.0 - 10.0 * weight / total];
    assert!((x - wanted[0]).abs() + (y - wanted[1]).abs() + (z - wanted[2]).abs() < 1e-8, "({x}, {y}, {z})");
}

/// The trolley runs out to its limit at 21 m and the hoist down to its limit at 11 m, each within a step.
#[test]
fn joints_stop_at_their_limits() {
    let limits = [("trolley.radius_max", 21.0), ("hoist.length_max", 11.0), ("trolley.rate", 0.4), ("hoist.rate", 0.3)];
    let mut crane = crane(0.7, &limits);
    while crane.time() < 7.0 {
        crane.step();
        let t = crane.time();
        let [radius, length, x] = crane.get3(["trolley.radius", "hoist.length", "trolley.x"]);
        assert!(
            (radius - (20.0 + 0.4 * t).min(21.0)).abs() < 1e-12 && (x - radius).abs() < 1e-12,
            "at {t} s: {radius}"
        );
        assert!((length - (10.0 + 0.3 * t).min(11.0)).abs() < 1e-12, "at {t} s: {length}");
        assert_eq!(crane.get_switch("at_limit"), t > 2.5);
    }
    crane.set("trolley.rate", -0.4).expect("a rate");
    crane.set("hoist.rate", -0.3).expect("a rate");
    crane.step();
    assert!(!crane.get_switch("at_limit"));
    // Too fast for any crane: cut at 100 rad/s, which a flag tells.
    crane.set("slew.rate", 1e300).expect("a rate");
    crane.step();
    assert!(crane.get_switch("at_limit") && (crane.get("slew.angle") - 70.0).abs() < 1e-9);
}
