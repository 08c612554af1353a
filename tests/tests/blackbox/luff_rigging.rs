//! `LuffRigging` against numbers computed independently for the rig of Table 2.3, and together with `BoomCrane`.

use serde_json::Value as Json;
use swayless::{Options, Recording, System, simulate};
use swayless_modeldesc::types::FmiVersion;

use crate::instance::{Instance, Set};
use crate::packaged;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Table 2.3: boom, jib and sheave of the luffing rig.
const RIG: [(&str, Set<'static>); 4] = [
    ("boom.length", Set::Real(0.89)),
    ("jib.length", Set::Real(0.33)),
    ("jib.angle", Set::Real(137.0 * DEGREE)),
    ("hoist_sheave.distance", Set::Real(0.29)),
];

fn rigging(values: &[(&str, Set<'_>)]) -> Instance {
    Instance::started("LuffRigging", 0.01, &[&RIG[..], values].concat())
}

fn set(instance: &mut Instance, values: &[(&str, f64)]) {
    values.iter().for_each(|(name, value)| instance.set(name, *value).expect("a value"));
}

#[track_caller]
fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() <= tolerance * (1.0 + wanted.abs()), "{found}, wanted {wanted}");
}

/// Lengths and rates that follow from the table; the mean of 15°/s printed there asks for a slower line.
#[test]
fn the_rig_of_table_2_3_moves_as_computed() {
    let table = &packaged::data("luffing.json")["table2.3"];
    let number = |json: &Json| json.as_f64().expect("a number");
    let mut rig = rigging(&[]);
    let mut at = |degrees: f64| {
        set(&mut rig, &[("luff.angle", degrees * DEGREE), ("luff.line_speed", 0.12)]);
        let [rate, line, hoist] = rig.get3(["luff.rate", "luff.line_length", "hoist.line_length"]);
        (rate / DEGREE, line, hoist)
    };
    let ((lowest, long, back), (highest, short, front)) = (at(11.0), at(80.0));
    // With the hoist line held the suspension is 0.18 m long at 11° and gets what B loses.
    close(0.18 + back - front, number(&table["length_at_80_deg"]), 1e-14);
    let rates = &table["luff_rate_at_11_deg_80_deg_and_least_deg/s"];
    let least = (11 * 50..80 * 50).map(|i| at(f64::from(i) / 50.0).0).fold(f64::INFINITY, f64::min);
    close(lowest, number(&rates[0]), 1e-13);
    close(highest, number(&rates[1]), 1e-13);
    close(least, number(&rates[2]), 1e-7);
    close(69.0 * 0.12 / (long - short), number(&table["average_luff_rate_deg/s"]), 1e-12);
    close(15.0 / 69.0 * (long - short), number(&table["line_speed_for_average_of_15_deg/s"]), 1e-12);
}

/// The static force of a payload of weight 1 under a boom without mass, over K, is its lever arm.
#[test]
fn the_payloads_lever_is_shorter_by_the_hoist_lines_reaction() {
    let data = packaged::data("luffing.json");
    let rows = &data["table2.3"]["luff_angle_deg, payload_arm_of_thesis, payload_arm_consistent"];
    for (reaction, column) in [("Thesis", 1), ("Consistent", 2)] {
        let weight = [("boom.mass", 0.0.into()), ("payload.mass", 1.0.into()), ("gravity", 1.0.into())];
        let mut rig = rigging(&[&weight[..], &[("reaction", reaction.into())]].concat());
        for row in rows.as_array().expect("rows") {
            let number = |i: usize| row[i].as_f64().expect("a number");
            set(&mut rig, &[("luff.angle", number(0) * DEGREE), ("luff.line_speed", 1.0)]);
            close(rig.get("luff.line_force_static") / rig.get("luff.rate"), number(column), 1e-13);
        }
    }
}

/// (3.14) at γ = 45°, θ = 30°, as printed there to five digits: what the lines do for a tip velocity along x, y or z.
#[test]
fn lines_turn_a_cartesian_velocity_into_joint_rates() {
    let (r, luff, slew) = (0.89, 45.0 * DEGREE, 30.0 * DEGREE);
    let mut rig = rigging(&[("luff.angle", luff.into())]);
    // Rows Ċ and L̇ of V T, and rows γ̇ and l̇ of T (3.6).
    for (lines, rates) in [
        ([0.42077, -0.49066], [-slew.cos() / (r * luff.sin()), -slew.cos() / luff.tan()]),
        ([0.24293, -0.28328], [-slew.sin() / (r * luff.sin()), -slew.sin() / luff.tan()]),
        ([0.0, -1.0], [0.0, -1.0]),
    ] {
        set(&mut rig, &[("luff.line_speed", -lines[0]), ("hoist.line_speed", lines[1])]);
        close(rig.get("luff.rate"), rates[0], 2e-5);
        close(rig.get("hoist.rate"), rates[1], 2e-5);
    }
}

/// A crane whose luff line is reeled in evenly while its hoist line is held: C falls evenly and ℓ + B stays.
#[test]
fn with_the_hoist_line_held_rope_and_suspension_keep_their_sum() {
    const SPEED: f64 = 0.1;
    const STEP: f64 = 0.005;
    let start = 20.0 * DEGREE;
    let mut rig = rigging(&[("luff.line_speed", SPEED.into())]);
    let values = [("boom.length", 0.89), ("luff.angle", start), ("hoist.length", 0.2), ("hoist.length_min", 0.1)];
    let mut crane = Instance::started("BoomCrane", STEP, &values.map(|(name, value)| (name, Set::Real(value))));
    let mut rates = |luff: f64| {
        set(&mut rig, &[("luff.angle", luff)]);
        let lengths = (rig.get("luff.line_length"), rig.get("hoist.line_length"));
        ([rig.get("luff.rate"), rig.get("hoist.rate")], lengths)
    };
    let (_, (long, back)) = rates(start);
    while crane.time() < 3.0 {
        // The mean of the rates over the step, as the Runge–Kutta method of fourth order takes it.
        let luff = crane.get("luff.angle");
        let (first, _) = rates(luff);
        let (second, _) = rates(luff + 0.5 * STEP * first[0]);
        let (third, _) = rates(luff + 0.5 * STEP * second[0]);
        let (fourth, _) = rates(luff + STEP * third[0]);
        let mean = |i: usize| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0;
        set(&mut crane, &[("luff.rate", mean(0)), ("hoist.rate", mean(1))]);
        crane.step();
        let (_, (line, hoist)) = rates(crane.get("luff.angle"));
        close(line, long - SPEED * crane.time(), 1e-11);
        close(crane.get("hoist.length") + hoist, 0.2 + back, 1e-11);
    }
    assert!(crane.get("luff.angle") > 70.0 * DEGREE);
}

/// The crane computes its cable's tension from the motion of its tip in three dimensions, the rigging by (2.21).
#[test]
fn the_hoist_lines_force_is_the_cranes_tension() {
    for (i, [speed, acceleration, paid, paying, swing, rate]) in [
        [0.0, 0.0, 0.0, 0.0, 0.3, -0.4],
        [0.5, 0.2, -0.3, 0.6, -0.2, 0.9],
        [-1.1, 1.4, 0.7, -0.8, 0.7, 0.1],
        [2.0, -2.5, 0.0, 0.0, -1.1, -0.6],
    ]
    .into_iter()
    .enumerate()
    {
        let (luff, length) = (0.3 + 0.25 * i as f64, 4.0 + 3.0 * i as f64);
        let mut rig = Instance::started("LuffRigging", 0.01, &[("luff.angle", luff.into())]);
        let lines = [
            ("luff.line_speed", speed),
            ("luff.line_acceleration", acceleration),
            ("hoist.line_speed", paid),
            ("hoist.line_acceleration", paying),
            ("hoist.length", length),
        ];
        set(&mut rig, &lines);
        let joints = ["luff.rate", "luff.acceleration", "hoist.rate", "hoist.acceleration"];
        let start = [("luff.angle", luff), ("hoist.length", length), ("swing.radial_start", swing)];
        let start = [&start[..], &[("swing.radial_rate_start", rate)]].concat();
        let mut values: Vec<_> = start.into_iter().map(|(name, value)| (name, Set::Real(value))).collect();
        values.extend(joints.map(|joint| (joint, Set::Real(rig.get(joint)))));
        let mut crane = Instance::started("BoomCrane", 0.01, &values);
        let seen = ["swing.radial", "swing.radial_rate"].map(|name| (name, crane.get(name)));
        set(&mut rig, &seen);
        close(rig.get("hoist.line_force"), crane.get("tension"), 1e-12);
    }
}

/// What a drive needs to know of its load does not depend on what the drive does; the rest is the mass's inertia.
#[test]
fn static_force_and_mass_are_the_force_at_any_acceleration() {
    let mut rig = Instance::started("LuffRigging", 0.01, &[]);
    set(&mut rig, &[("swing.radial", 0.2), ("swing.radial_rate", -0.3)]);
    let load = [rig.get("luff.line_force_static"), rig.get("luff.line_mass")];
    for acceleration in [0.0, 0.7, -4.0] {
        set(&mut rig, &[("luff.line_acceleration", acceleration)]);
        close(rig.get("luff.line_force"), load[0] + load[1] * acceleration, 1e-13);
    }
    set(&mut rig, &[("luff.line_speed", 0.5), ("hoist.line_speed", -0.2), ("hoist.line_acceleration", 0.3)]);
    assert_eq!([rig.get("luff.line_force_static"), rig.get("luff.line_mass")], load);
}

#[test]
fn where_the_lever_ends_outputs_stay_finite_and_a_flag_says_so() {
    let mut rig = rigging(&[("luff.line_speed", 0.12.into())]);
    assert!(!rig.get_switch("singular") && !rig.get_switch("at_limit"));
    for (degrees, singular) in [(136.0, false), (136.9, true), (137.0, true), (-43.1, true), (1e9, true), (45.0, false)]
    {
        set(&mut rig, &[("luff.angle", degrees * DEGREE)]);
        rig.step();
        assert_eq!(rig.get_switch("singular"), singular, "at {degrees}°");
        let rate = rig.get("luff.rate");
        assert!(rate > 0.0 && rate < 100.0, "{rate} rad/s at {degrees}°");
    }
    for (input, value) in [("luff.line_speed", 1e200), ("hoist.length", -1.0), ("hoist.line_acceleration", -1e7)] {
        let mut rig = rigging(&[]);
        set(&mut rig, &[(input, value)]);
        rig.step();
        assert!(rig.get_switch("at_limit") && !rig.get_switch("singular"), "{input} = {value}");
        for output in ["luff.rate", "hoist.rate", "luff.acceleration", "luff.line_force", "hoist.line_force"] {
            assert!(rig.get(output).is_finite(), "{output} for {input} = {value}");
        }
    }
}

/// Drives, rigging and crane of the small rig, as its parameter set has them, luff from 11° upwards: it fits the FMUs,
/// nothing is at a limit, there is no algebraic loop, and the crane does what the luff line does.
#[test]
fn the_parameter_set_of_the_luffing_rig_makes_a_chain() {
    let mut system = System::new("rig");
    for (name, fmu) in [
        ("luff_drive", "VectorDrive"),
        ("hoist_drive", "VectorDrive"),
        ("rigging", "LuffRigging"),
        ("crane", "BoomCrane"),
    ] {
        system.add_fmu(name, packaged::path(fmu, FmiVersion::V3)).expect("an FMU");
    }
    for axis in ["luff", "hoist"] {
        system.connect(format!("{axis}_drive.velocity"), format!("rigging.{axis}.line_speed"));
        system.connect(format!("{axis}_drive.acceleration"), format!("rigging.{axis}.line_acceleration"));
        system.connect(format!("rigging.{axis}.rate"), format!("crane.{axis}.rate"));
        system.connect(format!("rigging.{axis}.acceleration"), format!("crane.{axis}.acceleration"));
    }
    for fed_back in ["luff.angle", "hoist.length", "swing.radial", "swing.radial_rate"] {
        system.connect(format!("crane.{fed_back}"), format!("rigging.{fed_back}"));
    }
    let set = packaged::repository().join("examples/parameters/luffing-rig.ssv");
    system.add_parameter_set(set).expect("a parameter set");
    system.set_start_value("luff_drive.command", "1");
    let mut found = Recording::new();
    let options = Options { stop_time: Some(2.5), step_size: Some(1e-3), ..Options::default() };
    simulate(&system, &options, &mut found).expect("a run");

    let column = |name: &str| found.column(name).unwrap_or_else(|| panic!("no column {name}"));
    for flag in ["rigging.singular", "rigging.at_limit", "crane.at_limit", "crane.slack"] {
        assert!(column(flag).iter().all(|value| *value == 0.0), "{flag}");
    }
    let total = |i: usize| column("crane.hoist.length")[i] + column("rigging.hoist.line_length")[i];
    let line = |i: usize| column("rigging.luff.line_length")[i] + column("luff_drive.position")[i];
    // Rates are held over each step, so that a millisecond's change of the rates is what they are wrong by.
    for i in 0..=2500 {
        close(total(i), total(0), 1e-4);
        close(line(i), line(0), 1e-4);
    }
    assert!(column("crane.luff.angle")[2500] > 60.0 * DEGREE);
    close(column("crane.luff.angle")[0], 11.0 * DEGREE, 1e-12);
    // The rigging sees the swing that the crane tells: both have the same force in the hoist line, but for that too.
    let forces = column("rigging.hoist.line_force").iter().zip(column("crane.tension"));
    forces.for_each(|(rigging, crane)| close(*rigging, *crane, 1e-3));
}
