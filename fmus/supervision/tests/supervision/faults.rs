//! Sensors that fail.

use swayless_supervision::{AXES, Fault, Finding, Observation, State, Supervisor, Times};

use crate::plant::{INTERVAL, Plant, asked, settings};

/// Steps for so long (s) with something seen.
fn run(plant: &mut Plant, seen: Observation, time: f64) {
    for _ in 0..(time / INTERVAL).round() as u32 {
        plant.step(seen);
    }
}

fn blind(command: f64) -> Observation {
    Observation { position_valid: [false, true, true, true], ..asked(command) }
}

#[test]
fn a_short_dropout_is_held_and_a_long_one_is_a_fault() {
    let mut plant = Plant::new(settings());
    plant.run(0.4, 1.0);
    run(&mut plant, blind(0.7), 0.48);
    assert_eq!((plant.velocity(), plant.supervisor.state()), (0.4, State::Limited), "it goes on, no faster");
    plant.run(0.4, 0.1);
    assert_eq!(plant.supervisor.state(), State::Ready);
    run(&mut plant, blind(0.4), 0.5);
    assert_eq!(plant.supervisor.state(), State::Ready);
    run(&mut plant, blind(0.4), 2.0 * INTERVAL);
    assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::PositionInvalid, axis: 1 });
    assert!(plant.velocity() > 0.0, "the stop is controlled");
    plant.run(0.4, 1.0);
    assert_eq!((plant.velocity(), plant.supervisor.state()), (0.0, State::Fault), "and it is latched");
}

#[test]
fn a_fault_is_not_reset_before_the_sensor_is_back() {
    let mut plant = Plant::new(settings());
    run(&mut plant, blind(0.0), 1.0);
    plant.step(Observation { reset: true, ..blind(0.0) });
    assert_eq!(plant.supervisor.state(), State::Fault);
    plant.step(asked(0.0));
    plant.step(Observation { reset: true, ..asked(0.0) });
    assert_eq!((plant.supervisor.state(), plant.supervisor.finding()), (State::Ready, Finding::NONE));
}

#[test]
fn nothing_moves_before_its_position_has_been_seen() {
    let mut plant = Plant::new(settings());
    plant.step(blind(0.5));
    assert_eq!((plant.velocity(), plant.supervisor.state()), (0.0, State::Limited));
    plant.step(asked(0.5));
    assert_eq!(plant.velocity(), 0.5);
}

#[test]
fn an_axis_stops_at_its_end_in_a_dropout() {
    let mut settings = settings();
    settings.within.fault_time = 60.0;
    let mut plant = Plant::new(settings);
    plant.run(0.75, 1.0);
    run(&mut plant, blind(0.75), 30.0);
    assert!((plant.position[0] - 10.0).abs() < 1e-12 && plant.velocity() == 0.0, "{:?}", plant.position);
}

#[test]
fn a_hook_out_of_sight_keeps_its_swing_and_then_is_a_fault() {
    let mut plant = Plant::new(settings());
    plant.step(Observation { swing: 0.4, ..asked(0.0) });
    let unseen = Observation { hook_valid: false, swing: 0.0, ..asked(0.75) };
    run(&mut plant, unseen, 0.5);
    assert_eq!((plant.velocity(), plant.supervisor.state()), (0.75 * 0.25, State::Limited));
    run(&mut plant, unseen, 2.0 * INTERVAL);
    assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::HookInvalid, axis: 0 });
}

/// At 0.75 m/s an axis goes 15 mm from sample to sample, and half a second more is believed.
#[test]
fn a_jump_is_not_believed_and_then_is_a_fault() {
    let mut plant = Plant::new(settings());
    plant.run(0.5, 0.4);
    let true_position = plant.position[0];
    plant.position[0] += 0.38;
    plant.step(asked(0.5));
    assert!((plant.supervisor.finding(), plant.velocity()) == (Finding::NONE, 0.5), "that far it may jump");
    plant.position[0] = true_position - 2.0;
    plant.step(asked(0.7));
    assert_eq!(plant.velocity(), 0.5, "as in a dropout");
    plant.run(0.5, 0.2);
    plant.position[0] = true_position + 0.5;
    plant.run(0.5, 0.5);
    assert_eq!(plant.supervisor.state(), State::Ready, "it has come back");
    plant.position[0] -= 2.0;
    plant.run(0.5, 0.7);
    assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::PositionImplausible, axis: 1 });
}

