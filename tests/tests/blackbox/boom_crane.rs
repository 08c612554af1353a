//! `BoomCrane` against closed forms and conservation laws.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

use crate::instance::{Instance, Set};

const GRAVITY: f64 = 9.81;
const LENGTH: f64 = 10.0;

fn omega() -> f64 {
    (GRAVITY / LENGTH).sqrt()
}

fn crane(step: f64, values: &[(&str, f64)]) -> Instance {
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, Set::Real(*value))).collect();
    Instance::started("BoomCrane", step, &values)
}

/// Energy per m·g·ℓ of a payload 10 m under a resting pivot, from the angles and their rates:
/// n = (sin φ, cos φ sin β, −cos φ cos β), |ṅ|² = φ̇² + β̇² cos² φ.
pub fn energy(crane: &mut Instance) -> f64 {
    let [phi, phi_rate, beta] = crane.get3(["swing.radial", "swing.radial_rate", "swing.tangential"]);
    let beta_rate = crane.get("swing.tangential_rate");
    let speed = phi_rate.powi(2) + (beta_rate * phi.cos()).powi(2);
    0.5 * LENGTH / GRAVITY * speed - phi.cos() * beta.cos()
}

#[test]
fn free_swing_keeps_its_energy() {
    for (radial, tangential, tangential_rate) in [(0.1, 0.0, 0.0), (0.3, -0.2, 0.1), (1.0, 0.0, 0.3), (0.0, 1.2, 0.0)] {
        let mut crane = crane(
            0.1,
            &[
                ("swing.radial_start", radial),
                ("swing.tangential_start", tangential),
                ("swing.tangential_rate_start", tangential_rate),
            ],
        );
        let start = energy(&mut crane);
        let mut drift = 0.0_f64;
        while crane.time() < 60.0 {
            crane.step();
            drift = drift.max((energy(&mut crane) - start).abs());
        }
        println!("swing from ({radial}, {tangential}) rad: energy within {drift:.1e} m·g·ℓ");
        assert!(drift <= 1e-9, "({radial}, {tangential}) rad: energy drifts by {drift:e} m·g·ℓ");
    }
}

/// How far a swing angle is off eq. 5.7, θ = −(v_f/(Lω)) sin ωt, in two periods after a step of the pivot's velocity, 10 m
/// above the payload; in parts of the peak.
pub fn off_the_closed_form(crane: &mut Instance, angle: &str, speed: f64) -> f64 {
    let peak = speed / (LENGTH * omega());
    let mut worst = 0.0_f64;
    while crane.time() < 2.0 * TAU / omega() {
        crane.step();
        let wanted = -peak * (omega() * crane.time()).sin();
        worst = worst.max((crane.get(angle) - wanted).abs() / peak);
    }
    worst
}

/// Eq. 5.7 for a step of the pivot's velocity that is along x, y or the boom's tangent.
#[test]
fn a_velocity_step_answers_as_the_closed_form() {
    const SPEED: f64 = 1e-4;
    // Turning the boom by one axis moves the tip by SPEED, but also along a circle: that is of second order in SPEED.
    let reach = 18.0 * FRAC_PI_3.cos();
    let steps = [
        ("base.velocity.x", SPEED, "swing.radial"),
        ("base.velocity.y", SPEED, "swing.tangential"),
        ("slew.rate", SPEED / reach, "swing.tangential"),
        ("base.yaw_rate", SPEED / reach, "swing.tangential"),
    ];
    for (input, rate, angle) in steps {
        for set_before_start in [false, true] {
            let mut values = vec![("luff.angle", FRAC_PI_3), ("boom.offset", 0.0), ("hoist.length", LENGTH)];
            if set_before_start {
                values.push((input, rate));
            }
            let mut crane = crane(0.01, &values);
            if !set_before_start {
                crane.set(input, rate).expect("a rate");
            }
            let worst = off_the_closed_form(&mut crane, angle, SPEED);
            println!("step of {input}: within {worst:.1e} of the peak");
            assert!(worst <= 1e-6, "{input}: off by {worst:e} of the peak");
        }
    }
}

