//! `FlexibleModes` against closed forms, and against the shapers of thesis 5.3.4 that leave no vibration.

use std::f64::consts::TAU;

use swayless_modeldesc::types::{DataType, FmiVersion};

use crate::instance::Instance;

const SPEED: f64 = 0.3;
/// The rods of thesis 5.3.4: 1 and 2 Hz, and 1 and 4 Hz.
const RODS: [[f64; 2]; 2] = [[TAU, 2.0 * TAU], [TAU, 4.0 * TAU]];

/// As many modes as there are frequencies, started.
fn modes(step: f64, frequencies: &[f64], ratios: &[f64], velocity: f64) -> Instance {
    let mut modes = Instance::new("FlexibleModes", FmiVersion::V3, step);
    if frequencies.len() != 2 {
        let count = [modes.reference("mode.count")];
        modes.slave.enter_configuration_mode().expect("Configuration Mode");
        modes.slave.set_integer(DataType::UInt64, &count, &[frequencies.len() as i64]).expect("a count");
        modes.slave.exit_configuration_mode().expect("the end of Configuration Mode");
    }
    modes.set_all("mode.frequency", frequencies);
    modes.set_all("mode.damping_ratio", ratios);
    modes.set("base.velocity", velocity).expect("a velocity");
    modes.initialize(Some(1e-10)).expect("initialization");
    modes
}

/// Deflection and its rate after a step v of the base's velocity: ÿ + 2ζω ẏ + ω² y = 0 from y = 0, ẏ = −v.
fn answer(t: f64, omega: f64, zeta: f64) -> [f64; 2] {
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let (sin, cos) = (damped * t).sin_cos();
    let peak = SPEED / damped * (-zeta * omega * t).exp();
    [-peak * sin, peak * (zeta * omega * sin - damped * cos)]
}

/// Runs a step of the base's velocity and compares each mode with the closed form.
#[track_caller]
fn answers_a_step(frequencies: &[f64], ratios: &[f64]) {
    for set_before_start in [true, false] {
        let mut modes = modes(0.01, frequencies, ratios, if set_before_start { SPEED } else { 0.0 });
        modes.set("base.velocity", SPEED).expect("a velocity");
        let mut worst = 0.0_f64;
        while modes.time() < 2.0 {
            modes.step();
            let deflections = modes.get_all("mode.deflection", frequencies.len());
            let rates = modes.get_all("mode.rate", frequencies.len());
            for (i, (omega, zeta)) in frequencies.iter().zip(ratios).enumerate() {
                let [y, rate] = answer(modes.time(), *omega, *zeta);
                worst = worst.max((deflections[i] - y).abs() * omega / SPEED).max((rates[i] - rate).abs() / SPEED);
            }
        }
        // Modes that are not there do not count, though they have room.
        let left: f64 = modes.get_all("mode.amplitude", frequencies.len()).iter().sum();
        assert!((modes.get("amplitude") - left).abs() < 1e-15);
        println!("{} modes: within {worst:.1e} of the peaks", frequencies.len());
        // The integrator's tolerance is 1e-10 in a step, and there are some hundred steps.
        assert!(worst < 1e-8, "{frequencies:?}, {ratios:?}: off by {worst:e} of the peak");
    }
}

#[test]
fn a_velocity_step_answers_as_the_closed_form() {
    for frequencies in RODS {
        for ratios in [[0.0, 0.0], [0.01, 0.05], [0.3, 0.002]] {
            answers_a_step(&frequencies, &ratios);
        }
    }
}

/// Modes know nothing of each other: any number of them, from one to all there is room for.
#[test]
fn there_are_as_many_modes_as_are_asked_for() {
    let frequencies: [f64; 8] = std::array::from_fn(|i| 2.0 + 3.1 * i as f64);
    let ratios: [f64; 8] = std::array::from_fn(|i| 0.01 * i as f64);
    for count in [1, 3, 8] {
        answers_a_step(&frequencies[..count], &ratios[..count]);
    }
}

