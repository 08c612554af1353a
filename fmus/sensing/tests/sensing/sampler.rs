//! Samplers: samples that are late by exactly their latency, that repeat, that go on after they were saved.

use proptest::prelude::*;
use swayless_sensing::{Sampler, Timing};

/// Gives out what is due up to `t`, each at its own time, as a clock would; returns times and readings.
fn deliveries(sampler: &mut Sampler<[f64; 1]>, t: f64) -> Vec<(f64, Option<[f64; 1]>)> {
    let mut found = Vec::new();
    while let Some(due) = sampler.next_delivery().filter(|due| *due <= t) {
        sampler.deliver(due, |reading| found.push((due, reading)));
    }
    found
}

proptest! {
    /// Whether or not the latency is a multiple of the sample time.
    #[test]
    fn each_sample_is_late_by_exactly_the_latency(
        sample_time in 1e-3..0.1_f64,
        latency in prop_oneof![1e-6..1.0_f64, (1..20_u32).prop_map(|n| 0.01 * f64::from(n))],
        start in -100.0..100.0_f64,
    ) {
        let timing = Timing { sample_time, latency };
        let mut sampler = Sampler::new(0, timing);
        let mut found = Vec::new();
        let times: Vec<f64> = (0..200).map(|n| start + f64::from(n) * sample_time).collect();
        for t in &times {
            found.extend(deliveries(&mut sampler, *t));
            // Every third sample shows nothing.
            let nothing = found.len() % 3 == 0;
            prop_assert_eq!(sampler.sample(*t, timing, |_| (!nothing).then_some([*t])), None);
        }
        found.extend(deliveries(&mut sampler, f64::INFINITY));
        prop_assert_eq!(found.len(), times.len());
        for ((due, reading), t) in found.iter().zip(&times) {
            prop_assert_eq!(*due, t + latency);
            prop_assert!(reading.is_none_or(|reading| reading == [*t]));
        }
    }

    /// The same in a copy, in one that copies into old room, and in one made of bytes.
    #[test]
    fn a_saved_sampler_goes_on_to_the_same_bits(before in 0..300_u32, seed in any::<u64>(), latency in 0.0..0.1_f64) {
        let timing = Timing { sample_time: 0.001, latency };
        let run = |sampler: &mut Sampler<[f64; 1]>, from: u32, count: u32| {
            let mut seen = Vec::new();
            for n in from..from + count {
                let t = f64::from(n) * timing.sample_time;
                seen.extend(deliveries(sampler, t));
                seen.extend(sampler.sample(t, timing, |noise| Some([noise.draw()])).map(|reading| (t, reading)));
            }
            seen
        };
        let mut sampler = Sampler::new(seed, timing);
        run(&mut sampler, 0, before);
        let mut used = Sampler::default();
        run(&mut used, 0, 50);
        used.clone_from(&sampler);
        let bytes = postcard::to_allocvec(&sampler).unwrap();
        let others = [sampler.clone(), used, postcard::from_bytes(&bytes).unwrap()];
        let expected = run(&mut sampler, before, 200);
        prop_assert!(!expected.is_empty());
        for mut other in others {
            prop_assert_eq!(&run(&mut other, before, 200), &expected);
        }
    }
}

#[test]
fn without_latency_a_sample_is_given_out_at_once() {
    let timing = Timing { sample_time: 0.04, latency: 0.0 };
    let mut sampler = Sampler::new(0, timing);
    assert_eq!(sampler.sample(0.0, timing, |_| Some([3.0])), Some(Some([3.0])));
    assert_eq!(sampler.sample(0.04, timing, |_| None), Some(None));
    assert_eq!(sampler.next_delivery(), None);
}

