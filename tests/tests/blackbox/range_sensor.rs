//! `RangeSensor`: distances at its resolution, within its range, late by its latency.

use swayless_modeldesc::types::FmiVersion;

use crate::instance::{Instance, Set};

/// A laser without noise and delay that measures at every communication point, but for what is set.
fn ideal(values: &[(&str, Set<'_>)]) -> Instance {
    let none = ["sample_time", "latency", "noise"].map(|name| (name, Set::Real(0.0)));
    Instance::started("RangeSensor", 1.0, &[&none, values].concat())
}

/// Whether a distance is measured, and the last that was.
fn measure(laser: &mut Instance, distance: f64) -> (bool, f64) {
    laser.set("distance", distance).expect("any finite number");
    laser.step();
    (laser.get_switch("valid"), laser.get("measured.distance"))
}

#[test]
fn distances_are_rounded_to_the_resolution() {
    let mut laser = ideal(&[]);
    let mut worst = 0.0_f64;
    for i in 0..2500 {
        let distance = 0.100_037 * f64::from(i);
        let (valid, found) = measure(&mut laser, distance);
        assert!(valid && found == (distance / 1e-3).round() * 1e-3, "{found} for {distance}");
        worst = worst.max((found - distance).abs());
    }
    assert!((4.9e-4..=5e-4 + 1e-13).contains(&worst), "{worst}");
    // Without a resolution it is the distance itself.
    assert_eq!(measure(&mut ideal(&[("resolution", 0.0.into())]), 123.456_789), (true, 123.456_789));
}

#[test]
fn what_is_out_of_range_is_not_valid_and_the_last_distance_stays() {
    let mut laser = ideal(&[("range", 30.0.into())]);
    for distance in [0.0, 30.0, 12.5] {
        assert_eq!(measure(&mut laser, distance), (true, distance));
    }
    for distance in [30.0_f64.next_up(), -5e-324, -1.0, f64::MAX, f64::MIN] {
        assert_eq!(measure(&mut laser, distance), (false, 12.5), "{distance}");
    }
    assert_eq!(measure(&mut laser, 3.0), (true, 3.0));
}

/// Times are sums of powers of two: a distance appears at the very point that is a latency after its sample.
#[test]
fn a_distance_is_late_by_the_latency() {
    let second = |parts: u32| f64::from(parts) / 64.0;
    for (sample, latency) in [(4, 7), (4, 8), (3, 1), (5, 23), (4, 0)] {
        let values = [("noise", 0.0), ("sample_time", second(sample)), ("latency", second(latency))];
        let mut laser = Instance::started("RangeSensor", second(1), &values.map(|(name, value)| (name, value.into())));
        for point in 1..=100_u32 {
            laser.set("distance", f64::from(point)).expect("a distance");
            laser.step();
            let newest = point.checked_sub(latency).map(|seen| seen - seen % sample);
            // At the start the distance was 10 m.
            let wanted = newest.map_or(0.0, |newest| if newest == 0 { 10.0 } else { f64::from(newest) });
            assert_eq!(
                (laser.get_switch("valid"), laser.get("measured.distance")),
                (newest.is_some(), wanted),
                "{point}/64 s"
            );
        }
    }
}

/// Distances with noise, one for each step.
fn noisy(version: FmiVersion, seed: i32, distance: f64, count: usize) -> Vec<f64> {
    let mut laser = Instance::new("RangeSensor", version, 0.01);
    let values = [("sample_time", 0.01), ("latency", 0.0), ("resolution", 0.0), ("noise", 0.5), ("distance", distance)];
    values.iter().for_each(|(name, value)| laser.set(name, *value).expect("a value in range"));
    laser.set("seed", seed).expect("a seed");
    laser.initialize(None).expect("initialization");
    let mut next = || {
        laser.step();
        laser.get("measured.distance")
    };
    (0..count).map(|_| next()).collect()
}

#[test]
fn noise_has_its_deviation_and_stays_in_range() {
    let count = 20_000;
    let errors: Vec<f64> = noisy(FmiVersion::V3, 1, 100.0, count).iter().map(|d| (d - 100.0) / 0.5).collect();
    let mean = |f: &dyn Fn(f64) -> f64| errors.iter().map(|e| f(*e)).sum::<f64>() / count as f64;
    // In units of the standard deviation of each mean: 1/√n, √2/√n for squares.
    let root = (count as f64).sqrt();
    assert!(mean(&|error| error).abs() * root < 4.0);
    assert!((mean(&|error| error * error) - 1.0).abs() * root / 2.0_f64.sqrt() < 4.0);
    for distance in [0.0, 250.0] {
        let found = noisy(FmiVersion::V3, 1, distance, 200);
        assert!(found.iter().all(|d| (0.0..=250.0).contains(d)));
        let cut = found.iter().filter(|d| **d == distance).count();
        assert!((70..130).contains(&cut), "about half of it is beyond: {cut} of 200");
    }
}

#[test]
fn a_seed_repeats_its_noise_in_both_versions_and_another_does_not() {
    let first = noisy(FmiVersion::V3, 1, 100.0, 200);
    assert_eq!(noisy(FmiVersion::V3, 1, 100.0, 200), first);
    assert_eq!(noisy(FmiVersion::V2, 1, 100.0, 200), first);
    let other = noisy(FmiVersion::V2, 2, 100.0, 200);
    assert!(other.iter().zip(&first).all(|(a, b)| a != b));
}
