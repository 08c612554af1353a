//! The command from outside: what it prints where, and how it exits.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, its helpers too")]

mod common;
#[path = "common/pack.rs"]
mod pack;
#[path = "cli/shaper/mod.rs"]
mod shaper;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use zip::write::{SimpleFileOptions, ZipWriter};

const FAILED: i32 = 1;
const WRONG_USAGE: i32 = 2;
const FOUND_PROBLEMS: i32 = 3;

fn swayless(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_swayless"));
    // Help is wrapped and coloured as these say.
    command.env_remove("COLUMNS").env_remove("CLICOLOR_FORCE");
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("the command starts")
}

#[track_caller]
fn exits(arguments: &[&str], code: i32) -> (String, String) {
    let output = swayless(arguments);
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_owned()).expect("text");
    let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{stdout}\n{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
    (stdout, stderr)
}

/// Packs entries into an archive.
fn archive(folder: &Path, name: &str, entries: &[(&str, &str)]) -> PathBuf {
    let path = folder.join(name);
    let mut zip = ZipWriter::new(std::fs::File::create(&path).expect("a file"));
    for (name, text) in entries {
        zip.start_file(*name, SimpleFileOptions::default()).expect("an entry");
        zip.write_all(text.as_bytes()).expect("room");
    }
    zip.finish().expect("an archive");
    path
}

#[test]
fn every_command_has_help() {
    let (all, _) = exits(&["--help"], 0);
    for command in ["build", "info", "validate", "run", "shaper", "demo"] {
        assert!(all.contains(command), "{all}");
        let (help, errors) = exits(&[command, "--help"], 0);
        assert!(help.contains("Usage: swayless") && errors.is_empty(), "{help}");
    }
}

#[test]
fn wrong_usage_exits_with_2() {
    exits(&[], WRONG_USAGE);
    exits(&["fly"], WRONG_USAGE);
    exits(&["run"], WRONG_USAGE);
    exits(&["run", "x.fmu", "--step-size", "small"], WRONG_USAGE);
    exits(&["run", "x.fmu", "--start-value", "speed"], WRONG_USAGE);
    let (_, message) = exits(&["run", "x.fmu", "--fmu-dir", "fmus"], WRONG_USAGE);
    assert!(message.contains("`--fmu-dir`") && message.contains("single FMU"), "{message}");
    let (_, message) = exits(&["build", "BoomCrone"], WRONG_USAGE);
    assert!(message.contains("did you mean `boom-crane`?"), "{message}");
}

#[test]
fn a_missing_file_is_named_and_exits_with_1() {
    for command in ["info", "validate", "run"] {
        let (stdout, message) = exits(&[command, "no/such.fmu"], FAILED);
        assert!(stdout.is_empty());
        assert!(message.starts_with("error: ") && message.contains("no/such.fmu"), "{message}");
    }
}

#[test]
fn validation_tells_all_problems_and_exits_with_3() {
    let folder = tempfile::tempdir().unwrap();
    let description = "<?xml version=\"1.0\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"M\" bogus=\"1\">\n\
                       <CoSimulation modelIdentifier=\"M\"/>\n<ModelVariables/>\n<ModelStructure/>\n\
                       </fmiModelDescription>\n";
    let fmu = archive(folder.path(), "m.fmu", &[("modelDescription.xml", description)]);
    let fmu = fmu.to_str().unwrap();
    let (stdout, stderr) = exits(&["validate", fmu], FOUND_PROBLEMS);
    assert!(stderr.is_empty());
    assert!(stdout.contains("modelDescription.xml: line 2: error:"), "{stdout}");
    assert!(
        stdout.contains("instantiationToken") && stdout.contains("bogus") && stdout.contains("binaries/"),
        "{stdout}"
    );

    let (json, _) = exits(&["validate", "--json", fmu], FOUND_PROBLEMS);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json[0]["problems"].as_array().unwrap().len() >= 3);
}

#[test]
fn a_system_is_validated_with_its_fmus() {
    let folder = tempfile::tempdir().unwrap();
    let ssd = folder.path().join("system.ssd");
    let connector = |name: &str, kind: &str, data_type: &str| {
        format!("<ssd:Connector name=\"{name}\" kind=\"{kind}\"><ssc:{data_type}/></ssd:Connector>\n")
    };
    let write = |connectors: &str| {
        let text = format!(
            "<ssd:SystemStructureDescription name=\"s\" version=\"1.0\"\n  \
             xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\"\n  \
             xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\">\n\
             <ssd:System name=\"root\"><ssd:Elements>\n\
             <ssd:Component name=\"one\" source=\"one.fmu\"><ssd:Connectors>\n{connectors}\
             </ssd:Connectors></ssd:Component>\n</ssd:Elements></ssd:System></ssd:SystemStructureDescription>\n"
        );
        std::fs::write(&ssd, text).unwrap();
        ssd.to_str().unwrap()
    };
    let good = connector("rate", "input", "Real") + &connector("x", "output", "Real");
    let (stdout, _) = exits(&["validate", write(&good)], 0);
    assert!(stdout.contains("line 5: warning: component `one`: there is no file"), "{stdout}");
    pack::pack(&common::foreign(swayless_modeldesc::types::FmiVersion::V3), &folder.path().join("one.fmu"));
    let (stdout, _) = exits(&["validate", write(&good)], 0);
    assert!(stdout.contains("no problems"), "{stdout}");
    let wrong = [("rate", "output", "Real"), ("raet", "input", "Real"), ("x", "output", "Boolean")];
    let wrong: String = wrong.map(|(name, kind, data_type)| connector(name, kind, data_type)).concat();
    let (stdout, _) = exits(&["validate", write(&wrong)], FOUND_PROBLEMS);
    for text in [
        "line 6: error: the connector `one.rate` is of kind output, the variable of causality Input",
        "line 7: error: `one` (",
        "has no variable `raet`; did you mean `rate`?",
        "line 8: error: the connector `one.x` is Boolean, the variable Float64",
    ] {
        assert!(stdout.contains(text), "{text} is not in\n{stdout}");
    }
    assert_eq!(stdout.lines().count(), 3, "{stdout}");
}

