//! What a shaper leaves behind a drive that is not ideal.

use std::ops::RangeInclusive;

use swayless_shaping::{
    Design, Drive, Mode, Ramp, Sensitivity, Shaper, interchangeable, longest_ramp, residual_amplitude,
};

use super::candidate::OfMode;
use super::{Request, UncertainMode};

/// A drive and the step of its velocity that is shaped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveStep {
    /// The drive.
    pub drive: Drive,
    /// The step, in the drive's units.
    pub velocity: f64,
}

/// What becomes of the ramps that an acceleration limit makes of a shaped step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ramps {
    /// All alike and apart: the shaper cancels behind the limit what it cancels without (Theorem 1 of the thesis).
    Exact,
    /// Each is over before the next begins (5.13), but they are not alike.
    Apart,
    /// One is still under way when the next begins: the drive lags behind.
    Meet,
}

impl DriveStep {
    /// Residual vibration after the shaped step, as a share of what the bare step leaves without the drive's doing: the greater
    /// one of speeding up and, where that is another matter, slowing down.
    pub fn vibration(self, design: &Design, mode: Mode) -> f64 {
        let after = |shaper: &Shaper, from: f64, to: f64| {
            let changes = shaper.impulses().iter().map(|impulse| (impulse.time, (to - from) * impulse.amplitude));
            // The drive has been checked.
            residual_amplitude(changes, mode, self.drive, from).unwrap_or(f64::NAN)
        };
        let up = after(design.shaper(), 0.0, self.velocity);
        let down = match self.drive {
            Drive::FirstOrder { .. } => after(design.braking().unwrap_or(design.shaper()), self.velocity, 0.0),
            _ => 0.0,
        };
        up.max(down) * mode.damped_frequency() / self.velocity.abs()
    }

    /// What becomes of the ramps, behind an acceleration limit.
    pub fn ramps(self, shaper: &Shaper) -> Option<Ramps> {
        let ramp = self.ramp()?;
        Some(match (interchangeable(shaper, ramp), longest_ramp(shaper) >= ramp.time()) {
            (Ok(()), _) => Ramps::Exact,
            (_, true) => Ramps::Apart,
            (_, false) => Ramps::Meet,
        })
    }

    /// How much later than the bare step the shaped one is complete (s). Only an acceleration limit has an end of its own.
    pub fn delay(self, design: &Design) -> f64 {
        let (Some(ramp), shaper) = (self.ramp(), design.shaper()) else {
            return design.duration();
        };
        // The velocity and what it goes to, as shares of the step.
        let (mut velocity, mut target, mut time) = (0.0_f64, 0.0, 0.0);
        for impulse in shaper.impulses() {
            let way = (impulse.time - time) / ramp.time();
            velocity += (target - velocity).clamp(-way, way);
            target += impulse.amplitude;
            time = impulse.time;
        }
        (time + (target - velocity).abs() * ramp.time() - ramp.time()).max(0.0)
    }

    fn ramp(self) -> Option<Ramp> {
        match self.drive {
            Drive::RateLimit { acceleration } => Ramp::new(self.velocity, acceleration).ok(),
            _ => None,
        }
    }

    /// What a shaper leaves of a mode behind the drive.
    pub(super) fn of_mode(self, design: &Design, request: &Request, uncertain: &UncertainMode) -> OfMode {
        let mode = uncertain.mode;
        let vibration = |frequency: f64| {
            // Frequencies next to that of a mode are those of modes.
            Mode::new(frequency, mode.damping_ratio()).map_or(f64::NAN, |mode| self.vibration(design, mode))
        };
        OfMode {
            residual: vibration(mode.frequency()),
            worst: highest(&uncertain.range, design.duration(), vibration),
            insensitivity: width(mode.frequency(), request.level, vibration),
        }
    }
}

/// Where a curve is highest: the highest of samples, and then between its neighbours.
fn highest(range: &RangeInclusive<f64>, duration: f64, vibration: impl Fn(f64) -> f64) -> Sensitivity {
    let (low, high) = (*range.start(), *range.end());
    let points = ((10.0 * (high - low) * duration) as usize).clamp(64, 4096);
    let step = (high - low) / points as f64;
    let at = |frequency: f64| Sensitivity { frequency, vibration: vibration(frequency) };
    let samples = (0..=points).map(|point| at(if point == points { high } else { low + step * point as f64 }));
    let higher = |a: Sensitivity, b: Sensitivity| if b.vibration > a.vibration { b } else { a };
    let Some(best) = samples.reduce(higher) else {
        return at(low);
    };
    let (mut left, mut right) = ((best.frequency - step).max(low), (best.frequency + step).min(high));
    let mut found = best;
    for _ in 0..40 {
        let [a, b] = [left + (right - left) / 3.0, right - (right - left) / 3.0].map(at);
        if a.vibration < b.vibration {
            left = a.frequency
        } else {
            right = b.frequency
        }
        found = [a, b].into_iter().fold(found, higher);
    }
    found
}

/// Full width around a frequency, over it, of the range in which a curve stays at the level; humps above it by a hundredth of it
/// are let pass. Infinite where it stays there up to twenty times the frequency.
pub(super) fn width(frequency: f64, level: f64, vibration: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 0.002;
    const HIGHEST: f64 = 20.0;
    let low_enough = |place: f64, level: f64| vibration(place * frequency) <= level;
    if !low_enough(1.0, 1.01 * level) {
        return 0.0;
    }
    let edge = |step: f64| {
        let mut inside = 1.0;
        for count in 1.. {
            let place = 1.0 + step * f64::from(count);
            if place < STEP {
                return 0.0;
            }
            if place > HIGHEST {
                return f64::INFINITY;
            }
            if !low_enough(place, 1.01 * level) {
                return crossing(inside, place, |place| low_enough(place, level));
            }
            if low_enough(place, level) {
                inside = place;
            }
        }
        inside
    };
    edge(STEP) - edge(-STEP)
}

/// Bisects between a place inside and one outside.
fn crossing(mut inside: f64, mut outside: f64, is_inside: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if is_inside(middle) { inside = middle } else { outside = middle }
    }
    inside
}
