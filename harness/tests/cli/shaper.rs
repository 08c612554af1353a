//! `swayless shaper` from outside.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::{WRONG_USAGE, exits, swayless};

fn json(arguments: &[&str]) -> Value {
    let (stdout, _) = exits(&[&["shaper", "--json"], arguments].concat(), 0);
    serde_json::from_str(&stdout).expect("JSON")
}

/// The shapers of an answer by kind.
fn shapers(answer: &Value) -> BTreeMap<&str, &Value> {
    let list = answer["shapers"].as_array().expect("a list");
    list.iter().map(|shaper| (shaper["kind"].as_str().expect("a name"), shaper)).collect()
}

fn number(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer} is no number in {value:#}"))
}

#[track_caller]
fn close(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} within {tolerance:e}");
}

/// Durations in periods and insensitivities at 5 %, undamped, as the literature prints them (Singhose's tables).
const PUBLISHED: [(&str, f64, f64); 10] = [
    ("ZV", 0.5, 0.0637),
    ("ZVD", 1.0, 0.2871),
    ("ZVDD", 1.5, 0.4804),
    ("ZVDDD", 2.0, 0.6271),
    ("EI", 1.0, 0.3995),
    ("TwoHumpEI", 1.5, 0.7245),
    ("ThreeHumpEI", 2.0, 0.9639),
    ("SI", 1.002, 0.4),
    ("UMZV", 0.3333, 0.0551),
    ("UMZVD", 0.7325, 0.2586),
];

#[test]
fn the_published_numbers_come_out() {
    let answer = json(&["--hertz", "0.5"]);
    let shapers = shapers(&answer);
    for (kind, periods, insensitivity) in PUBLISHED {
        let shaper = shapers[kind];
        // to the digits printed; the table of SI has three
        close(0.5 * number(shaper, "/delay"), periods, if kind == "SI" { 5e-4 } else { 5e-5 });
        close(number(shaper, "/modes/0/insensitivity"), insensitivity, 5e-5);
        let impulses = shaper["impulses"].as_array().unwrap();
        close(impulses.iter().map(|impulse| number(impulse, "/amplitude")).sum(), 1.0, 1e-12);
        assert_eq!(impulses.last().map(|impulse| number(impulse, "/time")), Some(number(shaper, "/delay")));
    }
    close(number(&answer, "/modes/0/period"), 2.0, 1e-12);
    assert_eq!(number(shapers["UMZV"], "/gain"), 3.0);
    assert_eq!(shapers["UMZV"]["exceeds_command"], true);
    assert_eq!(shapers["ZV"]["exceeds_command"], false);
}

#[test]
fn the_table_says_what_the_json_says() {
    let arguments = ["--length", "10", "--damping", "0.02", "--range", "7..12"];
    let answer = json(&arguments);
    let (stdout, stderr) = exits(&[&["shaper"], &arguments[..]].concat(), 0);
    assert_eq!(stderr, "");
    for (kind, shaper) in shapers(&answer) {
        let row = stdout.lines().find(|line| line.split_whitespace().next() == Some(kind)).expect("a row");
        let cells: Vec<&str> = row.split_whitespace().filter(|cell| !["s", "%"].contains(cell)).collect();
        let cell = |place: usize| cells[place].parse::<f64>().expect("a number");
        // four significant digits of the delay, three of V, four decimals of the insensitivity
        close(cell(1), number(shaper, "/delay"), 5.1e-4 * number(shaper, "/delay"));
        assert_eq!(cell(3) as usize, shaper["impulses"].as_array().unwrap().len(), "{row}");
        close(0.01 * cell(4), number(shaper, "/modes/0/residual"), 5.1e-3 * number(shaper, "/modes/0/residual") + 1e-9);
        close(0.01 * cell(5), number(shaper, "/modes/0/worst/residual"), 5.1e-3);
        close(cell(6), number(shaper, "/modes/0/insensitivity"), 5.1e-5);
    }
    for refused in answer["refused"].as_array().unwrap() {
        assert!(stdout.contains(refused["reason"].as_str().unwrap()));
    }
    let in_one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(in_one_line(&stdout).contains(&in_one_line(answer["recommendation"]["text"].as_str().unwrap())));
}

