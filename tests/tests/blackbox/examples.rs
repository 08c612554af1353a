//! The examples: every system runs in both FMI versions, and every value of a parameter set says where it is from.

use std::path::{Path, PathBuf};

use swayless_modeldesc::ssp;

use crate::packaged::{self, repository};

/// Parameter sets, each with an example that takes it by `--parameter-set`, in the place of its own or once more.
const SETS: [(&str, &str); 5] = [
    ("industrial-bridge-crane", "bridge-crane"),
    ("ten-ton-bridge-crane", "bridge-crane"),
    ("portable-bridge-crane", "bridge-crane"),
    ("kobelco-ck800", "boom-tip-camera"),
    ("luffing-rig", "luffing-rig"),
];

/// Files with this extension, one folder below the examples.
fn files(extension: &str) -> Vec<PathBuf> {
    let folders = std::fs::read_dir(repository().join("examples")).expect("examples");
    let folders = folders.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_dir());
    let files = folders.flat_map(|folder| std::fs::read_dir(folder).expect("a folder"));
    let mut files: Vec<_> = files.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == extension));
    files.sort();
    assert!(!files.is_empty());
    files
}

/// What a run of a system records, as text, with the FMUs of both versions.
fn results(system: &Path, more: &[&str]) -> [String; 2] {
    ["fmi2", "fmi3"].map(|version| {
        let folder = tempfile::tempdir().expect("a folder");
        let result = folder.path().join("result.csv");
        let mut command = packaged::command();
        command.arg("run").arg(system).arg("--fmu-dir").arg(packaged::all().output_dir.join(version));
        let output = command.arg("--output-file").arg(&result).args(more).output().expect("the command starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{} with {version}: {message}", system.display());
        std::fs::read_to_string(result).expect("results")
    })
}

#[test]
fn every_system_runs_in_both_versions() {
    for system in files("ssd") {
        let [fmi2, fmi3] = results(&system, &[]);
        assert!(fmi2.lines().count() > 100, "{}", system.display());
        assert!(fmi2 == fmi3, "{}: the versions differ", system.display());
    }
}

#[test]
fn every_parameter_set_fits_its_system() {
    for (set, system) in SETS {
        let set = repository().join(format!("examples/parameters/{set}.ssv"));
        let system = repository().join(format!("examples/{system}/SystemStructure.ssd"));
        let set = set.to_str().expect("a path in UTF-8");
        let [fmi2, fmi3] = results(&system, &["--parameter-set", set, "--stop-time", "1", "--step-size", "0.1"]);
        assert!(fmi2 == fmi3, "{set}: the versions differ");
    }
}

/// What a bridge crane's set says of commands and shapers suits the crane that it makes: nothing runs into an end stop, and
/// the shapers leave less than a tenth of the swing that there is without them.
#[test]
fn the_shapers_of_a_set_suit_its_crane() {
    let system = repository().join("examples/bridge-crane/SystemStructure.ssd");
    for (set, _) in SETS.iter().filter(|(_, system)| *system == "bridge-crane") {
        let values = repository().join(format!("examples/parameters/{set}.ssv"));
        let run = |more: &[&str]| -> serde_json::Value {
            let mut command = packaged::command();
            command.arg("run").arg(&system).arg("--fmu-dir").arg(packaged::all().output_dir.join("fmi3"));
            command.arg("--parameter-set").arg(&values).arg("--json").args(more);
            serde_json::from_slice(&command.output().expect("the command starts").stdout).expect("JSON")
        };
        let of = |run: &serde_json::Value, name: &str, key: &str| -> f64 {
            let variables = run["variables"].as_array().expect("a list");
            let variable = variables.iter().find(|variable| variable["name"] == name).expect("a variable");
            variable[key].as_f64().expect("a number")
        };
        let shaped = run(&[]);
        let none = ["--start-value", "trolley_shaper.kind=None", "--start-value", "bridge_shaper.kind=None"];
        let swing = [&shaped, &run(&none)].map(|run| of(run, "crane.swing.amplitude", "end"));
        println!("{set}: {} rad, without shapers {} rad", swing[0], swing[1]);
        assert!(swing[0] < 0.1 * swing[1], "{set}: {swing:?}");
        assert_eq!(of(&shaped, "crane.at_limit", "max"), 0.0, "{set}");
    }
}

#[test]
fn every_value_says_where_it_is_from() {
    for path in files("ssv") {
        let text = std::fs::read_to_string(&path).expect("a set");
        let (set, problems) = ssp::read_parameters(&text).expect("a parameter set");
        assert!(problems.is_empty() && !set.parameters.is_empty(), "{}: {problems:?}", path.display());
        let machine = path.parent().is_some_and(|folder| folder.ends_with("parameters"));
        for parameter in &set.parameters {
            let description = parameter.description.as_deref().unwrap_or_default();
            let sourced = ["Printed", "Derived", "Assumed"].iter().any(|word| description.starts_with(word));
            let told = if machine { sourced } else { !description.is_empty() };
            assert!(told, "{}: {} is “{description}”", path.display(), parameter.name);
        }
    }
}
