//! Moves to a target and pushes on the load, through drive, camera and laser.

use swayless_control::*;

use crate::plant::{FASTEST, FREQUENCY};
use crate::rig::{Rig, envelope, judge};

/// What a crane is told of lengths that are 8 m and 3 m (m), and of the drive's frequency that is 3.7 rad/s.
const WRONG: [[f64; 3]; 6] =
    [[6.4, 2.4, 3.7], [9.6, 3.6, 3.7], [9.6, 2.4, 3.7], [6.4, 3.6, 3.7], [8.0, 3.0, 3.0], [8.0, 3.0, 4.4]];

fn told(form: Form, swing: f64, [hoist, rigging, natural_frequency]: [f64; 3]) -> Rig {
    let mut rig = Rig::new(form, swing);
    let crane = &mut rig.settings.crane;
    (crane.pendulum.hoist, crane.pendulum.rigging) = (hoist, rigging);
    crane.drive.natural_frequency = natural_frequency;
    rig
}

#[test]
fn a_planned_move_is_accurate_and_still_within_ten_seconds() {
    let found = judge(&Rig::new(Form::Planned, 0.0).run(30.0), 1.25);
    println!("{found:.2?}");
    assert!(found.error < 1.0 && found.residual < 2.0 && found.overshoot < 8.0 && found.settled < 8.0, "{found:?}");
}

#[test]
fn a_move_with_the_shaper_in_the_loop_is_as_accurate_and_as_fast() {
    let found = judge(&Rig::new(Form::InLoop, 0.0).run(30.0), 1.25);
    println!("{found:.2?}");
    assert!(found.error < 1.0 && found.residual < 2.0 && found.overshoot < 8.0 && found.settled < 9.0, "{found:?}");
}

/// Shaper, drive and sway feedback delay the loop by 2.5 s: more than K_p = 1/(e · 2.5 s) = 0.147 1/s overshoots.
#[test]
fn without_a_prediction_the_delay_of_the_shaper_makes_it_slow_or_overshoot() {
    let found = judge(&Rig::new(Form::PlainLoop, 0.0).run(40.0), 1.25);
    println!("{found:.2?}");
    assert!(found.error < 1.0 && found.residual < 2.0 && found.overshoot < 8.0, "{found:?}");
    assert!((15.0..25.0).contains(&found.settled), "{found:?}");
    let mut hasty = Rig::new(Form::PlainLoop, 0.0);
    hasty.settings.feedback.position_gain = 0.25;
    let found = judge(&hasty.run(40.0), 1.25);
    println!("{found:.2?}");
    assert!((100.0..200.0).contains(&found.overshoot), "{found:?}");
}

/// Nothing winds up: moves that run long at the limit, one whose sway feedback is cut, and one with so much gain that the
/// acceleration limit would not let it stop in time, end without overshoot.
#[test]
fn limits_do_not_wind_the_loop_up() {
    for (velocity, correction, gain) in
        [(FASTEST, 0.35, 1.5), (0.2, 0.35, 1.5), (FASTEST, 0.05, 1.5), (FASTEST, 0.35, 5.0)]
    {
        let mut rig = Rig::new(Form::InLoop, 0.0);
        (rig.settings.limits.velocity, rig.settings.correction_limit) = (velocity, correction);
        rig.settings.feedback.position_gain = gain;
        rig.goal = |_| Goal::Position(8.0);
        let found = judge(&rig.run(8.0 / velocity + 30.0), 8.0);
        println!("{velocity} m/s, {correction} m/s, {gain} 1/s: {found:.2?}");
        assert!(found.error < 2.0 && found.residual < 5.0 && found.overshoot < 8.0, "{found:?}");
        assert!(found.settled < 8.0 / velocity + 20.0, "{found:?}");
    }
}

/// The rows are those of plain feedback with k = 2 of a swing that is seen at once.
const PLAIN: [f64; 3] = [242.4, 122.8, 39.2];

#[test]
fn a_push_decays_faster_than_with_plain_feedback_that_sees_at_once() {
    for (form, goal) in [
        (Form::Planned, (|_| Goal::Hold) as fn(f64) -> Goal),
        (Form::Planned, |_| Goal::Velocity(0.0)),
        (Form::InLoop, |_| Goal::Hold),
        (Form::PlainLoop, |_| Goal::Hold),
    ] {
        let mut rig = Rig::new(form, 0.1);
        rig.goal = goal;
        let rows = rig.run(50.0);
        let found = envelope(&rows);
        println!("{form:?}, {:?}: {found:.1?} mm", goal(0.0));
        assert!(found.iter().zip(PLAIN).all(|(found, plain)| *found < 0.6 * plain), "{found:?} mm");
    }
}

/// The same gains without the observer: a swing that is 0.1 s late, with no lead.
#[test]
fn plain_feedback_of_a_late_swing_is_too_slow() {
    let mut rig = Rig::new(Form::Planned, 0.1);
    rig.goal = |_| Goal::Velocity(0.0);
    rig.settings.feedback = Feedback { position_gain: 0.0, sway_gain: 2.0, lead_time: 0.0 };
    rig.settings.hook_latency = 0.0;
    let found = envelope(&rig.run(50.0));
    println!("{found:.1?} mm");
    assert!(found[0] > PLAIN[0], "{found:?} mm");
}

#[test]
fn lengths_and_drive_may_be_wrong_by_a_fifth() {
    for wrong in WRONG {
        let mut moves = Vec::new();
        for form in [Form::Planned, Form::InLoop] {
            let found = judge(&told(form, 0.0, wrong).run(60.0), 1.25);
            assert!(found.error < 5.0 && found.residual < 5.0, "{form:?}, {wrong:?}: {found:?}");
            moves.push(found);
        }
        let decays = [Form::Planned, Form::InLoop].map(|form| {
            let mut pushed = told(form, 0.1, wrong);
            pushed.goal = |_| Goal::Hold;
            envelope(&pushed.run(50.0))
        });
        println!("{wrong:?}: {moves:.1?} {decays:.1?}");
        for decay in decays {
            assert!(decay.iter().zip(PLAIN).all(|(found, plain)| *found < plain), "{wrong:?}: {decay:?}");
        }
    }
}

/// The prediction rests on the drive; it may be twice as fast or half as fast as the controller thinks.
#[test]
fn the_prediction_bears_a_drive_that_is_wrong_by_a_factor_of_two() {
    for natural_frequency in [0.5 * FREQUENCY, 2.0 * FREQUENCY] {
        let found = judge(&told(Form::InLoop, 0.0, [8.0, 3.0, natural_frequency]).run(60.0), 1.25);
        println!("{natural_frequency} rad/s: {found:.2?}");
        assert!(
            found.error < 1.0 && found.residual < 2.0 && found.overshoot < 50.0 && found.settled < 25.0,
            "{found:?}"
        );
    }
}
