//! `VectorDrive` against the responses computed for the drive of thesis 6.1.
//!
//! `data/industrial_crane.json` was computed on a grid of 0.1 ms, so that its times carry that much.

use crate::instance::{Instance, Set};
use crate::packaged;

const STEP: f64 = 1e-4;
const GRID: f64 = 2e-4;
const LIMIT: f64 = 0.75;

fn reference(response: &str, figure: &str) -> f64 {
    let json = packaged::data("industrial_crane.json");
    json["6.1 drive"][response][figure].as_f64().unwrap_or_else(|| panic!("{response}: {figure}"))
}

#[track_caller]
fn close(found: f64, response: &str, figure: &str, tolerance: f64) {
    let wanted = reference(response, figure);
    println!("{response}, {figure}: {found:.5}, reference {wanted:.5}");
    assert!((found - wanted).abs() <= tolerance, "{response}, {figure}: {found}, reference {wanted}");
}

/// Velocities at every step after a command.
fn response(drive: &mut Instance, command: f64, duration: f64) -> Vec<f64> {
    drive.set("command", command).expect("a command");
    let mut velocities = vec![drive.get("velocity")];
    for _ in 0..(duration / STEP).round() as usize {
        drive.step();
        velocities.push(drive.get("velocity"));
    }
    velocities
}

/// When the values first pass a level (s).
fn passes(values: &[f64], level: f64) -> f64 {
    let side = |value: f64| (value - level).signum();
    let after = values.iter().position(|v| side(*v) != side(values[0])).expect("the level is passed");
    let (a, b) = (values[after - 1], values[after]);
    (after as f64 - (b - level) / (b - a)) * STEP
}

#[test]
fn steps_rise_and_settle_as_the_reference() {
    for (name, command) in [("step 100%", LIMIT), ("step 50%", 0.5 * LIMIT)] {
        let velocities = response(&mut Instance::started("VectorDrive", STEP, &[]), command, 6.0);
        let peak = velocities.iter().copied().fold(0.0, f64::max);
        let outside = velocities.iter().rposition(|v| (v - command).abs() > 0.02 * command).expect("a response");
        close(passes(&velocities, 0.1 * command), name, "t10", GRID);
        close(passes(&velocities, 0.9 * command), name, "t90", GRID);
        // The reference's overshoot is 2e-5 below the closed form, which is held below to 1e-8; where the response
        // slowly comes back to 2 %, that much is almost a millisecond.
        close(peak / command - 1.0, name, "overshoot", 5e-5);
        close((outside + 1) as f64 * STEP, name, "settle2%", 1e-3);
    }
}

/// The response of H(s) to a ramp of slope 1, and so to a rate-limited step: the difference of two ramps.
#[test]
fn a_step_is_the_closed_form() {
    let (zeta, omega, acceleration) = (0.75_f64, 3.7_f64, 0.63);
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let ramp = |t: f64| {
        let (sin, cos) = (damped * t).sin_cos();
        let decay = (-zeta * omega * t).exp();
        let late = 2.0 * zeta / omega;
        if t < 0.0 { 0.0 } else { t - late + decay * (late * cos + (2.0 * zeta * zeta - 1.0) / damped * sin) }
    };
    for command in [LIMIT, -0.5 * LIMIT] {
        let mut drive = Instance::started("VectorDrive", 0.01, &[]);
        drive.set("command", command).expect("a command");
        for _ in 0..600 {
            drive.step();
            let t = drive.time();
            let wanted = acceleration * command.signum() * (ramp(t) - ramp(t - command.abs() / acceleration));
            let found = drive.get("velocity");
            assert!((found - wanted).abs() < 1e-8, "at {t} s: {found}, closed form {wanted}");
        }
    }
}

/// The switch (6.1) holds the limiter at 0 until the velocity is below the threshold.
#[test]
fn reversals_wait_for_the_threshold_as_the_reference() {
    for (threshold, name) in
        [(0.005, "reversal X=0.005"), (0.02, "reversal X=0.02"), (0.05, "reversal X=0.05"), (0.1, "reversal X=0.1")]
    {
        let mut drive = Instance::started("VectorDrive", STEP, &[("reversal_threshold", Set::Real(threshold))]);
        response(&mut drive, LIMIT, 10.0);
        drive.set("command", -LIMIT).expect("a command");
        let (mut velocities, mut resting) = (vec![drive.get("velocity")], 0_u32);
        for _ in 0..60_000 {
            drive.step();
            velocities.push(drive.get("velocity"));
            resting += u32::from(drive.get("limiter.reference") == 0.0);
        }
        close(passes(&velocities, 0.0), name, "zero-cross time after reversal", GRID);
        close(passes(&velocities, -0.9 * LIMIT), name, "t to -90%", GRID);
        close(f64::from(resting) * STEP, name, "dwell of rate limiter at 0", 2.0 * GRID);
    }
}

/// Without smoothing a step is a ramp that ends at exactly v/a: there the position is v²/(2a), and grows by v from then.
#[test]
fn a_rate_limited_step_arrives_at_exactly_v_over_a() {
    let (speed, acceleration) = (0.5, 0.63);
    let step = speed / acceleration / 64.0;
    let mut drive = Instance::started("VectorDrive", step, &[("smoothing", Set::Switch(false))]);
    drive.set("command", speed).expect("a command");
    for _ in 0..64 {
        let ramp = (acceleration * drive.time(), 0.5 * acceleration * drive.time().powi(2));
        assert!((drive.get("velocity") - ramp.0).abs() < 1e-12 && (drive.get("position") - ramp.1).abs() < 1e-12);
        drive.step();
    }
    for _ in 0..64 {
        let position = speed * drive.time() - 0.5 * speed * speed / acceleration;
        assert!((drive.get("velocity") - speed).abs() < 1e-12, "{} at {} s", drive.get("velocity"), drive.time());
        // A late or early arrival by δ would leave δ·v/2.
        assert!((drive.get("position") - position).abs() < 1e-12, "position at {} s", drive.time());
        drive.step();
    }
}

#[test]
fn commands_beyond_the_limit_are_cut_and_within_the_dead_zone_count_as_none() {
    let mut drive = Instance::started("VectorDrive", 0.01, &[("dead_zone", Set::Real(0.1))]);
    for (command, velocity) in [(5.0, LIMIT), (0.1, 0.0), (0.11, 0.11), (-0.1, 0.0), (-9.0, -LIMIT)] {
        drive.set("command", command).expect("a command");
        drive.run_to(drive.time() + 20.0);
        assert!((drive.get("velocity") - velocity).abs() < 1e-9, "{command}: {}", drive.get("velocity"));
    }
}
