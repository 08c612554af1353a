//! Systems from SSP: descriptions and packages run; what is wrong with them has its place.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, its helpers too")]

mod common;
#[path = "common/pack.rs"]
mod pack;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use common::foreign;
use pack::pack;
use swayless::{CsvWriter, Error, InputSignals, Options, System, simulate};
use swayless_modeldesc::types::FmiVersion;

const NESTED: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription name="nested" version="1.0"
    xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription"
    xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"
    xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues">
  <ssd:System name="root">
    <ssd:Connectors>
      <ssd:Connector name="speed" kind="input"><ssc:Real/></ssd:Connector>
      <ssd:Connector name="position" kind="output"><ssc:Real/></ssd:Connector>
    </ssd:Connectors>
    <ssd:ParameterBindings>
      <ssd:ParameterBinding>
        <ssd:ParameterValues>
          <ssv:ParameterSet name="set" version="1.0"><ssv:Parameters>
            <ssv:Parameter name="inner.two.x_start"><ssv:Real value="200" unit="cm"/></ssv:Parameter>
            <ssv:Parameter name="one.label"><ssv:String value="./beside.txt"/></ssv:Parameter>
          </ssv:Parameters>
          <ssv:Units><ssc:Unit name="cm"><ssc:BaseUnit m="1" factor="0.01"/></ssc:Unit></ssv:Units></ssv:ParameterSet>
        </ssd:ParameterValues>
      </ssd:ParameterBinding>
    </ssd:ParameterBindings>
    <ssd:Elements>
      <ssd:Component name="one" source="one.fmu">
        <ssd:Connectors>
          <ssd:Connector name="rate" kind="input"><ssc:Real/></ssd:Connector>
          <ssd:Connector name="doubled" kind="output"><ssc:Real/></ssd:Connector>
        </ssd:Connectors>
      </ssd:Component>
      <ssd:System name="inner">
        <ssd:Connectors>
          <ssd:Connector name="rate_in" kind="input"><ssc:Real/></ssd:Connector>
          <ssd:Connector name="x_out" kind="output"><ssc:Real/></ssd:Connector>
        </ssd:Connectors>
        <ssd:ParameterBindings>
          <ssd:ParameterBinding prefix="two.">
            <ssd:ParameterValues>
              <ssv:ParameterSet name="set" version="1.0"><ssv:Parameters>
                <ssv:Parameter name="x_start"><ssv:Real value="7"/></ssv:Parameter>
                <ssv:Parameter name="label"><ssv:String value="inner"/></ssv:Parameter>
              </ssv:Parameters></ssv:ParameterSet>
            </ssd:ParameterValues>
          </ssd:ParameterBinding>
        </ssd:ParameterBindings>
        <ssd:Elements>
          <ssd:Component name="two" source="one.fmu">
            <ssd:Connectors>
              <ssd:Connector name="rate" kind="input"><ssc:Real/></ssd:Connector>
              <ssd:Connector name="x" kind="output"><ssc:Real/></ssd:Connector>
            </ssd:Connectors>
          </ssd:Component>
        </ssd:Elements>
        <ssd:Connections>
          <ssd:Connection startElement="two" startConnector="rate" endConnector="rate_in"/>
          <ssd:Connection startElement="two" startConnector="x" endConnector="x_out"/>
        </ssd:Connections>
      </ssd:System>
    </ssd:Elements>
    <ssd:Connections>
      <ssd:Connection startConnector="speed" endElement="one" endConnector="rate"/>
      <ssd:Connection startElement="one" startConnector="doubled" endElement="inner" endConnector="rate_in">
        <ssc:LinearTransformation factor="0.5" offset="1"/>
      </ssd:Connection>
      <ssd:Connection startElement="inner" startConnector="x_out" endConnector="position"/>
    </ssd:Connections>
  </ssd:System>
  <ssd:DefaultExperiment startTime="0" stopTime="1"/>
</ssd:SystemStructureDescription>
"#;