/// A small swing with damping d = 2ζω decays as e^(−ζωt) and turns with ω√(1 − ζ²).
#[test]
fn damped_swing_decays_as_its_ratio_says() {
    const ZETA: f64 = 0.05;
    const START: f64 = 1e-4;
    let mut crane = crane(0.05, &[("swing.damping", 2.0 * ZETA * omega()), ("swing.radial_start", START)]);
    let damped = omega() * (1.0 - ZETA * ZETA).sqrt();
    while crane.time() < 30.0 {
        crane.step();
        let t = crane.time();
        let (sin, cos) = (damped * t).sin_cos();
        let wanted = START * (-ZETA * omega() * t).exp() * (cos + ZETA * omega() / damped * sin);
        // The equations are not linear: START² is their difference from the linear ones.
        let found = crane.get("swing.radial");
        assert!((found - wanted).abs() <= 2.0 * START * START * START + 1e-12, "at {t} s: {found} and {wanted}");
    }
}

/// Under a constant force the payload comes to rest where the cable is along the sum of force and weight.
#[test]
fn wind_pushes_the_payload_to_the_static_angle() {
    const MASS: f64 = 800.0;
    let mut crane = crane(0.1, &[("payload.mass", MASS), ("swing.damping", 1.0)]);
    let (x, y, z) = (1500.0, -700.0, 400.0);
    for (input, force) in [("wind.x", x), ("wind.y", y), ("wind.z", z)] {
        crane.set(input, force).expect("a force");
    }
    crane.run_to(80.0);
    let down = MASS * GRAVITY - z;
    let total = (x * x + y * y + down * down).sqrt();
    assert!((crane.get("swing.radial") - (x / total).asin()).abs() < 1e-9);
    assert!((crane.get("swing.tangential") - (y / down).atan()).abs() < 1e-9);
}

/// Without offset, turning the base or turning the boom on it is the same to the payload.
#[test]
fn yawing_the_base_is_slewing_the_boom() {
    let values = [("boom.offset", 0.0), ("swing.radial_start", 0.2), ("hoist.length", LENGTH)];
    let (mut slewed, mut yawed) = (crane(0.02, &values), crane(0.02, &values));
    while slewed.time() < 20.0 {
        let rate = 0.1 * (0.7 * slewed.time()).sin();
        slewed.set("slew.rate", rate).expect("a rate");
        yawed.set("base.yaw_rate", rate).expect("a rate");
        slewed.step();
        yawed.step();
        for name in ["payload.x", "payload.y", "payload.z", "swing.radial", "swing.tangential"] {
            let (a, b) = (slewed.get(name), yawed.get(name));
            assert!((a - b).abs() < 1e-9, "{name} at {} s: {a} and {b}", slewed.time());
        }
    }
}

/// A base that moves evenly is as good as one at rest (Galileo): the swing is that of a start relative to the base.
#[test]
fn an_even_motion_of_the_base_changes_nothing() {
    const SPEED: f64 = 0.6;
    // Started with the base in motion, the payload is left behind with −SPEED: φ̇ = −v/ℓ for a hanging one.
    let mut moving = crane(0.02, &[("base.velocity.x", SPEED)]);
    let mut resting = crane(0.02, &[("swing.radial_rate_start", -SPEED / LENGTH)]);
    while moving.time() < 20.0 {
        moving.step();
        resting.step();
        let along = SPEED * moving.time();
        for (name, offset) in
            [("payload.x", along), ("payload.z", 0.0), ("swing.radial", 0.0), ("swing.amplitude", 0.0)]
        {
            let (a, b) = (moving.get(name), resting.get(name) + offset);
            assert!((a - b).abs() < 1e-8, "{name} at {} s: {a} and {b}", moving.time());
        }
    }
}

/// Turned about the vertical, everything is as before, turned.
#[test]
fn no_direction_is_special() {
    let turn = 0.4 * FRAC_PI_2;
    let start = [("swing.radial_start", 0.3), ("swing.tangential_rate_start", 0.1), ("boom.offset", 0.5)];
    let mut straight = crane(0.02, &start);
    let mut turned = crane(0.02, &[&start[..], &[("base.yaw", turn)]].concat());
    let (sin, cos) = turn.sin_cos();
    while straight.time() < 10.0 {
        let (x, y) = (0.3 * straight.time().sin(), -0.2);
        straight.set("base.velocity.x", x).expect("a rate");
        straight.set("base.velocity.y", y).expect("a rate");
        turned.set("base.velocity.x", cos * x - sin * y).expect("a rate");
        turned.set("base.velocity.y", sin * x + cos * y).expect("a rate");
        for crane in [&mut straight, &mut turned] {
            crane.set("luff.rate", -0.02).expect("a rate");
            crane.set("hoist.rate", 0.1).expect("a rate");
            crane.step();
        }
        let [x, y, z] = straight.get3(["payload.x", "payload.y", "payload.z"]);
        let wanted = [cos * x - sin * y, sin * x + cos * y, z];
        let found = turned.get3(["payload.x", "payload.y", "payload.z"]);
        assert!((0..3).all(|i| (found[i] - wanted[i]).abs() < 1e-8), "at {} s", straight.time());
    }
}