/// FMI 2.0 has two modes, the elements of which are variables of their own; the same bits come out.
#[test]
fn both_versions_have_the_same_modes() {
    let mut old = Instance::new("FlexibleModes", FmiVersion::V2, 0.01);
    for (name, value) in [("mode.damping_ratio[1]", 0.02), ("mode.deflection[2]", 0.1), ("base.velocity", SPEED)] {
        old.set(name, value).expect("a value");
    }
    old.initialize(Some(1e-10)).expect("initialization");
    let mut new = Instance::new("FlexibleModes", FmiVersion::V3, 0.01);
    new.set_all("mode.damping_ratio", &[0.02, 0.0]);
    new.set_all("mode.deflection", &[0.0, 0.1]);
    new.set("base.velocity", SPEED).expect("a velocity");
    new.initialize(Some(1e-10)).expect("initialization");
    for _ in 0..50 {
        old.step();
        new.step();
        let found = [old.get("mode.deflection[1]"), old.get("mode.deflection[2]")];
        assert_eq!(new.get_all("mode.deflection", 2), found);
    }
}

/// A mode that is let go swings as a cosine; its amplitude is there at once.
#[test]
fn a_deflected_mode_swings_freely() {
    let mut modes = Instance::new("FlexibleModes", FmiVersion::V3, 0.01);
    modes.set_all("mode.deflection", &[0.02, -0.01]);
    modes.initialize(Some(1e-10)).expect("initialization");
    while modes.time() < 3.0 {
        let deflections = modes.get_all("mode.deflection", 2);
        let amplitudes = modes.get_all("mode.amplitude", 2);
        for (i, start) in [0.02_f64, -0.01].into_iter().enumerate() {
            let wanted = start * (RODS[0][i] * modes.time()).cos();
            assert!((deflections[i] - wanted).abs() < 1e-10, "mode {i} at {} s", modes.time());
            assert!((amplitudes[i] - start.abs()).abs() < 1e-10, "mode {i} at {} s", modes.time());
        }
        let sums = [modes.get("deflection"), modes.get("amplitude")];
        assert_eq!(sums, [deflections[0] + deflections[1], amplitudes[0] + amplitudes[1]]);
        modes.step();
    }
}

/// The shapers with the fewest impulses for two modes without damping (5.33–5.37): in units of one time step, three
/// impulses of ⅓ for 1 and 2 Hz, and those of fig. 5.33 for 1 and 4 Hz. The base ends with a velocity and neither mode
/// vibrates; unshaped, both do.
#[test]
fn minimum_impulse_shapers_leave_no_vibration() {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (outer, middle) = (1.0 / (1.0 + golden.powi(2)), 1.0 - 2.0 / (1.0 + golden.powi(2)));
    assert!((outer - 0.72361).abs() < 5e-6 && (middle + 0.44721).abs() < 5e-6, "as in Table 5.2");
    for (rods, spacing, impulses) in [(RODS[0], 1.0 / 3.0, [1.0 / 3.0; 3]), (RODS[1], 0.2, [outer, middle, outer])] {
        for (shaped, impulses) in [(true, impulses), (false, [1.0, 0.0, 0.0])] {
            let mut modes = modes(spacing, &rods, &[0.0; 2], 0.0);
            let mut velocity = 0.0;
            for impulse in impulses {
                velocity += SPEED * impulse;
                modes.set("base.velocity", velocity).expect("a velocity");
                modes.step();
            }
            let left = modes.get_all("mode.amplitude", 2);
            let alone = [SPEED / rods[0], SPEED / rods[1]];
            let bound = if shaped { 0.0 } else { 1.0 };
            assert!((0..2).all(|i| (left[i] / alone[i] - bound).abs() < 1e-8), "{rods:?}, {impulses:?}: {left:?}");
        }
    }
}

#[test]
fn a_start_beyond_all_measure_is_refused_by_name() {
    let mut modes = Instance::new("FlexibleModes", FmiVersion::V3, 0.01);
    modes.set_all("mode.velocity", &[0.0, 1e7]);
    let failure = modes.initialize(None).expect_err("a refusal");
    let text = format!("{:?}", failure.messages);
    assert!(text.contains("mode.velocity is 10000000;"), "{text}");
}
