//! Which shaper to take. The rules:
//!
//! 1. A shaper *holds* if what it leaves, behind the drive if one is given, is at most the vibration limit over the whole range
//!    of every mode.
//!    Where no shaping at all holds, behind a drive, it is the choice. What does not hold and delays nothing, as the drive is too
//!    slow to be told from the bare command, is left out.
//! 2. It is *safe* if it has no negative impulse: whatever the command, the shaped one stays within the command's range, so a
//!    drive that can follow the command can follow it.
//! 3. The choice is the quickest shaper that holds and is safe. Where there is none, it is the quickest that holds; and where
//!    none holds, the safe one, else any, that leaves least.
//! 4. Shapers whose delays differ by at most [`AS_LONG`] count as equally long; of those the one that leaves least is taken, but one
//!    that is exact only while no other change is being shaped only where all are.
//! 5. The runner-up is what would be chosen of the others that are safe and as long as the choice; where there is none, of all
//!    others.
//! 6. Named beside them are a quicker one that holds but is not safe, and the quickest safe one of all, since what is waited
//!    for is worth knowing.

use std::cmp::Ordering;

use swayless_shaping::Kind;

use super::{Candidate, Figures};

/// Delays that differ by less than this share count as the same.
pub const AS_LONG: f64 = 0.01;

/// By this share V may be above the limit: as exactly as it is shown.
const TOUCHING: f64 = 1e-3;

/// By this much it may always be, for a limit of 0.
const ROUNDING: f64 = 1e-9;

/// Which shapers to take, by their places among the candidates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recommendation {
    /// The one to take.
    pub choice: usize,
    /// Whether it holds the vibration limit over the whole range.
    pub holds: bool,
    /// The one to take if that is not to be had.
    pub runner_up: Option<usize>,
    /// One that holds the limit sooner than the choice, by negative impulses.
    pub quicker: Option<usize>,
    /// The quickest without negative impulses, if it is sooner than the choice and not the runner-up.
    pub quickest: Option<usize>,
}

/// A candidate as the rules see it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Seen {
    place: usize,
    delay: f64,
    worst: f64,
    holds: bool,
    safe: bool,
    /// Whether it is no shaper at all.
    bare: bool,
    /// Whether it is exact whatever else is being shaped.
    adds_up: bool,
}

/// Applies the rules; `None` where no shaper was designed at all.
pub fn recommend(candidates: &[Candidate], vibration_limit: f64) -> Option<Recommendation> {
    let seen = |(place, candidate): (usize, &Candidate)| {
        let figures = candidate.figures()?;
        let holds = holds(figures, vibration_limit);
        let (bare, safe) = (candidate.kind == Kind::None, !figures.exceeds_command());
        let adds_up = figures.design.adds_up();
        Some(Seen { place, delay: figures.delay, worst: figures.worst(), holds, safe, bare, adds_up })
            .filter(|_| holds || !bare)
    };
    let seen: Vec<Seen> = candidates.iter().enumerate().filter_map(seen).collect();
    let is_idle = |one: &Seen| !one.holds && candidates[one.place].figures().is_some_and(Figures::is_idle);
    let active: Vec<Seen> = seen.iter().filter(|one| !is_idle(one)).copied().collect();
    rules(if active.is_empty() { &seen } else { &active })
}

/// Rule 1.
pub fn holds(figures: &Figures, vibration_limit: f64) -> bool {
    figures.worst() <= vibration_limit * (1.0 + TOUCHING) + ROUNDING
}

fn rules(seen: &[Seen]) -> Option<Recommendation> {
    let choice = choose(seen)?;
    let others: Vec<Seen> = seen.iter().filter(|other| other.place != choice.place).copied().collect();
    let as_long = |other: &&Seen| other.safe && (other.delay - choice.delay).abs() <= AS_LONG * choice.delay;
    let equals: Vec<Seen> = others.iter().filter(as_long).copied().collect();
    let runner_up = choose(&equals).or_else(|| choose(&others));
    let sooner = |wanted: fn(&Seen) -> bool| {
        let sooner = |other: &Seen| other.delay < choice.delay * (1.0 - AS_LONG);
        let found = others.iter().filter(|other| wanted(other) && sooner(other)).copied();
        quickest(&found.collect::<Vec<_>>()).filter(|found| Some(found.place) != runner_up.map(|other| other.place))
    };
    Some(Recommendation {
        choice: choice.place,
        holds: choice.holds,
        runner_up: runner_up.map(|other| other.place),
        quicker: sooner(|other| other.holds && !other.safe).map(|other| other.place),
        quickest: sooner(|other| other.safe).map(|other| other.place),
    })
}

