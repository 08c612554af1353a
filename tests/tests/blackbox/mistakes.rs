//! Wrong things fail well: through the `swayless` command and real FMUs, with exit codes and messages.

use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use swayless::slave::Status;
use swayless_modeldesc::types::FmiVersion;
use tempfile::TempDir;
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

use crate::instance::Instance;
use crate::packaged::{self, VERSIONS};

const FAILED: i32 = 1;
const WRONG_USAGE: i32 = 2;
const FOUND_PROBLEMS: i32 = 3;

/// Runs the command and returns what it says on stdout and stderr.
#[track_caller]
fn swayless(arguments: &[&str], code: i32) -> (String, String) {
    let output = packaged::command().args(arguments).output().expect("the command starts");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_owned()).expect("text");
    let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(code), "swayless {arguments:?}\n{stdout}\n{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
    (stdout, stderr)
}

/// Runs the command, which must fail and say all of this on stderr, and nothing on stdout.
#[track_caller]
fn fails(arguments: &[&str], code: i32, wanted: &[&str]) {
    let (stdout, stderr) = swayless(arguments, code);
    assert_eq!(stdout, "", "{stderr}");
    assert!(stderr.starts_with("error: "), "{stderr}");
    for part in wanted {
        assert!(stderr.contains(part), "`{part}` is missing in: {stderr}");
    }
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

/// An entry of an archive: name and contents.
type Entry = (String, Vec<u8>);

/// A copy of `BoomCrane` with changed entries.
fn altered(folder: &TempDir, version: FmiVersion, change: impl Fn(&mut Vec<Entry>)) -> PathBuf {
    let mut archive =
        ZipArchive::new(File::open(packaged::path("BoomCrane", version)).expect("a file")).expect("a zip");
    let mut entries = Vec::new();
    for i in 0..archive.len() {
        let mut entry = archive.by_index(i).expect("an entry");
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).expect("bytes");
        entries.push((entry.name().expect("a name").into_owned(), bytes));
    }
    change(&mut entries);
    let path = folder.path().join("altered.fmu");
    let mut writer = ZipWriter::new(File::create(&path).expect("a file"));
    for (name, bytes) in &entries {
        writer.start_file(name.as_str(), SimpleFileOptions::default()).expect("an entry");
        writer.write_all(bytes).expect("room");
    }
    writer.finish().expect("an archive");
    path
}

/// A system of cranes and a drive that is wired as said, in a file of its own.
fn wired(folder: &TempDir, connections: &[(&str, &str)]) -> PathBuf {
    let (mut elements, mut wires) = (String::new(), String::new());
    for (name, fmu) in [("one", "BoomCrane"), ("two", "BoomCrane"), ("drive", "VectorDrive")] {
        let copy = folder.path().join(format!("{fmu}.fmu"));
        std::fs::copy(packaged::path(fmu, FmiVersion::V3), copy).expect("a copy");
        let ends = connections.iter().flat_map(|(from, to)| [(*from, "output"), (*to, "input")]);
        let connectors = ends.filter_map(|(end, kind)| {
            let connector = end.strip_prefix(name)?.strip_prefix('.')?;
            Some(format!("<ssd:Connector name=\"{connector}\" kind=\"{kind}\"/>\n"))
        });
        let connectors: String = connectors.collect();
        let connectors = match connectors.as_str() {
            "" => connectors,
            some => format!("<ssd:Connectors>\n{some}</ssd:Connectors>\n"),
        };
        elements += &format!(
            "<ssd:Component name=\"{name}\" type=\"application/x-fmu-sharedlibrary\" source=\"{fmu}.fmu\">\n\
             {connectors}</ssd:Component>\n"
        );
    }
    for (from, to) in connections {
        let ((a, b), (c, d)) = (from.split_once('.').expect("a dot"), to.split_once('.').expect("a dot"));
        wires += &format!(
            "<ssd:Connection startElement=\"{a}\" startConnector=\"{b}\" endElement=\"{c}\" endConnector=\"{d}\"/>\n"
        );
    }
    let system = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ssd:SystemStructureDescription name=\"wired\" version=\"1.0\" \
         xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\">\n<ssd:System name=\"wired\">\n\
         <ssd:Elements>\n{elements}</ssd:Elements>\n<ssd:Connections>\n{wires}</ssd:Connections>\n</ssd:System>\n\
         </ssd:SystemStructureDescription>\n"
    );
    let path = folder.path().join("SystemStructure.ssd");
    std::fs::write(&path, system).expect("a file");
    path
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

#[test]
fn a_missing_file_is_named() {
    fails(&["run", "no/such.fmu"], FAILED, &["no/such.fmu"]);
    fails(&["run", "no/such.ssd"], FAILED, &["no/such.ssd"]);
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    fails(&["run", text(&crane), "--input-file", "no/such.csv"], FAILED, &["no/such.csv"]);
}

