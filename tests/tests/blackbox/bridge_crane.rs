//! `BridgeCrane` against the thesis's frequencies and planar equations, conserved energy, closed forms and `BoomCrane`.

use std::f64::consts::{FRAC_PI_2, TAU};

use serde_json::Value as Json;

use crate::instance::{Instance, Set};
use crate::packaged::repository;

const GRAVITY: f64 = 9.81;

fn crane(step: f64, values: &[(&str, f64)]) -> Instance {
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, Set::Real(*value))).collect();
    Instance::started("BridgeCrane", step, &values)
}

/// Lengths of cable and rigging and masses of hook and payload.
struct Rig {
    cable: f64,
    rigging: f64,
    hook: f64,
    payload: f64,
}

impl Rig {
    fn crane(&self, step: f64, more: &[(&str, f64)]) -> Instance {
        let own = [
            ("hoist.length", self.cable),
            ("rigging.length", self.rigging),
            ("hook.mass", self.hook),
            ("payload.mass", self.payload),
        ];
        crane(step, &[&own[..], more].concat())
    }
}

/// Eqs. 6.3, 6.4: a small swing that starts in a mode's shape keeps it and turns with the mode's frequency.
#[test]
fn small_swing_has_the_frequencies_of_both_modes() {
    const LARGEST: f64 = 1e-4;
    const PERIODS: f64 = 20.0;
    let text = std::fs::read_to_string(repository().join("tests/data/industrial_crane.json")).expect("the reference");
    let reference: Json = serde_json::from_str(&text).expect("JSON");
    let rows = reference["6.3-6.4 examples"].as_object().expect("examples");
    assert_eq!(rows.len(), 6);
    for (name, row) in rows {
        let parts: Vec<f64> =
            name.split(' ').map(|p| p.split_once('=').expect("=").1.parse().expect("a number")).collect();
        let rig = Rig { cable: parts[0], rigging: parts[1], hook: 400.0, payload: 400.0 * parts[2] };
        for mode in ["w1", "w2"] {
            let omega = row[mode].as_f64().expect("a frequency");
            // L_p ä₂ + L_h ä₁ + g a₂ = 0 in a mode of this frequency.
            let share = rig.cable * omega.powi(2) / (GRAVITY - rig.rigging * omega.powi(2));
            let (hook, payload) = (LARGEST / share.abs().max(1.0), LARGEST * share / share.abs().max(1.0));
            for axis in ["radial", "tangential"] {
                let start = [format!("hook.swing.{axis}_start"), format!("payload.swing.{axis}_start")];
                let mut crane =
                    rig.crane(FRAC_PI_2 / omega, &[(start[0].as_str(), hook), (start[1].as_str(), payload)]);
                crane.run_to((PERIODS + 0.25) * TAU / omega);
                // Where the hook passes the middle, close to now.
                let swing = crane.get(&format!("hook.swing.{axis}"));
                let late = swing / crane.get(&format!("hook.swing.{axis}_rate"));
                let found = (PERIODS + 0.25) * TAU / (crane.time() - late);
                println!("{name}: {mode} {axis} differs by {:.1e}", found / omega - 1.0);
                // What is left is of second order in the swing, and greatest for the fast mode of a heavy payload.
                assert!((found / omega - 1.0).abs() < 1e-7, "{name}: {mode} is {found} rad/s, not {omega}");
            }
        }
    }
}

/// n and ṅ from the angles and their rates, n = (sin φ, cos φ sin β, −cos φ cos β).
fn direction(crane: &mut Instance, mass: &str) -> ([f64; 3], [f64; 3]) {
    let mut get = |name: &str| crane.get(&format!("{mass}.swing.{name}"));
    let ((sin, cos), rate) = (get("radial").sin_cos(), get("radial_rate"));
    let ((sin_b, cos_b), rate_b) = (get("tangential").sin_cos(), get("tangential_rate"));
    let n = [sin, cos * sin_b, -cos * cos_b];
    let n_rate = [cos * rate, cos * cos_b * rate_b - sin * sin_b * rate, cos * sin_b * rate_b + sin * cos_b * rate];
    (n, n_rate)
}

fn squared(v: [f64; 3]) -> f64 {
    v.iter().map(|v| v * v).sum()
}

