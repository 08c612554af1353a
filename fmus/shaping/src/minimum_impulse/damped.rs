//! What becomes of a train for two modes as their damping grows, all damping ratios together, from none on.

use nalgebra::{Complex, SVector};

use super::system::System;
use super::{LARGEST, NEGLIGIBLE, SAME, Train};
use crate::continuation::Pace;
use crate::{Impulse, Mode};

/// The trains, one at most as a rule, that a train for the same modes without damping becomes with damping; none if it ceases to
/// exist on the way.
///
/// Next to where an impulse is zero it moves fast with damping, and stops close to another one. So there the train without it is
/// followed, too, from where it splits.
pub(super) fn follow(train: &Train, modes: [Mode; 2]) -> [Option<Train>; 2] {
    let bare = train.without_impulses_below(SMALL);
    let split = if bare.count == 2 { follow_one(&bare, modes) } else { None };
    [split, if train.count == 2 { None } else { follow_one(train, modes) }]
        .map(|found| found.filter(|found| (found.duration() / train.duration() - 1.0).abs() <= FARTHEST_DRIFT))
}

/// Trains are not followed where they become longer or shorter by more than this share.
pub(super) const FARTHEST_DRIFT: f64 = 0.3;

/// An impulse that may be so small that damping makes it another one.
const SMALL: f64 = 0.02;

fn follow_one(train: &Train, modes: [Mode; 2]) -> Option<Train> {
    let [slow, fast] = modes.map(|mode| mode.damping_ratio() * mode.frequency());
    let pair_first = match train.impulses() {
        [_, middle, end] => 2.0 * middle.time <= end.time,
        // of two impulses, the one that can split
        _ => fast < slow,
    };
    let unit = 0.5 * (modes[0].frequency() + modes[1].frequency());
    let rates = |share| modes.map(|mode| mode.rate(share) / unit);
    let start = pack(&if pair_first { train.mirrored() } else { *train }, unit);
    let opening = if train.count == 2 { opening(train.duration() * unit, rates(1.0)) } else { 0.0 };
    let guess = |share| start + Unknowns::new(0.0, 0.0, 0.0, opening * share);
    let solve = |guess: &Unknowns, share| {
        newton(&System::new(rates(share), pair_first), guess, if share == 1.0 { LAST_STEP } else { ROUGH_STEP })
    };
    let train = unpack(&PACE.follow(1.0, guess, solve).ok()?, unit)?;
    let train = if pair_first { train.mirrored() } else { train };
    let kept = train.without_impulses_below(NEGLIGIBLE);
    // a last impulse that is next to nothing is not left out but waited for: damping does its work
    (kept.impulses[0].time == 0.0 && kept.duration() == train.duration()).then_some(kept)
}

/// Most get to the end in one step.
const PACE: Pace = Pace { first: 1.0, growth: 2.0, shrinkage: 0.25, finest: 1e-3, most: 40 };

/// S, E, d, q of [`System`].
type Unknowns = SVector<f64, 4>;

/// Newton's method from a guess that must be good: `None` if it leads far away, or not anywhere soon.
fn newton(system: &System, guess: &Unknowns, last_step: f64) -> Option<Unknowns> {
    let mut unknowns = *guess;
    let mut last = FIRST_STEP * (1.0 + guess.amax());
    for _ in 0..MAX_ITERATIONS {
        let (residual, jacobian) = system.at(&unknowns);
        let step = jacobian.lu().solve(&residual)?;
        unknowns -= step;
        let size = step.amax();
        if size <= last_step {
            return Some(unknowns);
        }
        if size > 0.5 * last || size.is_nan() {
            return None;
        }
        last = size;
    }
    None
}

/// Twice the largest first step, relative to the unknowns: from further away it might lead to another train.
const FIRST_STEP: f64 = 0.2;

/// Convergence is quadratic: after a step this small, what is left is rounding.
const LAST_STEP: f64 = 1e-9;

/// After a step this small the solution is good enough to go on from.
const ROUGH_STEP: f64 = 1e-5;

const MAX_ITERATIONS: usize = 10;

/// dq/dλ at λ = 0, λ being the share of the damping: one of two equal impulses splits such that the pair's second moment makes up
/// for what the modes decay differently between the impulses, Sq(ω₂² − ω₁²)/2 = |ζ₂ω₂ − ζ₁ω₁|t₂/2.
fn opening(duration: f64, [slow, fast]: [Complex<f64>; 2]) -> f64 {
    2.0 * duration * (fast.re - slow.re).abs() / (fast.norm_sqr() - slow.norm_sqr())
}

/// The first impulse is alone, the others are the pair.
fn pack(train: &Train, unit: f64) -> Unknowns {
    let [alone, pair @ ..] = train.impulses() else { return Unknowns::zeros() };
    let (near, far) = (pair[0], pair[pair.len() - 1]);
    let half = 0.5 * (far.time - near.time) * unit;
    let distance = 0.5 * (far.time + near.time) * unit;
    Unknowns::new(1.0 - alone.amplitude, half * (far.amplitude - near.amplitude), distance, half * half)
}

/// The train, if it is one: of real times in order, and of amplitudes not too large.
fn unpack(unknowns: &Unknowns, unit: f64) -> Option<Train> {
    let [sum, skew, distance, square] = (*unknowns).into();
    let half = square.sqrt(); // NaN if impulses have met and passed
    let lean = skew / half;
    let impulse = |time: f64, amplitude| Impulse { time: time / unit, amplitude };
    let impulses = [
        impulse(0.0, 1.0 - sum),
        impulse(distance - half, 0.5 * (sum - lean)),
        impulse(distance + half, 0.5 * (sum + lean)),
    ];
    let size: f64 = impulses.iter().map(|impulse| impulse.amplitude.abs()).sum();
    let ordered = impulses[1].time > SAME * impulses[2].time && impulses[1].time < impulses[2].time;
    (ordered && size <= LARGEST).then_some(Train { count: 3, impulses })
}
