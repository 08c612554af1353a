//! What happens between moves: other goals, sensors that fail, a hoist that runs.

use swayless_control::*;

use crate::plant::{FASTEST, STEEPEST};
use crate::rig::{Rig, Row, SAMPLE, between, greatest, judge};

/// The command keeps to its limits, from sample to sample.
fn keeps_its_limits(rows: &[Row]) {
    let fastest = greatest(rows, |row| row.shown.velocity.abs());
    let steepest = rows.windows(2).map(|pair| (pair[1].shown.velocity - pair[0].shown.velocity).abs());
    let steepest = steepest.fold(0.0, f64::max) / SAMPLE;
    assert!(fastest <= FASTEST && steepest <= STEEPEST * (1.0 + 1e-12), "{fastest} m/s, {steepest} m/s²");
}

const FORMS: [Form; 3] = [Form::Planned, Form::InLoop, Form::PlainLoop];

#[test]
fn a_new_target_on_the_way_is_reached_as_well() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.goal = |time| Goal::Position(if time < 3.0 { 5.0 } else { 1.25 });
        let rows = rig.run(60.0);
        keeps_its_limits(&rows);
        let found = judge(&rows, 1.25);
        println!("{form:?}: {found:.2?}");
        assert!(found.error < 2.0 && found.residual < 2.0, "{form:?}: {found:?}");
    }
}

#[test]
fn modes_change_without_a_jump() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.goal = |time| match time {
            ..4.0 => Goal::Velocity(0.6),
            ..8.0 => Goal::Position(1.25),
            ..12.0 => Goal::Hold,
            ..14.0 => Goal::Off,
            ..18.0 => Goal::Velocity(-1e300),
            ..30.0 => Goal::Hold,
            _ => Goal::Position(1.25),
        };
        let rows = rig.run(90.0);
        keeps_its_limits(&rows);
        let off = between(&rows, 13.5, 14.0);
        assert!(off.iter().all(|row| row.shown.velocity == 0.0), "{form:?} commands something while it is off");
        let found = judge(&rows, 1.25);
        println!("{form:?}: {found:.2?}");
        assert!(found.error < 2.0 && found.residual < 5.0, "{form:?}: {found:?}");
    }
}

#[test]
fn without_a_camera_feedback_fades_and_comes_back() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.1);
        rig.goal = |_| Goal::Hold;
        rig.blind[0] = 5.0..15.0;
        let rows = rig.run(70.0);
        keeps_its_limits(&rows);
        let blind = between(&rows, 5.6, 15.0);
        let position_only = 0.14 * greatest(blind, |row| row.trolley.abs());
        assert!(greatest(blind, |row| row.shown.correction.abs()) <= position_only + 0.01, "{form:?}");
        assert!(blind.iter().all(|row| !row.shown.settled), "{form:?}");
        let left = 1e3 * greatest(between(&rows, 60.0, 70.0), |row| row.hook.abs());
        println!("{form:?}: {left:.1} mm");
        assert!(left < 10.0, "{form:?}: {left} mm");
    }
}

#[test]
fn without_a_laser_it_stops_and_goes_on_later() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.goal = |_| Goal::Position(6.0);
        rig.blind[1] = 4.0..16.0;
        let rows = rig.run(80.0);
        keeps_its_limits(&rows);
        let waiting = between(&rows, 14.0, 16.0);
        assert!(greatest(waiting, |row| row.shown.velocity.abs()) < 0.02, "{form:?}");
        assert!(waiting.iter().all(|row| !row.shown.at_target && row.trolley < 5.5), "{form:?}");
        let found = judge(&rows, 6.0);
        println!("{form:?}: {found:.2?}");
        assert!(found.error < 2.0 && found.residual < 3.0, "{form:?}: {found:?}");
    }
}

