//! Why there is no shaper for a range.

use std::error::Error;
use std::fmt;

use crate::{MAX_IMPULSES, ModeError};

/// Why [`specified_insensitivity`](crate::specified_insensitivity) gives no shaper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpecifiedError {
    /// An end of the range is no usable frequency, or the damping ratio is outside 0 ≤ ζ < 1.
    Mode(ModeError),
    /// There is no range at all.
    NoRange,
    /// A range is too far above the slowest one.
    Apart {
        /// The highest frequency over the middle of the slowest range.
        ratio: f64,
        /// The largest ratio that is designed for.
        most: f64,
    },
    /// The lower end of the range is above the upper end.
    Reversed {
        /// Lower end, rad/s.
        lower: f64,
        /// Upper end, rad/s.
        upper: f64,
    },
    /// The insensitivity (full width over frequency) is outside 0 ≤ I < 2.
    Insensitivity {
        /// What was given.
        value: f64,
    },
    /// The vibration limit is outside 0 < V < 1.
    VibrationLimit {
        /// What was given.
        value: f64,
    },
    /// The shortest shaper is longer than twelve periods of the range's middle frequency.
    TooLong,
    /// The shortest shaper has more than [`MAX_IMPULSES`] impulses.
    TooManyImpulses {
        /// How many it has.
        count: usize,
    },
    /// Ranges so wide, or a limit so low, ask for more impulses than can be worked out.
    TooWide,
    /// The damping ratio is so large that waiting beats shaping: the best train has no impulse at its end.
    Waiting,
    /// The search ended without a train that could be proved to be the shortest.
    NotFound,
}

impl fmt::Display for SpecifiedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mode(error) => error.fmt(f),
            Self::Apart { ratio, most } => write!(
                f,
                "the highest frequency is {ratio} times the slowest range's middle, and {most} times is the most for one \
                 shaper; bring the ranges closer, or convolve a shaper for each"
            ),
            Self::Reversed { lower, upper } => {
                write!(f, "the range's lower end, {lower} rad/s, is above its upper end, {upper} rad/s; swap them")
            }
            Self::NoRange => f.write_str("there is no range of frequencies to design for; give at least one"),
            Self::Insensitivity { value } => {
                write!(f, "the insensitivity is {value}; it must be at least 0 and less than 2")
            }
            Self::VibrationLimit { value } => write!(
                f,
                "the vibration limit is {value}; over a range of frequencies it must be greater than 0 and less than 1"
            ),
            Self::TooLong => f.write_str(
                "the shortest shaper is longer than twelve periods; raise the vibration limit or the range's lower end",
            ),
            Self::TooManyImpulses { count } => write!(
                f,
                "the shortest shaper has {count} impulses, and {MAX_IMPULSES} is the most; raise the vibration limit or \
                 narrow the range"
            ),
            Self::TooWide => f.write_str(
                "so wide a range with so low a vibration limit takes too many impulses; raise the vibration limit or narrow the \
                 range",
            ),
            Self::Waiting => f.write_str(
                "damping alone is quicker than shaping: the best train ends before its vibration is down to the limit; \
                 lower the damping ratio or the vibration limit",
            ),
            Self::NotFound => f.write_str(
                "no train was found that could be proved to be the shortest; change the range or the vibration limit a little",
            ),
        }
    }
}

impl Error for SpecifiedError {}

impl From<ModeError> for SpecifiedError {
    fn from(error: ModeError) -> Self {
        Self::Mode(error)
    }
}
