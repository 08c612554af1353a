//! Why there is no UMZVc shaper.

use std::error::Error;
use std::fmt;

use crate::DesignError;

/// Which of the two time constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TimeConstant {
    /// That of a growing speed, τ_a.
    Acceleration,
    /// That of a falling speed, τ_b.
    Braking,
}

impl TimeConstant {
    fn other(self) -> Self {
        match self {
            Self::Acceleration => Self::Braking,
            Self::Braking => Self::Acceleration,
        }
    }
}

impl fmt::Display for TimeConstant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Acceleration => "acceleration time constant",
            Self::Braking => "braking time constant",
        })
    }
}

/// Why [`compensated`](crate::compensated) gives no shaper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CompensatedError {
    /// A time constant is negative or not a number, or beyond all periods.
    TimeConstant {
        /// Which one.
        which: TimeConstant,
        /// What was given, in seconds.
        value: f64,
    },
    /// The mode has no UMZV, from which UMZVc begins.
    Unity(DesignError),
    /// One time constant is too long for the other (5.32): the three vectors of (5.28) close no triangle.
    Unequal {
        /// The longer one.
        which: TimeConstant,
        /// What was given, in seconds.
        value: f64,
        /// The longest that has a solution, all else the same.
        longest: f64,
    },
    /// No times were found at which the exact ramps cancel.
    NotFound {
        /// The mode's damping ratio.
        damping_ratio: f64,
        /// Acceleration time constant in seconds.
        acceleration_time_constant: f64,
        /// Braking time constant in seconds.
        braking_time_constant: f64,
        /// Both time constants times this have a solution.
        feasible_share: f64,
    },
}

impl CompensatedError {
    /// The same error where the time constants were given the other way round.
    pub(super) fn exchanged(self) -> Self {
        match self {
            Self::TimeConstant { which, value } => Self::TimeConstant { which: which.other(), value },
            Self::Unequal { which, value, longest } => Self::Unequal { which: which.other(), value, longest },
            Self::NotFound { damping_ratio, acceleration_time_constant, braking_time_constant, feasible_share } => {
                Self::NotFound {
                    damping_ratio,
                    acceleration_time_constant: braking_time_constant,
                    braking_time_constant: acceleration_time_constant,
                    feasible_share,
                }
            }
            Self::Unity(error) => Self::Unity(error),
        }
    }
}

impl fmt::Display for CompensatedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimeConstant { which, value } => {
                write!(f, "the {which} is {value} s; it must be at least 0 and finite")
            }
            Self::Unity(error) => error.fmt(f),
            Self::Unequal { which, value, longest } => write!(
                f,
                "the {which} of {value} s is too long for the {}, by (5.32); lower it to {longest} s, raise the other, or \
                 solve for the exact ramps",
                which.other()
            ),
            Self::NotFound {
                damping_ratio,
                acceleration_time_constant: acceleration,
                braking_time_constant: braking,
                feasible_share: share,
            } => write!(
                f,
                "no UMZVc shaper was found for an {} of {acceleration} s, a {} of {braking} s and the damping ratio \
                 {damping_ratio}; there is one for {} s and {} s",
                TimeConstant::Acceleration,
                TimeConstant::Braking,
                acceleration * share,
                braking * share
            ),
        }
    }
}

impl Error for CompensatedError {}