/// A parameter set of its own goes before what the system says, and start values that are set later before both.
#[test]
fn a_parameter_set_replaces_start_values() {
    let folder = tempfile::tempdir().unwrap();
    let set = folder.path().join("other.ssv");
    let text = r#"<ssv:ParameterSet name="other" version="1.0"
        xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues"
        xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon">
      <ssv:Parameters>
        <ssv:Parameter name="one.x_start"><ssv:Real value="300" unit="cm"/></ssv:Parameter>
        <ssv:Parameter name="one.label"><ssv:String value="./beside.txt"/></ssv:Parameter>
      </ssv:Parameters>
      <ssv:Units><ssc:Unit name="cm"><ssc:BaseUnit m="1" factor="0.01"/></ssc:Unit></ssv:Units>
    </ssv:ParameterSet>"#;
    fs::write(&set, text).unwrap();
    let fmu = folder.path().join("one.fmu");
    pack(&foreign(FmiVersion::V3), &fmu);
    let started = |system: &System| {
        let options = Options { output_variables: vec!["one.x".into(), "one.label".into()], ..Options::default() };
        let mut csv = CsvWriter::new("memory", Vec::new());
        simulate(system, &options, &mut csv).unwrap();
        let text = String::from_utf8(csv.into_inner().unwrap()).unwrap();
        text.lines().nth(1).unwrap().to_owned()
    };
    let mut system = System::new("set");
    system.add_fmu("one", &fmu).unwrap();
    system.set_start_value("one.x_start", "7");
    assert_eq!(started(&system), "0,7,foreign");
    system.add_parameter_set(&set).unwrap();
    assert!(started(&system).starts_with("0,3,") && started(&system).ends_with("beside.txt"));
    system.set_start_value("one.x_start", "8");
    assert!(started(&system).starts_with("0,8,"));

    // What is wrong has its place.
    fs::write(&set, text.replace("one.x_start", "one.y_start")).unwrap();
    system.add_parameter_set(&set).unwrap();
    let problem = system.check().unwrap_err().to_string();
    assert!(problem.contains("other.ssv:5") && problem.contains("y_start"), "{problem}");
    fs::write(&set, "<broken").unwrap();
    assert!(system.add_parameter_set(&set).unwrap_err().to_string().contains("other.ssv"));
    let missing = folder.path().join("missing.ssv");
    assert!(matches!(system.add_parameter_set(missing).unwrap_err(), Error::FileNotFound { .. }));
}

#[test]
fn nested_systems_run_from_a_description_and_from_a_package() {
    let folder = tempfile::tempdir().unwrap();
    let files = folder.path().join("files");
    fs::create_dir(&files).unwrap();
    pack(&foreign(FmiVersion::V3), &files.join("one.fmu"));
    let ssd = files.join("SystemStructure.ssd");
    fs::write(&ssd, NESTED).unwrap();
    let ssp = folder.path().join("nested.ssp");
    pack(&files, &ssp);
    let other = folder.path().join("fmi2");
    fs::create_dir(&other).unwrap();
    pack(&foreign(FmiVersion::V2), &other.join("one.fmu"));

    let systems = [System::open(&ssd), System::open(&ssp), System::open_with_fmus(&ssd, &other)];
    for (mut system, version) in systems.map(Result::unwrap).into_iter().zip(["3.0", "3.0", "2.0"]) {
        let names: Vec<&str> = system.instances().iter().map(|instance| instance.name.as_str()).collect();
        assert_eq!(names, ["one", "inner.two"]);
        let model = &system.instances()[0].model;
        assert_eq!(model.description().fmi_version.to_string(), version);
        assert!(Arc::ptr_eq(model, &system.instances()[1].model), "one file is opened once");
        system.set_input_signals(InputSignals::read("in.csv", b"time,speed\n0,3\n").unwrap());
        let mut csv = CsvWriter::new("memory", Vec::new());
        let names = ["position", "one.label", "inner.two.label", "inner.two.rate"].map(str::to_owned);
        let options = Options { output_variables: names.to_vec(), step_size: Some(0.5), ..Options::default() };
        simulate(&system, &options, &mut csv).unwrap();
        let text = String::from_utf8(csv.into_inner().unwrap()).unwrap();
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(rows[0], ["time", "inner.two.x", "one.label", "inner.two.label", "inner.two.rate"]);
        // 200 cm, then 0.5 s at 0.5 · (2 · 3) + 1 = 4 m/s.
        assert_eq!([rows[1][1], rows[2][1], rows[3][1]], ["2", "4", "6"]);
        assert!(rows[1][2].ends_with("beside.txt") && Path::new(rows[1][2]).is_absolute(), "{}", rows[1][2]);
        assert_eq!((rows[1][3], rows[1][4]), ("inner", "4"));
    }
}

