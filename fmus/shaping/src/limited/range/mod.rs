//! ALSI: the shortest command for a drive with an acceleration limit that keeps the vibration below a limit over a range of
//! frequencies (thesis 5.1.3).
//!
//! A command is u(τ) between 0 and 1, the share of the full acceleration, with ∫u = the time of the bare ramp. That the vibration
//! is at most V of the bare ramp's at each frequency is convex in u: the least highest ratio for a given length is a linear program
//! without damping and a second-order-cone program with, solved by [`exchange`] as for SI; the length is bisected. The optimum
//! switches between 0 and 1, and [`polish`] solves the conditions for its switches to rounding and proves it from both sides.
//!
//! Where the bare ramp leaves nothing, V of that is nothing, too. So that a range may contain such a frequency, the bare ramp's
//! vibration |B| counts as √(|B|² + ε²), ε being [`FLOOR`] of what an ideal step leaves.

mod exchange;
mod polish;
mod problem;
mod reply;
mod start;

use std::f64::consts::{PI, TAU};

use super::{Limited, LimitedError, Ramp};
use crate::specified::Response;
use crate::{Band, Impulse, MAX_IMPULSES, Mode, Shaper, SpecifiedError, specified_insensitivity};
use exchange::{Exchange, Verdict};
use polish::polish;
use problem::{Command, Problem};

/// The bare ramp counts as leaving this share of an ideal step's vibration even where it leaves less.
pub(super) const FLOOR: f64 = 0.005;

/// Designs ALSI: of all commands between 0 and the acceleration limit that keep the vibration at each frequency of `range`, all with
/// the same damping ratio, at or below `vibration_limit` times the bare ramp's, the shortest.
///
/// Where the bare ramp itself leaves next to nothing, 0.5 % of what an ideal step leaves is added to that as a root of squares.
/// The limit is kept, and no shorter command keeps it, to 1e-9 (1e-5 of the limit where a pulse is about to appear or two to merge).
/// As v_f → 0 it tends to SI. Allocates and takes milliseconds, for wide ranges up to a tenth of a second, with damping up to a
/// second, and with both, ramps of two or three periods and a limit of about 0.01 several: not meant for the inside of a simulation
/// step.
///
/// # Errors
/// [`LimitedError`] for a range, damping ratio or limit that is none, for a bare ramp of more than three periods of the range's
/// middle, for a limit below 0.001, for a command that would be too long or have too many pulses, where damping makes waiting the
/// best of commands, and where the search takes too long or ends without a proof. It does for one in fifty whose limit is 0.005 to
/// 0.007 and whose bare ramp is about as long as a period, and for one in ten thousand with limits of 0.02 or more.
pub fn limited_insensitivity(
    range: Band,
    damping_ratio: f64,
    ramp: Ramp,
    vibration_limit: f64,
) -> Result<Limited, LimitedError> {
    for end in [range.lower, range.upper] {
        Mode::new(end, damping_ratio).map_err(SpecifiedError::Mode)?;
    }
    if range.lower > range.upper {
        return Err(SpecifiedError::Reversed { lower: range.lower, upper: range.upper }.into());
    }
    if !(vibration_limit > 0.0 && vibration_limit < 1.0) {
        return Err(SpecifiedError::VibrationLimit { value: vibration_limit }.into());
    }
    let middle = 0.5 * range.lower + 0.5 * range.upper;
    let angle = middle * ramp.time();
    if angle > LONGEST {
        return Err(LimitedError::TooSlow { ramp, feasible_share: 0.999_999 * LONGEST / angle });
    }
    let response = if damping_ratio == 0.0 { Response::Symmetric } else { Response::damped(damping_ratio) };
    if angle < SHORTEST.min(vibration_limit.sqrt()) {
        let high = range.upper * ramp.time();
        let least = (vibration_limit - high * high / 24.0) * (-0.5 * damping_ratio * high).exp();
        let shaper = specified_insensitivity(range, damping_ratio, least)?;
        return Ok(Limited { shaper: starts(&shaper, ramp), ramp_time: ramp.time() });
    }
    let on_time = angle / response.duration_per_place();
    // next to where a pulse appears or two merge Newton's method finds no footing, but a little less vibration has a design
    let stricter = [0.0, 1e-6, 1e-5].map(|less| vibration_limit * (1.0 - less));
    if vibration_limit < LEAST_LIMIT {
        return Err(SpecifiedError::TooWide.into());
    }
    let mut found = Err(SpecifiedError::NotFound);
    for limit in stricter {
        let problem = Problem::new(response, range.lower / middle, range.upper / middle, on_time, limit);
        found = shortest(problem);
        if !matches!(found, Err(SpecifiedError::NotFound)) {
            break;
        }
    }
    limited(response, &found?, middle, ramp)
}

