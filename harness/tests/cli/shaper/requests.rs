//! Odd and impossible requests, and readers that go away.

use serde_json::Value;

use super::{number, shapers};
use crate::{WRONG_USAGE, exits, swayless};

/// Whoever reads the table may close the pipe before its end: the files are there all the same, and nothing panics.
#[test]
fn closed_pipes_lose_no_files() {
    let folder = tempfile::tempdir().unwrap();
    let set = folder.path().join("shaper.ssv");
    let start = |arguments: &[&str]| {
        std::process::Command::new(env!("CARGO_BIN_EXE_swayless"))
            .args(arguments)
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .expect("the command starts")
    };
    let mut deaf = start(&["shaper", "--hertz", "1", "--kind", "ZV", "--ssv", set.to_str().unwrap()]);
    drop((deaf.stdout.take(), deaf.stderr.take()));
    assert_eq!(deaf.wait().unwrap().code(), Some(0));
    assert!(std::fs::read_to_string(&set).unwrap().contains("\"ZV\""));
    let mut deaf = start(&["shaper", "--hertz", "0"]);
    drop((deaf.stdout.take(), deaf.stderr.take()));
    assert_eq!(deaf.wait().unwrap().code(), Some(WRONG_USAGE));
}

#[test]
fn refusals_name_the_option_the_value_and_the_remedy() {
    let cases: [(&[&str], &[&str]); 19] = [
        (&[], &["--length", "--frequency", "--hertz"]),
        (&["--length", "0"], &["`--length 0`", "greater than 0 (m)"]),
        (&["--length", "1", "--hertz", "1"], &["--length", "--hertz"]),
        (&["--length", "1", "--rigging-length", "1"], &["--mass-ratio"]),
        (&["--hertz", "1", "--hertz", "2", "--hertz", "3"], &["`--hertz` is given 3 times", "one mode or two"]),
        (&["--hertz", "1", "--damping", "1"], &["`--damping 1`", "at most 0.99"]),
        (&["--hertz", "1", "--damping", "0", "--damping", "0"], &["`--damping` is given 2 times", "one for each"]),
        (&["--hertz", "1", "--range", "2..1"], &["`--range 2..1`", "the lower end first"]),
        (&["--hertz", "1", "--range", "0.5..0.9"], &["`--range 0.5..0.9`", "the mode's frequency itself"]),
        (&["--length", "10", "--range", "12..15"], &["`--range 12..15`", "the length itself"]),
        (&["--hertz", "1", "--gravity", "3"], &["--gravity", "--hertz"]),
        (&["--hertz", "1", "--rigging-length", "3", "--mass-ratio", "1"], &["--rigging-length", "--hertz"]),
        (&["--hertz", "1", "--range", "0.9..50"], &["`--range 0.9..50`", "bring it nearer"]),
        (&["--hertz", "1", "--hertz", "2", "--range", "1..2"], &["`--range` is given 1 time(s)", "2 time(s)"]),
        (&["--hertz", "1", "--vibration-limit", "5"], &["`--vibration-limit 5`", "0.05 is 5 %"]),
        (&["--hertz", "1", "--insensitivity", "1.6"], &["`--insensitivity 1.6`", "at most 1.5"]),
        (&["--hertz", "1", "--range", "0.2..2"], &["`--range 0.2..2`", "narrow it"]),
        (&["--hertz", "1", "--kind", "ZVV"], &["--kind", "ZVV", "ZVD"]),
        (&["--hertz", "1", "--plot", "curves.pdf"], &["`--plot curves.pdf`", ".svg", ".html"]),
    ];
    for (arguments, words) in cases {
        let (stdout, message) = exits(&[&["shaper"], arguments].concat(), WRONG_USAGE);
        assert!(words.iter().all(|word| message.contains(word)), "{words:?} are not in\n{message}");
        assert_eq!(stdout, "");
    }
    // all that is wrong at once
    let (_, message) = exits(&["shaper", "--hertz", "-1", "--damping", "2", "--level", "NaN"], WRONG_USAGE);
    assert!(["`--hertz -1`", "`--damping 2`", "`--level NaN`"].iter().all(|part| message.contains(part)), "{message}");
    // and each thing once
    for arguments in [["--hertz", "1", "--range", "0..2"], ["--hertz", "1", "--vibration-limit", "5"]] {
        let (_, message) = exits(&[&["shaper"], &arguments[..]].concat(), WRONG_USAGE);
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    // what is asked for is right, but there is no such shaper
    let (stdout, message) = exits(&["shaper", "--hertz", "1", "--kind", "EI", "--damping", "0.9"], WRONG_USAGE);
    assert!(stdout.contains("no EI shaper") && stdout.contains("(`--damping`)"), "{stdout}");
    assert!(!stdout.contains("Insensitivity"), "a table of nothing: {stdout}");
    assert!(message.contains("there is no shaper to recommend"), "{message}");
}

/// Whatever the numbers, the answer is sound or names the option.
#[test]
fn odd_values_are_answered_or_refused_by_name() {
    let hertz = &["--hertz", "1"][..];
    let cases = [
        ("--length", &[][..]),
        ("--frequency", &[]),
        ("--hertz", &[]),
        ("--gravity", &["--length", "10"]),
        ("--damping", hertz),
        ("--insensitivity", hertz),
        ("--vibration-limit", hertz),
        ("--level", hertz),
        ("--solution", hertz),
        ("--acceleration-limit", &["--hertz", "1", "--velocity-limit", "1"]),
        ("--velocity-limit", &["--hertz", "1", "--acceleration-limit", "1"]),
        ("--braking-time-constant", &["--hertz", "1", "--acceleration-time-constant", "0.1"]),
    ];
    for (option, mode) in cases {
        for value in ["NaN", "inf", "-1", "0", "5e-324", "1e-160", "1e160", "1.7e308", "0.999999999999"] {
            sound(&[&["shaper", "--json", option, value], mode].concat(), option);
        }
    }
    for ends in ["0..1", "NaN..1", "1e-320..1", "0.06..19.9", "1..inf", "1..1", "-1..1"] {
        sound(&["shaper", "--json", "--hertz", "1", "--range", ends], "--range");
    }
}

fn sound(arguments: &[&str], option: &str) {
    let output = swayless(arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    match output.status.code() {
        Some(0) => {
            let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
            for (kind, shaper) in shapers(&answer) {
                assert!(number(shaper, "/delay") >= 0.0, "{arguments:?}: {kind}");
                assert!(number(shaper, "/modes/0/worst/residual") >= 0.0, "{arguments:?}: {kind}");
            }
        }
        code => {
            assert_eq!(code, Some(WRONG_USAGE), "{arguments:?}: {message}");
            // of the drive's limits it names the one that is with the other too little
            assert!(message.contains(option) || message.contains("--acceleration-limit"), "{arguments:?}: {message}");
        }
    }
}

#[test]
fn the_help_names_all_kinds() {
    let (help, _) = exits(&["shaper", "--help"], 0);
    let kinds = help.split_once("Kinds:").unwrap().1.split_once('.').unwrap().0;
    let named: Vec<&str> = kinds.split(',').map(str::trim).collect();
    assert_eq!(named, swayless_shaping::Kind::ALL.map(swayless_shaping::Kind::name));
}