#[test]
fn a_package_takes_nothing_from_outside() {
    let folder = tempfile::tempdir().unwrap();
    let files = folder.path().join("files");
    fs::create_dir(&files).unwrap();
    let outside = folder.path().join("outside.fmu");
    pack(&foreign(FmiVersion::V3), &outside);
    let source = format!("source=\"file://{}\"", outside.display());
    fs::write(files.join("SystemStructure.ssd"), NESTED.replace("source=\"one.fmu\"", &source)).unwrap();
    let ssp = folder.path().join("nested.ssp");
    pack(&files, &ssp);
    let text = System::open(&ssp).unwrap_err().to_string();
    assert!(text.contains("lies outside the archive"), "{text}");
    assert!(System::open(files.join("SystemStructure.ssd")).is_ok());
}

#[test]
fn what_is_wrong_with_a_description_has_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let ssd = folder.path().join("wrong.ssd");
    fs::write(&ssd, NESTED).unwrap();
    // Both components want the file.
    let text = System::open(&ssd).unwrap_err().to_string();
    for (name, opening) in [("one", "<ssd:Component name=\"one\""), ("two", "<ssd:Component name=\"two\"")] {
        let line = 1 + NESTED.lines().position(|line| line.contains(opening)).unwrap();
        let expected = format!("{}:{line}: component `{name}`: there is no file", ssd.display());
        assert!(text.contains(&expected) && text.contains("swayless build"), "{text}");
    }
    fs::write(&ssd, NESTED.replace("endElement=\"one\"", "endElement=\"won\"")).unwrap();
    let text = System::open(&ssd).unwrap_err().to_string();
    let line = 1 + NESTED.lines().position(|line| line.contains("endElement=\"one\"")).unwrap();
    assert!(text.contains(&format!("line {line}: ")) && text.contains("`won`"), "{text}");
    fs::write(&ssd, &NESTED[..NESTED.len() - 20]).unwrap();
    assert!(matches!(System::open(&ssd), Err(Error::InvalidDescription { .. })));
    assert!(matches!(System::open("no/such.ssd"), Err(Error::FileNotFound { .. })));
    assert!(matches!(System::open("no/such.fmu"), Err(Error::FileNotFound { .. })));
}

/// A component with values from a file.
const BOUND: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription name="bound" version="1.0"
    xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"
    xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription">
  <ssd:System name="root">
    <ssd:Elements>
      <ssd:Component name="one" source="one.fmu">
        <ssd:ParameterBindings><ssd:ParameterBinding source="values.ssv"/></ssd:ParameterBindings>
      </ssd:Component>
    </ssd:Elements>
  </ssd:System>
</ssd:SystemStructureDescription>
"#;

#[test]
fn values_from_a_file_are_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let (ssd, ssv) = (folder.path().join("bound.ssd"), folder.path().join("values.ssv"));
    pack(&foreign(FmiVersion::V3), &folder.path().join("one.fmu"));
    fs::write(&ssd, BOUND).unwrap();
    let text = System::open(&ssd).unwrap_err().to_string();
    let expected = format!("{}:8: parameter set: there is no file {}", ssd.display(), ssv.display());
    assert!(text.starts_with(&expected) && !text.contains("swayless build"), "{text}");

    let place = |line: u32| format!("{}:{line}: ", ssv.canonicalize().unwrap().display());
    let refused = |parameter: &str| {
        let set = format!(
            "<ssv:ParameterSet name=\"set\" version=\"1.0\"\n  \
             xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\">\n<ssv:Parameters>\n\
             {parameter}\n</ssv:Parameters></ssv:ParameterSet>\n"
        );
        fs::write(&ssv, set).unwrap();
        let system = System::open(&ssd).unwrap();
        simulate(&system, &Options::default(), &mut ()).unwrap_err().to_string()
    };
    let text = refused(r#"<ssv:Parameter name="rate"><ssv:String value="fast"/></ssv:Parameter>"#);
    assert_eq!(text, format!("{}start value one.rate = fast: `fast` is not a number", place(4)));
    let text = refused(r#"<ssv:Parameter name="x_start"><ssv:Real value="-1"/></ssv:Parameter>"#);
    assert!(text.starts_with(&format!("{}one.x_start = -1.0 was refused by the FMU", place(4))), "{text}");
    let text = refused(r#"<ssv:Parameter name="x_strat"><ssv:Real value="1"/></ssv:Parameter>"#);
    assert!(text.starts_with(&format!("{}`one`", place(4))) && text.contains("`x_start`?"), "{text}");
}
