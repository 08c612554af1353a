//! State events and time events inside co-simulation steps, against closed forms.

use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::fmi3;

use crate::ball::Ball;
use crate::host::Host;

const G: f64 = 9.81;

/// Height of a ball dropped from 1 m with restitution ½ at a time before it lies.
fn height(t: f64) -> (f64, i32) {
    let mut begin = 0.0;
    let (mut h, mut v) = (1.0_f64, 0.0_f64);
    let mut bounces = 0;
    loop {
        let flight = (v + (v * v + 2.0 * G * h).sqrt()) / G;
        if t < begin + flight {
            let s = t - begin;
            return (h + v * s - 0.5 * G * s * s, bounces);
        }
        begin += flight;
        (h, v) = (0.0, -0.5 * (v - G * flight));
        bounces += 1;
    }
}

#[test]
fn bounces_are_found_inside_steps() {
    // One step over several bounces, and many steps: the events are where they are.
    for step in [0.01, 0.25] {
        let ball = Host::co_simulation();
        ball.initialize();
        let steps = (1.25_f64 / step).round() as usize;
        for n in 0..steps {
            assert_eq!(ball.step(n as f64 * step, step), OK, "{:?}", ball.log);
            let (expected, bounces) = height((n + 1) as f64 * step);
            let found = ball.get("height");
            assert!((found - expected).abs() < 1e-12, "{n}: {found} for {expected}");
            assert_eq!(ball.integer("bounces"), bounces);
        }
        assert_eq!(ball.integer("bounces"), 4);
    }
}

#[test]
fn ticks_fall_on_their_time() {
    let ball = Host::co_simulation();
    assert_eq!(ball.set("tick", 0.1), OK);
    ball.initialize();
    // The end of a step counts, also where the tick, 3 · 0.1, and the end, 0.25 + 0.05, differ in their last bit.
    assert_eq!(ball.step(0.0, 0.25), OK);
    assert_eq!(ball.integer("ticks"), 2);
    assert_eq!(ball.step(0.25, 0.05), OK);
    assert_eq!(ball.integer("ticks"), 3);
    assert_eq!(ball.step(0.3, 0.7), OK);
    assert_eq!(ball.integer("ticks"), 10);
}

#[test]
fn an_input_acts_at_the_begin_of_its_step() {
    let ball = Host::co_simulation();
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.1), OK);
    // Weightless from here: the velocity stays.
    assert_eq!(ball.set("push", G), OK);
    assert_eq!(ball.step(0.1, 0.1), OK);
    let expected = 1.0 - 0.5 * G * 0.01 - G * 0.1 * 0.1;
    assert!((ball.get("height") - expected).abs() < 1e-13);
    // The ground rises through the ball: an event at the begin of the step, though nothing crosses inside it.
    assert_eq!(ball.set("floor", 2.0), OK);
    assert_eq!(ball.step(0.2, 0.001), OK);
    assert_eq!(ball.integer("bounces"), 1);
}

#[test]
fn events_are_logged() {
    let ball = Host::co_simulation();
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.5), OK);
    let fall = (2.0 / G).sqrt();
    let (status, category, text) = &ball.log[0];
    assert_eq!((*status, category.as_str()), (0, "logEvents"));
    let time: f64 = text.split(' ').nth(2).unwrap().parse().unwrap();
    assert!((time - fall).abs() < 1e-14, "{text}");
}

#[test]
fn a_step_returns_early_at_each_event_and_the_host_handles_it() {
    let ball = Host::with_event_mode(true);
    ball.initialize();
    assert_eq!(ball.handle_event(false), None);
    let fall = (2.0 / G).sqrt();
    // Bounces after 1, 2, 2.5 and 2.75 falls.
    let mut t = 0.0;
    for (n, bounce) in [1.0, 2.0, 2.5, 2.75].into_iter().enumerate() {
        let (status, event, early, last) = ball.step_to_event(t, 1.25 - t);
        assert_eq!((status, event, early), (OK, true, true));
        assert!((last - bounce * fall).abs() < 1e-13, "{last} for {}", bounce * fall);
        assert_eq!(ball.integer("bounces"), i32::try_from(n).unwrap(), "the event waits for the host");
        ball.handle_event(true);
        assert_eq!(ball.integer("bounces"), i32::try_from(n).unwrap() + 1);
        t = last;
    }
    assert_eq!(ball.step_to_event(t, 1.25 - t), (OK, false, false, 1.25));
    assert!((ball.get("height") - height(1.25).0).abs() < 1e-12);
}

#[test]
fn without_early_return_only_an_event_at_the_end_is_the_hosts() {
    let ball = Host::with_event_mode(false);
    assert_eq!(ball.set("tick", 0.5), OK);
    ball.initialize();
    assert_eq!(ball.handle_event(false), Some(0.5));
    // The bounce at 0.45 s is handled inside, the tick at the end is not.
    assert_eq!(ball.step_to_event(0.0, 0.5), (OK, true, false, 0.5));
    assert_eq!((ball.integer("bounces"), ball.integer("ticks")), (1, 0));
    assert_eq!(ball.handle_event(true), Some(1.0));
    assert_eq!(ball.integer("ticks"), 1);
    // A host that does not care loses nothing: the next step begins with the event.
    assert_eq!(ball.step_to_event(0.5, 0.5), (OK, true, false, 1.0));
    assert_eq!(ball.step_to_event(1.0, 0.25), (OK, false, false, 1.25));
    assert_eq!(ball.integer("ticks"), 2);
    assert!((ball.get("height") - height(1.25).0).abs() < 1e-12);
}

#[test]
fn event_mode_is_for_those_who_asked_for_it() {
    let ball = Host::co_simulation();
    ball.initialize();
    // SAFETY: an instance.
    assert_eq!(unsafe { fmi3::fmi3EnterEventMode::<Ball>(ball.instance) }, ERROR);
    assert!(ball.last_message().contains("eventModeUsed"), "{}", ball.last_message());
    let ball = Host::with_event_mode(true);
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.1), ERROR, "initialization ends in Event Mode");
}
