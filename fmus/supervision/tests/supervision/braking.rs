//! Braking distances, added up sample by sample.

use proptest::prelude::*;
use swayless_supervision::Braking;

/// How far a ramp goes until it is down to `last`: `velocity` for an interval, then less by a step, and so on.
fn distance(braking: Braking, mut velocity: f64, last: f64) -> f64 {
    let mut gone = velocity * braking.reaction;
    while velocity > last {
        gone += velocity * braking.interval;
        velocity -= braking.step();
    }
    gone
}

fn any_braking() -> impl Strategy<Value = Braking> {
    (0.05..5.0, 0.005..0.5, 0.0..1.0).prop_map(|(deceleration, interval, reaction)| Braking {
        deceleration,
        interval,
        reaction,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(256) })]

    /// Down to rest it is the very distance that there is.
    #[test]
    fn a_ramp_to_rest_takes_the_distance(braking in any_braking(), room in 0.0..30.0) {
        let fastest = braking.fastest(room, 0.0);
        let gone = distance(braking, fastest, 0.0);
        prop_assert!((gone - room).abs() <= 1e-12 * (1.0 + room), "{gone} of {room}");
    }

    /// Down to a velocity it is no more, and less by no more than that velocity goes in two intervals.
    #[test]
    fn a_ramp_to_a_velocity_takes_no_more(braking in any_braking(), room in 0.0..30.0, last in 0.0..2.0) {
        let fastest = braking.fastest(room, last);
        prop_assert!(fastest >= last);
        if fastest > last {
            let gone = distance(braking, fastest, last);
            prop_assert!(gone <= room + 1e-12 * (1.0 + room), "{gone} of {room}");
            prop_assert!(room - gone <= 2.0 * last * braking.interval + 1e-12 * (1.0 + room), "{gone} of {room}");
        }
    }
}

/// (w + u)² = w² + 2 d s.
#[test]
fn with_samples_close_together_it_is_the_parabola() {
    let braking = Braking { deceleration: 0.3, interval: 1e-7, reaction: 0.0 };
    for (room, last) in [(2.0_f64, 0.0_f64), (2.0, 0.4), (1e-3, 0.0), (50.0, 1.5)] {
        let wanted = (last * last + 2.0 * 0.3 * room).sqrt();
        let found = braking.fastest(room, last);
        assert!((found - wanted).abs() < 1e-6, "{found}, not {wanted}");
    }
}
