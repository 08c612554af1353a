//! `InputShaper`: the rules by which changes of a command are shaped, and what is refused.

use super::*;

/// The kinds for an acceleration limit are designed for each change, up to the velocity limit, unless `redesign` is off.
#[test]
fn limited_kinds_are_designed_for_each_change() {
    let trace = |velocity_limit: f64, redesign: bool, commands: [f64; 2]| {
        let values = [
            ("velocity_limit", velocity_limit.into()),
            ("acceleration_limit", 0.12.into()),
            ("redesign", redesign.into()),
        ];
        let mut shaper = shaper("ALZVD", [1.76, 0.0], &values);
        let mut trace = Vec::new();
        for command in commands {
            shaper.set("command", command).expect("a command");
            for _ in 0..800 {
                shaper.step();
                trace.push(shaper.get("shaped"));
            }
        }
        (trace, shaper.get_all("impulse.time", 32))
    };
    let (each, shown) = trace(0.358, true, [0.2, 0.0]);
    assert_eq!(each, trace(0.2, true, [0.2, 0.0]).0, "as if that were the limit");
    assert_eq!(shown, trace(0.358, false, [0.2, 0.0]).1, "what is shown is for the limit");
    let (kept, _) = trace(0.358, false, [0.2, 0.0]);
    assert_ne!(each, kept);
    let scaled: Vec<_> = trace(0.358, true, [0.358, 0.0]).0.iter().map(|value| value * (0.2 / 0.358)).collect();
    assert!(kept.iter().zip(&scaled).all(|(a, b)| (a - b).abs() < 1e-15), "one design for all is linear");
}

/// As the change tends to nothing the shaper for an acceleration limit tends to ZVD.
#[test]
fn small_changes_are_shaped_by_zvd() {
    let after = |kind: &str| {
        let mut shaper = shaper(kind, [1.76, 0.0], &[]);
        shaper.set("command", 1e-7).expect("a command");
        [1.0, 2.5, 4.0].map(|time| {
            shaper.run_to(time);
            shaper.get("shaped")
        })
    };
    let (limited, zvd) = (after("ALZVD"), after("ZVD"));
    assert!((0..3).all(|i| (limited[i] / zvd[i] - 1.0).abs() < 1e-6), "{limited:?}, {zvd:?}");
}

#[test]
fn overlapping_trains_interfere_where_they_are_exact_only_alone() {
    for (kind, exact) in [("UMZVc", false), ("ALZVD", false), ("ZVD", true), ("UMZV", true)] {
        let constants = [("acceleration_time_constant", 0.1.into()), ("braking_time_constant", 0.05.into())];
        let mut shaper = shaper(kind, [2.0, 0.0], &constants);
        let mut flags = Vec::new();
        for (command, until) in [(1.0, 5.0), (0.5, 10.0), (0.9, 10.2), (0.3, 20.0), (-0.3, 20.1), (-0.3, 30.0)] {
            shaper.set("command", command).expect("a command");
            shaper.run_to(until);
            flags.push(shaper.get_switch("interference"));
        }
        // A change while a train is under way does; a change of sign is two trains of UMZVc, one of the others.
        let wanted = [false, false, false, false, kind == "UMZVc", false];
        assert_eq!(flags, wanted, "{kind}");
        shaper.set("command", 0.3).expect("a command");
        shaper.run_to(30.1);
        shaper.set("command", 0.2).expect("a command");
        shaper.run_to(30.2);
        assert_eq!(shaper.get_switch("interference"), !exact, "{kind}");
        shaper.run_to(45.0);
        assert!(!shaper.get_switch("interference") && shaper.get("shaped") == 0.2, "{kind}");
    }
}

/// Whatever is commanded with whatever length, and switched on and off meanwhile: once all is passed on, it is the command.
#[test]
fn any_sequence_of_commands_ends_at_the_last() {
    let kinds = [
        "ZV",
        "ZVD",
        "ZVDD",
        "ZVDDD",
        "EI",
        "TwoHumpEI",
        "ThreeHumpEI",
        "SI",
        "UMZV",
        "UMZVD",
        "UMEI",
        "UMZVc",
        "ALZVD",
        "ALEI",
        "ALSI",
        "Convolved",
        "MinimumImpulse",
    ];
    let mut noise = noise();
    for kind in kinds {
        let values = [
            ("frequency_source", "Length".into()),
            ("rigging.length", 2.0.into()),
            ("mass_ratio", 0.4.into()),
            ("braking_time_constant", 0.1.into()),
            ("velocity_limit", 0.5.into()),
        ];
        let mut shaper = shaper(kind, [0.0; 2], &values);
        let mut command = 0.0;
        for step in 0..400 {
            if noise() > 0.6 {
                command = noise();
                shaper.set("command", command).expect("a command");
            }
            shaper.set("hoist.length", 6.0 + 5.0 * noise()).expect("a length");
            if step % 50 == 0 {
                shaper.set("enabled", noise() > -0.5).expect("a switch");
            }
            shaper.step();
            assert!(shaper.get_switch("valid"), "{kind}");
            assert!(shaper.get("shaped").abs() < 20.0, "{kind}: {}", shaper.get("shaped"));
        }
        shaper.slave.do_step(shaper.time(), 100.0).expect("a step");
        assert_eq!(shaper.get("shaped").to_bits(), command.to_bits(), "{kind}");
    }
}