/// An importer that sets its inputs after initialization: the first sample saw what they are declared to be.
#[test]
fn what_the_first_sample_saw_is_no_measure() {
    let mut plant = Plant::new(settings());
    plant.position[0] = 0.0;
    plant.step(asked(0.0));
    plant.position[0] = 4.0;
    plant.run(0.0, 1.0);
    assert_eq!(plant.supervisor.finding(), Finding::NONE);
    plant.run(0.5, 0.4);
    assert_eq!(plant.velocity(), 0.5);
    // From then on it is one.
    plant.position[0] = 0.0;
    plant.run(0.5, 1.0);
    assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::PositionImplausible, axis: 1 });
}

/// What does not move is found when it should have gone 2 s at full speed, however fast that is.
#[test]
fn an_axis_that_does_not_move_is_a_fault() {
    for command in [0.75, 0.1] {
        let mut plant = Plant::new(settings());
        let stays = plant.position;
        let time = 2.0 * 0.75 / command;
        let held = |plant: &mut Plant, time: f64| {
            for _ in 0..(time / INTERVAL).round() as u32 {
                plant.step(asked(command));
                // Half of the 2 % that count as standing still.
                plant.position = stays;
                plant.position[0] += 0.015 * f64::from(plant.samples % 2);
            }
        };
        held(&mut plant, time - 2.0 * INTERVAL);
        assert_eq!(plant.supervisor.state(), State::Ready);
        held(&mut plant, 5.0 * INTERVAL);
        assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::PositionFrozen, axis: 1 }, "{command}");
    }
}

#[test]
fn what_is_no_number_is_a_fault_and_what_comes_out_is_one() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.1e9, f64::MIN] {
        let cases = [
            Observation { command: [0.1, wrong, 0.0, 0.0], ..Observation::default() },
            Observation { swing: wrong, ..Observation::default() },
        ];
        for (case, axis) in cases.into_iter().zip([2, 0]) {
            let mut plant = Plant::new(settings());
            plant.run(0.5, 0.1);
            plant.step(case);
            assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::Input, axis });
            assert!(plant.supervisor.velocities().iter().all(|velocity| velocity.is_finite()));
        }
        // A position is one that the axis cannot have.
        let mut plant = Plant::new(settings());
        plant.position[2] = wrong;
        run(&mut plant, asked(0.5), 0.6);
        assert_eq!(plant.supervisor.finding(), Finding { fault: Fault::PositionImplausible, axis: 3 });
        assert!(plant.supervisor.velocities()[2] == 0.0);
    }
}

/// Without an interval the next sample is expected as far away as the last, and before there are two nothing moves.
#[test]
fn without_an_interval_it_goes_by_the_last() {
    let mut supervisor = Supervisor::default();
    let mut position = 5.0;
    let mut sample = |now: f64, command: f64| {
        let seen = Observation { position: [position, 0.0, 1.0, 4.2], ..asked(command) };
        supervisor.sample(Times { now, interval: 0.0 }, &settings(), &seen);
        position += supervisor.velocities()[0] * 0.05;
        (supervisor.velocities()[0], position)
    };
    assert_eq!(sample(0.0, 0.7).0, 0.0);
    assert_eq!(sample(0.05, 0.7).0, 0.7);
    let (velocity, position) = (2..600).map(|i| sample(f64::from(i) * 0.05, 0.7)).last().expect("samples");
    assert!(velocity.abs() < 1e-9 && (position - 10.0).abs() < 1e-9, "{velocity}, {position}");
    assert_eq!(AXES, 4);
}
