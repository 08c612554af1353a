//! Serialized states that somebody has tampered with, the checksum set right: refused, or an instance that lives on.

use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{TestCaseError, TestRunner};
use swayless_modeldesc::types::Start;

use super::call::{Call, Experiment};
use super::library::{Kind, Subject};
use super::player::Player;
use super::{config, subjects};

/// How many states are forged for each way to make an instance of each FMU.
const CASES: u32 = 300;

/// The length of the checksum, FNV-1a of 128 bits over all that follows it.
const CHECKSUM: usize = 16;

fn checksum(bytes: &[u8]) -> [u8; CHECKSUM] {
    const BASIS: u128 = 144_066_263_297_769_815_596_495_629_667_062_367_629;
    const PRIME: u128 = 309_485_009_821_345_068_724_781_371;
    bytes.iter().fold(BASIS, |hash, byte| (hash ^ u128::from(*byte)).wrapping_mul(PRIME)).to_le_bytes()
}

/// A state in the middle of a run.
fn under_way(subject: &Subject, kind: Kind) -> (Vec<u8>, f64) {
    let mut host = subject.instantiate(kind, true);
    let experiment = Experiment { tolerance: None, start: 0.0, stop: None };
    let mut calls = vec![Call::EnterInitialization(experiment), Call::ExitInitialization];
    match kind {
        Kind::ModelExchange => calls.extend([Call::Update, Call::EnterContinuousTime]),
        Kind::EventMode { .. } => calls.extend([Call::Update, Call::EnterStep, Call::DoStep { time: 0.0, size: 0.1 }]),
        Kind::CoSimulation => calls.push(Call::DoStep { time: 0.0, size: 0.1 }),
        Kind::ScheduledExecution => calls.push(Call::Activate(subject.input_clock(), 0.1)),
    }
    for call in calls {
        assert_eq!(host.play(&call).expect("a function").status, 0, "{call:?}");
    }
    (host.serialized().expect("a state"), if kind == Kind::ModelExchange { 0.0 } else { 0.1 })
}

/// Where start values stand among the values.
fn starts(subject: &Subject, values: &[u8]) -> Vec<usize> {
    let mut found = Vec::new();
    for variable in &subject.description.variables {
        let Some(Start::Float(start)) = &variable.start else { continue };
        for number in start.iter().filter(|number| **number != 0.0) {
            let bytes = number.to_le_bytes();
            found.extend((0..values.len()).filter(|at| values[*at..].starts_with(&bytes)));
        }
    }
    found
}

/// Where the values begin: behind a line of text, a token and the checksum.
fn values_at(subject: &Subject, state: &[u8]) -> usize {
    let line = state.iter().position(|byte| *byte == b'\n').expect("a line") + 1;
    let at = line + subject.description.instantiation_token.len() + CHECKSUM;
    assert_eq!(state[at - CHECKSUM..at], checksum(&state[at..]), "the checksum is made as it is written here");
    at
}

/// Parts of numbers and lengths that decoders stumble over.
const NASTY: [&[u8]; 10] = [
    &[0],
    &[1],
    &[0x7f],
    &[0xff],
    &[0x80, 0x80, 0x80, 0x80, 0x08],
    &[0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01],
    // Not a number, −∞, −1 and 10³⁰⁰.
    &[0, 0, 0, 0, 0, 0, 0xf8, 0x7f],
    &[0, 0, 0, 0, 0, 0, 0xf0, 0xff],
    &[0, 0, 0, 0, 0, 0, 0xf0, 0xbf],
    &[0x9c, 0x75, 0, 0x88, 0x3c, 0xe4, 0x37, 0x7e],
];

/// Numbers that a run would not have begun with.
const ODD: [f64; 8] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -1e-9, 1e300, 0.0, 5e-324];

/// Changes numbers only, so that the state can be read, or anything.
fn forge(values: &mut Vec<u8>, starts: &[usize], numbers: bool, changes: &[(u8, Index, Index)]) {
    if numbers && !starts.is_empty() {
        for (_, place, what) in changes {
            let at = *place.get(starts);
            values[at..at + 8].copy_from_slice(&ODD[what.index(ODD.len())].to_le_bytes());
        }
        return;
    }
    for (kind, place, what) in changes {
        if values.is_empty() {
            return;
        }
        let (at, nasty) = (place.index(values.len()), NASTY[what.index(NASTY.len())]);
        let end = (at + nasty.len()).min(values.len());
        match kind % 8 {
            0 => values.truncate(at),
            1 => values[at] ^= 1 << what.index(8),
            2 => drop(values.splice(at..at, nasty.iter().copied())),
            3 => drop(values.splice(at..end, [])),
            // Most often of the same length, so that what follows keeps its meaning.
            _ => drop(values.splice(at..end, nasty.iter().copied())),
        }
    }
}

#[test]
fn a_forged_state_is_refused_or_lived_with() {
    let mut failures = Vec::new();
    for subject in subjects() {
        for kind in subject.kinds() {
            let (state, time) = under_way(subject, kind);
            let at = values_at(subject, &state);
            let starts = starts(subject, &state[at..]);
            let forgery = prop::collection::vec(any::<(u8, Index, Index)>(), 1..4);
            let then = prop::collection::vec(prop::collection::vec(any::<u8>(), 0..48), 0..10);
            let outcome =
                TestRunner::new(config(CASES)).run(&(any::<bool>(), forgery, then), |(numbers, forgery, then)| {
                    let mut values = state[at..].to_vec();
                    forge(&mut values, &starts, numbers, &forgery);
                    let mut forged = state[..at - CHECKSUM].to_vec();
                    forged.extend(checksum(&values));
                    forged.extend(values);
                    let mut player = Player::new(subject, kind, false);
                    let outcome =
                        player.start_from(forged, time).and_then(|()| then.iter().try_for_each(|raw| player.step(raw)));
                    outcome.map_err(|why| TestCaseError::fail(format!("{why}\n{}", player.trace())))
                });
            if let Err(failure) = outcome {
                let text = failure.to_string();
                failures.push(text.split("minimal failing input").next().unwrap_or(&text).to_owned());
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}
