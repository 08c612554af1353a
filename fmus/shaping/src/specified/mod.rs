//! SI, specified insensitivity: the shortest positive shaper that keeps V below a limit over one or more ranges of frequencies.
//!
//! For trains of a given length the least highest vibration is a convex program, solved by [`exchange`]; it does not grow with
//! the length, so the shortest length that holds the limit is bisected. Once close, [`mod@polish`] solves the conditions for the
//! optimum to rounding and proves the result from both sides; there is no other local optimum to be caught in.
//!
//! Without damping a shaper may be replaced by the mean of itself and its mirror image without raising |V(ω)| anywhere, so
//! symmetric trains are enough and f(ω) is real. With damping f(ω) is complex and the program is a second-order-cone program,
//! whose cones the exchange approaches by tangents; the proof is the same.

mod error;
mod exchange;
mod extrema;
mod game;
mod polish;
mod response;

pub use error::SpecifiedError;
pub(crate) use exchange::samples;
pub(crate) use extrema::{Jet, minima};
pub(crate) use game::solve;
pub(crate) use response::Response;

use crate::order::order_by;
use std::f64::consts::TAU;

use crate::{Band, Impulse, MAX_IMPULSES, Mode, Shaper};
use exchange::{Exchange, Mix, Range, Verdict};
use polish::polish;

impl Band {
    /// The range of a given insensitivity I = (ω_high − ω_low)/ω around a frequency ω in rad/s: ω(1 ± I/2).
    ///
    /// # Errors
    /// [`SpecifiedError::Insensitivity`] unless 0 ≤ I < 2.
    pub fn around(frequency: f64, insensitivity: f64) -> Result<Self, SpecifiedError> {
        if !(0.0..2.0).contains(&insensitivity) {
            return Err(SpecifiedError::Insensitivity { value: insensitivity });
        }
        let half = 0.5 * insensitivity;
        Ok(Self { lower: frequency * (1.0 - half), upper: frequency * (1.0 + half) })
    }
}

/// Designs the SI shaper: of all trains of positive impulses that keep V ≤ `vibration_limit` at every frequency of `range`, all
/// with the same damping ratio, the shortest.
///
/// That it keeps the limit and that no shorter one does is checked for every result, to 1e-9 of the limit and duration. Without
/// damping the shaper is symmetric in time. Allocates and takes up to some milliseconds: not meant for the inside of a simulation step.
///
/// # Errors
/// [`SpecifiedError`] for a range, damping ratio or limit that is none, for a shaper that would be too long or have too many
/// impulses, and where damping is so large that waiting is quicker than shaping.
pub fn specified_insensitivity(
    range: Band,
    damping_ratio: f64,
    vibration_limit: f64,
) -> Result<Shaper, SpecifiedError> {
    specified_insensitivity_of(&[(range, damping_ratio)], vibration_limit)
}

/// Designs the SI shaper for several ranges, each with a damping ratio of its own: of all trains of positive impulses that keep
/// V ≤ `vibration_limit` at every frequency of every range, the shortest. All else is as for [`specified_insensitivity`], which is
/// this for one range.
///
/// Ranges may overlap. Time grows with the ratio of their frequencies: milliseconds for 4, tenths of a second for 20, or seconds for
/// limits of 1 % and less.
///
/// # Errors
/// Those of [`specified_insensitivity`], [`SpecifiedError::NoRange`] for an empty list, and [`SpecifiedError::Apart`] for frequencies
/// more than 50 times those of the slowest range.
pub fn specified_insensitivity_of(ranges: &[(Band, f64)], vibration_limit: f64) -> Result<Shaper, SpecifiedError> {
    for &(Band { lower, upper }, damping_ratio) in ranges {
        Mode::new(lower, damping_ratio)?;
        Mode::new(upper, damping_ratio)?;
        if lower > upper {
            return Err(SpecifiedError::Reversed { lower, upper });
        }
    }
    if !(vibration_limit > 0.0 && vibration_limit < 1.0) {
        return Err(SpecifiedError::VibrationLimit { value: vibration_limit });
    }
    let ranges = united(ranges);
    let (slowest, _) = ranges.first().ok_or(SpecifiedError::NoRange)?;
    let middle = 0.5 * slowest.lower + 0.5 * slowest.upper;
    let ratio = ranges.iter().map(|(band, _)| band.upper).fold(0.0, f64::max) / middle;
    if ratio > FARTHEST {
        return Err(SpecifiedError::Apart { ratio, most: FARTHEST });
    }
    let damped = ranges.iter().any(|(_, damping_ratio)| *damping_ratio > 0.0);
    let range = |(band, damping_ratio): &(Band, f64)| {
        let response = if damped { Response::damped(*damping_ratio) } else { Response::Symmetric };
        Range { response, low: band.lower / middle, high: band.upper / middle }
    };
    let exchange = Exchange::new(ranges.iter().map(range).collect());
    let train = shortest(exchange, vibration_limit)?;
    shaper(damped, &train, middle)
}