#[test]
fn a_broken_zip_is_told_from_a_missing_one() {
    let folder = folder();
    for version in VERSIONS {
        let whole = std::fs::read(packaged::path("BoomCrane", version)).expect("an archive");
        let path = folder.path().join("half.fmu");
        std::fs::write(&path, &whole[..whole.len() / 2]).expect("half a file");
        fails(&["run", text(&path)], FAILED, &["half.fmu", "zip archive"]);
        let (stdout, _) = swayless(&["validate", text(&path)], FOUND_PROBLEMS);
        assert!(stdout.contains("zip archive"), "{stdout}");
    }
}

#[test]
fn damaged_contents_are_noticed() {
    let folder = folder();
    let mut bytes = std::fs::read(packaged::path("BoomCrane", FmiVersion::V3)).expect("an archive");
    // Somewhere in the compressed library, which is most of the archive.
    let middle = bytes.len() / 2;
    bytes[middle..middle + 16].iter_mut().for_each(|byte| *byte ^= 0xff);
    let path = folder.path().join("damaged.fmu");
    std::fs::write(&path, bytes).expect("a file");
    fails(&["run", text(&path)], FAILED, &["damaged.fmu", "zip archive"]);
}

#[test]
fn a_path_that_leaves_the_archive_is_refused() {
    let folder = folder();
    for escape in ["../escaped.txt", "resources/../../escaped.txt", "/tmp/escaped-from-an-fmu.txt"] {
        let path = altered(&folder, FmiVersion::V3, |entries| entries.push((escape.to_owned(), b"out".to_vec())));
        fails(&["run", text(&path)], FAILED, &[escape, "leave the folder"]);
        let (stdout, _) = swayless(&["validate", text(&path)], FOUND_PROBLEMS);
        assert!(stdout.contains(escape), "{stdout}");
    }
    assert!(!Path::new("/tmp/escaped-from-an-fmu.txt").exists());
    assert!(!std::env::temp_dir().join("escaped.txt").exists());
}

#[test]
fn a_wrong_token_is_refused_by_the_library() {
    let folder = folder();
    for version in VERSIONS {
        let path = altered(&folder, version, |entries| {
            for (_, bytes) in entries.iter_mut().filter(|(name, _)| name == "modelDescription.xml") {
                let xml = String::from_utf8(bytes.clone()).expect("UTF-8");
                let begin = xml.find('{').expect("a token") + 1;
                let other = if xml[begin..].starts_with('0') { "1" } else { "0" };
                *bytes = format!("{}{other}{}", &xml[..begin], &xml[begin + 1..]).into_bytes();
            }
        });
        fails(&["run", text(&path)], FAILED, &["instantiati", "token", "the FMU says"]);
    }
}

#[test]
fn a_missing_binary_is_named_with_those_that_are_there() {
    let folder = folder();
    let library = format!("BoomCrane.{}", std::env::consts::DLL_EXTENSION);
    for version in VERSIONS {
        let moved = altered(&folder, version, |entries| {
            for (name, _) in entries.iter_mut().filter(|(name, _)| name.starts_with("binaries/")) {
                *name = format!("binaries/pdp11-unix/{library}");
            }
        });
        fails(&["run", text(&moved)], FAILED, &["no binary for this platform", &library, "pdp11-unix"]);
        let none = altered(&folder, version, |entries| entries.retain(|(name, _)| !name.starts_with("binaries/")));
        fails(&["run", text(&none)], FAILED, &["no binary for this platform", "none"]);
    }
}

#[test]
fn a_missing_description_makes_no_fmu() {
    let folder = folder();
    let path = altered(&folder, FmiVersion::V3, |entries| entries.retain(|(name, _)| name != "modelDescription.xml"));
    fails(&["run", text(&path)], FAILED, &["modelDescription.xml"]);
    let cut = altered(&folder, FmiVersion::V3, |entries| entries[0].1.truncate(2000));
    fails(&["run", text(&cut)], FAILED, &["modelDescription.xml", "line"]);
}

#[test]
fn an_unknown_variable_brings_a_suggestion() {
    for version in VERSIONS {
        let crane = packaged::path("BoomCrane", version);
        let crane = text(&crane);
        let suggestion = ["swing.radial_strat", "did you mean `swing.radial_start`?"];
        fails(&["run", crane, "--start-value", "swing.radial_strat=0.1"], FAILED, &suggestion);
        let suggestion = ["swing.radail", "did you mean `swing.radial`?"];
        fails(&["run", crane, "--output-variable", "swing.radail"], FAILED, &suggestion);
    }
    let folder = folder();
    let system = wired(&folder, &[("drive.velocty", "one.slew.rate")]);
    fails(&["run", text(&system)], FAILED, &["velocty", "did you mean `velocity`?"]);
    let system = wired(&folder, &[("drvie.velocity", "one.slew.rate")]);
    fails(&["run", text(&system)], FAILED, &["drvie", "line 16"]);
}