#[test]
fn what_has_no_design_is_refused_by_name_with_the_nearest_that_has() {
    let refused = |kind: &str, frequencies: [f64; 2], values: &[(&str, Set<'_>)]| {
        let failure = fresh(kind, frequencies, values).initialize(None).expect_err("a refusal");
        failure.messages.iter().map(|message| message.text.clone()).collect::<String>()
    };
    let one = [1.0, 0.0];
    for (text, hint) in [
        (refused("ZV", [0.0; 2], &[]), ["mode.frequency[1] cannot be used", "greater than 0"]),
        (refused("ZVD", [1.0, 2.0], &[]), ["mode.frequency[2] cannot be used", "shapes one mode only"]),
        (
            refused("ALZVD", one, &[("acceleration_limit", 0.01.into())]),
            ["velocity_limit cannot be used", "there is one for"],
        ),
        (
            refused("UMZVc", one, &[("acceleration_time_constant", 9.0.into())]),
            ["acceleration_time_constant cannot be used", "there is one for"],
        ),
        (refused("SI", one, &[("vibration_limit", 0.0.into())]), ["vibration_limit cannot be used", "at least 0.005"]),
        (
            refused(
                "SI",
                one,
                &[("insensitivity", 1.5.into()), ("vibration_limit", 0.005.into()), ("sample_time", 1e-9.into())],
            ),
            ["sample_time is", "at least 0.00001"],
        ),
        (
            refused("MinimumImpulse", [1.0, 2.0], &[("solution", 32.into())]),
            ["solution cannot be used", "minimum impulses have"],
        ),
    ] {
        assert!(hint.iter().all(|hint| text.contains(hint)), "{text}");
    }
    let mut damped = fresh("EI", one, &[]);
    damped.set_all("mode.damping_ratio", &[0.9, 0.0]);
    let text = format!("{:?}", damped.initialize(None).expect_err("a refusal").messages);
    assert!(
        text.contains("mode.damping_ratio[1] cannot be used") && text.contains("there is one for a damping ratio of"),
        "{text}"
    );
    let mut unused = fresh("EI", one, &[]);
    unused.set_all("mode.damping_ratio", &[0.0, 0.1]);
    let text = format!("{:?}", unused.initialize(None).expect_err("a refusal").messages);
    assert!(text.contains("mode.damping_ratio[2] is 0.1"), "{text}");
}

/// A length or a tuned value without a design: the one before is kept, and `valid` says so.
#[test]
fn without_a_design_the_one_before_holds() {
    let mut shaper = shaper("ZV", [0.0; 2], &[("frequency_source", "Length".into())]);
    let mut change = |length: f64, command: f64| {
        shaper.set("hoist.length", length).expect("a length");
        shaper.set("command", command).expect("a command");
        shaper.run_to(shaper.time() + 20.0);
        (shaper.get_switch("valid"), shaper.get("duration"), shaper.get("shaped"))
    };
    let half = |length: f64| 0.5 * TAU * (length / GRAVITY).sqrt();
    let close = |(valid, duration, shaped): (bool, f64, f64), wanted: (bool, f64, f64)| {
        assert!(
            (valid, shaped) == (wanted.0, wanted.2) && (duration - wanted.1).abs() < 1e-14,
            "{valid} {duration} {shaped}"
        );
    };
    close(change(10.0, 1.0), (true, half(10.0), 1.0));
    close(change(-3.0, 2.0), (false, half(10.0), 2.0));
    close(change(0.0, 1.5), (false, half(10.0), 1.5));
    close(change(4.0, 1.0), (true, half(4.0), 1.0));

    let mut tuned = fresh("EI", [1.0, 0.0], &[]);
    tuned.initialize(None).expect("initialization");
    let mut change = |damping: f64, command: f64| {
        tuned.set_all("mode.damping_ratio", &[damping, 0.0]);
        tuned.set("command", command).expect("a command");
        tuned.step();
        (tuned.get_switch("valid"), tuned.get_all("impulse.time", 32))
    };
    let (first, last) = (change(0.0, 1.0), change(0.95, 0.5));
    assert!(first.0 && !last.0 && first.1 == last.1);
    assert!(change(0.1, 1.0).0);
}

/// The command before the start is not the first command: that is shaped.
#[test]
fn a_first_command_that_differs_is_shaped() {
    let mut shaper = fresh("ZV", [TAU, 0.0], &[("command_start", 1.0.into()), ("command", 3.0.into())]);
    shaper.initialize(None).expect("initialization");
    assert_eq!(shaper.get("shaped"), 2.0);
    shaper.run_to(0.49);
    assert_eq!(shaper.get("shaped"), 2.0);
    shaper.run_to(0.5);
    assert_eq!(shaper.get("shaped"), 3.0);
}

/// With a sample time a change is seen at the next sample; impulses come when they are due all the same.
#[test]
fn samples_see_changes_and_impulses_do_not_wait_for_them() {
    let mut shaper = shaper("ZV", [TAU / 0.9, 0.0], &[("sample_time", 0.2.into())]);
    let mut seen = Vec::new();
    for (command, until) in [(0.0, 0.25), (1.0, 0.39), (1.0, 0.4), (1.0, 0.84), (1.0, 0.85), (1.0, 2.0)] {
        shaper.set("command", command).expect("a command");
        shaper.run_to(until);
        seen.push(shaper.get("shaped"));
    }
    assert_eq!(seen, [0.0, 0.0, 0.5, 0.5, 1.0, 1.0]);
}