#[test]
fn free_swing_keeps_its_energy() {
    let rig = Rig { cable: 6.0, rigging: 3.5, hook: 700.0, payload: 1100.0 };
    let weight = GRAVITY * ((rig.hook + rig.payload) * rig.cable + rig.payload * rig.rigging);
    let energy = |crane: &mut Instance| {
        let ((n1, n1_rate), (n2, n2_rate)) = (direction(crane, "hook"), direction(crane, "payload"));
        let hook = n1_rate.map(|rate| rig.cable * rate);
        let payload = std::array::from_fn(|i| hook[i] + rig.rigging * n2_rate[i]);
        let kinetic = 0.5 * (rig.hook * squared(hook) + rig.payload * squared(payload));
        let heights = [rig.cable * n1[2], rig.cable * n1[2] + rig.rigging * n2[2]];
        kinetic + GRAVITY * (rig.hook * heights[0] + rig.payload * heights[1])
    };
    for [radial, tangential, below, rate] in [[0.3, 0.0, -0.3, 0.0], [1.0, -0.5, 0.7, 0.4], [0.0, 1.2, 2.5, -1.0]] {
        let mut crane = rig.crane(
            0.1,
            &[
                ("hook.swing.radial_start", radial),
                ("hook.swing.tangential_start", tangential),
                ("payload.swing.tangential_start", below),
                ("payload.swing.radial_rate_start", rate),
            ],
        );
        let start = energy(&mut crane);
        // Hanging at rest it is −weight, and −weight cos A in line at the angle A.
        let amplitude = (-start / weight).clamp(-1.0, 1.0);
        let mut drift = 0.0_f64;
        while crane.time() < 40.0 {
            crane.step();
            drift = drift.max((energy(&mut crane) - start).abs() / weight);
            drift = drift.max((crane.get("swing.amplitude").cos() - amplitude).abs());
        }
        println!("swing from ({radial}, {tangential}, {below}) rad: energy within {drift:.1e} of the weight's");
        assert!(drift <= 1e-8, "({radial}, {tangential}, {below}) rad: energy drifts by {drift:e}");
    }
}

/// The planar equations of hook and payload with both angles from the vertical, as mass matrix and right side:
/// (1+M) L_h ä₁ + M L_p cos(a₁−a₂) ä₂ = −M L_p sin(a₁−a₂) ȧ₂² − (1+M)(g sin a₁ + u cos a₁)
/// L_h cos(a₁−a₂) ä₁ + L_p ä₂ = L_h sin(a₁−a₂) ȧ₁² − g sin a₂ − u cos a₂
struct Planar {
    ratio: f64,
    cable: f64,
    rigging: f64,
}

impl Planar {
    fn solve(&self, [a1, a2]: [f64; 2], right: [f64; 2]) -> [f64; 2] {
        let cos = (a1 - a2).cos();
        let matrix =
            [[(1.0 + self.ratio) * self.cable, self.ratio * self.rigging * cos], [self.cable * cos, self.rigging]];
        let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
        [
            (right[0] * matrix[1][1] - matrix[0][1] * right[1]) / determinant,
            (matrix[0][0] * right[1] - right[0] * matrix[1][0]) / determinant,
        ]
    }

    fn rates(&self, [a1, a2, b1, b2]: [f64; 4]) -> [f64; 4] {
        let sin = (a1 - a2).sin();
        let right = [
            -self.ratio * self.rigging * sin * b2 * b2 - (1.0 + self.ratio) * GRAVITY * a1.sin(),
            self.cable * sin * b1 * b1 - GRAVITY * a2.sin(),
        ];
        let [c1, c2] = self.solve([a1, a2], right);
        [b1, b2, c1, c2]
    }

    /// After a jump of the trolley's velocity, the integral of u.
    fn pushed(&self, [a1, a2, b1, b2]: [f64; 4], jump: f64) -> [f64; 4] {
        let [c1, c2] = self.solve([a1, a2], [-(1.0 + self.ratio) * jump * a1.cos(), -jump * a2.cos()]);
        [a1, a2, b1 + c1, b2 + c2]
    }

    /// After `time`, by the classical Runge–Kutta method in steps of 0.1 ms.
    fn after(&self, mut x: [f64; 4], time: f64) -> [f64; 4] {
        let steps = (time / 1e-4).round();
        let h = time / steps;
        let moved = |x: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| x[i] + h * k[i]);
        for _ in 0..steps as u32 {
            let k1 = self.rates(x);
            let k2 = self.rates(moved(x, k1, 0.5 * h));
            let k3 = self.rates(moved(x, k2, 0.5 * h));
            let k4 = self.rates(moved(x, k3, h));
            x = std::array::from_fn(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        }
        x
    }
}

