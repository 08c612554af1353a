//! What can be wrong with a mode, an impulse train or a design.

use std::error::Error;
use std::fmt;

use crate::{Kind, MAX_IMPULSES};

/// Why a [`Mode`](crate::Mode) was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModeError {
    /// The frequency is not a positive, finite number.
    Frequency {
        /// What was given, in rad/s.
        value: f64,
    },
    /// The damping ratio is outside 0 ≤ ζ < 1.
    DampingRatio {
        /// What was given.
        value: f64,
    },
}

impl fmt::Display for ModeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Frequency { value } => {
                write!(f, "the mode's frequency is {value} rad/s; it must be finite and greater than 0")
            }
            Self::DampingRatio { value } => {
                write!(f, "the mode's damping ratio is {value}; it must be at least 0 and less than 1")
            }
        }
    }
}

impl Error for ModeError {}

/// Why a list of impulses is no [`Shaper`](crate::Shaper). Impulses are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShaperError {
    /// No impulse, or more than [`MAX_IMPULSES`].
    Count {
        /// How many were given.
        count: usize,
    },
    /// An impulse's time is not finite, is negative or does not lie behind the time of the one before.
    Time {
        /// Which impulse.
        index: usize,
        /// Its time in seconds.
        value: f64,
    },
    /// An impulse's amplitude is not finite.
    Amplitude {
        /// Which impulse.
        index: usize,
        /// Its amplitude.
        value: f64,
    },
}

impl fmt::Display for ShaperError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { count } => write!(f, "a shaper has 1 to {MAX_IMPULSES} impulses, not {count}"),
            Self::Time { index, value } => write!(
                f,
                "the time of impulse {index} is {value} s; times must be finite, at least 0 and strictly ascending"
            ),
            Self::Amplitude { index, value } => {
                write!(f, "the amplitude of impulse {index} is {value}; it must be finite")
            }
        }
    }
}

impl Error for ShaperError {}

/// Why there is no such shaper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DesignError {
    /// A mode and a limit do not say enough about a shaper of this kind.
    Kind {
        /// The kind asked for.
        kind: Kind,
    },
    /// The vibration limit is outside 0 ≤ V < 1.
    VibrationLimit {
        /// What was given.
        value: f64,
    },
    /// The shaper's equations have no solution that is a shaper of this kind, or none was found.
    NoSolution {
        /// The kind asked for.
        kind: Kind,
        /// The mode's damping ratio.
        damping_ratio: f64,
        /// The vibration limit, if the kind works with one.
        vibration_limit: Option<f64>,
        /// A damping ratio next to where solutions end that has one, all else the same, if one is known.
        nearest_damping_ratio: Option<f64>,
    },
}

impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Kind { kind } => {
                write!(f, "a mode alone does not say what {kind} is designed for; ask by a specification")
            }
            Self::VibrationLimit { value } => {
                write!(f, "the vibration limit is {value}; it must be at least 0 and less than 1")
            }
            Self::NoSolution { kind, damping_ratio, vibration_limit, nearest_damping_ratio } => {
                write!(f, "no {kind} shaper was found for the damping ratio {damping_ratio}")?;
                if let Some(limit) = vibration_limit {
                    write!(f, " and the vibration limit {limit}")?;
                }
                match nearest_damping_ratio {
                    Some(nearest) => write!(f, "; there is one for a damping ratio of {nearest}"),
                    None => f.write_str("; a lower limit has one"),
                }
            }
        }
    }
}

impl Error for DesignError {}
