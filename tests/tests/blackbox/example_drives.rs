//! What the example systems of the tower crane and of the mobile base show: little swing, and a crane that is carried.

use std::collections::BTreeMap;

use crate::packaged::{self, VERSIONS, repository};

/// The columns of a run's record by their names; truth values are 0 and 1.
type Record = BTreeMap<String, Vec<f64>>;

/// Runs an example by the command, with the FMUs of both versions, which must give the same.
fn run(example: &str, more: &[&str]) -> Record {
    let [old, new] = VERSIONS.map(|version| {
        let output = packaged::command()
            .arg("run")
            .arg(repository().join("examples").join(example).join("SystemStructure.ssd"))
            .arg("--fmu-dir")
            .arg(packaged::all().folder(version))
            .args(["--step-size", "0.02", "--output-file", "-"])
            .args(more)
            .output()
            .expect("the command");
        assert!(output.status.success(), "{example}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("text")
    });
    assert!(old == new, "{example}: the versions differ");
    let mut lines = new.lines();
    let names = lines.next().expect("a header").split(',');
    let mut columns: Vec<_> = names.map(|name| (name.to_owned(), Vec::new())).collect();
    for line in lines {
        for (column, text) in columns.iter_mut().zip(line.split(',')) {
            column.1.push(text.parse().unwrap_or_else(|_| f64::from(u8::from(text == "true"))));
        }
    }
    columns.into_iter().collect()
}

fn last(record: &Record, name: &str) -> f64 {
    *record[name].last().expect("a row")
}

#[test]
fn shapers_still_the_tower_crane() {
    let off = ["slew", "trolley", "hoist"].map(|axis| format!("{axis}_shaper.kind=None"));
    let without: Vec<&str> = off.iter().flat_map(|value| ["--start-value", value]).collect();
    let records = [run("tower-crane", &[]), run("tower-crane", &without)];
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

#[test]
fn the_base_carries_the_crane() {
    let record = run("mobile-base", &[]);
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
