//! The importer against FMUs that are not ours: compiled from C, with the oddities that foreign FMUs have.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, its helpers too")]

mod common;

use common::foreign;
use swayless::slave::{Experiment, Model, Slave, Status, Step};
use swayless::{Error, Fmu};
use swayless_modeldesc::types::{DataType, FmiVersion};

const EXPERIMENT: Experiment = Experiment { start_time: 0.0, stop_time: 10.0, tolerance: None };
const BOTH: [FmiVersion; 2] = [FmiVersion::V2, FmiVersion::V3];

fn stepping(version: FmiVersion) -> Box<dyn Slave> {
    let mut slave = Fmu::open(foreign(version)).unwrap().instantiate("it", false).unwrap();
    slave.enter_initialization_mode(&EXPERIMENT).unwrap();
    slave.exit_initialization_mode().unwrap();
    slave
}

fn counter_type(version: FmiVersion) -> DataType {
    if version == FmiVersion::V2 { DataType::Int32 } else { DataType::Int8 }
}

#[test]
fn values_of_all_types_go_in_and_out() {
    for version in BOTH {
        let mut slave = stepping(version);
        slave.set_float(DataType::Float64, &[0], &[2.0]).unwrap();
        assert_eq!(slave.do_step(0.0, 0.5).unwrap(), Step::Completed);
        let mut values = [0.0; 2];
        slave.get_float(DataType::Float64, &[1, 2], &mut values).unwrap();
        assert_eq!(values, [1.0, 4.0]);
        let mut counter = [0];
        slave.get_integer(counter_type(version), &[4], &mut counter).unwrap();
        assert_eq!(counter, [1]);
        slave.set_integer(counter_type(version), &[4], &[-3]).unwrap();
        slave.get_integer(counter_type(version), &[4], &mut counter).unwrap();
        assert_eq!(counter, [-3]);
        let mut moving = [false];
        slave.get_boolean(&[5], &mut moving).unwrap();
        assert_eq!(moving, [true]);
        slave.set_string(&[6], &["Überlast".to_owned()]).unwrap();
        let mut label = [String::new()];
        slave.get_string(&[6], &mut label).unwrap();
        assert_eq!(label, ["Überlast"]);
        slave.terminate().unwrap();
        slave.reset().unwrap();
        slave.enter_initialization_mode(&EXPERIMENT).unwrap();
        slave.get_float(DataType::Float64, &[1], &mut values[..1]).unwrap();
        assert_eq!(values[0], 0.0);
    }
}

#[test]
fn arrays_travel_whole() {
    let mut slave = stepping(FmiVersion::V3);
    slave.set_float(DataType::Float64, &[7, 0], &[4.0, 5.0, 6.0, 2.0]).unwrap();
    slave.do_step(0.0, 0.5).unwrap();
    let mut values = [0.0; 4];
    slave.get_float(DataType::Float64, &[8, 1], &mut values).unwrap();
    assert_eq!(values, [4.0, 5.0, 6.0, 1.0]);
}

#[test]
fn slices_that_do_not_fit_never_reach_the_fmu() {
    for version in BOTH {
        let mut slave = stepping(version);
        let failure = slave.get_float(DataType::Float64, &[0, 1, 2], &mut [0.0]).unwrap_err();
        assert_eq!(failure.status, Status::NotCalled);
        let failure = slave.set_integer(counter_type(version), &[4], &[1 << 40]).unwrap_err();
        assert!(failure.messages[0].text.contains("1099511627776 does not fit"), "{failure:?}");
        let failure = slave.set_string(&[6], &["a\0b".to_owned()]).unwrap_err();
        assert!(failure.messages[0].text.contains("NUL"), "{failure:?}");
        let failure = slave.get_float(DataType::Int32, &[1], &mut [0.0]).unwrap_err();
        assert_eq!(failure.status, Status::NotCalled);
        assert_eq!(slave.do_step(0.0, 0.5).unwrap(), Step::Completed, "the instance is as it was");
    }
    let failure = stepping(FmiVersion::V2).get_float(DataType::Float64, &[1], &mut [0.0; 2]).unwrap_err();
    assert_eq!(failure.status, Status::NotCalled);
}

