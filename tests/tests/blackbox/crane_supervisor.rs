//! `CraneSupervisor` over a `BridgeCrane` with drive and laser: where it stops, how, and what starts it again.

use swayless_modeldesc::types::{DataType, FmiVersion};

use crate::instance::{Instance, Set};

/// The items of `state` and `fault.code` that are met.
const READY: i64 = 1;
const LIMITED: i64 = 2;
const STOPPED: i64 = 3;
const FAULT: i64 = 4;
const POSITION_INVALID: i64 = 3;

const STEP: f64 = 0.02;
const SPEED: f64 = 0.75;
const DECELERATION: f64 = 0.5;

/// A supervisor, for the first axis of which the range is 0 … 5 m.
fn supervisor(values: &[(&str, Set<'_>)]) -> Instance {
    let mut supervisor = Instance::new("CraneSupervisor", FmiVersion::V3, STEP);
    supervisor.set_all("position_min", &[0.0, -1e9, -1e9, -1e9]);
    supervisor.set_all("position_max", &[5.0, 1e9, 1e9, 1e9]);
    // As wired: the crane's position is there when the first sample is taken.
    supervisor.set_all("position", &[2.5, 0.0, 0.0, 0.0]);
    values.iter().for_each(|(name, value)| supervisor.set(name, *value).expect("a value in range"));
    supervisor.initialize(None).expect("initialization");
    supervisor
}

fn item(supervisor: &mut Instance, name: &str) -> i64 {
    let mut value = [0];
    supervisor.slave.get_integer(DataType::Enumeration, &[supervisor.reference(name)], &mut value).expect("an item");
    value[0]
}

fn velocity(supervisor: &mut Instance) -> f64 {
    supervisor.get_all("velocity", 4)[0]
}

/// Takes a step with a command and a position of the first axis.
fn look(supervisor: &mut Instance, command: f64, (position, valid): (f64, bool)) -> f64 {
    supervisor.set_all("command", &[command, 0.0, 0.0, 0.0]);
    supervisor.set_all("position", &[position, 0.0, 0.0, 0.0]);
    let reference = [supervisor.reference("position.valid")];
    supervisor.slave.set_boolean(&reference, &[valid, true, true, true]).expect("truth values");
    supervisor.step();
    velocity(supervisor)
}

fn bridge() -> Instance {
    Instance::started("BridgeCrane", STEP, &[("trolley.x", Set::Real(2.5))])
}

/// Lets the trolley go for a step.
fn go(crane: &mut Instance, rate: f64) -> f64 {
    crane.set("trolley.rate", rate).expect("a rate");
    crane.step();
    crane.get("trolley.x")
}

/// A sample at every communication point sees where the trolley is: full speed, the ramp, slow, and the very end.
#[test]
fn the_trolley_stops_at_the_end_of_its_range() {
    for (command, end) in [(2.0, 5.0), (-2.0, 0.0)] {
        let (mut supervisor, mut crane) = (supervisor(&[("sample_time", 0.0.into())]), bridge());
        let mut x = 2.5;
        let mut last: f64 = 0.0;
        for _ in 0..1000 {
            let rate = look(&mut supervisor, command, (x, true));
            assert!(rate.abs() <= SPEED && rate.abs() >= last.abs() - DECELERATION * STEP - 1e-12, "{rate} at {x} m");
            last = rate;
            x = go(&mut crane, rate);
            assert!((-1e-12..=5.0 + 1e-12).contains(&x), "{x} m");
        }
        assert!((x - end).abs() < 1e-9, "{x} m, not {end} m");
        assert_eq!((last.abs() < 1e-9, item(&mut supervisor, "state")), (true, LIMITED));
        let rate = look(&mut supervisor, -command.signum() * 0.7, (x, true));
        assert_eq!((rate, item(&mut supervisor, "state")), (-command.signum() * 0.7, READY), "away from the end");
    }
}

/// Stepped side by side, the trolley does what the supervisor said a step ago. Three times that as reaction time, and it does
/// not pass the end: the last bit of the way is 4 h v = s, which with s a step old is critically damped. Without any it does
/// by less than it goes in a step.
#[test]
fn what_is_seen_late_is_made_up_for() {
    let end = |reaction: f64| {
        let mut supervisor = supervisor(&[("reaction_time", reaction.into())]);
        let mut crane = bridge();
        let (mut rate, mut x, mut furthest) = (0.0, 2.5, 0.0_f64);
        for _ in 0..1000 {
            let next = look(&mut supervisor, 2.0, (x, true));
            x = go(&mut crane, rate);
            rate = next;
            furthest = furthest.max(x);
        }
        (x, furthest)
    };
    let (x, furthest) = end(3.0 * STEP);
    assert!((x - 5.0).abs() < 1e-6 && furthest <= 5.0 + 1e-12, "{x} m, at most {furthest} m");
    let (_, furthest) = end(0.0);
    println!("seen a step late it is at most at {furthest} m");
    assert!((1e-5..SPEED * STEP).contains(&(furthest - 5.0)), "{furthest} m");
}

/// Pressed at full speed: v²/2d, as a staircase v h/2 more. But for the reset nothing moves it then.
#[test]
fn an_emergency_stop_takes_its_distance_and_stays_until_it_is_reset() {
    let (mut supervisor, mut crane) = (supervisor(&[("sample_time", 0.0.into())]), bridge());
    let mut x = 2.5;
    let mut drive = |supervisor: &mut Instance, command: f64, time: f64| {
        for _ in 0..(time / STEP).round() as u32 {
            let rate = look(supervisor, command, (x, true));
            x = go(&mut crane, rate);
        }
        x
    };
    let from = drive(&mut supervisor, -SPEED, 0.5);
    supervisor.set("emergency_stop", true).expect("a switch");
    let to = drive(&mut supervisor, -SPEED, 2.0);
    // The first step of the ramp is taken at once.
    let wanted = SPEED * SPEED / (2.0 * DECELERATION) - 0.5 * SPEED * STEP;
    assert!((from - to - wanted).abs() < 1e-12, "{} m, not {wanted} m", from - to);
    assert_eq!(item(&mut supervisor, "state"), STOPPED);
    supervisor.set("emergency_stop", false).expect("a switch");
    assert_eq!((drive(&mut supervisor, 0.6, 1.0), drive(&mut supervisor, -0.6, 1.0)), (to, to));
    supervisor.set("reset", true).expect("a switch");
    assert_eq!(drive(&mut supervisor, -0.6, 0.1), to, "there is a command");
    supervisor.set("reset", false).expect("a switch");
    drive(&mut supervisor, 0.0, 0.1);
    supervisor.set("reset", true).expect("a switch");
    drive(&mut supervisor, 0.0, STEP);
    assert_eq!((item(&mut supervisor, "state"), supervisor.get_switch("record")), (READY, true));
    assert!(drive(&mut supervisor, 0.6, 1.0) > to + 0.5);
}

/// The trolley leaves the range of its laser: the last velocity for `fault_time`, then the ramp.
#[test]
fn a_laser_that_sees_nothing_stops_the_trolley() {
    let mut supervisor = supervisor(&[("sample_time", 0.0.into()), ("fault_time", 0.3.into())]);
    let mut crane = bridge();
    let exact = ["sample_time", "latency", "noise", "resolution"].map(|name| (name, Set::Real(0.0)));
    let mut laser = Instance::started("RangeSensor", STEP, &[&exact[..], &[("range", Set::Real(3.0))]].concat());
    let (mut x, mut seen): (f64, f64) = (2.5, 0.0);
    for _ in 0..200 {
        laser.set("distance", x).expect("a distance");
        laser.step();
        let valid = laser.get_switch("valid");
        seen = if valid { x } else { seen };
        let rate = look(&mut supervisor, 0.5, (laser.get("measured.distance"), valid));
        x = go(&mut crane, rate);
    }
    assert_eq!((item(&mut supervisor, "state"), item(&mut supervisor, "fault.code")), (FAULT, POSITION_INVALID));
    let axis = [supervisor.reference("fault.axis")];
    let mut found = [0];
    supervisor.slave.get_integer(DataType::Int32, &axis, &mut found).expect("an axis");
    assert_eq!(found, [1]);
    // A step until it is missed, 0.3 s, one step more until that is longer; then the ramp, as of an emergency stop.
    let wanted = 0.5 * (0.3 + STEP) + 0.5 * 0.5 / (2.0 * DECELERATION) - 0.5 * 0.5 * STEP;
    assert!((x - seen - wanted).abs() < 1e-12, "{} m, not {wanted} m", x - seen);
    assert_eq!(velocity(&mut supervisor), 0.0);
}

/// A drive that follows late, and accelerates no more than 0.63 m/s²: its lag is 2ζ/ω.
#[test]
fn with_a_real_drive_the_reaction_time_keeps_the_trolley_in_its_range() {
    let lag = 2.0 * 0.75 / 3.7;
    let furthest = |reaction: f64| {
        let values = [("sample_time", 0.0.into()), ("reaction_time", reaction.into())];
        let mut supervisor = supervisor(&values);
        let mut drive = Instance::started("VectorDrive", STEP, &[]);
        let mut crane = bridge();
        let (mut x, mut furthest) = (2.5, 0.0_f64);
        for _ in 0..1500 {
            let command = look(&mut supervisor, SPEED, (x, true));
            drive.set("command", command).expect("a command");
            drive.step();
            x = go(&mut crane, drive.get("velocity"));
            furthest = furthest.max(x);
        }
        (furthest, x)
    };
    let (far, near) = (furthest(0.0), furthest(4.0 * lag));
    println!(
        "without a reaction time it is at most at {:.4} m, with one at {:.6} m, at last {:.6} m",
        far.0, near.0, near.1
    );
    assert!(far.0 > 5.01 && near.0 <= 5.0 + 1e-9 && near.1 > 4.99, "{far:?} m, {near:?} m");
}

/// Inputs that are set after initialization: the first sample has seen the trolley elsewhere.
#[test]
fn a_crane_may_be_seen_first_when_it_is_stepped() {
    let mut supervisor = supervisor(&[]);
    for _ in 0..60 {
        look(&mut supervisor, 0.0, (4.0, true));
    }
    assert_eq!(item(&mut supervisor, "state"), READY);
}

#[test]
fn a_range_that_is_none_is_refused() {
    let mut supervisor = Instance::new("CraneSupervisor", FmiVersion::V3, STEP);
    supervisor.set_all("position_min", &[0.0, 2.0, 0.0, 0.0]);
    supervisor.set_all("position_max", &[1.0, 1.0, 1.0, 1.0]);
    let failure = supervisor.initialize(None).expect_err("no range, no start");
    let text = failure.messages.iter().map(|message| message.text.clone()).collect::<String>();
    assert!(text.contains("position_max[2]") && text.contains("position_min[2]"), "{text}");
}
