//! What the recommendation says.

use serde_json::Value;

use super::{close, json, number, shapers};
use crate::exits;

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