#[test]
fn a_wrong_token_is_an_error_with_what_the_fmu_logged() {
    for version in BOTH {
        let folder = tempfile::tempdir().unwrap();
        copy(&foreign(version), folder.path());
        let file = folder.path().join("modelDescription.xml");
        let xml = std::fs::read_to_string(&file).unwrap().replace("{foreign}", "{other}");
        std::fs::write(&file, xml).unwrap();
        let error = Fmu::open(folder.path()).unwrap().instantiate("it", false).err().unwrap();
        assert!(matches!(error, Error::Instantiate { .. }));
        let text = error.to_string();
        let said = if version == FmiVersion::V2 { "wrong token {other}, 42 of 2.50" } else { "wrong token" };
        assert!(text.contains(said) && text.contains("`it`"), "{text}");
    }
}

#[test]
fn calls_out_of_order_are_refused_before_the_fmu_sees_them() {
    for version in BOTH {
        let mut slave = Fmu::open(foreign(version)).unwrap().instantiate("it", false).unwrap();
        assert!(slave.do_step(0.0, 0.1).unwrap_err().messages[0].text.contains("only instantiated"));
        slave.enter_initialization_mode(&EXPERIMENT).unwrap();
        assert!(slave.enter_initialization_mode(&EXPERIMENT).is_err());
        assert!(slave.do_step(0.0, 0.1).is_err());
        slave.exit_initialization_mode().unwrap();
        slave.terminate().unwrap();
        let failure = slave.do_step(0.0, 0.1).unwrap_err();
        assert_eq!(failure.status, Status::NotCalled);
        assert!(failure.messages[0].text.contains("terminated"), "{failure:?}");
        let mut x = [1.0];
        slave.get_float(DataType::Float64, &[1], &mut x).unwrap();
        assert_eq!(x, [0.0], "values can still be got");
    }
}

#[test]
fn steps_fail_with_the_fmus_own_words() {
    for version in BOTH {
        let mut slave = stepping(version);
        slave.set_float(DataType::Float64, &[0], &[f64::NAN]).unwrap();
        let failure = slave.do_step(0.0, 0.5).unwrap_err();
        assert_eq!(failure.status, Status::Discard);
        assert_eq!(failure.last_successful_time, Some(0.0));
        assert!(failure.messages[0].text.starts_with("rate is n"), "{failure:?}");

        let mut slave = stepping(version);
        slave.set_float(DataType::Float64, &[0], &[-1e7]).unwrap();
        assert_eq!(slave.do_step(0.0, 0.5).unwrap_err().status, Status::Error);
        assert!(slave.get_float(DataType::Float64, &[1], &mut [0.0]).is_err());

        let mut slave = stepping(version);
        slave.set_float(DataType::Float64, &[0], &[1e4]).unwrap();
        assert_eq!(slave.do_step(0.0, 0.5).unwrap(), Step::Terminated(0.5));
        slave.terminate().unwrap();
    }
}

#[test]
fn a_discarded_step_can_be_tried_again() {
    for version in BOTH {
        let mut slave = stepping(version);
        slave.set_float(DataType::Float64, &[0], &[2.0]).unwrap();
        slave.do_step(0.0, 0.5).unwrap();
        slave.set_float(DataType::Float64, &[0], &[f64::NAN]).unwrap();
        let failure = slave.do_step(0.5, 0.5).unwrap_err();
        assert_eq!((failure.status, failure.last_successful_time), (Status::Discard, Some(0.5)));
        slave.set_float(DataType::Float64, &[0], &[4.0]).unwrap();
        assert_eq!(slave.do_step(0.5, 0.25).unwrap(), Step::Completed);
        let mut x = [0.0];
        slave.get_float(DataType::Float64, &[1], &mut x).unwrap();
        assert_eq!(x, [2.0], "2 m/s for 0.5 s, then 4 m/s for 0.25 s");
    }
}

#[test]
fn clocks_that_nobody_ticks_are_told_before_instantiation() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ForeignClocked.fmu");
    copy(&foreign(FmiVersion::V3), &path);
    let file = path.join("modelDescription.xml");
    let xml = std::fs::read_to_string(&file).unwrap();
    let with = |causality: &str, interval: &str| {
        let clock = format!("<Clock name=\"tick\" valueReference=\"77\" causality=\"{causality}\" {interval}/>");
        let output = if causality == "output" { "<Output valueReference=\"77\" dependencies=\"\"/>" } else { "" };
        let xml = xml.replace("</ModelVariables>", &format!("{clock}</ModelVariables>"));
        std::fs::write(&file, xml.replace("<ModelStructure>", &format!("<ModelStructure>{output}"))).unwrap();
        Fmu::open(&path).unwrap()
    };
    let clocked = with("input", "intervalVariability=\"constant\" intervalDecimal=\"0.1\"");
    let text = clocked.instantiate("it", false).err().unwrap().to_string();
    assert!(text.contains("leaves its clocks to the importer (`tick`)") && text.ends_with("ticks none"), "{text}");
    std::fs::write(folder.path().join("Foreign.fmu"), "").unwrap();
    let mut system = swayless::System::new("clocks");
    system.add_model("it", std::sync::Arc::new(clocked));
    let text = system.check().unwrap_err().to_string();
    assert!(text.contains("Foreign.fmu ticks them itself"), "{text}");
    // A clock that the FMU ticks harms nobody.
    let ticking = with("output", "intervalVariability=\"triggered\"");
    assert!(ticking.instantiate("it", false).is_ok());
}

