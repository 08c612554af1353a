//! Commands shaped while they change, against the plain double sum over changes and impulses.

use proptest::prelude::*;
use swayless_shaping::{Design, Kind, Shaper, Trains};

use crate::{designed, shaper};

/// One change of the command: when, to what, shaped how.
#[derive(Clone, Debug)]
struct Change {
    time: f64,
    command: f64,
    shaper: Shaper,
}

fn changes() -> impl Strategy<Value = Vec<Change>> {
    let shaper = (proptest::sample::select(Kind::OF_A_MODE.to_vec()), 0.5..8.0_f64, 0.0..0.25_f64)
        .prop_map(|(kind, frequency, zeta)| designed(kind, frequency, zeta));
    let change = (0.0..0.7_f64, -2.0..2.0_f64, shaper);
    proptest::collection::vec(change, 1..60).prop_map(|gaps| {
        let mut now = 0.0;
        let mut change = |(gap, command, shaper)| {
            now += gap;
            Change { time: now, command, shaper }
        };
        gaps.into_iter().map(&mut change).collect()
    })
}

/// Σ over changes and impulses of Δ·Aᵢ for all that is due.
fn expected(changes: &[Change], start: f64, time: f64) -> f64 {
    let before = std::iter::once(start).chain(changes.iter().map(|change| change.command));
    let deltas = changes.iter().zip(before).map(|(change, before)| (change, change.command - before));
    start
        + deltas
            .flat_map(|(change, delta)| {
                change.shaper.impulses().iter().map(move |i| (change.time + i.time, delta * i.amplitude))
            })
            .filter(|(due, _)| *due <= time)
            .map(|(_, amount)| amount)
            .sum::<f64>()
}

/// The shaped command at each of the times, which ascend.
fn shaped(changes: &[Change], start: f64, times: &[f64]) -> Vec<f64> {
    let mut trains = Trains::new(start, 8);
    let mut rest = changes;
    let values = times.iter().map(|&time| {
        while let [change, later @ ..] = rest
            && change.time <= time
        {
            trains.set_command(change.time, change.command, &change.shaper.clone().into());
            rest = later;
        }
        trains.advance(time)
    });
    values.collect()
}

fn sample(step: f64, count: usize) -> Vec<f64> {
    (0..count).map(|n| n as f64 * step).collect()
}

/// 60 changes of at most 4 with at most 5 impulses, each rounded
const ROUNDING: f64 = 1e-12;

proptest! {
    #[test]
    fn every_impulse_comes_at_its_time(changes in changes(), start in -1.0..1.0_f64, step in 0.003..0.5_f64) {
        let times = sample(step, 200);
        for (value, &time) in shaped(&changes, start, &times).into_iter().zip(&times) {
            prop_assert!((value - expected(&changes, start, time)).abs() < ROUNDING);
        }
    }

    #[test]
    fn ends_at_the_command_to_the_bit(changes in changes(), start in -1.0..1.0_f64) {
        let end = shaped(&changes, start, &[1000.0])[0];
        prop_assert_eq!(end.to_bits(), changes[changes.len() - 1].command.to_bits());
    }

    #[test]
    fn trains_for_braking_and_accelerating_end_at_the_command_to_the_bit(changes in changes()) {
        let mut trains = Trains::new(0.0, 8);
        for (n, pair) in changes.windows(2).enumerate() {
            let [one, other] = [&pair[0].shaper, &pair[1].shaper].map(Clone::clone);
            let design = if n % 3 == 0 { Design::alone(one) } else { Design::of_both(one, other) };
            trains.set_command(pair[0].time, pair[0].command, &design);
            prop_assert!(trains.pending().map(|pending| pending.time).is_sorted());
        }
        let end = trains.command();
        prop_assert_eq!(trains.advance(1000.0).to_bits(), end.to_bits());
        prop_assert!(!trains.interfere(1000.0));
    }

    #[test]
    fn step_size_does_not_matter(changes in changes(), step in 0.003..0.5_f64) {
        let fine = sample(step, 200);
        let coarse: Vec<_> = fine.iter().copied().step_by(7).collect();
        let every_seventh: Vec<_> = shaped(&changes, 0.0, &fine).into_iter().step_by(7).collect();
        prop_assert_eq!(every_seventh, shaped(&changes, 0.0, &coarse));
    }

    #[test]
    fn shaping_is_linear(changes in changes(), other in proptest::collection::vec(-2.0..2.0_f64, 60), factor in -3.0..3.0_f64) {
        let times = sample(0.05, 400);
        let with = |value: &dyn Fn(usize, f64) -> f64| {
            let mut all = changes.clone();
            all.iter_mut().enumerate().for_each(|(n, change)| change.command = value(n, change.command));
            shaped(&all, 0.0, &times)
        };
        let one = with(&|_, command| command);
        let two = with(&|n, _| other[n]);
        let both = with(&|n, command| command + factor * other[n]);
        for n in 0..times.len() {
            prop_assert!((both[n] - one[n] - factor * two[n]).abs() < 10.0 * ROUNDING);
        }
    }

    #[test]
    fn pending_impulses_stay_in_order(changes in changes()) {
        let mut trains = Trains::new(0.0, 8);
        for change in &changes {
            trains.set_command(change.time, change.command, &change.shaper.clone().into());
            prop_assert!(trains.pending().map(|pending| pending.time).is_sorted());
            prop_assert!(trains.pending().all(|pending| pending.time > change.time));
            prop_assert_eq!(trains.next_time(), trains.pending().next().map(|pending| pending.time));
        }
    }

    #[test]
    fn positive_shapers_stay_within_the_command_range(commands in proptest::collection::vec(-1.0..1.0_f64, 1..40)) {
        let zvd = designed(Kind::ZVD, 2.0, 0.05);
        let all = commands.iter().enumerate();
        let changes: Vec<_> =
            all.map(|(n, &command)| Change { time: 0.13 * n as f64, command, shaper: zvd.clone() }).collect();
        for value in shaped(&changes, 0.0, &sample(0.05, 300)) {
            prop_assert!(value.abs() <= 1.0 + ROUNDING);
        }
    }
}