/// A payload let go from rest at an angle A from the vertical: T/m = g (3 cos θ − 2 cos A), which is negative above
/// cos θ = ⅔ cos A.
#[test]
fn a_payload_that_falls_from_above_leaves_its_cable_slack_at_first() {
    const MASS: f64 = 500.0;
    const START: f64 = 2.5;
    let mut crane = crane(0.01, &[("swing.tangential_start", START), ("payload.mass", MASS)]);
    let (mut slack, mut taut) = (0, 0);
    while crane.time() < 6.0 {
        let angle = crane.get("swing.tangential");
        let wanted = MASS * GRAVITY * (3.0 * angle.cos() - 2.0 * START.cos());
        let found = crane.get("tension");
        assert!((found - wanted).abs() < 1e-8 * MASS * GRAVITY, "at {} s: {found} N, not {wanted} N", crane.time());
        assert_eq!(crane.get_switch("slack"), wanted < 0.0, "at {} s: {wanted} N", crane.time());
        *(if wanted < 0.0 { &mut slack } else { &mut taut }) += 1;
        crane.step();
    }
    assert!(slack > 100 && taut > 100, "{slack} steps slack, {taut} taut");
}

/// T = m (g − ℓ̈) for a hanging payload.
#[test]
fn a_hoist_that_lets_go_leaves_the_cable_slack() {
    let mut crane = crane(0.01, &[("payload.mass", 200.0)]);
    for (acceleration, slack) in [(0.0, false), (9.7, false), (9.9, true), (-5.0, false)] {
        crane.set("hoist.acceleration", acceleration).expect("an acceleration");
        crane.step();
        assert!((crane.get("tension") - 200.0 * (GRAVITY - acceleration)).abs() < 1e-9);
        assert_eq!(crane.get_switch("slack"), slack, "ℓ̈ = {acceleration}");
    }
}

/// Telescoping a boom that lies level is driving the base; of one that is raised, it moves the tip along the boom.
#[test]
fn a_telescoping_boom_moves_its_tip_along_itself() {
    let turn = 0.7;
    let (sin, cos) = f64::sin_cos(turn);
    let start = [("luff.angle", 0.0), ("slew.angle", turn), ("swing.tangential_start", 0.2)];
    let (mut telescoping, mut driving) = (crane(0.02, &start), crane(0.02, &start));
    let mut raised = crane(0.02, &[("luff.angle", 1.0), ("boom.offset", 0.3), ("boom.extension", -2.0)]);
    while raised.time() < 10.0 {
        let rate = 0.4 * (0.8 * raised.time()).sin();
        telescoping.set("boom.rate", rate).expect("a rate");
        raised.set("boom.rate", rate).expect("a rate");
        driving.set("base.velocity.x", rate * cos).expect("a rate");
        driving.set("base.velocity.y", rate * sin).expect("a rate");
        [&mut telescoping, &mut driving, &mut raised].into_iter().for_each(Instance::step);
        for name in ["payload.x", "payload.y", "payload.z", "swing.radial", "swing.tangential_rate"] {
            let (a, b) = (telescoping.get(name), driving.get(name));
            assert!((a - b).abs() < 1e-8, "{name} at {} s: {a} and {b}", raised.time());
        }
        let length = 18.0 + raised.get("boom.extension");
        let [x, _, z] = raised.get3(["tip.x", "tip.y", "tip.z"]);
        assert!((x - 0.3 - length * 1_f64.cos()).abs() < 1e-12 && (z - 1.5 - length * 1_f64.sin()).abs() < 1e-12);
    }
}

#[test]
fn a_telescope_stops_at_its_limits() {
    let limits = [("boom.extension_min", -1.0), ("boom.extension_max", 2.5)];
    let mut limited = crane(0.1, &limits);
    for (rate, end) in [(0.5, 2.5), (-0.5, -1.0)] {
        limited.set("boom.rate", rate).expect("a rate");
        limited.run_to(limited.time() + 10.0);
        assert_eq!((limited.get("boom.extension"), limited.get_switch("at_limit")), (end, true));
    }
    // Without limits of its own it keeps some of its length.
    let mut short = crane(0.1, &[("boom.length", 2.0)]);
    short.set("boom.rate", -1.0).expect("a rate");
    short.run_to(5.0);
    assert!((short.get("boom.extension") - (1e-3 - 2.0)).abs() < 1e-12);
}
