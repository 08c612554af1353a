//! The emergency stop, the reset, and the record.

use proptest::prelude::*;
use swayless_supervision::{AXES, Observation, State};

use crate::plant::{INTERVAL, Plant, asked, settings};

fn press(plant: &mut Plant) {
    plant.step(Observation { emergency_stop: true, ..asked(0.75) });
}

fn reset(plant: &mut Plant, command: f64) {
    plant.step(asked(command));
    plant.step(Observation { reset: true, ..asked(command) });
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(64) })]

    /// But the reset nothing overrides a stop: every axis comes to rest with its deceleration, and stays.
    #[test]
    fn nothing_but_a_reset_ends_a_stop(
        start in prop::array::uniform4(-1.0..1.0),
        commands in prop::collection::vec(prop::array::uniform4(-2.0..2.0), 100),
        position in prop::array::uniform4(-3.0..12.0),
        valid in any::<bool>(),
        swing in 0.0..1.0,
    ) {
        let mut plant = Plant::new(settings());
        for _ in 0..30 {
            plant.step(Observation { command: start, ..Observation::default() });
        }
        let mut left = plant.supervisor.velocities();
        plant.step(Observation { emergency_stop: true, ..Observation::default() });
        for command in commands.into_iter().flat_map(|command| [command; 5]) {
            let after = plant.supervisor.velocities();
            for axis in 0..AXES {
                let ramp = (left[axis].abs() - plant.settings.axes[axis].deceleration * INTERVAL).max(0.0);
                prop_assert!((after[axis].abs() - ramp).abs() < 1e-12, "axis {axis}: {left:?}, {after:?}");
            }
            left = after;
            prop_assert_eq!(plant.supervisor.state(), State::Stopped);
            if left == [0.0; AXES] {
                // Even a sensor that says anything moves nothing then.
                plant.position = position;
            }
            let position_valid = [valid; AXES];
            plant.step(Observation { command, position_valid, hook_valid: valid, swing, ..Observation::default() });
        }
        prop_assert_eq!(left, [0.0; AXES]);
    }
}

#[test]
fn a_stop_takes_its_time_and_is_reset_at_rest_without_command() {
    let mut plant = Plant::new(settings());
    plant.run(0.75, 1.0);
    press(&mut plant);
    // 0.75/0.5 s.
    let begin = plant.samples;
    while plant.velocity() != 0.0 {
        reset(&mut plant, 0.0);
        assert_eq!(plant.supervisor.state(), State::Stopped, "it still moves");
    }
    assert!((f64::from(plant.samples - begin) * INTERVAL - 1.5).abs() < 3.0 * INTERVAL);
    reset(&mut plant, 1e-9);
    assert_eq!(plant.supervisor.state(), State::Stopped, "there is a command");
    plant.step(Observation { emergency_stop: true, reset: false, ..asked(0.0) });
    plant.step(Observation { emergency_stop: true, reset: true, ..asked(0.0) });
    assert_eq!(plant.supervisor.state(), State::Stopped, "the button is pressed");
    plant.step(Observation { reset: true, ..asked(0.0) });
    assert_eq!(plant.supervisor.state(), State::Stopped, "a reset that stays pressed is no press");
    reset(&mut plant, 0.0);
    assert_eq!(plant.supervisor.state(), State::Ready);
    plant.step(asked(0.75));
    assert_eq!(plant.velocity(), 0.75);
}

#[test]
fn a_reset_that_is_pressed_from_the_start_is_no_press() {
    let mut plant = Plant::new(settings());
    for _ in 0..3 {
        plant.step(Observation { emergency_stop: plant.samples == 0, reset: true, ..asked(0.0) });
    }
    assert_eq!(plant.supervisor.state(), State::Stopped);
}

#[test]
fn drives_and_events_are_recorded_and_for_a_while_what_follows() {
    let mut plant = Plant::new(settings());
    plant.run(0.0, 1.0);
    assert!(!plant.supervisor.records());
    plant.run(0.5, 1.0);
    assert!(plant.supervisor.records());
    plant.run(0.0, 9.9);
    assert!(plant.supervisor.records());
    plant.run(0.0, 0.2);
    assert!(!plant.supervisor.records() && plant.supervisor.events() == 0);
    press(&mut plant);
    assert!(plant.supervisor.records() && plant.supervisor.events() == 1);
    // A lever that is held meanwhile makes no drive of it.
    plant.run(0.5, 10.1);
    assert!(!plant.supervisor.records());
    reset(&mut plant, 0.0);
    assert!(plant.supervisor.records() && plant.supervisor.events() == 2);
}

#[test]
fn a_second_sample_at_an_instant_takes_the_place_of_the_first() {
    let mut once = Plant::new(settings());
    once.run(0.5, 0.5);
    let mut twice = Plant { supervisor: once.supervisor, ..Plant::new(settings()) };
    (twice.samples, twice.position) = (once.samples, once.position);
    let position = twice.position;
    twice.step(Observation { emergency_stop: true, hook_valid: false, ..asked(-0.5) });
    (twice.samples, twice.position) = (once.samples, position);
    once.step(asked(0.6));
    twice.step(asked(0.6));
    assert_eq!(once.supervisor, twice.supervisor);
}