#[test]
fn modes_come_from_lengths_frequencies_or_hertz() {
    let of_length = json(&["--length", "10", "--gravity", "10", "--range", "4..40", "--kind", "ZV"]);
    close(number(&of_length, "/modes/0/frequency"), 1.0, 1e-15);
    close(number(&of_length, "/modes/0/range/low"), 0.5, 1e-15);
    close(number(&of_length, "/modes/0/range/high"), (10.0_f64 / 4.0).sqrt(), 1e-15);
    let turn = std::f64::consts::TAU;
    let hertz = json(&["--hertz", "0.5", "--range", "0.4..0.6", "--kind", "ZV"]);
    close(number(&hertz, "/modes/0/range/low"), 0.4 * turn, 1e-12);
    let radians = json(&["--frequency", &format!("{}", 0.5 * turn), "--insensitivity", "0.4", "--kind", "ZV"]);
    close(number(&radians, "/modes/0/range/low"), number(&hertz, "/modes/0/range/low"), 1e-12);
    close(number(&radians, "/shapers/0/delay"), number(&hertz, "/shapers/0/delay"), 1e-12);
    // (6.3) for a hook on 8 m with half its mass on 3 m below it
    let double = json(&[
        "--length",
        "8",
        "--rigging-length",
        "3",
        "--mass-ratio",
        "0.5",
        "--range",
        "6..9",
        "--kind",
        "Convolved",
    ]);
    close(number(&double, "/modes/0/frequency"), 1.0284, 5e-5);
    close(number(&double, "/modes/1/frequency"), 2.3847, 5e-5);
    let hook_alone = json(&["--length", "8", "--rigging-length", "3", "--mass-ratio", "0", "--kind", "ZV"]);
    assert_eq!(hook_alone["modes"], json(&["--length", "8", "--kind", "ZV"])["modes"]);
    let of_9 = json(&["--length", "9", "--rigging-length", "3", "--mass-ratio", "0.5", "--kind", "Convolved"]);
    assert_eq!(number(&double, "/modes/1/range/low"), number(&of_9, "/modes/1/frequency"));
}

#[test]
fn the_worst_of_the_range_is_where_it_is_said_to_be() {
    // V of ZV, undamped: |cos(πω/2ω₀)|, highest at the end that is farther away.
    let answer = json(&["--frequency", "2", "--range", "1.8..2.1", "--kind", "ZV"]);
    let worst = &answer["shapers"][0]["modes"][0]["worst"];
    close(number(worst, "/frequency"), 1.8, 1e-12);
    close(number(worst, "/residual"), (0.25 * std::f64::consts::PI * 1.8).cos(), 1e-12);
}

/// SI within `Convolved` is for the range, as SI alone is.
#[test]
fn convolved_specified_insensitivities_keep_the_limit_over_both_ranges() {
    for insensitivity in ["0.1", "0.6"] {
        let modes = ["--frequency", "1", "--frequency", "4.4", "--insensitivity", insensitivity];
        let answer = json(&[&modes[..], &["--base-kind", "SI", "--kind", "Convolved"]].concat());
        let shaper = &answer["shapers"][0];
        for mode in [0, 1] {
            assert!(number(shaper, &format!("/modes/{mode}/worst/residual")) <= 0.05 + 1e-6);
        }
        close(number(shaper, "/parameters/insensitivity"), insensitivity.parse().unwrap(), 1e-12);
        // no longer than each for itself
        let alone = |frequency: &str| {
            let mode = ["--frequency", frequency, "--insensitivity", insensitivity, "--kind", "SI"];
            number(&json(&mode), "/shapers/0/duration")
        };
        close(number(shaper, "/duration"), alone("1") + alone("4.4"), 1e-9);
    }
    // Beside another kind only that of SI counts, and the other stays at its mode.
    let ranges = ["--frequency", "1", "--frequency", "4.4", "--range", "0.9..1.3", "--range", "4.3..4.7"];
    let mixed = ["--kind", "Convolved", "--base-kind", "ZVD", "--base-kind", "SI"];
    let answer = json(&[&ranges[..], &mixed].concat());
    let parameters = &answer["shapers"][0]["parameters"];
    close(number(parameters, "/mode.frequency[1]"), 1.0, 1e-12);
    close(number(parameters, "/mode.frequency[2]"), 4.5, 1e-12);
    close(number(parameters, "/insensitivity"), 0.4 / 4.5, 1e-9);
}