#[test]
fn a_second_look_at_the_same_instant_replaces_the_first_and_has_its_noise() {
    for latency in [0.0, 0.06] {
        let timing = Timing { sample_time: 0.0, latency };
        let (mut once, mut twice) = (Sampler::new(5, timing), Sampler::new(5, timing));
        for n in 0..20 {
            let t = 0.1 * f64::from(n);
            twice.sample(t, timing, |noise| Some([noise.draw() - 100.0]));
            let looks = [&mut once, &mut twice].map(|s| s.sample(t, timing, |noise| Some([noise.draw()])));
            assert_eq!(looks[0], looks[1]);
            assert_eq!(deliveries(&mut once, t + 0.07), deliveries(&mut twice, t + 0.07));
        }
        assert_eq!(once, twice);
    }
}

/// Samples taken whenever it suits: no more than there is room for, and evenly thinned out.
#[test]
fn samples_without_a_rate_are_thinned_out_to_what_there_is_room_for() {
    let timing = Timing { sample_time: 0.0, latency: 2.0 };
    let mut sampler = Sampler::new(0, timing);
    let mut found = Vec::new();
    for n in 0..60_000 {
        let t = 1e-4 * f64::from(n);
        found.extend(deliveries(&mut sampler, t));
        sampler.sample(t, timing, |_| Some([t]));
    }
    let taken: Vec<f64> = found.iter().map(|(_, reading)| reading.unwrap()[0]).collect();
    assert!((1900..=2000).contains(&taken.len()), "{}", taken.len());
    assert!(taken.windows(2).all(|pair| (2e-3 - 1e-9..2.2e-3).contains(&(pair[1] - pair[0]))));
    // Slower than that nothing is left out.
    let mut sampler = Sampler::new(0, timing);
    for n in 0..100 {
        sampler.sample(0.01 * f64::from(n), timing, |_| Some([0.0]));
    }
    assert_eq!(deliveries(&mut sampler, 10.0).len(), 100);
}

/// A clock that ticks much more often than was told cannot make a sampler grow.
#[test]
fn what_there_is_no_room_for_is_not_taken() {
    let timing = Timing { sample_time: 0.01, latency: 10.0 };
    let mut sampler = Sampler::new(0, timing);
    for n in 0..5000 {
        sampler.sample(1e-4 * f64::from(n), timing, |_| Some([0.0]));
    }
    let count = deliveries(&mut sampler, 100.0).len();
    assert!((1000..1100).contains(&count), "{count}");
}

/// Due times in any order are not what a sampler writes; it never writes them itself, however time runs.
#[test]
fn what_cannot_be_is_refused() {
    let timing = Timing { sample_time: 0.0, latency: 0.5 };
    let mut sampler = Sampler::<[f64; 1]>::new(1, timing);
    for t in [1.0, 2.0, -5.0, 3.0, 1e300, 4.0] {
        sampler.sample(t, timing, |_| Some([t]));
    }
    let bytes = postcard::to_allocvec(&sampler).unwrap();
    assert_eq!(postcard::from_bytes::<Sampler<[f64; 1]>>(&bytes).as_ref(), Ok(&sampler));

    type Line = Vec<(f64, Option<[f64; 1]>)>;
    let refused = |last: Option<f64>, room: usize, line: Line| {
        let bytes = postcard::to_allocvec(&(1_u64, 1_u64, last, room, line)).unwrap();
        postcard::from_bytes::<Sampler<[f64; 1]>>(&bytes).is_err()
    };
    assert!(!refused(Some(1.0), 8, vec![(1.0, Some([2.0])), (1.0, None), (3.0, Some([1.0]))]));
    assert!(refused(Some(f64::NAN), 8, vec![]));
    assert!(refused(None, 8, vec![(2.0, None), (1.0, None)]));
    assert!(refused(None, 8, vec![(f64::INFINITY, None)]));
    assert!(refused(None, 8, vec![(f64::NAN, None)]));
    assert!(refused(None, 8, vec![(1.0, Some([f64::NAN]))]));
    assert!(refused(None, 8, vec![(1.0, None); 9]));
    assert!(refused(None, 2000, vec![(1.0, None); 9]));
    assert!(refused(None, usize::MAX, vec![]));
}
