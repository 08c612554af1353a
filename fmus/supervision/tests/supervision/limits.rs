//! Whatever is commanded, seen or pressed: no axis is too fast, leaves its range, or is slowed down harder than it may be.

use proptest::prelude::*;
use swayless_supervision::{AXES, Observation, State};

use crate::plant::{INTERVAL, Plant, asked, settings};

/// How exact a position is (m).
const EXACT: f64 = 1e-12;

/// Something that is seen for some samples.
fn any_spell() -> impl Strategy<Value = (Observation, u32)> {
    let command = prop::array::uniform4(prop_oneof![Just(0.0), -1.5..1.5, -0.05..0.05]);
    let sees = || prop::bool::weighted(0.95);
    let rarely = || prop::bool::weighted(0.04);
    let switches = (rarely(), prop::bool::weighted(0.3));
    (command, prop::array::uniform4(sees()), sees(), 0.0..0.4, switches, 1_u32..120).prop_map(
        |(command, position_valid, hook_valid, swing, (emergency_stop, reset), samples)| {
            let position = [0.0; AXES];
            let seen = Observation { command, position, position_valid, hook_valid, swing, emergency_stop, reset };
            (seen, samples)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(128) })]

    #[test]
    fn no_sequence_of_commands_leaves_the_limits(
        spells in prop::collection::vec(any_spell(), 1..40),
        slow_zone in prop_oneof![Just(0.0), 0.0..1.5],
        reaction in prop_oneof![Just(0.0), 0.0..0.5],
    ) {
        let mut plant = Plant::new(swayless_supervision::Settings { slow_zone, reaction, ..settings() });
        for (seen, samples) in spells {
            for _ in 0..samples {
                let from = plant.position;
                let [before, after] = plant.step(seen);
                let held = matches!(plant.supervisor.state(), State::Stopped | State::Fault);
                for axis in 0..AXES {
                    let limits = plant.settings.axes[axis];
                    let (was, is) = (before[axis], after[axis]);
                    prop_assert!(is.abs() <= limits.velocity, "axis {axis} at {is}");
                    let range = limits.position_min - EXACT..=limits.position_max + EXACT;
                    prop_assert!(range.contains(&plant.position[axis]), "axis {axis} at {}", plant.position[axis]);
                    // Towards an end and faster than slow, it does not get into the zone before the next sample.
                    let room = |position: f64| match is > 0.0 {
                        true => limits.position_max - position,
                        false => position - limits.position_min,
                    };
                    let slow = plant.settings.slow_share * limits.velocity;
                    prop_assert!(
                        slow_zone == 0.0 || is.abs() <= slow || room(plant.position[axis]) >= slow_zone - EXACT,
                        "axis {axis} at {is}, from {}", from[axis]
                    );
                    // What slows it down by more than the deceleration is the command alone.
                    let ramp = (was.abs() - limits.deceleration * INTERVAL).max(0.0);
                    let kept = if was == 0.0 { is.abs() } else { is * was.signum() };
                    let asked = if held { 0.0 } else { seen.command[axis] * was.signum() };
                    prop_assert!(kept >= ramp.min(asked) - EXACT, "axis {axis} from {was} to {is}");
                    prop_assert!(!held || kept <= ramp + EXACT, "axis {axis} from {was} to {is}");
                    // And nothing makes it go where it has not been told to.
                    prop_assert!(held || is == 0.0 || is * seen.command[axis] > 0.0, "axis {axis} at {is}");
                }
            }
        }
    }
}

#[test]
fn an_axis_stops_at_its_end_and_may_go_back_at_once() {
    let mut plant = Plant::new(settings());
    plant.run(2.0, 30.0);
    assert!((plant.position[0] - 10.0).abs() < EXACT && plant.velocity() == 0.0, "{:?}", plant.position);
    assert_eq!(plant.supervisor.state(), State::Limited);
    plant.step(asked(-0.75));
    assert_eq!((plant.velocity(), plant.supervisor.state()), (-0.75, State::Ready));
}

/// Full speed, down to slow with the deceleration, slow through the zone: v²/2d and v h/2 of the staircase.
#[test]
fn an_axis_is_slow_in_the_zone_and_no_earlier_than_it_must() {
    let mut plant = Plant::new(settings());
    let (full, slow, deceleration, zone) = (0.75, 0.75 * 0.25, 0.5, 0.3);
    plant.run(full, 1.0);
    let mut brakes = None;
    while plant.position[0] < 10.0 - zone {
        let from = plant.position[0];
        plant.step(asked(full));
        if plant.velocity() < full && brakes.is_none() {
            brakes = Some(from);
        }
    }
    assert_eq!(plant.velocity(), slow);
    let ramp = (full * full - slow * slow) / (2.0 * deceleration);
    let wanted = 10.0 - zone - ramp;
    let found = brakes.expect("it brakes");
    // Two intervals before, and one because it is noticed at a sample.
    assert!((-3.0 * full * INTERVAL..=0.0).contains(&(found - wanted)), "{found}, not {wanted}");
}

#[test]
fn an_axis_beyond_its_end_may_only_go_back() {
    let mut plant = Plant::new(settings());
    plant.position[0] = 10.7;
    plant.step(asked(0.1));
    assert_eq!((plant.velocity(), plant.supervisor.state()), (0.0, State::Limited));
    plant.step(asked(-0.4));
    assert_eq!((plant.velocity(), plant.supervisor.state()), (-0.4, State::Ready));
}

#[test]
fn what_swings_too_far_is_not_sped_up_but_goes_on_and_may_creep() {
    let mut plant = Plant::new(settings());
    let swings = |command| Observation { swing: 0.31, ..asked(command) };
    let slow = 0.75 * 0.25;
    plant.step(swings(0.75));
    assert_eq!((plant.velocity(), plant.supervisor.state()), (slow, State::Limited));
    plant.step(asked(0.5));
    plant.step(swings(0.75));
    assert_eq!(plant.velocity(), 0.5, "no faster than it was");
    plant.step(swings(0.3));
    plant.step(swings(0.5));
    assert_eq!(plant.velocity(), 0.3);
    plant.step(swings(-0.75));
    assert_eq!(plant.velocity(), -slow, "the other way no faster than slow");
    plant.step(Observation { swing: 0.3, ..asked(-0.75) });
    assert_eq!((plant.velocity(), plant.supervisor.state()), (-0.75, State::Ready));
}