#[test]
fn the_recommendation_follows_the_limit() {
    let choice = |arguments: &[&str]| {
        let answer = json(arguments);
        let recommendation = &answer["recommendation"];
        let name = |key: &str| recommendation[key].as_str().map(str::to_owned);
        (name("choice").unwrap(), recommendation["holds"] == true, name("runner_up"), name("quicker"), name("quickest"))
    };
    let some = |name: &str| Some(name.to_owned());
    // ±20 % of frequency: SI and EI are a period long, ZV is not nearly enough
    let (best, holds, runner_up, _, quickest) = choice(&["--hertz", "1", "--insensitivity", "0.4"]);
    assert_eq!((best.as_str(), holds, runner_up, quickest), ("SI", true, some("EI"), some("ZV")));
    // without doubt about the frequency the shortest is enough
    assert_eq!(choice(&["--hertz", "1", "--insensitivity", "0.01", "--kind", "ZV", "--kind", "ZVD"]).0, "ZV");
    // a short one with negative impulses is named, not chosen
    let (best, _, _, quicker, _) =
        choice(&["--hertz", "1", "--insensitivity", "0.05", "--kind", "UMZV", "--kind", "ZV", "--kind", "ZVD"]);
    assert_eq!((best.as_str(), quicker), ("ZV", some("UMZV")));
    // a ramp that takes a period leaves nothing by itself
    let drive = ["--acceleration-limit", "1", "--velocity-limit", "1"];
    assert_eq!(choice(&[&["--hertz", "1", "--insensitivity", "0.02"], &drive[..]].concat()).0, "None");
    // nothing holds, and the words say so
    let arguments = ["--hertz", "1", "--insensitivity", "1", "--kind", "ZV", "--kind", "ZVD"];
    let (best, holds, ..) = choice(&arguments);
    assert_eq!((best.as_str(), holds), ("ZVD", false));
    let (stdout, _) = exits(&[&["shaper"], &arguments[..]].concat(), 0);
    assert!(stdout.contains("None of these keeps") && stdout.contains("ZVD comes closest"), "{stdout}");
}

