//! Communication points.

use proptest::prelude::*;

use super::*;

fn clock(start: f64, stop: f64, step_size: f64) -> Result<Clock> {
    let options =
        Options { start_time: Some(start), stop_time: Some(stop), step_size: Some(step_size), ..Options::default() };
    Clock::of(&System::new("none"), &options)
}

#[test]
fn rounding_makes_no_extra_step() {
    for (stop, step, steps) in
        [(60.0, 0.1, 600), (0.3, 0.1, 3), (1.0, 1.0 / 3.0, 3), (20.0, 0.001, 20_000), (1.0, 0.3, 4)]
    {
        assert_eq!(clock(0.0, stop, step).unwrap().steps, steps);
    }
}

#[test]
fn without_anything_said_a_run_is_a_thousand_steps_of_a_second() {
    let clock = Clock::of(&System::new("none"), &Options::default()).unwrap();
    assert_eq!((clock.start, clock.stop, clock.steps), (0.0, 1.0, 1000));
}

proptest! {
    #[test]
    fn steps_lead_from_start_to_stop(start in -100.0..100.0f64, length in 0.001..100.0f64, step in 0.001..10.0f64) {
        let clock = clock(start, start + length, step).unwrap();
        prop_assert_eq!(clock.step(0).0, start);
        prop_assert_eq!(clock.step(clock.steps - 1).2, clock.stop);
        prop_assert!(clock.is_sampled(0) && clock.is_sampled(clock.steps));
        for index in 0..clock.steps.min(1000) {
            let (time, size, next) = clock.step(index);
            prop_assert!(size > 0.0 && size <= step * (1.0 + 1e-9));
            prop_assert!((time + size - next).abs() <= 1e-6 * step);
        }
    }
}
