//! What timings are refused, and that what is told instead will do.

use proptest::prelude::*;
use swayless_sensing::{Sampler, Timing};

fn told(timing: Timing) -> String {
    let error = timing.check().expect_err("refused");
    format!("{} {error}", error.quantity())
}

#[test]
fn what_has_no_room_is_refused_with_the_numbers() {
    assert_eq!(
        told(Timing { sample_time: 0.001, latency: 2.5 }),
        "latency is 2.5 s; with a sample every 0.001 s there is room for 1000 that are under way: it must be at most \
         1 s, or sample_time at least 0.0025 s"
    );
    assert_eq!(
        told(Timing { sample_time: 1e-6, latency: 0.0 }),
        "sample_time is 0.000001 s; it must be 0 or at least 0.00001 s"
    );
    for (sample_time, latency) in [(0.0, 0.0), (0.0, 1e3), (1e-5, 0.0), (0.04, 0.06), (0.001, 1.0), (1e3, 1e3)] {
        assert_eq!(Timing { sample_time, latency }.check(), Ok(()));
    }
}

proptest! {
    #[test]
    fn the_nearest_values_do(sample_time in 1e-5..1.0_f64, latency in 0.0..1e3_f64) {
        prop_assume!(Timing { sample_time, latency }.check().is_err());
        prop_assert_eq!(Timing { sample_time, latency: 1000.0 * sample_time }.check(), Ok(()));
        prop_assert_eq!(Timing { sample_time: latency / 1000.0, latency }.check(), Ok(()));
    }

    /// The longest latency there is room for loses no sample, with ticks as clocks count them.
    #[test]
    fn the_longest_latency_has_room(sample_time in 1e-5..1.0_f64, start in -1e3..1e3_f64) {
        let timing = Timing { sample_time, latency: 1000.0 * sample_time };
        let mut sampler = Sampler::new(1, timing);
        let (mut given, mut next) = (0_u32, start);
        for n in 0..3000_u32 {
            while sampler.next_delivery().is_some_and(|due| due <= next) {
                let due = sampler.next_delivery().unwrap();
                sampler.deliver(due, |reading| {
                    assert_eq!(reading, Some([f64::from(given)]));
                    given += 1;
                });
            }
            sampler.sample(next, timing, |_| Some([f64::from(n)]));
            next = start + f64::from(n + 1) * sample_time;
        }
        prop_assert!((1998..=2001).contains(&given), "{given}");
    }
}
