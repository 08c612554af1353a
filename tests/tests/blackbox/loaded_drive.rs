//! `VectorDrive` with a weak motor and a load.
//!
//! (motor.mass + load.mass) a = force + brake.force − load.force, with |force| ≤ force_limit.

use crate::instance::{Instance, Set, noise};

const MOTOR: f64 = 2.0;
const LOAD: f64 = 3.0;
const LIMIT: f64 = 4.0;
const WANTED: f64 = 0.63;

/// A drive whose motor has a mass of 2 and a force of 4, with a load of mass 3.
fn started(step: f64, smoothing: bool) -> Instance {
    let values: [(&str, Set<'_>); 3] =
        [("motor.mass", MOTOR.into()), ("force_limit", LIMIT.into()), ("smoothing", smoothing.into())];
    let mut drive = Instance::started("VectorDrive", step, &values);
    drive.set("load.mass", LOAD).expect("a mass");
    drive
}

#[track_caller]
fn close(found: f64, wanted: f64, tolerance: f64, what: &str) {
    assert!((found - wanted).abs() <= tolerance, "{what}: {found} instead of {wanted}");
}

#[track_caller]
fn balanced(drive: &mut Instance) {
    let [force, brake, load] = drive.get3(["force", "brake.force", "load.force"]);
    let mass = MOTOR + drive.get("load.mass").max(0.0);
    let [a, v, at] = [drive.get("acceleration"), drive.get("velocity"), drive.time()];
    close(force + brake - load, mass * a, 1e-12 * (1.0 + load.abs() + (mass * a).abs()), "balance of forces");
    assert!(force.abs() <= LIMIT, "at {at} s the motor has {force}");
    assert!(brake * v <= 0.0, "at {at} s the brake pushes with {brake} at {v}");
    assert!(brake == 0.0 || drive.get_switch("overloaded"), "at {at} s the brake helps with {brake}");
}

/// Up against the load with (4 − 2.5)/5 = 0.3, down with it by −(4 + 2.5)/5, which is more than is wanted.
#[test]
fn a_weak_motor_gives_what_its_limit_allows() {
    let mut drive = started(0.01, false);
    drive.set("load.force", 2.5).expect("a load");
    drive.set("command", 0.5).expect("a command");
    let arrival = 0.5 / 0.3;
    for _ in 0..300 {
        drive.step();
        let t = drive.time();
        let (v, s) = if t < arrival { (0.3 * t, 0.15 * t * t) } else { (0.5, 0.5 * t - 0.25 * arrival) };
        close(drive.get("velocity"), v, 1e-12, "velocity");
        close(drive.get("position"), s, 1e-11, "position");
        assert_eq!(drive.get_switch("limited"), t < arrival, "at {t} s");
        balanced(&mut drive);
    }
    drive.set("command", 0.0).expect("a command");
    drive.run_to(3.5);
    close(drive.get("velocity"), 0.5 - 0.5 * WANTED, 1e-12, "braking as is wanted");
    // Without the load's weight, but with more of its mass, the motor limits braking as well: 4/25.
    drive.set("load.force", 0.0).expect("a load");
    drive.set("load.mass", 23.0).expect("a mass");
    let before = drive.get("velocity");
    drive.run_to(4.0);
    close(drive.get("velocity"), before - 0.5 * 0.16, 1e-12, "braking with all there is");
    close(drive.get("force"), -LIMIT, 0.0, "force");
}

/// What the drive does with a load it can hold, computed in tiny steps without any mode: V̇ = A cut to what the limit
/// allows, Ȧ by its own equation.
#[derive(Debug, Default, Clone, Copy)]
struct Tiny {
    reference: f64,
    velocity: f64,
    acceleration: f64,
}

impl Tiny {
    const STEP: f64 = 2e-5;

    fn rates(&self, load: f64) -> (f64, f64) {
        let (zeta, omega) = (0.75, 3.7);
        let allowed = self.acceleration.clamp((-LIMIT - load) / (MOTOR + LOAD), (LIMIT - load) / (MOTOR + LOAD));
        let lag = self.reference - self.velocity;
        (allowed, omega * omega * lag - 2.0 * zeta * omega * self.acceleration)
    }

    fn step(&mut self, command: f64, load: f64) {
        let opposed = command * self.velocity < 0.0 && self.velocity.abs() > 0.05;
        let target = if opposed { 0.0 } else { command };
        let before = self.rates(load);
        let mut middle = *self;
        let way = WANTED * Self::STEP;
        self.reference += (target - self.reference).clamp(-way, way);
        middle.reference = 0.5 * (middle.reference + self.reference);
        middle.velocity += 0.5 * Self::STEP * before.0;
        middle.acceleration += 0.5 * Self::STEP * before.1;
        let rates = middle.rates(load);
        self.velocity += Self::STEP * rates.0;
        self.acceleration += Self::STEP * rates.1;
    }
}

#[test]
fn behind_the_response_the_velocity_moves_with_the_limit() {
    let (mut drive, mut tiny) = (started(0.05, true), Tiny::default());
    let mut limited = 0;
    for (command, load) in [(0.7, 3.0), (0.1, -2.0), (-0.6, -3.5), (0.7, 1.0), (0.3, 3.9), (-0.7, 0.0), (0.0, 3.0)] {
        drive.set("command", command).expect("a command");
        drive.set("load.force", load).expect("a load");
        for _ in 0..80 {
            drive.step();
            for _ in 0..2500 {
                tiny.step(command, load);
            }
            // The reference finds the threshold of a reversal and the end of a ramp within a tiny step.
            close(drive.get("velocity"), tiny.velocity, 2e-5, &format!("velocity at {} s", drive.time()));
            limited += u32::from(drive.get_switch("limited"));
            balanced(&mut drive);
        }
    }
    assert!((50..400).contains(&limited), "{limited} steps end at the limit");
}

/// From 0.5 against a load of 6.2 at rest after 0.5 · 5/2.2 s; there it stays, and goes on when the load is taken off.
#[test]
fn an_overload_brings_the_axis_to_rest_and_no_further() {
    for (smoothing, sign) in [(false, 1.0), (true, 1.0), (false, -1.0), (true, -1.0)] {
        let mut drive = started(0.05, smoothing);
        drive.set("command", sign * 0.5).expect("a command");
        drive.run_to(20.0);
        drive.set("load.force", sign * 6.2).expect("a load");
        for _ in 0..60 {
            drive.step();
            let t = drive.time() - 20.0;
            let speed = (0.5 - 0.44 * t).max(0.0);
            close(drive.get("velocity"), sign * speed, 1e-8, &format!("velocity {t} s later"));
            assert_eq!(drive.get("velocity") == 0.0, speed == 0.0, "{t} s later");
            assert!(drive.get_switch("overloaded"));
            balanced(&mut drive);
        }
        let position = drive.get("position");
        drive.set("load.force", sign * 4.5).expect("a load");
        drive.run_to(30.0);
        assert_eq!(drive.get("position"), position, "an axis at rest does not creep");
        close(drive.get("brake.force"), sign * 4.5, 0.0, "the brake holds all");
        drive.set("load.force", sign * 3.0).expect("a load");
        drive.step();
        assert!(!drive.get_switch("overloaded"));
        if !smoothing {
            close(drive.get("velocity"), sign * 0.2 * 0.05, 1e-12, "under way with (4 − 3)/5");
        }
        drive.run_to(50.0);
        close(drive.get("velocity"), sign * 0.5, 1e-8, "at speed again");
    }
}

/// Without a response, the reference itself is torn off its target; it comes back no faster than it may.
#[test]
fn after_an_overload_the_axis_runs_to_its_speed_again() {
    let mut drive = started(0.01, false);
    drive.set("command", 0.5).expect("a command");
    drive.run_to(2.0);
    drive.set("load.force", 6.2).expect("a load");
    drive.run_to(2.5);
    close(drive.get("velocity"), 0.5 - 0.44 * 0.5, 1e-12, "slowed down");
    drive.set("load.force", 0.0).expect("a load");
    for _ in 0..50 {
        drive.step();
        close(drive.get("velocity"), (0.28 + WANTED * (drive.time() - 2.5)).min(0.5), 1e-12, "on its way back");
    }
}

/// Along with a load that the motor cannot hold the axis goes as it is told, and the brake stops it.
#[test]
fn an_overhauling_load_is_lowered_under_control() {
    for smoothing in [false, true] {
        let mut drive = started(0.02, smoothing);
        let values: [(&str, Set<'_>); 2] = [("motor.mass", MOTOR.into()), ("smoothing", smoothing.into())];
        let mut strong = Instance::started("VectorDrive", 0.02, &values);
        drive.set("load.force", 6.0).expect("a load");
        let mut helped = false;
        for (command, until) in [(-0.4, 4.0), (-0.1, 8.0), (0.0, 12.0), (0.4, 14.0)] {
            drive.set("command", command).expect("a command");
            strong.set("command", command.min(0.0)).expect("a command");
            while drive.time() < until - 0.01 {
                drive.step();
                strong.step();
                // Down it follows as a strong one; it overshoots the end of that by nothing.
                let wanted = strong.get("velocity").min(0.0);
                let rests = drive.get("velocity") == 0.0;
                assert!(rests || (drive.get("velocity") - wanted).abs() < 1e-8, "at {} s", drive.time());
                helped |= drive.get("brake.force") > 0.0 && !rests;
                balanced(&mut drive);
            }
        }
        assert!(helped, "the brake helps");
        assert_eq!(drive.get("velocity"), 0.0, "up it cannot");
        assert!(drive.get_switch("brake.closed"));
    }
}

/// Any commands, any loads: forces balance, the motor stays within its limit, and nothing runs away.
#[test]
fn forces_balance_whatever_comes() {
    for (smoothing, damping) in [(true, 0.75), (true, 0.0), (false, 0.75)] {
        let values: [(&str, Set<'_>); 4] = [
            ("motor.mass", MOTOR.into()),
            ("force_limit", LIMIT.into()),
            ("smoothing", smoothing.into()),
            ("damping_ratio", damping.into()),
        ];
        let mut drive = Instance::started("VectorDrive", 0.03, &values);
        let mut random = noise();
        let mut overloaded = 0;
        for round in 0..600 {
            if round % 5 == 0 {
                drive.set("command", if random() < -0.6 { 0.0 } else { random() }).expect("a command");
            }
            drive.set("load.force", 8.0 * random().powi(3)).expect("a load");
            drive.set("load.mass", 4.0 * random()).expect("a mass");
            for _ in 0..3 {
                drive.step();
                balanced(&mut drive);
                overloaded += u32::from(drive.get_switch("overloaded"));
                // A response without damping doubles a step of ±0.75.
                assert!(drive.get("velocity").abs() < 4.0, "{} at {} s", drive.get("velocity"), drive.time());
            }
            assert_eq!(drive.get_switch("valid"), drive.get("load.mass") >= 0.0);
        }
        assert!(overloaded > 100, "{overloaded} steps end overloaded");
    }
}

/// A motor without a limit moves any load as if there were none, to the last bit.
#[test]
fn a_strong_motor_does_not_feel_its_load() {
    let [mut loaded, mut free] = [1e9, 0.0].map(|load| {
        let mut drive = Instance::started("VectorDrive", 0.05, &[]);
        drive.set("load.force", load).expect("a load");
        drive
    });
    for (command, until) in [(0.75, 3.0), (-0.5, 8.0)] {
        for drive in [&mut loaded, &mut free] {
            drive.set("command", command).expect("a command");
            drive.run_to(until);
        }
        for name in ["velocity", "acceleration", "position"] {
            assert_eq!(loaded.get(name).to_bits(), free.get(name).to_bits(), "{name} at {until} s");
        }
    }
}