/// Step 0.358 m/s at 0.12 m/s² on a mode of 0.28 Hz (thesis 5.1.3): the commands end after 2.983, 3.277, 4.317, 4.468 and
/// 4.504 s, ALEI's pulses begin at 0, 1.39457 and 3.86947 s, and ZVD leaves 0.0577 m where the bare ramp leaves 0.0383 m.
#[test]
fn behind_an_acceleration_limit_the_published_numbers_come_out() {
    let answer = json(&[
        "--hertz",
        "0.28",
        "--range",
        "0.24..0.32",
        "--acceleration-limit",
        "0.12",
        "--velocity-limit",
        "0.358",
    ]);
    let shapers = shapers(&answer);
    let bare = 0.358 / 0.12;
    for (kind, end) in [("None", 2.983), ("ZV", 3.277), ("ZVD", 4.317), ("ALZVD", 4.468), ("ALEI", 4.504)] {
        close(bare + number(shapers[kind], "/delay"), end, 5.1e-4);
    }
    close(number(shapers["ALEI"], "/impulses/1/time"), 1.39457, 5.1e-6);
    close(number(shapers["ALEI"], "/impulses/2/time"), 3.86947, 5.1e-6);
    let residual = |kind: &str| number(shapers[kind], "/modes/0/residual");
    close(residual("ZVD") / residual("None"), 0.0577 / 0.0383, 0.003);
    assert!(residual("ZV") < 1e-12 && residual("ALZVD") < 1e-12);
    // of what the bare ramp leaves, 5 %
    close(residual("ALEI") / residual("None"), 0.05, 1e-9);
    assert!(number(shapers["ZVD"], "/without_drive/0/residual") < 1e-12);
    let ramps = |kind: &str| shapers[kind]["ramps"].as_str().unwrap();
    assert_eq!(["ZV", "ZVD", "UMZV"].map(ramps), ["exact", "apart", "meet"]);
    assert_eq!(answer["recommendation"]["choice"], "ALZVD");
    assert_eq!(shapers["ALZVD"]["parameters"]["acceleration_limit"], 0.12);
    assert_eq!(shapers["ALZVD"]["adds_up"], false);
}

/// What is said behind a drive is computed in another way than what is said without: with no drive to speak of both are the same.
#[test]
fn a_quick_drive_is_none() {
    let mode = ["--hertz", "0.5", "--damping", "0.03", "--range", "0.4..0.55"];
    let kinds = ["--kind", "ZV", "--kind", "ZVD", "--kind", "EI", "--kind", "SI", "--kind", "UMZV"];
    let limit = ["--acceleration-limit", "1e9", "--velocity-limit", "2"];
    let constants = ["--acceleration-time-constant", "1e-9", "--braking-time-constant", "1e-9"];
    for drive in [limit, constants] {
        let answer = json(&[&mode[..], &kinds, &drive].concat());
        for (kind, shaper) in shapers(&answer) {
            close(number(shaper, "/delay"), number(shaper, "/duration"), 3e-9);
            for name in ["residual", "worst/residual", "insensitivity"] {
                let [with, without] = ["modes", "without_drive"].map(|of| number(shaper, &format!("/{of}/0/{name}")));
                // a few 1e-9 s of up to 3.5 rad/s
                assert!((with - without).abs() < 2e-8, "{kind}, {name}: {with} is not {without}");
            }
        }
    }
}

/// A load on 0.84 m, τ_a = 0.2 s and τ_b = 0.065 s (thesis 5.2.3): for the exact ramps t₂ = 0.37988, t₃ = 0.56917,
/// t₂′ = 0.21579, t₃′ = 0.64926 s.
#[test]
fn behind_unequal_time_constants_umzvc_leaves_nothing() {
    let drive = ["--acceleration-time-constant", "0.2", "--braking-time-constant", "0.065"];
    let answer = json(&[&["--length", "0.84"], &drive[..]].concat());
    let shapers = shapers(&answer);
    let shaper = shapers["UMZVc"];
    for (pointer, time) in [
        ("/impulses/1/time", 0.37988),
        ("/impulses/2/time", 0.56917),
        ("/braking_impulses/1/time", 0.21579),
        ("/braking_impulses/2/time", 0.64926),
    ] {
        close(number(shaper, pointer), time, 5.1e-6);
    }
    assert!(number(shaper, "/modes/0/residual") < 1e-12);
    assert!(number(shapers["UMZV"], "/modes/0/residual") > 0.05);
    assert_eq!(shaper["parameters"]["braking_time_constant"], 0.065);
    let (_, message) = exits(&["shaper", "--hertz", "1", "--acceleration-limit", "1"], WRONG_USAGE);
    assert!(message.contains("--velocity-limit"), "{message}");
}

