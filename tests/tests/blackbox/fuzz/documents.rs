//! Model descriptions and system descriptions that somebody has broken: read to the end or refused, in useful time.

use std::path::Path;
use std::time::{Duration, Instant};

use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{TestCaseError, TestRunner};
use swayless_modeldesc::check::read_and_check;
use swayless_modeldesc::ssp;
use swayless_modeldesc::write::write;

use super::{config, subjects};
use crate::packaged;

/// How many documents are made of each.
const CASES: u32 = 100;

/// What stands where a document wants a name, a number or a list.
const NASTY: [&str; 16] = [
    "",
    " ",
    "0",
    "-1",
    "1e999",
    "NaN",
    "99999999999999999999999999",
    "18446744073709551615",
    "4294967295",
    "1 2 3 4 5 6 7 8 9",
    "true",
    "&lt;",
    "&#0;",
    "&#x10ffff;",
    "\u{feff}",
    "../../../../etc/passwd",
];

/// The model descriptions of all FMUs and the systems of the examples.
fn documents() -> Vec<(String, String)> {
    let read = |path: &Path| (path.display().to_string(), std::fs::read_to_string(path).expect("a text"));
    let mut found: Vec<_> =
        subjects().iter().map(|subject| read(&subject.fmu().folder().join("modelDescription.xml"))).collect();
    let mut folders = vec![packaged::repository().join("examples")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "ssd" || e == "ssv" || e == "ssm") {
                found.push(read(&path));
            }
        }
    }
    assert!(found.iter().any(|(path, _)| path.ends_with("ssd")));
    found
}

/// Where elements begin.
fn elements(text: &str) -> Vec<usize> {
    text.match_indices('<').map(|(at, _)| at).collect()
}

/// Changes values, elements and depths, so that most documents stay well-formed and their meaning breaks.
fn broken(mut text: String, changes: &[(u8, Index, Index)]) -> String {
    for (kind, place, what) in changes {
        let starts = elements(&text);
        let Some(&at) = (!starts.is_empty()).then(|| place.get(&starts)) else { return text };
        let end = text[at..].find('>').map_or(text.len(), |end| at + end + 1);
        match kind % 8 {
            // The value of one of its attributes.
            0..=3 => {
                let values: Vec<usize> = text[at..end].match_indices("=\"").map(|(value, _)| at + value + 2).collect();
                if let Some(value) = (!values.is_empty()).then(|| *what.get(&values)) {
                    let quote = text[value..].find('"').map_or(text.len(), |quote| value + quote);
                    text.replace_range(value..quote, NASTY[what.index(NASTY.len())]);
                }
            }
            // The element once more, somewhere else.
            4 => {
                let element = text[at..end].to_owned();
                text.insert_str(*what.get(&starts), &element);
            }
            5 => text.replace_range(at..end, ""),
            // Deep or wide.
            6 => text.insert_str(at, &"<a>".repeat(what.index(3000))),
            _ => text.insert_str(at, &"<a b=\"c\"/>".repeat(what.index(3000))),
        }
    }
    text
}

#[test]
fn broken_documents_are_read_or_refused_in_useful_time() {
    for (path, document) in documents() {
        let changes = prop::collection::vec(any::<(u8, Index, Index)>(), 1..6);
        let outcome = TestRunner::new(config(CASES)).run(&changes, |changes| {
            let text = broken(document.clone(), &changes);
            let begin = Instant::now();
            if let Ok((description, _)) = read_and_check(text.as_bytes()) {
                let _ = write(&description);
            }
            if let Ok((system, _)) = ssp::read_system(&text) {
                ssp::check(&system);
                let _ = ssp::write_system(&system);
            }
            let _ = ssp::read_parameters(&text);
            let _ = ssp::read_mapping(&text);
            let took = begin.elapsed();
            if took > Duration::from_secs(30) {
                return Err(TestCaseError::fail(format!("{} bytes took {took:?}", text.len())));
            }
            Ok(())
        });
        outcome.unwrap_or_else(|failure| panic!("{path}: {failure}"));
    }
}
