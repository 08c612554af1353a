//! Why a specification has no design, and what of it to change.

use std::error::Error;
use std::fmt;

use crate::{
    CompensatedError, DesignError, Kind, LimitedError, MinimumImpulseError, ShaperError, SpecifiedError, TimeConstant,
};

/// What a [`SpecificationError`] is about; modes are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// [`Specification::kind`](crate::Specification::kind).
    Kind,
    /// The frequency of a mode of [`Specification::modes`](crate::Specification::modes).
    Frequency(usize),
    /// The damping ratio of a mode of [`Specification::modes`](crate::Specification::modes).
    DampingRatio(usize),
    /// [`Specification::vibration_limit`](crate::Specification::vibration_limit).
    VibrationLimit,
    /// [`Specification::insensitivity`](crate::Specification::insensitivity).
    Insensitivity,
    /// [`Specification::acceleration_limit`](crate::Specification::acceleration_limit).
    AccelerationLimit,
    /// [`Specification::velocity_limit`](crate::Specification::velocity_limit).
    VelocityLimit,
    /// [`Specification::acceleration_time_constant`](crate::Specification::acceleration_time_constant).
    AccelerationTimeConstant,
    /// [`Specification::braking_time_constant`](crate::Specification::braking_time_constant).
    BrakingTimeConstant,
    /// One of [`Specification::base_kinds`](crate::Specification::base_kinds).
    BaseKind(usize),
    /// [`Specification::solution`](crate::Specification::solution).
    Solution,
}

/// Why a [`Specification`](crate::Specification) has no design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpecificationError {
    /// The kind needs a mode that is not given.
    MissingMode {
        /// The kind asked for.
        kind: Kind,
        /// Which mode, from 0.
        index: usize,
    },
    /// A second mode is given to a kind that shapes one mode only.
    UnusedMode {
        /// The kind asked for.
        kind: Kind,
    },
    /// `Convolved` cannot be made of that kind.
    BaseKind {
        /// The kind asked for.
        kind: Kind,
        /// For which mode, from 0.
        index: usize,
    },
    /// The equations of the kind have no solution.
    Design {
        /// Why.
        error: DesignError,
        /// Of which mode, from 0.
        mode: usize,
    },
    /// There is no SI shaper.
    Specified {
        /// Why.
        error: SpecifiedError,
        /// Of which mode, from 0.
        mode: usize,
    },
    /// There is no such shaper for the acceleration limit.
    Limited(LimitedError),
    /// There is no UMZVc shaper.
    Compensated(CompensatedError),
    /// The two shapers have no train in series.
    Convolved(ShaperError),
    /// There is no such minimum-impulse shaper.
    MinimumImpulse(MinimumImpulseError),
}

impl SpecificationError {
    /// What to change.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        match self {
            Self::MissingMode { index, .. } => Quantity::Frequency(*index),
            Self::UnusedMode { .. } => Quantity::Frequency(1),
            Self::BaseKind { index, .. } => Quantity::BaseKind(*index),
            Self::Design { error, mode } => match error {
                DesignError::Kind { .. } => Quantity::Kind,
                DesignError::VibrationLimit { .. } => Quantity::VibrationLimit,
                DesignError::NoSolution { .. } => Quantity::DampingRatio(*mode),
            },
            Self::Limited(error) => match error {
                LimitedError::Range(error) => Self::from(*error).quantity(),
                LimitedError::Acceleration { .. } => Quantity::AccelerationLimit,
                LimitedError::Speed { .. } | LimitedError::TooSlow { .. } | LimitedError::NoPulses { .. } => {
                    Quantity::VelocityLimit
                }
                LimitedError::VibrationLimit { .. } | LimitedError::Damping { .. } => Quantity::VibrationLimit,
            },
            Self::Compensated(error) => match error {
                CompensatedError::Unity(_) => Quantity::DampingRatio(0),
                CompensatedError::TimeConstant { which, .. } | CompensatedError::Unequal { which, .. } => match which {
                    TimeConstant::Acceleration => Quantity::AccelerationTimeConstant,
                    TimeConstant::Braking => Quantity::BrakingTimeConstant,
                },
                // it is the longer one that asks too much
                CompensatedError::NotFound {
                    acceleration_time_constant: tau_a, braking_time_constant: tau_b, ..
                } => {
                    if tau_a > tau_b {
                        Quantity::AccelerationTimeConstant
                    } else {
                        Quantity::BrakingTimeConstant
                    }
                }
            },
            Self::Convolved(_) => Quantity::BaseKind(1),
            Self::MinimumImpulse(error) => match error {
                MinimumImpulseError::Apart { .. } => Quantity::Frequency(1),
                MinimumImpulseError::Solution { .. } => Quantity::Solution,
            },
            Self::Specified { error, mode } => match error {
                SpecifiedError::Mode(_) | SpecifiedError::Waiting => Quantity::DampingRatio(*mode),
                SpecifiedError::VibrationLimit { .. } => Quantity::VibrationLimit,
                SpecifiedError::NoRange
                | SpecifiedError::Reversed { .. }
                | SpecifiedError::Insensitivity { .. }
                | SpecifiedError::TooLong
                | SpecifiedError::TooManyImpulses { .. }
                | SpecifiedError::TooWide
                | SpecifiedError::NotFound => Quantity::Insensitivity,
                SpecifiedError::Apart { .. } => Quantity::Frequency(1),
            },
        }
    }
}

impl fmt::Display for SpecificationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingMode { kind, index } => write!(f, "{kind} needs the frequency of mode {}", index + 1),
            Self::UnusedMode { kind } => write!(f, "{kind} shapes one mode only; leave the second out"),
            Self::BaseKind { kind, index } => {
                write!(f, "Convolved is made of kinds for one mode, and {kind}, for mode {}, is none", index + 1)
            }
            Self::Design { error, .. } => error.fmt(f),
            Self::Specified { error, .. } => error.fmt(f),
            Self::Limited(error) => error.fmt(f),
            Self::Compensated(error) => error.fmt(f),
            Self::Convolved(error) => write!(f, "{error}; convolve kinds with fewer impulses"),
            Self::MinimumImpulse(error) => error.fmt(f),
        }
    }
}

impl Error for SpecificationError {}

impl From<DesignError> for SpecificationError {
    fn from(error: DesignError) -> Self {
        Self::Design { error, mode: 0 }
    }
}

impl From<SpecifiedError> for SpecificationError {
    fn from(error: SpecifiedError) -> Self {
        Self::Specified { error, mode: 0 }
    }
}

impl From<LimitedError> for SpecificationError {
    fn from(error: LimitedError) -> Self {
        Self::Limited(error)
    }
}

impl From<CompensatedError> for SpecificationError {
    fn from(error: CompensatedError) -> Self {
        Self::Compensated(error)
    }
}

impl From<MinimumImpulseError> for SpecificationError {
    fn from(error: MinimumImpulseError) -> Self {
        Self::MinimumImpulse(error)
    }
}
