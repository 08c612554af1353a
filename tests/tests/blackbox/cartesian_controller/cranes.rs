//! What cranes do of the rates: they keep height and line, and come to rest where a joint ends.

use super::{DEGREE, STEP, controller, rates, set};
use crate::instance::{Instance, Set};

/// The line of fig. 3.4 with the crane itself, from x = −9.2 m to 9.2 m at 1 m/s: the time it takes, how far the load strays
/// from its height and from y = 2 m on the way, and the last place before the end.
fn line(step: f64, look_ahead: f64, scaling: &str) -> [f64; 4] {
    let start = [("slew.angle", 2.0_f64.atan2(-9.2)), ("luff.angle", (9.2_f64.hypot(2.0) / 10.0).acos())];
    let length = ("boom.length", Set::Real(10.0));
    let crane = [length, (start[0].0, start[0].1.into()), (start[1].0, start[1].1.into())];
    let mut crane = Instance::started("BoomCrane", step, &crane);
    let mut controller = controller(&[
        length,
        ("luff.rate_limit", (4.0 * DEGREE).into()),
        ("slew.rate_limit", (15.0 * DEGREE).into()),
        ("look_ahead", look_ahead.into()),
        ("scaling", scaling.into()),
    ]);
    set(&mut controller, &[("velocity.x", 1.0)]);
    let height = crane.get("tip.z") - crane.get("hoist.length");
    let mut found = [0.0_f64; 4];
    loop {
        let [x, y, z] = crane.get3(["tip.x", "tip.y", "tip.z"]);
        if x >= 9.2 {
            return found;
        }
        let strayed = (z - crane.get("hoist.length") - height).abs();
        found = [crane.time() + step, found[1].max(strayed), found[2].max((y - 2.0).abs()), x];
        let [slew, luff, hoist, ..] = {
            let joints = ["slew.angle", "luff.angle"].map(|name| (name, crane.get(name)));
            rates(&mut controller, &joints)
        };
        assert!(controller.get_switch("saturated"));
        set(&mut crane, &[("slew.rate", slew), ("luff.rate", luff), ("hoist.rate", hoist)]);
        crane.step();
    }
}

/// An independent integration in steps of 1 ms, with rates that are held over each.
#[test]
fn the_line_is_that_of_an_independent_integration() {
    for (scaling, height) in [("Uniform", 0.000_495_611_342_724_8), ("Thesis", 8.158_369_211_923_11)] {
        let found = line(1e-3, 0.0, scaling);
        println!("{scaling}: {found:?}");
        for (found, wanted) in found.iter().zip([32.952, height, 0.001_465_875_350_782_6, 9.199_939_922_085_75]) {
            assert!((found - wanted).abs() < 1e-9, "{scaling}: {found} for {wanted}");
        }
    }
}

/// The rates are held over a step: without looking ahead by half of it the height is lost by r sin γ γ̇²·h/2 every second;
/// with it the error is of the second order, and of both signs.
#[test]
fn the_crane_keeps_height_and_line_through_saturation() {
    let [_, height, off, _] = line(STEP, 0.5 * STEP, "Uniform");
    println!("looking ahead: height {height:.2e} m, line {off:.2e} m");
    assert!(height < 1e-6 && off < 1e-5, "{height} m, {off} m");
    let [_, height, off, _] = line(STEP, 0.0, "Uniform");
    println!("not looking ahead: height {height:.5} m, line {off:.5} m");
    assert!((0.004..0.006).contains(&height) && off < 0.02, "{height} m, {off} m");
    let [_, height, off, _] = line(STEP, 0.5 * STEP, "Thesis");
    println!("the thesis's law: height {height:.4} m, line {off:.2e} m");
    // As with small steps and without looking ahead.
    assert!((height - 8.158).abs() < 0.005 && off < 1e-5, "{height} m, {off} m");
}

