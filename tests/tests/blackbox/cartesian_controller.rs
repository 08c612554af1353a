//! `CartesianController`: the thesis's matrices, saturation, singular positions, frames and moving bases, and what crane
//! FMUs do of its rates.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6};

use swayless_modeldesc::types::FmiVersion;

use crate::instance::{Instance, Set, noise};

const DEGREE: f64 = std::f64::consts::PI / 180.0;
const STEP: f64 = 0.01;
/// All that moves something.
const RATES: [&str; 7] =
    ["slew.rate", "luff.rate", "hoist.rate", "trolley.rate", "extension.rate", "luff.line_speed", "hoist.line_speed"];

/// A controller that samples at every communication point.
fn controller(values: &[(&str, Set<'_>)]) -> Instance {
    Instance::started("CartesianController", STEP, &[&[("sample_time", 0.0.into())], values].concat())
}

fn set(instance: &mut Instance, values: &[(&str, f64)]) {
    values.iter().for_each(|(name, value)| instance.set(name, *value).expect("a value"));
}

/// All rates after a step with these inputs.
fn rates(controller: &mut Instance, values: &[(&str, f64)]) -> [f64; 7] {
    set(controller, values);
    controller.step();
    RATES.map(|name| controller.get(name))
}

/// Commands along x, y and z.
const UNITS: [[(&str, f64); 3]; 3] = [
    [("velocity.x", 1.0), ("velocity.y", 0.0), ("velocity.z", 0.0)],
    [("velocity.x", 0.0), ("velocity.y", 1.0), ("velocity.z", 0.0)],
    [("velocity.x", 0.0), ("velocity.y", 0.0), ("velocity.z", 1.0)],
];

/// V·T (3.14) on the rig of Table 2.3 at γ = 45°, θ = 30°, computed independently.
#[test]
fn the_rig_has_the_thesis_matrix() {
    let rig =
        [("boom.length", 0.89), ("jib.length", 0.33), ("hoist_sheave.distance", 0.29), ("jib.angle", 137.0 * DEGREE)];
    let mut controller = controller(&rig.map(|(name, value)| (name, value.into())));
    set(&mut controller, &[("luff.angle", FRAC_PI_4), ("slew.angle", FRAC_PI_6)]);
    let wanted = [
        [0.420_772_421_150_611_3, -0.794_502_001_333_199_4, -0.490_656_768_139_853_37],
        [0.242_933_070_618_876, 1.376_117_833_024_257_4, -0.283_280_817_165_256_1],
        [0.0, 0.0, -1.0],
    ];
    let geometry = rig.map(|(name, value)| (name, Set::Real(value)));
    let mut ropes = Instance::started("LuffRigging", STEP, &geometry);
    for (unit, wanted) in UNITS.iter().zip(wanted) {
        let [slew, luff, hoist, .., reeled_in, paid_out] = rates(&mut controller, unit);
        // The ropes make of their speeds the rates that were meant.
        set(&mut ropes, &[("luff.line_speed", reeled_in), ("hoist.line_speed", paid_out)]);
        assert!((ropes.get("luff.rate") - luff).abs() < 1e-15 && (ropes.get("hoist.rate") - hoist).abs() < 1e-15);
        for (found, wanted) in [-reeled_in, slew, paid_out].into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-14, "{found}, not {wanted}");
        }
        assert!(!controller.get_switch("saturated") && !controller.get_switch("singular"));
    }
}

