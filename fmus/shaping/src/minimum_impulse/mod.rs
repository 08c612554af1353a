//! Minimum impulses for two modes: the trains of no more than three impulses that leave nothing of either mode (thesis 5.3).
//!
//! With the first impulse at time 0 there are two times and three amplitudes for two complex conditions and ΣA = 1 (5.33–5.37),
//! so solutions are single points, infinitely many. Amplitudes may be negative, and larger than 1. Without damping [`comb`] has
//! them all; [`damped`] follows each of them as damping grows, until it may cease to exist.

mod comb;
mod damped;
mod error;
mod system;

pub use error::MinimumImpulseError;

use std::f64::consts::TAU;

use crate::order::order_by;
use crate::{Impulse, Mode, Shaper};
use comb::Comb;

/// The minimum-impulse shapers of two modes, from the shortest on; what [`minimum_impulse`] gives.
#[derive(Clone, Debug)]
pub struct MinimumImpulse {
    count: usize,
    trains: [Train; MAX_SOLUTIONS],
}

impl MinimumImpulse {
    /// The most solutions that are listed.
    pub const MOST: usize = MAX_SOLUTIONS;

    /// How many there are.
    #[must_use]
    #[expect(
        clippy::len_without_is_empty,
        reason = "the first solution is always there without damping, and may lack only with it"
    )]
    pub fn len(&self) -> usize {
        self.count
    }

    /// The shapers in order of duration; of two equally long, the one with the later second impulse comes first.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Shaper> {
        self.trains[..self.count].iter().map(Train::shaper)
    }
}

const MAX_SOLUTIONS: usize = 32;

/// How many times as fast the faster mode may be.
const FARTHEST: f64 = 50.0;

/// The longest train listed, in periods of the slower mode.
const MAX_PERIODS: f64 = 2.0;

/// All shapers of no more than three impulses that leave nothing of either mode, up to two periods of the slower mode long, of
/// which the 32 shortest; mirror images and those with negative impulses are among them. Does not allocate.
///
/// Without damping the shortest is 2/(f₁ + f₂) long. It is ZVD for f₂ = f₁, has three positive impulses up to f₂ = 3f₁, where the
/// middle one vanishes and ZV is left, is UMZV for f₂ = 5f₁, and has amplitudes beyond ±1 above.
///
/// With damping these are what those 32 become. Some cease to exist, for example, for f₂ = 4f₁, the mirrored one of the two that
/// are 3/(f₁ + f₂) long, between ζ = 0.02 and 0.05; one that has become longer or shorter by more than 30 % is left out, too. Where
/// f₂ = 3f₁ and the like, the last impulse of ZV splits in two.
///
/// # Errors
/// [`MinimumImpulseError::Apart`] if one mode is more than 50 times as fast as the other.
pub fn minimum_impulse(modes: [Mode; 2]) -> Result<MinimumImpulse, MinimumImpulseError> {
    solve(modes, MAX_SOLUTIONS)
}

fn undamped(frequencies: [f64; 2]) -> MinimumImpulse {
    let longest = MAX_PERIODS * TAU / frequencies[0] * (1.0 + SAME);
    let mut solutions = MinimumImpulse::none();
    let [mut opposite, mut equal] = Comb::both(frequencies);
    while solutions.count < MAX_SOLUTIONS {
        let next = if opposite.duration() <= equal.duration() { &mut opposite } else { &mut equal };
        if next.duration() > longest {
            break;
        }
        if let Some(train) = next.train() {
            solutions.insert(train);
        }
        next.advance();
    }
    solutions
}

/// One of the [`minimum_impulse`] shapers, counted from 1, which is the shortest. Takes 3 µs without damping; with damping 4 µs to
/// 7 µs for the first, where all together take a few 100 µs.
///
/// ```
/// use std::f64::consts::TAU;
/// use swayless_shaping::{Kind, Mode, convolve, design, minimum_impulse_solution};
///
/// let modes = [Mode::new(1.0 * TAU, 0.0)?, Mode::new(4.0 * TAU, 0.0)?];
/// let series = convolve(&design(Kind::ZV, modes[0], 0.0)?, &design(Kind::ZV, modes[1], 0.0)?)?;
/// assert!((series.duration() - 0.625).abs() < 1e-15);
/// let short = minimum_impulse_solution(modes, 1)?; // faster, for its negative impulse
/// assert!((short.duration() - 0.4).abs() < 1e-15 && !short.is_positive());
/// let medium = minimum_impulse_solution(modes, 2)?; // the fastest without one
/// assert!((medium.duration() - 0.6).abs() < 1e-15 && medium.is_positive());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`MinimumImpulseError`] for an index of 0 or of more than there are, which it tells, and for modes too far apart.
pub fn minimum_impulse_solution(modes: [Mode; 2], index: usize) -> Result<Shaper, MinimumImpulseError> {
    let solutions = solve(modes, index)?;
    let count = solutions.len();
    let train = index.checked_sub(1).and_then(|index| solutions.trains[..count].get(index));
    train.map(Train::shaper).ok_or(MinimumImpulseError::Solution { index, count })
}