/// 20 s from 0 to 1 m/s: what ZV, ZVD and the like ask for, the drive reaches as late as what the bare command asks for.
#[test]
fn a_shaper_that_the_drive_makes_nothing_of_is_not_named() {
    let drive = ["--acceleration-limit", "0.05", "--velocity-limit", "1"];
    let answer = json(&[&["--length", "10"], &drive[..]].concat());
    let shapers = shapers(&answer);
    for idle in ["ZV", "ZVD", "TwoHumpEI"] {
        close(number(shapers[idle], "/delay"), 0.0, 1e-12);
        close(number(shapers[idle], "/modes/0/residual"), number(shapers["None"], "/modes/0/residual"), 1e-12);
    }
    let recommendation = &answer["recommendation"];
    assert_eq!(recommendation["choice"], "ZVDD");
    assert_eq!(recommendation["quickest"], Value::Null);
    // unless there is nothing else
    let alone = json(&[&["--length", "10", "--kind", "ZV"], &drive[..]].concat());
    assert_eq!(alone["recommendation"]["choice"], "ZV");
}

#[test]
fn the_words_say_what_else_there_is_to_do() {
    let words = |arguments: &[&str]| json(arguments)["recommendation"]["text"].as_str().unwrap().to_owned();
    // A tower crane: 5 to 40 m of cable are more than half an octave to either side.
    let (wide, narrow) =
        (words(&["--length", "18", "--range", "5..40"]), words(&["--length", "18", "--range", "15..20"]));
    assert!(wide.contains("frequency_source = Length") && !narrow.contains("frequency_source"), "{wide}\n{narrow}");
    // Two modes behind a drive: 5.4 % remain at best of those that are compared.
    let hook = ["--length", "10", "--rigging-length", "2", "--mass-ratio", "2"];
    let drive = ["--acceleration-limit", "1", "--velocity-limit", "0.5"];
    let none = words(&[&hook[..], &drive].concat());
    assert!(none.contains("`--base-kind SI`"), "{none}");
    let robust = json(&[&hook[..], &drive, &["--base-kind", "SI"]].concat());
    assert_eq!(robust["recommendation"]["choice"], "Convolved");
    assert_eq!(robust["recommendation"]["holds"], true);
    // ln 20/(0.7 · 0.8 rad/s) = 5.35 s, and ln 20/(0.3 · 0.8 rad/s) = 12.5 s
    let [heavy, light] = ["0.7", "0.3"].map(|ratio| words(&["--frequency", "1", "--kind", "ZVD", "--damping", ratio]));
    assert!(heavy.contains("damping alone brings the vibration down to 5 % in 5.35 s"), "{heavy}");
    assert!(!light.contains("damping alone"), "{light}");
    // 0.569 s, and three times 0.2 s until the drive has followed (5.24)
    let compensated = words(&[
        "--length",
        "0.84",
        "--kind",
        "UMZVc",
        "--acceleration-time-constant",
        "0.2",
        "--braking-time-constant",
        "0.065",
    ]);
    assert!(compensated.contains("1.249 s apart or more"), "{compensated}");
}

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

#[test]
fn impulses_are_printed() {
    let (stdout, _) = exits(&["shaper", "--hertz", "0.5", "--kind", "zvd", "--impulses"], 0);
    for row in [["1", "0.000000", "0.250000"], ["2", "1.000000", "0.500000"], ["3", "2.000000", "0.250000"]] {
        assert!(stdout.lines().any(|line| line.split_whitespace().eq(row)), "{row:?} is not in\n{stdout}");
    }
}