/// What the plants make of the rates is the velocity that was asked for: differences of their positions over a step of
/// 1 µs. Where a machine has no such axis, nothing is asked of it.
#[test]
fn the_cranes_move_as_asked() {
    let mut random = noise();
    let machines = [("Boom", "BoomCrane", "tip"), ("Tower", "TowerCrane", "trolley"), ("BoomLift", "BoomLift", "tip")];
    for (machine, plant, end) in machines {
        let unused: &[usize] = match machine {
            "Boom" => &[3, 4],
            "Tower" => &[1, 4, 5, 6],
            _ => &[2, 3, 5, 6],
        };
        for _ in 0..6 {
            let slew = 3.0 * random();
            let luff = 0.7 + 0.6 * random();
            let joints = match machine {
                "Boom" => vec![("slew.angle", slew), ("luff.angle", luff)],
                "Tower" => vec![("slew.angle", slew), ("trolley.radius", 20.0 + 10.0 * random())],
                _ => vec![("slew.angle", slew), ("luff.angle", luff), ("extension.length", 4.0 + 3.0 * random())],
            };
            let wanted = [random(), random(), random()];
            // The lift's own boom is 12 m long.
            let length = if machine == "BoomLift" { 12.0 } else { 18.0 };
            let mut controller = controller(&[("machine", machine.into()), ("boom.length", length.into())]);
            let command = ["velocity.x", "velocity.y", "velocity.z"].into_iter().zip(wanted);
            let found = rates(&mut controller, &[joints.clone(), command.collect()].concat());
            assert!(unused.iter().all(|i| found[*i] == 0.0), "{machine}: {found:?}");

            let starts: Vec<_> = joints.iter().map(|(name, value)| (*name, Set::Real(*value))).collect();
            let mut plant = Instance::started(plant, 1e-6, &starts);
            let place = |plant: &mut Instance| {
                let mut at = ["x", "y", "z"].map(|axis| plant.get(&format!("{end}.{axis}")));
                // The load hangs below; a boom lift has no hoist.
                at[2] -= if machine == "BoomLift" { 0.0 } else { plant.get("hoist.length") };
                at
            };
            let before = place(&mut plant);
            let inputs = RATES[..5].iter().zip(found).filter(|(name, _)| match machine {
                "Boom" => !["trolley.rate", "extension.rate"].contains(name),
                "Tower" => !["luff.rate", "extension.rate"].contains(name),
                _ => !["hoist.rate", "trolley.rate"].contains(name),
            });
            set(&mut plant, &inputs.map(|(name, rate)| (*name, rate)).collect::<Vec<_>>());
            plant.step();
            let after = place(&mut plant);
            for ((before, after), wanted) in before.into_iter().zip(after).zip(wanted) {
                // Positions of 40 m have 1e-14 m, over 1 µs; and rates change by some 1e-7 of themselves.
                let moved = (after - before) / 1e-6;
                assert!((moved - wanted).abs() < 1e-6, "{machine}: {moved}, not {wanted}");
            }
        }
    }
}

/// The same motion, told in each frame, and from a base that stands turned.
#[test]
fn frames_are_turned_into_each_other() {
    let joints = [("slew.angle", 0.4), ("luff.angle", 0.8), ("base.yaw", -1.1)];
    let velocity = |x: f64, y: f64| [("velocity.x", x), ("velocity.y", y), ("velocity.z", 0.2)];
    let told = |frame: &str, [x, y]: [f64; 2], heading: f64| {
        let values = [&joints[..], &velocity(x, y), &[("operator.heading", heading)]].concat();
        rates(&mut controller(&[("frame", frame.into())]), &values)
    };
    let turned = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [0.5 * cos - 0.3 * sin, 0.5 * sin + 0.3 * cos]
    };
    // 0.5 radial and 0.3 tangential.
    let crane = told("Crane", [0.5, 0.3], 9.0);
    let others = [told("World", turned(0.4 - 1.1), 9.0), told("Ground", turned(0.4 - 1.1 - 2.0), 2.0)];
    for other in others {
        assert!(crane.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-15), "{crane:?} and {other:?}");
    }
    assert!((crane[0] - 0.3 / (18.0 * 0.8_f64.cos())).abs() < 1e-16 && crane[1] < 0.0);
}

