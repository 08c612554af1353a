//! `MobileBase` against the circles and lines that it drives.

use std::f64::consts::TAU;

use crate::instance::{Instance, Set};

const WHEELBASE: f64 = 3.2;

/// A base on its way: what it is driven with from the start on.
fn base(step: f64, speed: f64, steering: f64, values: &[(&str, f64)]) -> Instance {
    let more = [("wheelbase", WHEELBASE), ("speed", speed), ("steering", steering)];
    let values: Vec<_> = more.iter().chain(values).map(|(name, value)| (*name, Set::Real(*value))).collect();
    Instance::started("MobileBase", step, &values)
}

/// The rear axle runs on a circle of radius L/tan δ, and closes it after 2π L/(v tan δ).
#[test]
fn a_steady_turn_is_a_circle() {
    for (speed, steering) in [(1.2, 0.4), (1.2, -0.4), (-0.8, 0.25), (0.3, 0.6)] {
        let radius = WHEELBASE / f64::tan(steering);
        let turn = TAU * (radius / speed).abs();
        let mut base = base(turn / 64.0, speed, steering, &[]);
        for _ in 0..64 {
            base.step();
            let yaw = speed * base.time() / radius;
            let wanted = [radius * yaw.sin(), radius * (1.0 - yaw.cos()), yaw];
            let found = base.get3(["base.x", "base.y", "base.yaw"]);
            // A hundred times the integrator's tolerance, for a way of 2π radii.
            let near = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-8 * radius.abs().max(1.0));
            assert!(near, "at {} s: {found:?}, not {wanted:?}", base.time());
        }
        let [x, y, yaw] = base.get3(["base.x", "base.y", "base.yaw"]);
        assert!(x.hypot(y) < 1e-8 * radius.abs() && (yaw.abs() - TAU).abs() < 1e-12, "({x}, {y}), {yaw} rad");
    }
}

#[test]
fn without_steering_it_drives_straight() {
    let yaw = 0.7_f64;
    let mut base = base(0.5, -1.5, 0.0, &[("base.x", 2.0), ("base.y", -1.0), ("base.yaw", yaw)]);
    base.run_to(20.0);
    let [x, y, found] = base.get3(["base.x", "base.y", "base.yaw"]);
    let way = -1.5 * base.time();
    assert!((x - 2.0 - way * yaw.cos()).abs() < 1e-12 && (y + 1.0 - way * yaw.sin()).abs() < 1e-12, "({x}, {y})");
    assert_eq!(found, yaw);
}

/// Differences over four steps of 10 ms: their error is h⁴/30 times a fifth derivative, below 1e-9 here.
#[test]
fn velocities_are_the_derivatives_of_positions_and_accelerations_those_of_velocities() {
    const STEP: f64 = 0.01;
    let pairs = [
        ("base.x", "base.velocity.x"),
        ("base.y", "base.velocity.y"),
        ("base.yaw", "base.yaw_rate"),
        ("base.velocity.x", "base.acceleration.x"),
        ("base.velocity.y", "base.acceleration.y"),
        ("base.yaw_rate", "base.yaw_acceleration"),
    ];
    let mut base = base(STEP, 1.4, -0.35, &[("base.yaw", 2.0)]);
    let mut rows = Vec::new();
    while rows.len() < 100 {
        rows.push(pairs.map(|(value, derivative)| (base.get(value), base.get(derivative))));
        base.step();
    }
    for row in rows.windows(5) {
        for (i, (value, derivative)) in pairs.iter().enumerate() {
            let at = |k: usize| row[k][i].0;
            let wanted = (8.0 * (at(3) - at(1)) - (at(4) - at(0))) / (12.0 * STEP);
            let found = row[2][i].1;
            assert!((found - wanted).abs() < 1e-9, "{derivative} is {found}; {value} changes by {wanted}");
        }
    }
}

/// The accelerations that a driver causes: v̇ ahead, and ψ̈ = (v̇ tan δ + v δ̇/cos² δ)/L.
#[test]
fn what_the_driver_changes_counts_until_a_limit_cuts_it() {
    let (speed, steering) = (1.5, 0.3_f64);
    let mut base = base(0.1, speed, steering, &[("acceleration", 0.5), ("steering_rate", 0.2)]);
    let yaw = (0.5 * steering.tan() + speed * 0.2 / steering.cos().powi(2)) / WHEELBASE;
    let left = speed * speed * steering.tan() / WHEELBASE;
    let names = ["base.acceleration.x", "base.acceleration.y", "base.yaw_acceleration"];
    let close = |found: [f64; 3], wanted: [f64; 3]| (0..3).all(|i| (found[i] - wanted[i]).abs() < 1e-14);
    assert!(close(base.get3(names), [0.5, left, yaw]));
    // Both beyond their limits of 2 m/s and 0.6 rad: nothing changes any more. At the limits nothing is cut yet.
    for (name, limit) in [("speed", -2.0), ("steering", 0.6)] {
        base.set(name, limit).expect("a value");
    }
    base.step();
    assert!(!base.get_switch("at_limit"));
    for (name, beyond) in [("speed", -2.1), ("steering", 1e300)] {
        base.set(name, beyond).expect("a value");
    }
    let before = base.get("base.yaw");
    base.step();
    assert!(base.get_switch("at_limit"));
    assert!((base.get("base.yaw_rate") + 2.0 * f64::tan(0.6) / WHEELBASE).abs() < 1e-14);
    assert!((base.get("base.yaw") - before - 0.1 * base.get("base.yaw_rate")).abs() < 1e-12);
    assert_eq!(base.get("base.yaw_acceleration"), 0.0);
    let [x, y, _] = base.get3(names);
    assert!((x.hypot(y) - 4.0 * f64::tan(0.6) / WHEELBASE).abs() < 1e-14, "v²/R, and nothing ahead");
}
