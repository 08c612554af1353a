//! Why there is no such minimum-impulse shaper.

use std::error::Error;
use std::fmt;

/// Why [`minimum_impulse`](crate::minimum_impulse) gives no shaper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MinimumImpulseError {
    /// The modes are too far apart for three impulses of useful size.
    Apart {
        /// The faster frequency over the slower one.
        ratio: f64,
        /// The largest ratio that is designed for.
        most: f64,
    },
    /// There is no solution of this number.
    Solution {
        /// The number asked for, from 1.
        index: usize,
        /// How many there are.
        count: usize,
    },
}

impl fmt::Display for MinimumImpulseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Apart { ratio, most } => write!(
                f,
                "one mode is {ratio} times as fast as the other, and {most} times is the most for minimum impulses; bring \
                 the frequencies closer, or convolve a shaper for each"
            ),
            Self::Solution { count: 0, .. } => {
                f.write_str("minimum impulses have no solution for these modes; lower the damping ratios")
            }
            Self::Solution { index, count } => {
                write!(f, "there is no solution {index}: minimum impulses have {count} for these modes, counted from 1")
            }
        }
    }
}

impl Error for MinimumImpulseError {}