#[test]
fn messages_are_collected_and_paths_are_what_the_standard_says() {
    for (version, scheme) in [(FmiVersion::V2, "file:///"), (FmiVersion::V3, "/")] {
        let fmu = Fmu::open(foreign(version)).unwrap();
        let messages = fmu.instantiate("it", true).unwrap().take_messages();
        let text = messages[0].text.strip_prefix("resources: ").unwrap_or(&messages[0].text).to_owned();
        assert_eq!((messages.len(), messages[0].category.as_str()), (1, "logAll"));
        assert!(text.starts_with(scheme), "{text}");
        match version {
            FmiVersion::V2 => assert!(text.is_ascii() && text.contains("%7B%C3%BC%7D%20"), "{text}"),
            FmiVersion::V3 => assert!(text.ends_with("/resources/") && text.contains("{ü} "), "{text}"),
        }
    }
}

#[test]
fn what_an_fmu_lacks_is_named() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(Fmu::open(folder.path()).err().unwrap(), Error::NoDescription { .. }));

    copy(&foreign(FmiVersion::V3), folder.path());
    let binaries = folder.path().join("binaries");
    let here = binaries.join(&swayless::importer::platform_folders(FmiVersion::V3)[0]);
    std::fs::rename(&here, binaries.join("pdp11-unix")).unwrap();
    let instantiate = || Fmu::open(folder.path()).unwrap().instantiate("it", false).err().unwrap();
    let text = instantiate().to_string();
    assert!(text.contains("it has pdp11-unix/foreign."), "{text}");

    std::fs::create_dir(&here).unwrap();
    let library = here.join(format!("foreign.{}", std::env::consts::DLL_EXTENSION));
    std::fs::write(&library, "no library").unwrap();
    assert!(matches!(instantiate(), Error::Load { .. }));

    let other = foreign(FmiVersion::V2).join("binaries");
    let other = other.join(&swayless::importer::platform_folders(FmiVersion::V2)[0]);
    std::fs::copy(other.join(library.file_name().unwrap()), &library).unwrap();
    let text = instantiate().to_string();
    assert!(text.contains("does not export fmi3InstantiateCoSimulation"), "{text}");

    let file = folder.path().join("modelDescription.xml");
    let xml = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, xml.replace("=\"foreign\"", "=\"../foreign\"")).unwrap();
    assert!(instantiate().to_string().contains("not a C identifier"));
    std::fs::write(&file, xml.replace("CoSimulation", "ModelExchange")).unwrap();
    let error = Fmu::open(folder.path()).and_then(|fmu| fmu.instantiate("it", false)).err().unwrap();
    assert!(matches!(error, Error::NoCoSimulation { .. } | Error::InvalidDescription { .. }), "{error}");
    std::fs::write(&file, &xml[..xml.len() / 2]).unwrap();
    assert!(matches!(Fmu::open(folder.path()).err().unwrap(), Error::InvalidDescription { .. }));
}

#[test]
fn an_fmu_that_allows_one_instance_gets_one() {
    let folder = tempfile::tempdir().unwrap();
    copy(&foreign(FmiVersion::V3), folder.path());
    let file = folder.path().join("modelDescription.xml");
    let xml = std::fs::read_to_string(&file).unwrap();
    let flag = "canBeInstantiatedOnlyOncePerProcess=\"true\" modelIdentifier";
    std::fs::write(&file, xml.replace("modelIdentifier", flag)).unwrap();
    let fmu = Fmu::open(folder.path()).unwrap();
    let first = fmu.instantiate("first", false).unwrap();
    assert!(matches!(fmu.instantiate("second", false).err().unwrap(), Error::OnlyOnce { .. }));
    drop(first);
    assert!(fmu.instantiate("third", false).is_ok());
}

fn copy(from: &std::path::Path, to: &std::path::Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &to.join(entry.file_name()));
        } else {
            std::fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
        }
    }
}