#[test]
fn an_impulse_at_the_end_of_a_step_is_in_it() {
    let halves = Design::from(shaper([(0.0, 0.5), (0.3, 0.5)]));
    for start in [0.0, 0.1, 0.7, 12.3, 1e6] {
        let mut trains = Trains::new(0.0, 4);
        assert_eq!(trains.set_command(start, 1.0, &halves), 0.5);
        assert_eq!(trains.next_time(), Some(start + 0.3));
        assert_eq!(trains.advance(start + 0.299_999), 0.5);
        assert_eq!(trains.advance(start + 0.3), 1.0);
        assert_eq!(trains.next_time(), None);
    }
}

#[test]
fn rounding_does_not_delay_an_impulse_by_a_step() {
    // n·h and t₀ + tᵢ mean the same time, but 0.1 + 0.2 rounds up and 3 × 0.1 too, whereas 0.3 does not
    let mut trains = Trains::new(0.0, 4);
    trains.set_command(0.1, 1.0, &shaper([(0.0, 0.5), (0.2, 0.5)]).into());
    assert!(trains.next_time().unwrap() > 0.3);
    assert_eq!(trains.advance(0.3), 1.0);
}

#[test]
fn unshaped_changes_pass_at_once_and_live_trains_finish() {
    let mut trains = Trains::new(0.0, 4);
    trains.set_command(0.0, 1.0, &shaper([(0.0, 0.25), (1.0, 0.75)]).into());
    assert_eq!(trains.set_command(0.5, 3.0, &Design::unshaped()), 2.25);
    assert_eq!((trains.command(), trains.value(), trains.pending().len()), (3.0, 2.25, 1));
    assert_eq!(trains.advance(1.0), 3.0);
}

#[test]
fn a_repeated_command_spawns_nothing() {
    let mut trains = Trains::new(2.0, 4);
    assert_eq!(trains.set_command(1.0, 2.0, &designed(Kind::ZV, 1.0, 0.0).into()), 2.0);
    assert_eq!(trains.next_time(), None);
}

