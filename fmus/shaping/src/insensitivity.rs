//! Insensitivity: how wide a band of frequencies a shaper keeps quiet.

use crate::analysis::Residual;
use crate::{Mode, Shaper};

/// A band of frequencies in rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Lower end, at least 0.
    pub lower: f64,
    /// Upper end; infinite where V stays below the level up to twenty times the design frequency.
    pub upper: f64,
}

/// The band around the mode's frequency over which V ≤ `level`, all with the mode's damping ratio; `None` if V at the mode's
/// own frequency is above the level (or the level is NaN).
///
/// The band ends where V first crosses the level; no excursion wider than 1e-5 of the mode's frequency is jumped over. V may
/// touch the level from below, as EI's does at the mode's frequency; for that the level is taken 1e-9 of itself (and 1e-12)
/// higher. The ends are exact to what that makes, about 1e-9 of the mode's frequency.
#[must_use]
pub fn band(shaper: &Shaper, mode: Mode, level: f64) -> Option<Band> {
    let residual = Residual::new(shaper, mode.damping_ratio(), mode.frequency());
    let level = level * (1.0 + 1e-9) + 1e-12;
    if residual.vibration(1.0) > level || level.is_nan() {
        return None;
    }
    let lower = edge(&residual, level, Direction::Down).unwrap_or(0.0);
    let upper = edge(&residual, level, Direction::Up).unwrap_or(f64::INFINITY);
    Some(Band { lower: lower * mode.frequency(), upper: upper * mode.frequency() })
}

/// Insensitivity at a level: the full width of the [`band`] over which V ≤ `level`, divided by the mode's frequency. 0 if V at
/// that frequency is above the level already.
///
/// Without damping at 5 %, and for a limit of 5 %: ZV 0.0637, ZVD 0.2871, ZVDD 0.4804, ZVDDD 0.6271, EI 0.3995, TwoHumpEI 0.7245,
/// ThreeHumpEI 0.9639, UMZV 0.0551, UMZVD 0.2586, UMEI 0.3590. A damped EI has the peak of
/// its hump beside the design frequency and up to about 1 % of V above its limit, so ask a little above the limit.
#[must_use]
pub fn insensitivity(shaper: &Shaper, mode: Mode, level: f64) -> f64 {
    band(shaper, mode, level).map_or(0.0, |band| (band.upper - band.lower) / mode.frequency())
}

/// Upper end of the search, as a multiple of the design frequency.
const HIGHEST: f64 = 20.0;

/// Lower end of the search, as a multiple of the design frequency. A band that reaches this far reaches 0.
const LOWEST: f64 = 1e-9;

/// Steps of the search are not shorter than this, in units of the design frequency.
const SHORTEST_STEP: f64 = 1e-5;

#[derive(Clone, Copy, PartialEq)]
enum Direction {
    Down,
    Up,
}

/// The frequency, in units of the design frequency, at which V first crosses the level; `None` if there is none within the
/// search.
///
/// With |d²V²/dω²| ≤ M, V² cannot reach the level before the root of V² + h |dV²/dω| + Mh²/2 = level² (the slope with the sign
/// that it has in the direction of search). Steps of that h never pass a crossing; where they get too short to go on, a
/// crossing is near, or the curve runs along the level.
fn edge(residual: &Residual<'_>, level: f64, direction: Direction) -> Option<f64> {
    let mut frequency = 1.0;
    if level >= residual.highest() {
        return None;
    }
    while LOWEST < frequency && frequency < HIGHEST {
        let (square, slope) = residual.squared(frequency);
        let margin = level * level - square;
        // damping makes M fall with frequency: on the way down, M holds for a step as far as half the frequency
        let (rise, bound, longest) = match direction {
            Direction::Up => (slope, residual.curvature_bound(frequency), HIGHEST - frequency),
            Direction::Down => (-slope, residual.curvature_bound(0.5 * frequency), 0.5 * frequency),
        };
        let root = (rise * rise + 2.0 * bound * margin).sqrt();
        // the root in the form that does not cancel; a single impulse has V = 1 everywhere, and M = 0
        let step = match bound {
            0.0 => longest,
            _ if rise > 0.0 => 2.0 * margin / (rise + root),
            _ => (root - rise) / bound,
        };
        let step = step.max(SHORTEST_STEP).min(longest);
        let next = if direction == Direction::Up { frequency + step } else { frequency - step };
        if residual.vibration(next) > level {
            return Some(crossing(residual, level, frequency, next));
        }
        frequency = next;
    }
    None
}

/// Bisects between a frequency where V ≤ level and one where V > level; returns the former.
fn crossing(residual: &Residual<'_>, level: f64, mut inside: f64, mut outside: f64) -> f64 {
    while (outside - inside).abs() > 1e-15 * inside {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            break;
        }
        if residual.vibration(middle) > level {
            outside = middle;
        } else {
            inside = middle;
        }
    }
    inside
}
