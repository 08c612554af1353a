//! Sequences of calls in any order with any arguments.

use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};

use super::player::Player;
use super::{config, subjects};

/// How many sequences are played on each way to make an instance of each FMU.
const CASES: u32 = 300;

#[test]
fn any_sequence_of_calls_is_answered_by_the_rules() {
    let mut failures = Vec::new();
    for subject in subjects() {
        for kind in subject.kinds() {
            let sequence = prop::collection::vec(prop::collection::vec(any::<u8>(), 0..64), 1..60);
            let mut runner = TestRunner::new(config(CASES));
            let outcome = runner.run(&(any::<bool>(), sequence), |(bare, sequence)| {
                let mut player = Player::new(subject, kind, bare);
                for raw in sequence {
                    player.step(&raw).map_err(|why| TestCaseError::fail(format!("{why}\n{}", player.trace())))?;
                }
                Ok(())
            });
            if let Err(failure) = outcome {
                // Without the bytes, which say nothing.
                let text = failure.to_string();
                failures.push(text.split("minimal failing input").next().unwrap_or(&text).to_owned());
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}