#[test]
fn plots_are_pictures_and_pages() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let draw = |name: &str, mode: &[&str]| {
        let (_, note) = exits(&[&["shaper", "--plot", &path(name)], mode].concat(), 0);
        assert!(note.contains(name), "{note}");
        std::fs::read_to_string(path(name)).unwrap()
    };
    let svg = draw("curves.svg", &["--length", "10", "--range", "8..12"]);
    let tree = resvg::usvg::Tree::from_str(&svg, &resvg::usvg::Options::default()).expect("a picture");
    assert_eq!((tree.size().width(), tree.size().height()), (960.0, 480.0));
    assert!(
        svg.contains("frequency (rad/s)") && svg.contains(">\nrange\n<") && svg.contains(">\nSI\n<"),
        "{svg:.2000}"
    );
    // a curve for each of ZV, ZVD, the choice and what is named beside it, and the limit; the others only on the page
    assert!(!svg.contains("ThreeHumpEI"));
    let page = draw("curves.html", &["--hertz", "1", "--hertz", "3", "--damping", "0", "--damping", "0.1"]);
    for text in ["frequency (Hz)", "ThreeHumpEI", "Shaped steps", "range of mode 2", "at damping ratio 0.1"] {
        assert!(page.contains(text), "{text}");
    }
    // each reason for itself, and what to copy into a system
    assert!(page.contains("<p class=\"note\">UMZVc is made for"), "reasons run into each other");
    assert!(page.contains("<p>InputShaper: kind = "), "no parameters");
}

#[test]
fn a_parameter_set_holds_the_recommended_shaper() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shaper.ssv");
    let file = file.to_str().unwrap();
    let answer = json(&["--length", "10", "--damping", "0.01", "--ssv", file]);
    let (stdout, _) = exits(&["validate", file], 0);
    assert!(stdout.contains("no problems"), "{stdout}");
    let choice = answer["recommendation"]["choice"].as_str().unwrap();
    let (set, _) = swayless_modeldesc::ssp::read_parameters(&std::fs::read_to_string(file).unwrap()).unwrap();
    let parameters = shapers(&answer)[choice]["parameters"].as_object().unwrap().clone();
    assert_eq!(set.parameters.len(), parameters.len());
    for parameter in set.parameters {
        let (written, said) = (parameter.value.to_string(), &parameters[&parameter.name]);
        match said.as_str() {
            Some(said) => assert_eq!(written, said),
            // the JSON is read here to a rounding only
            None => close(written.parse().unwrap(), said.as_f64().unwrap(), 1e-15),
        }
    }
}

/// Durations and widths in the table of `InputShaper`'s page are those of its shapers.
#[test]
fn the_page_of_the_shaper_tells_its_durations_and_widths() {
    let page = std::fs::read_to_string("../fmus/input-shaper/README.md").unwrap();
    let answer = json(&["--hertz", "1"]);
    let mut rows = 0;
    for (kind, shaper) in shapers(&answer) {
        let Some(row) = page.lines().find(|line| line.starts_with(&format!("| `{kind}` ("))) else { continue };
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let (Ok(duration), Ok(width)) = (cells[3].parse::<f64>(), cells[4].parse::<f64>()) else { continue };
        close(number(shaper, "/duration"), duration, 5.1e-4);
        close(number(shaper, "/modes/0/insensitivity"), width, 5.1e-4);
        rows += 1;
    }
    assert_eq!(rows, 10, "{page}");
}

/// The pages show what the command prints, to the letter.
#[test]
fn the_pages_show_true_output() {
    for page in ["../README.md", "../docs/shaper.md"] {
        let text = std::fs::read_to_string(page).unwrap();
        let shown: Vec<&str> =
            text.split("```").skip(1).step_by(2).filter(|block| block.contains("\n$ swayless shaper")).collect();
        assert!(!shown.is_empty(), "{page}");
        for block in shown {
            let (command, output) = block.split_once("$ swayless ").unwrap().1.split_once('\n').unwrap();
            let (stdout, _) = exits(&command.split_whitespace().collect::<Vec<_>>(), 0);
            let plain =
                |text: &str| text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n").trim_end().to_owned();
            assert_eq!(plain(output), plain(&stdout), "{page}: {command}");
        }
    }
}