#[test]
fn a_hoist_that_runs_is_followed() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.goal = |_| Goal::Position(6.0);
        rig.hoisting = |time| if (2.0..12.0).contains(&time) { -0.3 } else { 0.0 };
        let rows = rig.run(80.0);
        keeps_its_limits(&rows);
        let found = judge(&rows, 6.0);
        println!("{form:?}: {found:.2?}");
        assert!(found.error < 2.0 && found.residual < 3.0, "{form:?}: {found:?}");
    }
}

#[test]
fn a_hook_without_payload_is_a_single_pendulum() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.plant.mass_ratio = 0.0;
        rig.settings.crane.pendulum.mass_ratio = 0.0;
        let found = judge(&rig.run(40.0), 1.25);
        println!("{form:?}: {found:.2?}");
        assert!(found.error < 1.0 && found.residual < 2.0, "{form:?}: {found:?}");
    }
}

/// The camera's zero is 20 mm off: the trolley does not run after it.
#[test]
fn a_camera_that_is_not_level_does_not_move_the_trolley() {
    let mut rig = Rig::new(Form::Planned, 0.0);
    rig.plant.state[4..6].fill(0.0);
    let mut control = PositionControl::new();
    let mut plant = rig.plant.clone();
    for i in 0..3000 {
        let time = f64::from(i) * SAMPLE;
        let measured = Measured { hook: Some(plant.hook() + 0.02), position: Some(plant.trolley()) };
        let shown = control.step(time, SAMPLE, &rig.settings, Goal::Position(1.25), measured);
        (0..4).for_each(|_| plant.step(shown.velocity, SAMPLE / 4.0));
    }
    assert!((plant.trolley() - 1.25).abs() < 2e-3, "{} m", plant.trolley());
}

/// Saved and restored in the middle of a move, and copied into a controller that has seen something else, it goes on with
/// the same bits.
#[test]
fn a_saved_controller_goes_on_as_it_would_have() {
    let settings = Rig::new(Form::InLoop, 0.0).settings;
    let measured = |i: u32| Measured { hook: Some(0.1 * f64::from(i).sin()), position: Some(0.01 * f64::from(i % 7)) };
    let step = |control: &mut PositionControl, i: u32| {
        control.step(f64::from(i) * SAMPLE, SAMPLE, &settings, Goal::Position(1.25), measured(i))
    };
    let mut control = PositionControl::new();
    for i in 0..300 {
        step(&mut control, i);
    }
    let bytes = postcard::to_allocvec(&control).expect("bytes");
    let mut restored: PositionControl = postcard::from_bytes(&bytes).expect("a controller");
    let mut copied = PositionControl::new();
    step(&mut copied, 0);
    copied.clone_from(&control);
    for i in 300..500 {
        let wanted = step(&mut control, i);
        assert_eq!((step(&mut restored, i), step(&mut copied, i)), (wanted, wanted));
    }
}

#[test]
fn a_second_sample_at_an_instant_takes_the_place_of_the_first() {
    let settings = Rig::new(Form::Planned, 0.0).settings;
    let measured = Measured { hook: Some(0.2), position: Some(0.0) };
    let other = Measured { hook: Some(-0.4), position: Some(3.0) };
    let run = |again: bool| {
        let mut control = PositionControl::new();
        let mut shown = Shown::default();
        for i in 0..100 {
            let time = 0.013 * f64::from(i);
            if again {
                control.step(time, 0.0, &settings, Goal::Velocity(0.3), other);
            }
            shown = control.step(time, 0.0, &settings, Goal::Position(1.25), measured);
        }
        shown
    };
    assert_eq!(run(true), run(false));
}

/// Far from where the controller thinks it is before the laser has told.
#[test]
fn a_crane_that_starts_anywhere_is_held_there() {
    for form in FORMS {
        let mut rig = Rig::new(form, 0.0);
        rig.plant.state[0] = -17.0;
        rig.goal = |_| Goal::Hold;
        let rows = rig.run(20.0);
        let away = greatest(&rows, |row| (row.trolley + 17.0).abs());
        assert!(away < 0.01, "{form:?}: {away} m");
    }
}