/// Large swing in a plane, along either axis, with jumps of the velocity on the way.
#[test]
fn planar_motion_is_that_of_the_thesis() {
    let rig = Rig { cable: 5.0, rigging: 2.0, hook: 300.0, payload: 450.0 };
    let planar = Planar { ratio: 1.5, cable: 5.0, rigging: 2.0 };
    // The payload gets to 72°; beyond 90° its radial angle would count back.
    let start = [0.6, -0.3, 0.2, -0.5];
    for (axis, input) in [("radial", "trolley.rate"), ("tangential", "bridge.rate")] {
        let name = |mass: &str, what: &str| format!("{mass}.swing.{axis}{what}");
        let starts = [
            name("hook", "_start"),
            name("payload", "_start"),
            name("hook", "_rate_start"),
            name("payload", "_rate_start"),
        ];
        let values: Vec<(&str, f64)> = starts.iter().map(String::as_str).zip(start).collect();
        let mut crane = rig.crane(0.1, &values);
        let mut wanted = start;
        let mut speed = 0.0;
        for (k, next) in [0.7, 0.7, -0.5, 0.0].into_iter().enumerate() {
            crane.set(input, next).expect("a rate");
            wanted = planar.pushed(wanted, next - speed);
            speed = next;
            crane.run_to(1.5 * (k + 1) as f64);
            wanted = planar.after(wanted, 1.5);
            let found = ["", "_rate"].map(|what| ["hook", "payload"].map(|mass| crane.get(&name(mass, what))));
            let error = found.as_flattened().iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("{axis} at {} s: within {error:.1e} rad and rad/s", crane.time());
            assert!(error < 1e-8, "{axis} at {} s: {found:?} and {wanted:?}", crane.time());
        }
    }
}

/// Eq. 5.7, θ = −(v_f/(Lω)) sin ωt, for a hook without payload.
#[test]
fn a_hook_alone_answers_a_velocity_step_as_the_closed_form() {
    const SPEED: f64 = 1e-4;
    const LENGTH: f64 = 8.0;
    let omega = (GRAVITY / LENGTH).sqrt();
    for (input, axis) in [("trolley.rate", "radial"), ("bridge.rate", "tangential")] {
        let mut crane = crane(0.05, &[("payload.mass", 0.0), ("hoist.length", LENGTH), (input, SPEED)]);
        let peak = SPEED / (LENGTH * omega);
        while crane.time() < 2.0 * TAU / omega {
            crane.step();
            let wanted = -peak * (omega * crane.time()).sin();
            for mass in ["hook", "payload"] {
                let found = crane.get(&format!("{mass}.swing.{axis}"));
                assert!((found - wanted).abs() <= 1e-6 * peak, "{mass} at {} s: {found}", crane.time());
            }
        }
    }
}

/// Without payload it is a boom crane whose base drives with trolley and bridge, whatever there is of rigging.
#[test]
fn a_hook_alone_swings_as_the_payload_of_a_boom_crane() {
    let mut bridge = crane(
        0.1,
        &[
            ("payload.mass", 0.0),
            ("hook.mass", 250.0),
            ("swing.damping", 0.02),
            ("hook.swing.radial_start", 0.6),
            ("hook.swing.tangential_rate_start", 0.3),
            ("payload.swing.radial_start", -1.0),
            ("payload.swing.tangential_rate_start", 5.0),
            ("rail.height", 18.0),
        ],
    );
    let values = [
        ("payload.mass", 250.0),
        ("swing.damping", 0.02),
        ("swing.radial_start", 0.6),
        ("swing.tangential_rate_start", 0.3),
        ("luff.angle", 0.0),
        ("boom.height", 18.0),
        ("base.x", -18.0),
    ];
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, Set::Real(*value))).collect();
    let mut boom = Instance::started("BoomCrane", 0.1, &values);
    while bridge.time() < 20.0 {
        let t = bridge.time();
        let inputs = [
            ("trolley.rate", "base.velocity.x", 0.5 * t.sin()),
            ("bridge.rate", "base.velocity.y", -0.4),
            ("hoist.rate", "hoist.rate", 0.3 * t.cos()),
            ("wind.y", "wind.y", 100.0),
        ];
        for (ours, theirs, value) in inputs {
            bridge.set(ours, value).expect("a rate");
            boom.set(theirs, value).expect("a rate");
        }
        bridge.step();
        boom.step();
        for what in ["x", "y", "z", "swing.radial", "swing.tangential_rate"] {
            let (hook, payload) = (bridge.get(&format!("hook.{what}")), bridge.get(&format!("payload.{what}")));
            assert_eq!(hook, payload, "{what}");
            let wanted = boom.get(&if what.len() == 1 { format!("payload.{what}") } else { what.to_owned() });
            assert!((hook - wanted).abs() < 1e-9, "{what} at {t} s: {hook} and {wanted}");
        }
        assert!((bridge.get("swing.amplitude") - boom.get("swing.amplitude")).abs() < 1e-9, "at {t} s");
    }
}

