//! Moves to a target and pushes on the load, through drive, camera and laser.

use swayless_control::*;

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
fn a_move_with_the_shaper_in_the_loop_is_as_accurate_but_slower() {
    let found = judge(&Rig::new(Form::InLoop, 0.0).run(40.0), 1.25);
    println!("{found:.2?}");
    assert!(found.error < 1.0 && found.residual < 2.0 && found.overshoot < 8.0, "{found:?}");
    assert!((15.0..25.0).contains(&found.settled), "{found:?}");
    // With more gain than the shaper's delay allows it overshoots.
    let mut hasty = Rig::new(Form::InLoop, 0.0);
    hasty.settings.feedback.position_gain = 0.25;
    let found = judge(&hasty.run(40.0), 1.25);
    println!("{found:.2?}");
    assert!((100.0..200.0).contains(&found.overshoot), "{found:?}");
}

/// The rows are those of plain feedback with k = 2 of a swing that is seen at once.
const PLAIN: [f64; 3] = [242.4, 122.8, 39.2];

#[test]
fn a_push_decays_faster_than_with_plain_feedback_that_sees_at_once() {
    for (form, goal) in [
        (Form::Planned, (|_| Goal::Hold) as fn(f64) -> Goal),
        (Form::Planned, |_| Goal::Velocity(0.0)),
        (Form::InLoop, |_| Goal::Hold),
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
        let planned = judge(&told(Form::Planned, 0.0, wrong).run(60.0), 1.25);
        let in_loop = judge(&told(Form::InLoop, 0.0, wrong).run(60.0), 1.25);
        let mut pushed = told(Form::Planned, 0.1, wrong);
        pushed.goal = |_| Goal::Hold;
        let decay = envelope(&pushed.run(50.0));
        println!("{wrong:?}: {planned:.1?} {in_loop:.1?} {decay:.1?}");
        for found in [planned, in_loop] {
            assert!(found.error < 5.0 && found.residual < 5.0, "{wrong:?}: {found:?}");
        }
        assert!(decay.iter().zip(PLAIN).all(|(found, plain)| *found < plain), "{wrong:?}: {decay:?}");
    }
}