#[test]
fn a_ramp_of_an_hour_neither_drifts_nor_allocates() {
    let (zvd, step) = (Design::from(designed(Kind::ZVD, 1.0, 0.01)), 0.01);
    let mut trains = Trains::new(0.0, 1500);
    let room = trains.capacity();
    let mut command = 0.0;
    for n in 0..360_000 {
        let time = f64::from(n) * step;
        command = 1e-3 * time * (1.0 + (0.3 * time).sin());
        trains.set_command(time, command, &zvd);
    }
    assert_eq!(trains.capacity(), room);
    assert!(trains.pending().len() > 900, "{}", trains.pending().len());
    // what is passed on and what is pending make up the command, to the rounding of one sum
    let pending: f64 = trains.pending().map(|pending| pending.amount).sum();
    assert!((trains.value() + pending - command).abs() < 1e-13);
    assert_eq!(trains.advance(1e6), command);
}

/// The rule of UMZVc, by hand: growing from 0 and on, shrinking, changing sign, shrinking to 0.
#[test]
fn braking_has_its_own_train() {
    let up = shaper([(0.0, 1.0), (2.0, -1.0), (4.0, 1.0)]);
    let down = shaper([(0.0, 1.0), (1.0, -1.0), (5.0, 1.0)]);
    let both = Design::of_both(up, down);
    assert_eq!(both.duration(), 5.0);
    let mut trains = Trains::new(0.0, 16);
    for (start, before, command, expected) in [
        (0.0, 0.0, -2.0, [(0.0, -2.0), (2.0, 0.0), (4.0, -2.0)].as_slice()),
        (10.0, -2.0, -3.0, &[(0.0, -3.0), (2.0, -2.0), (4.0, -3.0)]),
        (20.0, -3.0, -1.0, &[(0.0, -1.0), (1.0, -3.0), (5.0, -1.0)]),
        // −(−1) by the braking train and +4 by the accelerating one
        (30.0, -1.0, 4.0, &[(0.0, 4.0), (1.0, 3.0), (2.0, -1.0), (4.0, 3.0), (5.0, 4.0)]),
        (40.0, 4.0, 0.0, &[(0.0, 0.0), (1.0, 4.0), (5.0, 0.0)]),
    ] {
        assert_eq!(trains.value(), before);
        let first = trains.set_command(start, command, &both);
        assert_eq!(first, expected[0].1);
        assert_eq!(trains.pending().len(), expected.len() - 1);
        for &(time, value) in expected {
            assert_eq!(trains.advance(start + time), value, "{command} at {time}");
        }
    }
}

#[test]
fn trains_interfere_while_they_overlap_unless_they_add_up() {
    let train = shaper([(0.0, 0.5), (2.0, 0.5)]);
    let mut trains = Trains::new(0.0, 16);
    let alone = Design::alone(train.clone());
    trains.set_command(-10.0, 1.0, &alone);
    assert!(!trains.interfere(-10.0));
    // one that ends when the other begins does not overlap it
    trains.set_command(-8.0, 0.0, &alone);
    assert!(!trains.interfere(-8.0));
    trains.set_command(-7.0, 1.0, &alone);
    assert!(trains.interfere(-7.0) && trains.interfere(-6.1) && !trains.interfere(-6.0));
    // nor do trains that add up, or changes that pass at once
    trains.set_command(0.0, 0.0, &train.clone().into());
    trains.set_command(1.0, 1.0, &train.clone().into());
    trains.set_command(1.0, 2.0, &Design::unshaped());
    assert!(!trains.interfere(1.0));
    // a change of sign that brakes and accelerates is two trains; they overlap until the first has ended
    let mut trains = Trains::new(-1.0, 16);
    trains.set_command(0.0, 1.0, &Design::of_both(shaper([(0.0, 1.0), (3.0, 0.0)]), train));
    assert!(trains.interfere(0.0) && trains.interfere(1.9) && !trains.interfere(2.0));
}

#[test]
fn forged_trains_are_refused() {
    let mut trains = Trains::new(0.5, 16);
    trains.set_command(0.0, 1.0, &Design::alone(designed(Kind::ZVD, 1.0, 0.0)));
    let saved = serde_json::to_value(&trains).unwrap();
    assert!(serde_json::from_value::<Trains>(saved.clone()).is_ok());
    let forge = |path: &str, value: serde_json::Value| {
        let mut forged = saved.clone();
        *forged.pointer_mut(path).unwrap() = value;
        serde_json::from_value::<Trains>(forged)
    };
    for (path, value) in [("/ends/1", 1e9.into()), ("/pending/0/time", 0.0.into()), ("/pending/1/amount", ().into())] {
        assert!(forge(path, value).is_err(), "{path}");
    }
}
