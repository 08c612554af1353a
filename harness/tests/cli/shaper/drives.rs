//! Behind drives with limits.

use super::{close, json, number, shapers};
use crate::{WRONG_USAGE, exits};

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
