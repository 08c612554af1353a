//! Systems that are wired wrongly.

use std::path::PathBuf;

use swayless_modeldesc::types::FmiVersion;
use tempfile::TempDir;

use super::{FAILED, fails, folder, text};
use crate::packaged::{self, VERSIONS};

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