/// Half the longest bare ramp, in radians, is three periods.
const LONGEST: f64 = 6.0 * PI;

/// For shorter bare ramps, in radians, pulses are as good as impulses: answers differ by the square of this over 24, and with damping
/// they die away for up to half a ramp longer than that of the bare ramp. So the limit is met, but missed by up to 1e-3 of it.
const SHORTEST: f64 = 1e-3;

/// Impulses in the middles of their ramps, from the first one's start.
fn starts(shaper: &Shaper, ramp: Ramp) -> Shaper {
    let half = 0.5 * ramp.time();
    let first = shaper.impulses()[0].amplitude;
    shaper.map_times(|impulse| impulse.time + (first - impulse.amplitude) * half)
}

/// The pulses of the shortest command, in places.
fn shortest(problem: Problem) -> Result<Command, SpecifiedError> {
    let bare = vec![[0.0, problem.on_time]];
    if exchange::humps(&problem, problem.on_time, |omega| problem.answer(&bare, omega))
        .iter()
        .all(|(_, size)| *size <= problem.limit)
    {
        return Ok(bare);
    }
    let longest = problem.on_time + MAX_PERIODS * TAU / problem.response.duration_per_place();
    let quarter = 0.5 * PI / problem.response.duration_per_place();
    let mut exchange = Exchange::new(problem);
    let (mut short, mut long) = (problem.on_time, problem.on_time + 2.0 * quarter);
    let mut holds = false;
    for _ in 0..MAX_JUDGEMENTS {
        // first upwards until the limit is held, then inwards
        let at = if holds { 0.5 * (short + long) } else { long };
        if at > longest {
            return Err(SpecifiedError::TooLong);
        }
        let (verdict, mix) = exchange.judge(at).ok_or(SpecifiedError::NotFound)?;
        if let Some(command) = polish(&problem, &mix, at) {
            return Ok(command);
        }
        match verdict {
            Verdict::TooShort => {
                short = at;
                long = if holds { long } else { at + quarter };
            }
            Verdict::LongEnough => {
                long = at;
                holds = true;
            }
            Verdict::Open => {}
            Verdict::Close => return Err(SpecifiedError::NotFound),
        }
        if holds && long - short <= CLOSE * long {
            return Err(SpecifiedError::NotFound);
        }
    }
    Err(SpecifiedError::TooWide)
}

/// Bisections that end take half as many; where more are needed, rounds are slow, too.
const MAX_JUDGEMENTS: usize = 60;

/// Lower limits take seconds.
const LEAST_LIMIT: f64 = 1e-3;

/// Bisecting further helps no more.
const CLOSE: f64 = 1e-9;

/// Longest command looked for, beyond the bare ramp, in periods of the middle frequency.
const MAX_PERIODS: f64 = 12.0;

/// The command's pulses in order of time.
fn limited(response: Response, command: &Command, unit: f64, ramp: Ramp) -> Result<Limited, LimitedError> {
    let length = command.last().map_or(0.0, |[_, end]| *end);
    let on_time: f64 = command.iter().map(|[from, to]| to - from).sum();
    let share = |width: f64| width / (on_time * response.duration_per_place());
    let mut impulses: Vec<Impulse> = Vec::new();
    let mut add = |start: f64, width: f64| impulses.push(Impulse { time: start / unit, amplitude: share(width) });
    let central = matches!(response, Response::Symmetric) && command[0][0] == 0.0;
    if matches!(response, Response::Damped(_)) && command[0][0] > 0.0 {
        return Err(SpecifiedError::Waiting.into());
    }
    for [from, to] in command.iter().rev() {
        if *from == 0.0 && central {
            add(length - to, 2.0 * to);
        } else {
            add(length - to, to - from);
        }
    }
    if matches!(response, Response::Symmetric) {
        command.iter().filter(|[from, _]| *from > 0.0).for_each(|[from, to]| add(length + from, to - from));
    }
    if impulses.len() > MAX_IMPULSES {
        return Err(SpecifiedError::TooManyImpulses { count: impulses.len() }.into());
    }
    let shaper = Shaper::new(&impulses).map_err(|_| SpecifiedError::NotFound)?;
    Ok(Limited { shaper, ramp_time: ramp.time() })
}