/// Two limits at once. The thesis's law keeps slew and luff in proportion; this one also the hoist.
#[test]
fn saturation_keeps_the_direction() {
    let limits = [("slew.rate_limit", 0.02.into()), ("luff.rate_limit", 0.01.into())];
    let inputs = [("luff.angle", 0.9), ("velocity.x", 0.9), ("velocity.y", 1.1), ("velocity.z", 0.1)];
    let free = rates(&mut controller(&[]), &inputs);
    let mut uniform = controller(&limits);
    let found = rates(&mut uniform, &inputs);
    let share = (0.02 / free[0].abs()).min(0.01 / free[1].abs());
    assert!(share < 1.0 && (uniform.get("speed_fraction") - share).abs() < 1e-15 && uniform.get_switch("saturated"));
    assert!(found.iter().zip(free).all(|(found, free)| (found - share * free).abs() < 1e-15), "{found:?} of {free:?}");
    let mut thesis = controller(&[&limits[..], &[("scaling", "Thesis".into())]].concat());
    let found = rates(&mut thesis, &inputs);
    assert!((found[0] - share * free[0]).abs() < 1e-15 && (found[1] - share * free[1]).abs() < 1e-15);
    assert_eq!(found[2], free[2]);
    assert!(thesis.get_switch("saturated"));
    // A locked hoist: nothing moves that would change the height.
    let locked = rates(&mut controller(&[("hoist.rate_limit", 0.0.into())]), &inputs);
    assert_eq!(locked, [0.0; 7]);
}

/// From rest to full speed no axis gets faster than it can, one of them as fast as it can, and all of them together.
#[test]
fn axes_speed_up_together() {
    let limits = [("slew", 0.05), ("luff", 0.02), ("hoist", 0.3)];
    let names = limits.map(|(axis, _)| format!("{axis}.acceleration_limit"));
    let values: Vec<_> = names.iter().zip(limits).map(|(name, (_, limit))| (name.as_str(), Set::Real(limit))).collect();
    let inputs = [("luff.angle", 0.9), ("slew.angle", 0.4), ("velocity.x", 0.5), ("velocity.y", -0.7)];
    let full = rates(&mut controller(&[]), &inputs);
    let mut controller = controller(&values);
    // At the start there has been no time to get faster.
    let mut before = rates(&mut controller, &inputs);
    assert!(before.iter().all(|rate| *rate == 0.0) && controller.get_switch("saturated"));
    let mut steps = 0;
    while before != full {
        let now = rates(&mut controller, &inputs);
        let shares: Vec<f64> = (0..3).map(|i| (now[i] - before[i]).abs() / (limits[i].1 * STEP)).collect();
        let most = shares.iter().copied().fold(0.0, f64::max);
        let share = now[0] / full[0];
        assert!(most < 1.0 + 1e-9 && (most > 1.0 - 1e-9 || share == 1.0), "{shares:?} at {share}");
        assert!((0..7).all(|i| (now[i] - share * full[i]).abs() < 1e-12), "{now:?} of {full:?}");
        assert_eq!(controller.get_switch("saturated"), share < 1.0);
        before = now;
        steps += 1;
    }
    let slowest = (0..3).map(|i| full[i].abs() / (limits[i].1 * STEP)).fold(0.0, f64::max);
    assert_eq!(f64::from(steps), slowest.ceil());
}

