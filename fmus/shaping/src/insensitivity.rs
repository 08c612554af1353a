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
/// The band ends where V first crosses the level: no excursion is jumped over, however narrow. V may touch the level from
/// below, as EI's does at ω₀; for that the level is taken 1e-9 of itself (and 1e-12) higher. Its ends are exact to that, about
/// 1e-9 of the width.
#[must_use]
pub fn band(shaper: &Shaper, mode: Mode, level: f64) -> Option<Band> {
    let residual = Residual::new(shaper, mode.damping_ratio());
    let design = mode.frequency();
    let level = level * (1.0 + 1e-9) + 1e-12;
    // written so that NaN is refused, too
    if !(residual.vibration(design) <= level) {
        return None;
    }
    let lower = edge(&residual, design, level, Direction::Down).unwrap_or(0.0);
    let upper = edge(&residual, design, level, Direction::Up).unwrap_or(f64::INFINITY);
    Some(Band { lower, upper })
}

/// Insensitivity at a level: the full width of the [`band`] over which V ≤ `level`, divided by the mode's frequency. 0 if V at
/// that frequency is above the level already.
///
/// Without damping at 5 %: ZV 0.0637, ZVD 0.2871, ZVDD 0.4804, EI (for 5 %) 0.3995, UMZV 0.0551. A damped EI has the peak of
/// its hump beside the design frequency and up to about 1 % of V above its limit, so ask a little above the limit.
#[must_use]
pub fn insensitivity(shaper: &Shaper, mode: Mode, level: f64) -> f64 {
    band(shaper, mode, level).map_or(0.0, |band| (band.upper - band.lower) / mode.frequency())
}

/// Upper end of the search, as a multiple of the design frequency.
const HIGHEST: f64 = 20.0;

/// Lower end of the search, as a multiple of the design frequency. A band that reaches this far reaches 0.
const LOWEST: f64 = 1e-9;

#[derive(Clone, Copy, PartialEq)]
enum Direction {
    Down,
    Up,
}

/// The frequency beyond the design frequency at which V first crosses the level; `None` if there is none within the search.
///
/// With |d²V²/dω²| ≤ M, V² cannot reach the level before the root of V² + h |dV²/dω| + Mh²/2 = level² (the slope with the sign
/// that it has in the direction of search). Steps of that h come close to the crossing as Newton's method does, never past it.
fn edge(residual: &Residual<'_>, design: f64, level: f64, direction: Direction) -> Option<f64> {
    let mut frequency = design;
    while (LOWEST * design..=HIGHEST * design).contains(&frequency) {
        let (square, slope) = residual.squared(frequency);
        let margin = level * level - square;
        if margin <= 0.0 {
            return Some(frequency);
        }
        // damping makes M fall with frequency: on the way down, M holds for a step as far as half the frequency
        let (rise, bound, longest) = match direction {
            Direction::Up => (slope, residual.curvature_bound(frequency), f64::INFINITY),
            Direction::Down => (-slope, residual.curvature_bound(0.5 * frequency), 0.5 * frequency),
        };
        let root = (rise * rise + 2.0 * bound * margin).sqrt();
        // the root in the form that does not cancel; not finite when nothing can rise (one impulse)
        let step = if rise > 0.0 { 2.0 * margin / (rise + root) } else { (root - rise) / bound };
        let step = step.min(longest);
        if step <= 1e-14 * design {
            return Some(frequency);
        }
        frequency += if direction == Direction::Up { step } else { -step };
    }
    None
}