/// Under a constant force each rope comes to rest along the force and the weight that it carries.
#[test]
fn wind_pushes_to_the_static_angles() {
    let (hook, (x, y, z)) = (300.0, (1500.0, -700.0, 400.0));
    for payload in [800.0, 0.0] {
        let mut crane = crane(0.1, &[("hook.mass", hook), ("payload.mass", payload), ("swing.damping", 1.0)]);
        for (input, force) in [("wind.x", x), ("wind.y", y), ("wind.z", z)] {
            crane.set(input, force).expect("a force");
        }
        crane.run_to(80.0);
        for (mass, carried) in [("hook", hook + payload), ("payload", if payload > 0.0 { payload } else { hook })] {
            let down = carried * GRAVITY - z;
            let total = (x * x + y * y + down * down).sqrt();
            let [radial, tangential] = ["radial", "tangential"].map(|axis| crane.get(&format!("{mass}.swing.{axis}")));
            assert!((radial - (x / total).asin()).abs() < 1e-9, "{mass} of {carried} kg: {radial}");
            assert!((tangential - (y / down).atan()).abs() < 1e-9, "{mass} of {carried} kg: {tangential}");
        }
    }
}

/// Positions follow from the angles; displacements are relative to the trolley.
#[test]
fn positions_are_where_the_angles_point() {
    let rig = Rig { cable: 6.0, rigging: 3.5, hook: 700.0, payload: 1100.0 };
    let mut crane = rig
        .crane(0.5, &[("trolley.x", 3.0), ("bridge.y", -2.0), ("rail.height", 12.0), ("hook.swing.radial_start", 0.4)]);
    crane.set("trolley.rate", 0.3).expect("a rate");
    crane.set("bridge.rate", -0.2).expect("a rate");
    crane.run_to(5.0);
    assert!((crane.get("trolley.x") - 4.5).abs() < 1e-12 && (crane.get("bridge.y") + 3.0).abs() < 1e-12);
    let trolley = [crane.get("trolley.x"), crane.get("bridge.y"), 12.0];
    let ((n1, _), (n2, _)) = (direction(&mut crane, "hook"), direction(&mut crane, "payload"));
    for (mass, below) in [("hook", 0.0), ("payload", rig.rigging)] {
        let place: [f64; 3] = std::array::from_fn(|i| rig.cable * n1[i] + below * n2[i]);
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            assert!((crane.get(&format!("{mass}.{axis}")) - trolley[i] - place[i]).abs() < 1e-12);
        }
        for (i, axis) in ["radial", "tangential"].into_iter().enumerate() {
            assert!((crane.get(&format!("{mass}.displacement.{axis}")) - place[i]).abs() < 1e-12);
        }
    }
}

#[test]
fn trolley_and_bridge_stop_at_their_limits_and_the_load_swings_on() {
    let mut crane = crane(0.5, &[("trolley.x_max", 0.4), ("bridge.y_min", -0.6)]);
    crane.set("trolley.rate", 0.5).expect("a rate");
    crane.set("bridge.rate", -0.2).expect("a rate");
    crane.run_to(4.0);
    assert_eq!(crane.get("trolley.x"), 0.4);
    assert_eq!(crane.get("bridge.y"), -0.6);
    assert!(crane.get("swing.amplitude") > 0.01);
    crane.set("trolley.rate", -0.1).expect("a rate");
    crane.run_to(6.0);
    assert!((crane.get("trolley.x") - 0.2).abs() < 1e-12);
    assert_eq!(crane.get("bridge.y"), -0.6);
}

#[test]
fn a_payload_too_heavy_for_its_hook_is_refused() {
    use swayless_modeldesc::types::FmiVersion;
    for (mass, refused) in [(3000.0, false), (3001.0, true)] {
        let mut crane = Instance::new("BridgeCrane", FmiVersion::V3, 0.1);
        crane.set("hook.mass", 3.0).expect("a mass");
        crane.set("payload.mass", mass).expect("a mass");
        assert_eq!(crane.initialize(None).is_err(), refused, "{mass} kg");
    }
}
