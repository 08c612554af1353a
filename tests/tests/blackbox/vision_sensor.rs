//! `VisionSensor`: what it measures against geometry done another way, sample by sample.

use swayless_modeldesc::types::FmiVersion;

use crate::instance::{Instance, Set};
use crate::packaged;

const MEASURED: [&str; 4] = [
    "measured.swing.radial",
    "measured.swing.tangential",
    "measured.displacement.radial",
    "measured.displacement.tangential",
];

/// A camera without errors and delay that takes an image at every communication point, but for what is set.
fn ideal(values: &[(&str, Set<'_>)]) -> Instance {
    let none = ["sample_time", "latency", "pixel_size", "noise"].map(|name| (name, Set::Real(0.0)));
    Instance::started("VisionSensor", 1.0, &[&none, values].concat())
}

/// Whether there is a measurement in an image that is taken now, and the last one.
fn look(camera: &mut Instance, inputs: &[(&str, f64)]) -> (bool, [f64; 4]) {
    inputs.iter().for_each(|(name, value)| camera.set(name, *value).expect("any finite number"));
    camera.step();
    (camera.get_switch("valid"), MEASURED.map(|name| camera.get(name)))
}

/// Swing angles over the whole field of view.
fn swings() -> impl Iterator<Item = (f64, f64)> {
    let angles = || (-10..=10).map(|i| 0.035 * f64::from(i));
    angles().flat_map(move |radial| angles().map(move |tangential| (radial, tangential)))
}

#[test]
fn without_errors_the_measured_swing_is_the_swing() {
    let mut camera = ideal(&[]);
    for length in [1.5, 10.0, 80.0] {
        let mut seen = 0;
        for (radial, tangential) in swings() {
            let (valid, found) = look(
                &mut camera,
                &[("swing.radial", radial), ("swing.tangential", tangential), ("hoist.length", length)],
            );
            if valid {
                let wanted = [radial, tangential, length * radial.sin(), length * radial.cos() * tangential.sin()];
                for (found, wanted) in found.iter().zip(wanted) {
                    assert!((found - wanted).abs() <= 1e-14 * length.max(1.0), "{found}, not {wanted}, at {length} m");
                }
                seen += 1;
            }
        }
        // Of 21 × 21, the fewer the closer the payload is to the camera.
        assert!((seen == 441) == (length > 1.5) && seen > 250, "{seen} at {length} m");
    }
}

/// In the plane of the boom the payload at an angle α from the camera swings by φ = α − asin(κ sin α), the law of sines.
/// A pixel shows tan α, and what is measured is as if the payload were in the middle of the pixel.
#[test]
fn pixels_err_by_no_more_than_half_of_one() {
    let (pixel, drop, length) = (0.004, 0.8, 5.0);
    let kappa: f64 = drop / length;
    let mut camera = ideal(&[("pixel_size", pixel.into()), ("camera.drop", drop.into())]);
    camera.set("hoist.length", length).expect("a length");
    let swing_of = |u: f64| u.atan() - (kappa * u.atan().sin()).asin();
    let mut worst = 0.0_f64;
    for i in -3000..=3000 {
        let radial = 1e-4 * f64::from(i);
        let (valid, found) = look(&mut camera, &[("swing.radial", radial)]);
        assert!(valid && found[1] == 0.0 && found[3] == 0.0);
        let u = radial.sin() / (radial.cos() - kappa);
        assert!((found[0] - swing_of((u / pixel).round() * pixel)).abs() < 1e-14);
        // φ grows with u, the less the greater u is.
        let bound = swing_of(u.abs()) - swing_of(u.abs() - 0.5 * pixel);
        worst = worst.max((found[0] - radial).abs() / bound);
        assert!((found[2] - length * found[0].sin()).abs() < 1e-14 * length);
    }
    assert!((0.95..=1.0 + 1e-9).contains(&worst), "{worst} of half a pixel");
}

/// A camera that the bars pitch outwards by ε sees n turned inwards by ε: φ' = φ − ε cos β and β' = β − ε tan φ sin β to
/// first order.
#[test]
fn bars_that_do_not_keep_it_level_show_as_swing() {
    let gain = 0.02;
    let mut camera = ideal(&[("leveling.gain", gain.into()), ("leveling.luff_reference", 0.9.into())]);
    for luff in [0.9, 0.2, 0.95, 1.4] {
        let pitch = gain * (luff - 0.9);
        for (radial, tangential) in swings().filter(|(radial, tangential)| radial.hypot(*tangential) < 0.3) {
            let inputs = [("swing.radial", radial), ("swing.tangential", tangential), ("luff.angle", luff)];
            let (valid, found) = look(&mut camera, &inputs);
            let wanted = [radial - pitch * tangential.cos(), tangential - pitch * radial.tan() * tangential.sin()];
            // Of second order there is at most ε², and none where the payload swings in the plane of the boom.
            let rest = if tangential == 0.0 { 0.0 } else { pitch * pitch };
            assert!(
                valid && (found[0] - wanted[0]).abs() <= rest + 1e-14 && (found[1] - wanted[1]).abs() <= rest + 1e-14
            );
        }
    }
}

#[test]
fn what_is_out_of_view_is_not_valid_and_the_last_measurement_stays() {
    let mut camera = ideal(&[("field_of_view", 0.6.into()), ("camera.drop", 0.0.into())]);
    let (valid, last) = look(&mut camera, &[("swing.radial", 0.3 - 1e-9)]);
    assert!(valid && (last[0] - (0.3 - 1e-9)).abs() < 1e-15);
    let out = [
        ("swing.radial", 0.3 + 1e-9),
        ("swing.radial", -2.0),
        ("swing.tangential", 0.31),
        ("swing.tangential", 1e300),
        ("hoist.length", 0.0),
        ("hoist.length", -7.0),
        ("hoist.length", f64::MIN),
    ];
    for (name, value) in out {
        let inside = [("swing.radial", 0.0), ("swing.tangential", 0.0), ("hoist.length", 10.0)];
        let inputs = inside.map(|(other, start)| (other, if other == name { value } else { start }));
        assert_eq!(look(&mut camera, &inputs), (false, last), "{name} = {value}");
    }
    // Any length below the camera is fine.
    for length in [f64::MIN_POSITIVE, 1e-9, 1e300, f64::MAX] {
        let (valid, found) =
            look(&mut camera, &[("hoist.length", length), ("swing.radial", 0.1), ("swing.tangential", 0.0)]);
        assert!(valid && (found[0] - 0.1).abs() < 1e-15 && (found[2] / length - 0.1_f64.sin()).abs() < 1e-15);
    }
}

/// Times are sums of powers of two: what is measured appears at the very point that is a latency after the image, whether
/// or not that is a multiple of the sample time, and wherever steps end.
#[test]
fn a_measurement_is_late_by_the_latency() {
    let second = |parts: u32| f64::from(parts) / 64.0;
    for (sample, latency) in [(4, 7), (4, 8), (3, 1), (5, 23), (4, 0)] {
        let exact = [("pixel_size", Set::Real(0.0)), ("noise", 0.0.into())];
        let timing = [("sample_time", second(sample).into()), ("latency", second(latency).into())];
        let mut camera = Instance::started("VisionSensor", second(1), &[exact, timing].concat());
        // The input of a step is the number of the point it ends at: what an image at its end sees.
        for point in 1..=100_u32 {
            camera.set("swing.radial", 1e-3 * f64::from(point)).expect("a swing");
            camera.step();
            let newest = point.checked_sub(latency).map(|seen| seen - seen % sample);
            let wanted = newest.map_or(0.0, |newest| 1e-3 * f64::from(newest));
            let found = camera.get("measured.swing.radial");
            assert!((found - wanted).abs() < 1e-15, "{found}, not {wanted}, at {point}/64 s");
            assert_eq!(camera.get_switch("valid"), newest.is_some());
        }
    }
}

/// Images of a payload at rest that is about `1/noise` times as far as the noise moves it; one for each step.
fn noisy(version: FmiVersion, seed: i32, count: usize) -> Vec<[f64; 2]> {
    let mut camera = Instance::new("VisionSensor", version, 0.01);
    let values = [("sample_time", 0.01), ("latency", 0.0), ("pixel_size", 0.0), ("noise", 1e-6), ("camera.drop", 0.0)];
    values.iter().for_each(|(name, value)| camera.set(name, *value).expect("a value in range"));
    camera.set("seed", seed).expect("a seed");
    camera.initialize(None).expect("initialization");
    let mut image = || {
        camera.step();
        // To first order the swing is the image.
        ["measured.swing.radial", "measured.swing.tangential"].map(|name| camera.get(name) / 1e-6)
    };
    (0..count).map(|_| image()).collect()
}

#[test]
fn noise_has_its_deviation_and_its_axes_are_independent() {
    let count = 20_000;
    let images = noisy(FmiVersion::V3, 1, count);
    let mean = |f: &dyn Fn(&[f64; 2]) -> f64| images.iter().map(f).sum::<f64>() / count as f64;
    // In units of the standard deviation of each mean: 1/√n, √2/√n for squares.
    let root = (count as f64).sqrt();
    for axis in 0..2 {
        assert!(mean(&|image| image[axis]).abs() * root < 4.0);
        assert!((mean(&|image| image[axis].powi(2)) - 1.0).abs() * root / 2.0_f64.sqrt() < 4.0);
    }
    assert!(mean(&|image| image[0] * image[1]).abs() * root < 4.0);
}

#[test]
fn a_seed_repeats_its_noise_in_both_versions_and_another_does_not() {
    let bits = |images: Vec<[f64; 2]>| images.into_iter().flatten().map(f64::to_bits).collect::<Vec<_>>();
    let first = bits(noisy(FmiVersion::V3, 1, 200));
    assert_eq!(bits(noisy(FmiVersion::V3, 1, 200)), first);
    assert_eq!(bits(noisy(FmiVersion::V2, 1, 200)), first);
    for other in [0, 2, -1] {
        let noise = bits(noisy(FmiVersion::V2, other, 200));
        assert!(noise.iter().zip(&first).all(|(a, b)| a != b), "{other}");
    }
}

#[test]
fn what_there_is_no_room_for_is_refused_with_what_there_is() {
    let message = |values: &[(&str, f64)]| {
        let mut camera = Instance::new("VisionSensor", FmiVersion::V3, 0.1);
        values.iter().for_each(|(name, value)| camera.set(name, *value).expect("a value in range"));
        let failure = camera.initialize(None).expect_err("refused");
        failure.messages.iter().map(|m| m.text.clone()).collect::<String>()
    };
    let text = message(&[("sample_time", 0.002), ("latency", 5.0)]);
    assert!(
        text.contains("latency is 5 s") && text.contains("at most 2 s") && text.contains("at least 0.005 s"),
        "{text}"
    );
    assert!(message(&[("sample_time", 1e-7)]).contains("sample_time is 0.0000001 s"));
}

/// In the FMU with clocks, what is measured is computed by both: by the image itself where there is no latency.
#[test]
fn both_clocks_compute_what_is_measured() {
    let fmu = packaged::open("VisionSensorClocked", FmiVersion::V3);
    let variables = &fmu.description().variables;
    let clock = |name: &str| variables.iter().find(|v| v.name == name).expect("a clock").value_reference;
    for name in MEASURED.iter().chain(&["valid"]) {
        let variable = variables.iter().find(|v| v.name == *name).expect("an output");
        assert_eq!(variable.clocks, [clock("sample"), clock("delivery")], "{name}");
    }
}
