//! SI, specified insensitivity: the shortest positive shaper that keeps V below a limit over a range of frequencies.
//!
//! For trains of a given length the least highest vibration is a convex program, solved by [`exchange`]; it does not grow with
//! the length, so the shortest length that holds the limit is bisected. Once close, [`polish`] solves the conditions for the
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
pub(crate) use extrema::minima;

use std::f64::consts::TAU;

use crate::{Band, Impulse, MAX_IMPULSES, Mode, Shaper};
use exchange::{Exchange, Mix, Verdict};
use polish::polish;
use response::Response;

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
    for end in [range.lower, range.upper] {
        Mode::new(end, damping_ratio)?;
    }
    if range.lower > range.upper {
        return Err(SpecifiedError::Reversed { lower: range.lower, upper: range.upper });
    }
    if !(vibration_limit > 0.0 && vibration_limit < 1.0) {
        return Err(SpecifiedError::VibrationLimit { value: vibration_limit });
    }
    let middle = 0.5 * range.lower + 0.5 * range.upper;
    let response = Response::new(damping_ratio);
    let exchange = Exchange::new(response, range.lower / middle, range.upper / middle);
    let train = shortest(exchange, vibration_limit)?;
    shaper(response, &train, middle)
}

/// Places (in radians of the middle frequency) and shares of the shortest train.
fn shortest(mut exchange: Exchange, limit: f64) -> Result<Vec<(f64, f64)>, SpecifiedError> {
    let longest = MAX_PERIODS * TAU / exchange.response.duration_per_place();
    // an impulse at τ ≤ π/2 answers with cos ωτ at least, so shorter trains do not reach any limit
    let mut short = match exchange.response {
        Response::Symmetric => limit.acos() / exchange.high,
        Response::Damped(_) => 0.0,
    };
    let mut long = (short * 1.01).max(0.5 * TAU / 4.0 * exchange.response.duration_per_place());
    let mut holds: Option<Mix> = None;
    loop {
        // first upwards until the limit is held, then inwards
        let at = if holds.is_some() { 0.5 * (short + long) } else { long };
        if at > longest {
            return Err(SpecifiedError::TooLong);
        }
        let verdict = exchange.judge(at, limit).ok_or(SpecifiedError::NotFound)?;
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

/// Longest train looked for, in periods of the middle frequency.
const MAX_PERIODS: f64 = 12.0;

fn shaper(response: Response, train: &[(f64, f64)], unit: f64) -> Result<Shaper, SpecifiedError> {
    let length = train.last().map_or(0.0, |(place, _)| *place);
    let mut impulses: Vec<Impulse> = Vec::new();
    let mut add = |angle: f64, amplitude| impulses.push(Impulse { time: angle / unit, amplitude });
    for &(place, share) in train.iter().rev() {
        match response {
            Response::Symmetric if place > 0.0 => add(length - place, 0.5 * share),
            _ => add(length - place, share),
        }
    }
    match response {
        Response::Symmetric => train.iter().filter(|(place, _)| *place > 0.0).for_each(|&(place, share)| {
            add(length + place, 0.5 * share);
        }),
        Response::Damped(_) if train[0].0 > 0.0 => return Err(SpecifiedError::Waiting),
        Response::Damped(_) => {}
    }
    if impulses.len() > MAX_IMPULSES {
        return Err(SpecifiedError::TooManyImpulses { count: impulses.len() });
    }
    Shaper::new(&impulses).map_err(|_| SpecifiedError::NotFound)
}
