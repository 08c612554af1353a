//! Memory: a part of the plays once more under valgrind, which sees every read and write beside what was given, every use
//! of what was never set, and every leak, on both sides of the C boundary.

use std::process::Command;
use std::time::Instant;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use swayless::Fmu;
use swayless::slave::{Experiment as Run, Model};
use swayless_modeldesc::types::{Causality, DataType};

use super::call::{Access, Call, Experiment, Values};
use super::library::{Kind, Subject};
use super::player::Player;
use super::{callbacks, config, subjects};
use crate::packaged;

/// How many sequences are played on each way to make an instance of each FMU.
const CASES: u32 = 10;

/// What the test program is told when it runs under valgrind: the archives, so that it need not build them.
pub const ARCHIVES: &str = "SWAYLESS_FUZZ_ARCHIVES";

/// Without valgrind this is a test like others; with it, it is what valgrind looks at.
#[test]
fn plays_to_be_watched() {
    for subject in subjects() {
        for kind in subject.kinds() {
            let sequence = prop::collection::vec(prop::collection::vec(any::<u8>(), 0..48), 1..30);
            let outcome = TestRunner::new(config(CASES)).run(&(any::<bool>(), sequence), |(bare, sequence)| {
                let mut player = Player::new(subject, kind, bare);
                for raw in sequence {
                    player.step(&raw).map_err(|why| TestCaseError::fail(format!("{why}\n{}", player.trace())))?;
                }
                Ok(())
            });
            outcome.unwrap_or_else(|failure| panic!("{failure}"));
            panic_everywhere(subject, kind);
        }
        callbacks::play(subject);
        // The harness uses no Event Mode, which clocks need.
        if subject.kinds().contains(&Kind::CoSimulation) {
            by_the_harness(subject.fmu());
        }
    }
}

/// Gives every text parameter of an FMU every word of its documentation: among them are the places where the FMU made
/// to panic does so. Saved states are left out: after a panic nothing may be called to free them.
fn panic_everywhere(subject: &Subject, kind: Kind) {
    let texts = subject.description.variables.iter();
    for text in texts.filter(|v| v.data_type == DataType::String && v.causality == Causality::Parameter) {
        let words = text.description.as_deref().unwrap_or_default().split(|c: char| !c.is_alphabetic());
        for word in words.filter(|word| !word.is_empty()) {
            let references = vec![text.value_reference];
            let access = Access { data_type: DataType::String, references, count: 1, null: false };
            let mut host = subject.instantiate(kind, false);
            host.play(&Call::Set(access, Values::Texts(vec![Some(word.to_owned())])));
            let calls = [
                Call::EnterInitialization(Experiment { tolerance: None, start: 0.0, stop: None }),
                Call::ExitInitialization,
                Call::Update,
                Call::EnterContinuousTime,
                Call::GetDerivatives(subject.description.structure.derivatives.len()),
                Call::GetIndicators(subject.description.number_of_event_indicators),
                Call::EnterStep,
                Call::DoStep { time: 0.0, size: 0.1 },
                Call::Reset,
            ];
            calls.iter().for_each(|call| drop(host.play(call)));
        }
    }
}

/// A run by the harness's own loader, with its loggers.
fn by_the_harness(fmu: &Fmu) {
    let mut slave = fmu.instantiate("watched", true).unwrap_or_else(|error| panic!("{error}"));
    let floats: Vec<u32> = fmu
        .description()
        .variables
        .iter()
        .filter(|v| v.data_type == DataType::Float64 && v.dimensions.is_empty())
        .map(|v| v.value_reference)
        .collect();
    let mut values = vec![0.0; floats.len()];
    slave.enter_initialization_mode(&Run { start_time: 0.0, stop_time: 1.0, tolerance: None }).expect("initialization");
    slave.exit_initialization_mode().expect("initialization");
    for k in 0..5 {
        slave.do_step(f64::from(k) * 0.25, 0.25).expect("a step");
        slave.get_float(DataType::Float64, &floats, &mut values).expect("values");
    }
    assert!(slave.do_step(99.0, 0.25).is_err());
    slave.reset().expect("a reset");
    assert!(slave.get_float(DataType::Float64, &[u32::MAX], &mut [0.0]).is_err());
    slave.take_messages();
}

#[test]
fn valgrind_finds_nothing() {
    if !Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success()) {
        let asked = std::env::var_os("CI").is_some();
        assert!(!asked, "valgrind is not installed, but CI is set: memory must be checked there");
        eprintln!("SKIPPED: valgrind is not installed, so that memory is not checked");
        return;
    }
    let archives = std::env::join_paths(packaged::paths()).expect("paths without a separator in them");
    let program = std::env::current_exe().expect("the test program");
    let begin = Instant::now();
    let output = Command::new("valgrind")
        .args(["--error-exitcode=99", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect"])
        // Libraries stay, so that their frames have names.
        .args(["--keep-debuginfo=yes", "--num-callers=30", "--quiet"])
        .arg(program)
        .args(["--exact", "fuzz::memory::plays_to_be_watched", "--test-threads=1", "--nocapture"])
        .env(ARCHIVES, archives)
        .output()
        .expect("valgrind starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{}\n{stdout}\n{stderr}", output.status);
    assert!(stdout.contains("1 passed"), "{stdout}\n{stderr}");
    println!("valgrind took {:?}", begin.elapsed());
}