/// The shortest solutions up to that number, or all if there are fewer or none is asked for, and maybe longer ones.
fn solve(mut modes: [Mode; 2], wanted: usize) -> Result<MinimumImpulse, MinimumImpulseError> {
    order_by(&mut modes, |mode| mode.frequency());
    let frequencies = modes.map(Mode::frequency);
    let ratio = frequencies[1] / frequencies[0];
    if ratio > FARTHEST {
        return Err(MinimumImpulseError::Apart { ratio, most: FARTHEST });
    }
    let undamped = undamped(frequencies);
    if modes.iter().all(|mode| mode.damping_ratio() == 0.0) {
        return Ok(undamped);
    }
    let mut damped = MinimumImpulse::none();
    for train in &undamped.trains[..undamped.count] {
        let found = wanted.checked_sub(1).and_then(|last| damped.trains[..damped.count].get(last));
        // no later train becomes as short
        if found.is_some_and(|found| found.duration() < (1.0 - damped::FARTHEST_DRIFT) * train.duration()) {
            break;
        }
        damped::follow(train, modes).into_iter().flatten().for_each(|train| damped.insert(train));
    }
    Ok(damped)
}

impl MinimumImpulse {
    fn none() -> Self {
        Self { count: 0, trains: [Train::default(); MAX_SOLUTIONS] }
    }

    /// Adds a train in its place, unless it is there.
    fn insert(&mut self, train: Train) {
        let held = &self.trains[..self.count];
        if self.count == MAX_SOLUTIONS || held.iter().any(|other| other.is_close(&train)) {
            return;
        }
        let place = held.iter().rposition(|other| !train.comes_before(other)).map_or(0, |before| before + 1);
        self.trains[place..=self.count].rotate_right(1);
        self.trains[place] = train;
        self.count += 1;
    }
}

/// Two or three impulses in order.
#[derive(Clone, Copy, Debug, Default)]
struct Train {
    count: usize,
    impulses: [Impulse; 3],
}

impl Train {
    /// Three impulses, of which one that is zero to rounding is left out.
    fn of(impulses: [Impulse; 3]) -> Self {
        Self { count: 3, impulses }.without_impulses_below(NEGLIGIBLE)
    }

    fn without_impulses_below(&self, size: f64) -> Self {
        let mut train = Self::default();
        for impulse in self.impulses().iter().filter(|impulse| impulse.amplitude.abs() > size) {
            train.impulses[train.count] = *impulse;
            train.count += 1;
        }
        train
    }

    /// The same with time reversed.
    fn mirrored(&self) -> Self {
        let mut mirrored = Self { count: self.count, ..Self::default() };
        for (to, from) in mirrored.impulses.iter_mut().zip(self.impulses().iter().rev()) {
            *to = Impulse { time: self.duration() - from.time, ..*from };
        }
        mirrored
    }

    fn impulses(&self) -> &[Impulse] {
        &self.impulses[..self.count]
    }

    fn duration(&self) -> f64 {
        self.impulses[self.count - 1].time
    }

    fn comes_before(&self, other: &Self) -> bool {
        let (duration, same) = (self.duration(), SAME * self.duration());
        let later = duration - other.duration();
        later < -same || (later <= same && self.impulses[1].time > other.impulses[1].time)
    }

    fn is_close(&self, other: &Self) -> bool {
        let near = |(a, b): (&Impulse, &Impulse)| {
            (a.time - b.time).abs() <= SAME * self.duration() && (a.amplitude - b.amplitude).abs() <= SAME
        };
        self.count == other.count && self.impulses().iter().zip(other.impulses()).all(near)
    }

    fn shaper(&self) -> Shaper {
        Shaper::ordered(self.impulses())
    }
}

/// Trains whose amplitudes are larger, summed, are no solutions: there the modes are all but in phase at two of the impulses.
const LARGEST: f64 = 500.0;

/// Amplitudes below this are rounding.
const NEGLIGIBLE: f64 = 1e-13;

/// Trains this close to each other, and durations relative to each other, are the same.
const SAME: f64 = 1e-9;