/// The ranges in order, those that overlap and have the same damping ratio as one.
fn united(ranges: &[(Band, f64)]) -> Vec<(Band, f64)> {
    let mut ordered = ranges.to_vec();
    order_by(&mut ordered, |(band, _)| band.lower);
    let mut united: Vec<(Band, f64)> = Vec::new();
    for (band, damping_ratio) in ordered {
        let same = |(other, ratio): &&mut (Band, f64)| *ratio == damping_ratio && band.lower <= other.upper;
        match united.iter_mut().find(same) {
            Some((other, _)) => other.upper = other.upper.max(band.upper),
            None => united.push((band, damping_ratio)),
        }
    }
    united
}

/// Places (in radians of the slowest range's middle frequency) and shares of the shortest train.
fn shortest(mut exchange: Exchange, limit: f64) -> Result<Vec<(f64, f64)>, SpecifiedError> {
    let response = exchange.ranges[0].response;
    let longest = MAX_PERIODS * TAU / response.duration_per_place();
    // an impulse at τ ≤ π/2 answers with cos ωτ at least, so shorter trains do not reach any limit
    let mut short = match response {
        Response::Symmetric => exchange.ranges.iter().map(|range| limit.acos() / range.high).fold(0.0, f64::max),
        Response::Damped(_) => 0.0,
    };
    let mut long = (short * 1.01).max(0.5 * TAU / 4.0 * response.duration_per_place());
    let mut holds: Option<Mix> = None;
    loop {
        // first upwards until the limit is held, then inwards
        let at = if holds.is_some() { 0.5 * (short + long) } else { long };
        if at > longest {
            return Err(SpecifiedError::TooLong);
        }
        let verdict = exchange.judge(at, limit)?;
        let (Verdict::TooShort(mix) | Verdict::LongEnough(mix) | Verdict::Close(mix)) = &verdict;
        if holds.is_some()
            && let Some(train) = polish(&exchange, mix, at, limit)
        {
            return Ok(train);
        }
        let undecided = matches!(verdict, Verdict::Close(_));
        match verdict {
            Verdict::TooShort(_) => {
                short = at;
                long = if holds.is_some() { long } else { 1.3 * at };
            }
            Verdict::LongEnough(mix) => {
                long = at;
                holds = Some(mix);
            }
            Verdict::Close(_) => {}
        }
        let close = long - short <= CLOSE * long;
        match &holds {
            Some(mix) if close => return Ok(mix.ordered_train()),
            _ if close || undecided => return Err(SpecifiedError::NotFound),
            _ => {}
        }
    }
}

/// Where an impulse is about to split in two, Newton's method finds no footing. The bisection does, to this share of the
/// duration; only the impulses that are splitting, all but equal in time, are then not exact.
const CLOSE: f64 = 1e-9;

/// How many times the slowest range's middle frequency the highest frequency may be.
const FARTHEST: f64 = 50.0;

/// Longest train looked for, in periods of the slowest range's middle frequency.
const MAX_PERIODS: f64 = 12.0;

/// Impulses closer than this share of the duration are one, found twice.
const MET: f64 = 1e-12;

fn shaper(damped: bool, train: &[(f64, f64)], unit: f64) -> Result<Shaper, SpecifiedError> {
    let length = train.last().map_or(0.0, |(place, _)| *place);
    let met = MET * length;
    let mut impulses: Vec<Impulse> = Vec::new();
    let mut add = |angle: f64, amplitude| impulses.push(Impulse { time: angle / unit, amplitude });
    for &(place, share) in train.iter().rev() {
        let whole = damped || place <= met;
        add(length - place, if whole { share } else { 0.5 * share });
    }
    if !damped {
        let later = train.iter().filter(|(place, _)| *place > met);
        later.for_each(|&(place, share)| add(length + place, 0.5 * share));
    } else if train.first().is_some_and(|(place, _)| *place > met) {
        return Err(SpecifiedError::Waiting);
    }
    impulses.dedup_by(|later, earlier| {
        let same = later.time - earlier.time <= met / unit;
        earlier.amplitude += if same { later.amplitude } else { 0.0 };
        same
    });
    if impulses.len() > MAX_IMPULSES {
        return Err(SpecifiedError::TooManyImpulses { count: impulses.len() });
    }
    Shaper::new(&impulses).map_err(|_| SpecifiedError::NotFound)
}
