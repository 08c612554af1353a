//! `swayless shaper` and `InputShaper` agree: the parameter set that the command writes makes the FMU the shaper it showed.

use serde_json::Value;

use crate::packaged::{VERSIONS, command, path};

/// What the command prints as JSON.
fn json(arguments: &[&str]) -> Value {
    let output = command().args(arguments).output().expect("the command starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// The last value of an output of a run.
fn end(run: &Value, name: &str) -> f64 {
    let name = format!("InputShaper.{name}");
    let variables = run["variables"].as_array().expect("a list");
    let variable = variables.iter().find(|variable| variable["name"] == *name).expect("an output");
    variable["end"].as_f64().expect("a number")
}

#[test]
fn the_parameter_set_makes_the_shaper() {
    let folder = tempfile::tempdir().expect("a folder");
    let set = folder.path().join("shaper.ssv");
    let set = set.to_str().expect("text");
    let (one, two) = (["--length", "10", "--damping", "0.01"], ["--frequency", "1", "--frequency", "3.6"]);
    let limit = ["--acceleration-limit", "0.12", "--velocity-limit", "0.358"];
    let constants = ["--acceleration-time-constant", "0.5", "--braking-time-constant", "0.2"];
    let cases: [(&str, Vec<&str>); 12] = [
        ("ZVDDD", one.to_vec()),
        ("SI", [&one[..], &["--range", "8..13"]].concat()),
        // as little and as much as the command takes
        ("SI", vec!["--hertz", "1", "--vibration-limit", "0.005", "--insensitivity", "0"]),
        ("SI", vec!["--hertz", "1", "--vibration-limit", "0.5", "--insensitivity", "1.5"]),
        ("UMEI", [&one[..], &["--vibration-limit", "0.08"]].concat()),
        ("ALEI", [&one[..], &limit].concat()),
        ("ALSI", [&one[..], &limit].concat()),
        ("UMZVc", [&one[..], &constants].concat()),
        ("Convolved", [&two[..], &["--base-kind", "ZV", "--base-kind", "ZVD"]].concat()),
        ("Convolved", [&two[..], &["--base-kind", "SI", "--insensitivity", "0.15"]].concat()),
        ("MinimumImpulse", [&two[..], &["--solution", "2"]].concat()),
        ("MultiModeSI", [&two[..], &["--insensitivity", "0.2"]].concat()),
    ];
    for (place, (kind, mode)) in cases.into_iter().enumerate() {
        let answer = json(&[&["shaper", "--json", "--kind", kind, "--ssv", set], &mode[..]].concat());
        let shaper = &answer["shapers"][0];
        let fmu = path("InputShaper", VERSIONS[place % 2]);
        // A step at the start, as large as the drive of ALEI is asked for.
        let start =
            ["--parameter-set", set, "--start-value", "command=0.358", "--stop-time", "0.1", "--step-size", "0.1"];
        let run = json(&[&["run", fmu.to_str().expect("text"), "--json"], &start[..]].concat());
        let impulses = shaper["impulses"].as_array().expect("a list");
        assert_eq!(end(&run, "impulse.count") as usize, impulses.len(), "{kind}");
        for (index, impulse) in (1..).zip(impulses) {
            for name in ["time", "amplitude"] {
                let (has, wanted) =
                    (end(&run, &format!("impulse.{name}[{index}]")), impulse[name].as_f64().expect("a number"));
                assert!((has - wanted).abs() <= 1e-12, "{kind}: impulse.{name}[{index}] is {has}, not {wanted}");
            }
        }
    }
}