/// Rule 3.
fn choose(seen: &[Seen]) -> Option<Seen> {
    let of = |wanted: fn(&Seen) -> bool| seen.iter().filter(|one| wanted(one)).copied().collect::<Vec<_>>();
    of(|one| one.holds && one.bare)
        .pop()
        .or_else(|| quickest(&of(|one| one.holds && one.safe)))
        .or_else(|| quickest(&of(|one| one.holds)))
        .or_else(|| of(|one| one.safe).into_iter().min_by(quieter))
        .or_else(|| seen.iter().copied().min_by(quieter))
}

/// Rule 4.
fn quickest(seen: &[Seen]) -> Option<Seen> {
    let shortest = seen.iter().map(|one| one.delay).fold(f64::INFINITY, f64::min);
    let equals = seen.iter().filter(|one| one.delay <= shortest * (1.0 + AS_LONG)).copied();
    equals.min_by(|one, other| other.adds_up.cmp(&one.adds_up).then(quieter(one, other)))
}

fn quieter(one: &Seen, other: &Seen) -> Ordering {
    one.worst.total_cmp(&other.worst).then(one.delay.total_cmp(&other.delay))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(list: &[(f64, f64, bool)]) -> Vec<Seen> {
        let one = |(place, &(delay, worst, safe)): (usize, &(f64, f64, bool))| Seen {
            place,
            delay,
            worst,
            holds: worst <= 0.05,
            safe,
            bare: false,
            adds_up: true,
        };
        list.iter().enumerate().map(one).collect()
    }

    #[track_caller]
    fn check(list: &[(f64, f64, bool)], choice: usize, runner_up: Option<usize>, beside: [Option<usize>; 2]) {
        let holds = list[choice].1 <= 0.05;
        let [quicker, quickest] = beside;
        assert_eq!(rules(&seen(list)), Some(Recommendation { choice, holds, runner_up, quicker, quickest }));
    }

    #[test]
    fn the_quickest_that_holds_and_is_safe() {
        // too loud, right, right but longer
        check(&[(0.5, 0.3, true), (1.0, 0.04, true), (1.5, 0.01, true)], 1, Some(2), [None, Some(0)]);
    }

    #[test]
    fn of_two_as_long_the_quieter() {
        check(&[(1.0, 0.04, true), (1.009, 0.03, true)], 1, Some(0), [None, None]);
        check(&[(1.0, 0.04, true), (1.011, 0.03, true)], 0, Some(1), [None, None]);
    }

    #[test]
    fn of_two_as_long_the_one_that_is_exact_for_any_command() {
        let mut alone = seen(&[(1.0, 0.03, true), (1.005, 0.04, true), (1.2, 0.02, true)]);
        alone[0].adds_up = false;
        assert_eq!(rules(&alone).map(|found| (found.choice, found.runner_up)), Some((1, Some(0))));
        // but not for a longer delay
        alone[1].delay = 1.02;
        assert_eq!(rules(&alone).map(|found| found.choice), Some(0));
    }

    #[test]
    fn the_runner_up_is_as_long_or_holds_too() {
        check(&[(1.0, 0.04, true), (1.0, 0.1, true), (1.5, 0.01, true)], 0, Some(1), [None, None]);
        check(&[(1.0, 0.04, true), (0.5, 0.1, true), (1.5, 0.01, true)], 0, Some(2), [None, Some(1)]);
        check(&[(1.0, 0.04, true), (1.0, 0.1, false), (1.5, 0.01, true)], 0, Some(2), [None, None]);
    }

    #[test]
    fn negative_impulses_are_named_but_not_chosen() {
        check(&[(0.7, 0.04, false), (1.0, 0.04, true)], 1, Some(0), [None, None]);
        check(&[(0.7, 0.04, false), (1.0, 0.04, true), (2.0, 0.0, true)], 1, Some(2), [Some(0), None]);
    }

    #[test]
    fn negative_impulses_are_chosen_where_nothing_else_holds() {
        check(&[(0.7, 0.04, false), (1.0, 0.06, true)], 0, Some(1), [None, None]);
    }

    #[test]
    fn where_nothing_holds_the_quietest_that_is_safe() {
        check(&[(0.5, 0.3, true), (1.0, 0.1, true), (0.7, 0.06, false)], 1, Some(0), [None, None]);
        check(&[(0.7, 0.06, false)], 0, None, [None, None]);
        assert_eq!(rules(&[]), None);
    }
}