/// An FMU with a bit of everything that ticks and groups, beside what a model description must have.
fn clocked(folder: &Path) -> PathBuf {
    let description = include_str!("../../modeldesc/tests/golden/fmi3_clocks.xml");
    let terminals = "<fmiTerminalsAndIcons fmiVersion='3.0'><Terminals>\n\
                     <Terminal name='swing' matchingRule='bus' terminalKind='sway'>\n\
                     <TerminalMemberVariable variableName='swing.push' memberName='push' variableKind='signal'/>\n\
                     <TerminalMemberVariable variableName='swing.pull' memberName='pull' variableKind='signal'/>\n\
                     </Terminal></Terminals></fmiTerminalsAndIcons>";
    let entries = [
        ("modelDescription.xml", description),
        ("terminalsAndIcons/terminalsAndIcons.xml", terminals),
        ("binaries/x86_64-linux/Pendulum.so", ""),
    ];
    archive(folder, "clocked.fmu", &entries)
}

#[test]
fn terminals_are_validated_with_the_variables() {
    let folder = tempfile::tempdir().unwrap();
    let (stdout, _) = exits(&["validate", clocked(folder.path()).to_str().unwrap()], FOUND_PROBLEMS);
    assert_eq!(stdout.lines().count(), 1, "{stdout}");
    let place = "terminalsAndIcons/terminalsAndIcons.xml: line 4: error:";
    assert!(stdout.contains(place) && stdout.contains("`swing.pull`"), "{stdout}");
}

#[test]
fn info_shows_enumerations_clocks_sizes_and_terminals() {
    let folder = tempfile::tempdir().unwrap();
    let fmu = clocked(folder.path());
    let (stdout, stderr) = exits(&["info", fmu.to_str().unwrap()], 0);
    assert_eq!(stderr, "");
    let has = |words: &[&str]| {
        let found = |line: &str| line.split_whitespace().collect::<Vec<_>>() == words;
        assert!(stdout.lines().any(found), "{words:?} is not in\n{stdout}");
    };
    has(&["Kind", "Payload", "2", "and", "hook"]);
    has(&["n", "3", "modes"]);
    has(&["ticks.constant", "constant", "0.5", "0", "count,", "count.before"]);
    has(&["ticks.countdown", "countdown", "4"]);
    has(&["swing", "sway", "push", "swing.push"]);
    assert!(stdout.contains("Float32[2][n]"), "{stdout}");

    let (json, _) = exits(&["info", "--json", fmu.to_str().unwrap()], 0);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    for (path, value) in [
        ("/interfaces/CoSimulation/hasEventMode", serde_json::json!(true)),
        ("/interfaces/ModelExchange/needsCompletedIntegratorStep", serde_json::json!(true)),
        ("/interfaces/ScheduledExecution/modelIdentifier", serde_json::json!("Pendulum")),
        ("/enumerations/0/items/1/value", serde_json::json!(2)),
        ("/variables/13/clock/intervalVariability", serde_json::json!("constant")),
        ("/variables/20/clocks", serde_json::json!(["ticks.constant", "ticks.fixed"])),
        ("/terminals/0/members/0/variableName", serde_json::json!("swing.push")),
    ] {
        assert_eq!(json.pointer(path), Some(&value), "{path}");
    }
}

#[test]
fn a_broken_archive_is_a_problem_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.fmu");
    std::fs::write(&path, "this is no archive").unwrap();
    let path = path.to_str().unwrap();
    let (stdout, _) = exits(&["validate", path], FOUND_PROBLEMS);
    assert!(stdout.contains("zip archive"), "{stdout}");
    exits(&["run", path], FAILED);
}

/// Sends SIGINT to a long run; nothing is left of it but whole lines.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_whole_lines_and_no_folders() {
    let folder = tempfile::tempdir().unwrap();
    let temporary = folder.path().join("temporary");
    std::fs::create_dir(&temporary).unwrap();
    let (fmu, csv) = (folder.path().join("foreign.fmu"), folder.path().join("out.csv"));
    pack::pack(&common::foreign(swayless_modeldesc::types::FmiVersion::V3), &fmu);
    let mut run = Command::new(env!("CARGO_BIN_EXE_swayless"))
        .args(["run", "--stop-time", "1e7", "--step-size", "0.125", "--start-value", "rate=0.2", "-o"])
        .args([&csv, &fmu])
        .env("TMPDIR", &temporary)
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let begin = std::time::Instant::now();
    let written = || std::fs::metadata(&csv).map_or(0, |file| file.len());
    while written() == 0 && begin.elapsed().as_secs() < 60 {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert_eq!(std::fs::read_dir(&temporary).unwrap().count(), 1, "the unpacked FMU");
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    assert_eq!(run.wait().unwrap().code(), Some(130));
    let mut message = String::new();
    std::io::Read::read_to_string(&mut run.stderr.take().unwrap(), &mut message).unwrap();
    assert!(message.starts_with("error: interrupted at t = "), "{message}");
    assert_eq!(std::fs::read_dir(&temporary).unwrap().count(), 0);
    let text = std::fs::read_to_string(&csv).unwrap();
    let fields = |line: &str| line.split(',').count();
    assert!(text.ends_with('\n') && text.lines().count() > 1);
    assert!(text.lines().all(|line| fields(line) == fields(text.lines().next().unwrap())));
}
