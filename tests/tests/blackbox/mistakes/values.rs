//! Values that no FMU can run with, and calls at the wrong time.

use swayless::slave::Status;
use swayless_modeldesc::types::FmiVersion;

use super::{FAILED, WRONG_USAGE, fails, folder, text};
use crate::instance::Instance;
use crate::packaged::{self, VERSIONS};

#[test]
fn all_problems_are_told_at_once() {
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    let values = ["--start-value", "boom.lenght=1", "--start-value", "slew.rte=1", "--start-value", "luff.rate=fast"];
    let arguments = [&["run", text(&crane)], &values[..]].concat();
    fails(&arguments, FAILED, &["boom.lenght", "slew.rte", "luff.rate"]);
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