#[test]
fn all_problems_are_told_at_once() {
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    let values = ["--start-value", "boom.lenght=1", "--start-value", "slew.rte=1", "--start-value", "luff.rate=fast"];
    let arguments = [&["run", text(&crane)], &values[..]].concat();
    fails(&arguments, FAILED, &["boom.lenght", "slew.rte", "luff.rate"]);
}

#[test]
fn types_that_do_not_fit_are_not_connected() {
    let folder = folder();
    let system = wired(&folder, &[("one.at_limit", "two.slew.rate")]);
    fails(&["run", text(&system)], FAILED, &["one.at_limit", "two.slew.rate", "Boolean", "cannot be connected"]);
}

#[test]
fn units_that_do_not_fit_are_not_connected() {
    let folder = folder();
    let system = wired(&folder, &[("one.hoist.length", "two.slew.rate")]);
    fails(&["run", text(&system)], FAILED, &["one.hoist.length", "two.slew.rate", "`m`", "`rad/s`", "converted"]);
}

#[test]
fn an_algebraic_loop_is_shown() {
    let folder = folder();
    // A swing rate feeds through from the luff rate; the swing angle would not.
    let crossed = [("one.swing.radial_rate", "two.luff.rate"), ("two.swing.radial_rate", "one.luff.rate")];
    let parts = ["algebraic loop", "one.swing.radial_rate", "two.luff.rate", "two.swing.radial_rate", "one.luff.rate"];
    fails(&["run", text(&wired(&folder, &crossed))], FAILED, &parts);
    let circle = [("one.swing.radial_rate", "one.luff.rate")];
    fails(&["run", text(&wired(&folder, &circle))], FAILED, &["algebraic loop", "one.swing.radial_rate"]);
}

#[test]
fn an_input_that_is_not_a_number_is_named() {
    for version in VERSIONS {
        let crane = packaged::path("BoomCrane", version);
        fails(&["run", text(&crane), "--start-value", "slew.rate=NaN"], FAILED, &["slew.rate"]);
    }
    let folder = folder();
    let signals = folder.path().join("signals.csv");
    std::fs::write(&signals, "time,slew.rate\n0,0\n1,nan\n").expect("a file");
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    fails(&["run", text(&crane), "--input-file", text(&signals)], FAILED, &["signals.csv:3", "nan"]);
}

#[test]
fn an_input_that_is_not_a_number_is_refused_by_the_library() {
    for (version, bad) in VERSIONS.into_iter().flat_map(|v| [(v, f64::NAN), (v, f64::INFINITY)]) {
        let mut crane = Instance::new("BoomCrane", version, 0.1);
        crane.initialize(None).expect("initialization");
        crane.set("luff.rate", 0.05).expect("a rate");
        crane.run_to(1.0);
        let before = crane.get3(["swing.radial", "luff.angle", "payload.x"]);
        crane.set("slew.rate", bad).expect("a setter refuses nothing");
        let failure = crane.try_step().expect_err("no step with a NaN");
        assert_eq!(failure.status, Status::Discard, "{failure:?}");
        assert!(failure.messages.iter().any(|m| m.text.contains("slew.rate")), "{failure:?}");
        if version == FmiVersion::V2 {
            assert_eq!(failure.last_successful_time, Some(1.0));
        }
        assert_eq!(crane.get3(["swing.radial", "luff.angle", "payload.x"]), before);
    }
}

#[test]
fn a_parameter_out_of_its_range_is_named() {
    for version in VERSIONS {
        let crane = packaged::path("BoomCrane", version);
        fails(&["run", text(&crane), "--start-value", "boom.length=-1"], FAILED, &["boom.length", "-1"]);
        fails(&["run", text(&crane), "--start-value", "gravity=NaN"], FAILED, &["gravity"]);
    }
}

/// The harness does not even ask; what the library answers is checked from Python, which does.
#[test]
fn no_step_after_terminate() {
    for version in VERSIONS {
        let mut crane = Instance::new("BoomCrane", version, 0.1);
        crane.initialize(None).expect("initialization");
        crane.step();
        crane.slave.terminate().expect("the end");
        let angle = crane.get("luff.angle");
        let failure = crane.try_step().expect_err("no step after the end");
        assert_eq!(failure.status, Status::NotCalled, "{failure:?}");
        assert!(failure.messages.iter().any(|m| m.text.contains("terminated")), "{failure:?}");
        // Values can still be looked at, and a reset makes a new start.
        assert_eq!(crane.get("luff.angle"), angle);
        crane.slave.reset().expect("a reset");
        crane.initialize(None).expect("initialization");
    }
}

#[test]
fn options_that_make_no_sense_are_wrong_usage() {
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    fails(&["run", text(&crane), "--stop-time=-1"], WRONG_USAGE, &["stop"]);
    fails(&["run", text(&crane), "--step-size", "0"], WRONG_USAGE, &["step size"]);
}