/// At a singular luff angle and right beside it: finite, slower, told, and free to leave.
#[test]
fn singular_positions_are_told_and_left() {
    for (machine, angle, away) in [("Boom", 0.0, -1.0), ("BoomLift", FRAC_PI_2, 1.0)] {
        let mut controller = controller(&[("machine", machine.into()), ("frame", "Crane".into())]);
        for off in [0.0, 1e-300, 1e-15, 1e-6, 0.049] {
            let luff = if angle == 0.0 { off } else { angle - off };
            let leaving = rates(&mut controller, &[("luff.angle", luff), ("velocity.x", away)]);
            assert!(leaving[1] * (FRAC_PI_4 - angle) > 0.01, "{machine} {luff}: {leaving:?}");
            assert!(controller.get_switch("singular"));
            let entering = rates(&mut controller, &[("velocity.x", -away)]);
            assert!(
                entering[1].abs() <= 1.01 * leaving[1].abs() * (off / 0.05 + 1e-12),
                "{machine} {luff}: {entering:?}"
            );
            assert!(controller.get("speed_fraction") < 1.0 && controller.get_switch("saturated"));
        }
        // Out of the margin nothing is slower.
        rates(&mut controller, &[("luff.angle", if angle == 0.0 { 0.051 } else { angle - 0.051 })]);
        assert!(!controller.get_switch("singular") && !controller.get_switch("saturated"));
        assert_eq!(controller.get("speed_fraction"), 1.0);
    }
    let mut tower = controller(&[("machine", "Tower".into()), ("frame", "Crane".into())]);
    let found = rates(&mut tower, &[("trolley.radius", 0.0), ("velocity.x", 0.4), ("velocity.y", 0.0)]);
    assert!(found[3] == 0.4 && tower.get_switch("singular") && !tower.get_switch("saturated"));
    assert_eq!(rates(&mut tower, &[("velocity.x", -0.4)])[3], 0.0);
    let found = rates(&mut tower, &[("velocity.x", 0.0), ("velocity.y", 0.4)]);
    assert!((found[0] - 0.8).abs() < 1e-9, "0.4 m/s half a metre away: {found:?}");
}

/// Any finite input: finite rates, and a flag where something was cut.
#[test]
fn any_finite_input_gives_finite_rates() {
    let names = [
        "velocity.x",
        "velocity.z",
        "slew.angle",
        "luff.angle",
        "trolley.radius",
        "extension.length",
        "base.yaw",
        "base.velocity.y",
        "base.yaw_rate",
        "operator.heading",
    ];
    for machine in ["Boom", "Tower", "BoomLift"] {
        for scaling in ["Uniform", "Thesis"] {
            let values = [("machine", machine.into()), ("scaling", scaling.into()), ("frame", "Ground".into())];
            let mut controller = controller(&[&values[..], &[("look_ahead", 10.0.into())]].concat());
            for name in names {
                for value in [f64::MAX, f64::MIN, f64::MIN_POSITIVE, -0.0] {
                    set(&mut controller, &[("velocity.x", 1.0), ("velocity.y", -1.0), (name, value)]);
                    let found = rates(&mut controller, &[]);
                    assert!(found.iter().all(|rate| rate.abs() <= 100.0), "{machine} {name} {value}: {found:?}");
                    let fraction = controller.get("speed_fraction");
                    assert!((0.0..=1.0).contains(&fraction), "{machine} {name} {value}: {fraction}");
                    let huge = value.abs() == f64::MAX;
                    let matters = match name {
                        "trolley.radius" => machine == "Tower",
                        "extension.length" => machine != "Tower",
                        _ => true,
                    };
                    assert!(!(huge && matters) || controller.get_switch("saturated"), "{machine} {name} {value}");
                }
                set(&mut controller, &[(name, 0.3)]);
            }
        }
    }
}

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

/// Between two samples the rates are held, in both versions alike.
#[test]
fn rates_are_held_between_samples() {
    let run = |version| {
        let mut controller = Instance::new("CartesianController", version, 0.004);
        set(&mut controller, &[("sample_time", 0.02), ("velocity.x", 0.5)]);
        controller.initialize(None).expect("initialization");
        let mut found = Vec::new();
        for step in 0..50 {
            controller.set("luff.angle", 0.5 + 0.01 * f64::from(step)).expect("an angle");
            controller.step();
            found.push(controller.get("luff.rate"));
        }
        found
    };
    let found = run(FmiVersion::V3);
    assert_eq!(found, run(FmiVersion::V2));
    let changes = found.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert_eq!(changes, 10, "50 steps of 4 ms have 10 samples of 20 ms");
}
