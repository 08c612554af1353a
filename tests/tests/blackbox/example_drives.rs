//! What the example systems of the tower crane and of the mobile base show: little swing, and a crane that is carried.

use crate::record::{last, run};

#[test]
fn shapers_still_the_tower_crane() {
    let off = ["slew", "trolley", "hoist"].map(|axis| format!("{axis}_shaper.kind=None"));
    let without: Vec<&str> = off.iter().flat_map(|value| ["--start-value", value]).collect();
    let records = [run("tower-crane", "0.02", &[]), run("tower-crane", "0.02", &without)];
    let [shaped, unshaped] = [0, 1].map(|i| last(&records[i], "crane.swing.amplitude"));
    println!("residual swing: {shaped:.4} rad shaped, {unshaped:.4} rad unshaped");
    assert!(shaped < 0.1 * unshaped, "{shaped} rad shaped, {unshaped} rad unshaped");
    for record in records {
        assert!(record["crane.at_limit"].iter().all(|flag| *flag == 0.0));
        let ways = [
            ("slew_drive.position", "crane.slew.angle"),
            ("trolley_drive.position", "crane.trolley.radius"),
            ("hoist_drive.position", "crane.hoist.length"),
        ];
        for (way, joint) in ways {
            // The velocity is held for each step, but both begin and end at rest.
            let moved = last(&record, joint) - record[joint][0];
            assert!((moved - last(&record, way)).abs() < 1e-4, "{joint} by {moved}, {way} {}", last(&record, way));
        }
    }
}

/// Both modes, for the length that the cable has been hoisted to; with the slower mode alone the hook goes on under the payload.
#[test]
fn shapers_for_two_modes_still_the_bridge_crane() {
    let residual = |values: &[&str]| {
        let kinds: Vec<String> = ["trolley", "bridge"]
            .iter()
            .flat_map(|axis| values.iter().map(move |value| format!("{axis}_shaper.{value}")))
            .collect();
        let arguments: Vec<&str> = kinds.iter().flat_map(|value| ["--start-value", value]).collect();
        last(&run("bridge-crane", "0.01", &arguments), "crane.swing.amplitude")
    };
    let [both, slower, none] = [&[][..], &["kind=ZVD"], &["kind=None"]].map(residual);
    println!("residual swing: {both:.5} rad for both modes, {slower:.5} for the slower one, {none:.5} unshaped");
    assert!(both < 0.03 * none && both < 0.2 * slower, "{both}, {slower}, {none}");
}

#[test]
fn the_base_carries_the_crane() {
    let record = run("mobile-base", "0.02", &[]);
    let apart = |name: &str| {
        let (base, crane) = (&record[&format!("base.{name}")], &record[&format!("crane.{name}")]);
        base.iter().zip(crane).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let [x, y, yaw] = ["base.x", "base.y", "base.yaw"].map(apart);
    let (way, left) = (last(&record, "speed_drive.position"), last(&record, "crane.swing.amplitude"));
    println!("over {way:.2} m: within {x:.1e} m, {y:.1e} m, {yaw:.1e} rad; residual swing {left:.4} rad");
    // The crane holds for 0.02 s what it is told: half of that times 0.8 m/s. The yaw rate is steady over a step.
    assert!(way > 30.0 && x.max(y) < 0.0085 && yaw < 1e-9, "{x} m, {y} m, {yaw} rad");
    assert!(left < 0.02, "{left} rad");
    assert!(record["base.at_limit"].iter().chain(&record["crane.at_limit"]).all(|flag| *flag == 0.0));
}
