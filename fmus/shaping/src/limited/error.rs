//! Why there is no acceleration-limited shaper.

use std::error::Error;
use std::fmt;

use super::Ramp;
use crate::SpecifiedError;

/// Why [`limited`](crate::limited) or [`limited_insensitivity`](crate::limited_insensitivity) gives no shaper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitedError {
    /// The velocity step is not a finite number, or beyond all measure for the acceleration.
    Speed {
        /// What was given, in m/s.
        value: f64,
        /// The acceleration limit, in m/s².
        acceleration: f64,
    },
    /// The acceleration limit is not greater than 0.
    Acceleration {
        /// What was given, in m/s².
        value: f64,
    },
    /// The vibration limit is outside 0 ≤ V < 1.
    VibrationLimit {
        /// What was given.
        value: f64,
    },
    /// The range, or the limit over it, is none or has no such command.
    Range(SpecifiedError),
    /// The drive takes more than three periods of the mode for the bare step.
    TooSlow {
        /// The step and the acceleration limit.
        ramp: Ramp,
        /// Of the step, or of 1/a: what has a solution, all else the same.
        feasible_share: f64,
    },
    /// With so much damping there are no three pulses for the ramp: they would touch, or nothing was found.
    NoPulses {
        /// The step and the acceleration limit.
        ramp: Ramp,
        /// The mode's damping ratio.
        damping_ratio: f64,
        /// Of the step, or of 1/a: what has a solution, all else the same.
        feasible_share: f64,
    },
    /// With so much damping there are no three impulses for the vibration limit, even without an acceleration limit.
    Damping {
        /// The mode's damping ratio.
        damping_ratio: f64,
        /// The vibration limit.
        vibration_limit: f64,
        /// One that has a solution.
        feasible_limit: f64,
    },
}

impl fmt::Display for LimitedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let advice = |f: &mut fmt::Formatter<'_>, ramp: &Ramp, share: f64| {
            if share <= 0.0 {
                return f.write_str("; there is none for smaller steps either");
            }
            let (speed, acceleration) = (ramp.speed() * share, ramp.acceleration() / share);
            write!(f, "; there is one for {speed} m/s, or for an acceleration limit of {acceleration} m/s²")
        };
        match self {
            Self::Speed { value, acceleration } => write!(
                f,
                "the velocity step is {value} m/s for an acceleration limit of {acceleration} m/s²; it must be finite, and so \
                 must be their ratio"
            ),
            Self::Acceleration { value } => {
                write!(f, "the acceleration limit is {value} m/s²; it must be greater than 0")
            }
            Self::VibrationLimit { value } => {
                write!(f, "the vibration limit is {value}; it must be at least 0 and less than 1")
            }
            Self::Range(error) => error.fmt(f),
            Self::TooSlow { ramp, feasible_share } => {
                write!(
                    f,
                    "a velocity step of {} m/s takes the drive {} s at {} m/s², more than three periods of the mode, and is \
                     not shaped for the limit",
                    ramp.speed(),
                    ramp.time(),
                    ramp.acceleration()
                )?;
                advice(f, ramp, *feasible_share)
            }
            Self::NoPulses { ramp, damping_ratio, feasible_share } => {
                write!(
                    f,
                    "no three pulses apart from each other were found for a velocity step of {} m/s at {} m/s² and the \
                     damping ratio {damping_ratio}",
                    ramp.speed(),
                    ramp.acceleration()
                )?;
                advice(f, ramp, *feasible_share)
            }
            Self::Damping { damping_ratio, vibration_limit, feasible_limit } => write!(
                f,
                "no train of three was found for the vibration limit {vibration_limit} and the damping ratio \
                 {damping_ratio}; there is one for the limit {feasible_limit}"
            ),
        }
    }
}

impl Error for LimitedError {}

impl From<SpecifiedError> for LimitedError {
    fn from(error: SpecifiedError) -> Self {
        Self::Range(error)
    }
}