/// A crane that is told to move on where its controller knows an end: how far its load strays from its height, and where its joints
/// come to rest. It samples with steps of 10 ms and looks ahead by half of one.
fn against_an_end(machine: &str, end: (&str, f64), velocity: [f64; 2]) -> (f64, Instance, Instance) {
    let [end, look_ahead] = [(end.0, end.1.into()), ("look_ahead", Set::Real(0.5 * STEP))];
    let (plant, pivot, joint, rate) = match machine {
        "Boom" => ("BoomCrane", "tip", "luff.angle", "luff.rate"),
        _ => ("TowerCrane", "trolley", "trolley.radius", "trolley.rate"),
    };
    let mut plant = Instance::started(plant, STEP, &[]);
    let values = [end, look_ahead, ("machine", machine.into()), ("frame", "Crane".into())];
    let accelerations = ["luff", "hoist", "slew", "trolley"].map(|axis| format!("{axis}.acceleration_limit"));
    let accelerations = accelerations.each_ref().map(|name| (name.as_str(), Set::Real(0.2)));
    let mut controller = controller(&[&values[..], &accelerations].concat());
    set(&mut controller, &[("velocity.x", velocity[0]), ("velocity.z", velocity[1])]);
    let height = |plant: &mut Instance| plant.get(&format!("{pivot}.z")) - plant.get("hoist.length");
    let (start, mut strays) = (height(&mut plant), 0.0_f64);
    for _ in 0..4000 {
        let joints = ["slew.angle", "hoist.length", joint].map(|name| (name, plant.get(name)));
        set(&mut controller, &joints);
        controller.step();
        set(&mut plant, &["slew.rate", "hoist.rate", rate].map(|name| (name, controller.get(name))));
        plant.step();
        assert!(!plant.get_switch("at_limit"), "{machine} at {} s", plant.time());
        strays = strays.max((height(&mut plant) - start).abs());
    }
    (strays, controller, plant)
}

/// A joint that comes to its end takes all others with it: nothing is left that would lift or lower the load. The crane's own
/// stops are not reached.
#[test]
fn a_load_comes_to_rest_at_the_end_of_a_joint() {
    for (machine, joint, end, velocity) in [
        ("Boom", "luff.angle", ("luff.angle_max", 1.1), [-0.5, 0.0]),
        ("Boom", "luff.angle", ("luff.angle_min", 0.6), [0.5, 0.0]),
        ("Boom", "hoist.length", ("hoist.length_min", 7.0), [0.5, 0.0]),
        ("Boom", "hoist.length", ("hoist.length_max", 12.0), [-0.5, 0.0]),
        ("Tower", "trolley.radius", ("trolley.radius_max", 30.0), [0.5, 0.0]),
        ("Tower", "trolley.radius", ("trolley.radius_min", 12.0), [-0.5, 0.0]),
        ("Tower", "hoist.length", ("hoist.length_max", 12.0), [0.0, -0.4]),
    ] {
        let (strays, mut controller, mut plant) = against_an_end(machine, end, velocity);
        let (at, end) = (plant.get(joint), end.1);
        println!("{machine} {joint}: {:.1e} from its end, height {strays:.1e} m", (at - end).abs());
        // What is held for a step is half a step early or late.
        assert!((at - end).abs() < 1e-6 && (velocity[1] != 0.0 || strays < 1e-5), "{machine} {at}: {strays} m");
        assert!(controller.get("speed_fraction") < 1e-3 && controller.get_switch("saturated"), "{machine} {joint}");
        // And back it goes.
        set(&mut controller, &[("velocity.x", -velocity[0]), ("velocity.z", -velocity[1])]);
        for _ in 0..400 {
            let joints = ["hoist.length", joint].map(|name| (name, plant.get(name)));
            set(&mut controller, &joints);
            controller.step();
            let rates: &[&str] =
                if machine == "Boom" { &["luff.rate", "hoist.rate"] } else { &["trolley.rate", "hoist.rate"] };
            set(&mut plant, &rates.iter().map(|name| (*name, controller.get(name))).collect::<Vec<_>>());
            plant.step();
        }
        assert!((plant.get(joint) - end).abs() > 0.02 && controller.get("speed_fraction") == 1.0, "{machine} {joint}");
    }
}
