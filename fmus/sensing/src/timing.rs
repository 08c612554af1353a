//! When samples are taken, and how late they are.

use std::error::Error;
use std::fmt;

/// How many samples may be under way at once.
pub const MOST_UNDER_WAY: usize = 1000;

/// No sensor samples faster (s): a second of it still takes but a moment to compute.
const SHORTEST: f64 = 1e-5;

/// When samples are taken, and how late they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The time from one sample to the next (s); 0 if they are taken whenever it suits.
    pub sample_time: f64,
    /// The time from taking a sample to giving it out (s).
    pub latency: f64,
}

/// Why samples cannot be taken like that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimingError {
    /// The samples follow each other too fast.
    SampleTime(Timing),
    /// More samples would be under way than there is room for.
    Latency(Timing),
}

impl Timing {
    /// How many samples are under way: as many as may be where they are taken whenever it suits.
    pub(crate) fn under_way(&self) -> f64 {
        if self.latency == 0.0 {
            0.0
        } else if self.sample_time == 0.0 {
            MOST_UNDER_WAY as f64
        } else {
            self.latency / self.sample_time
        }
    }

    /// Whether samples can be taken like that: no faster than every 10 µs, and no more than [`MOST_UNDER_WAY`] at once.
    ///
    /// # Errors
    /// What is wrong, with the nearest values that would do.
    pub fn check(&self) -> Result<(), TimingError> {
        // What is told as the nearest value must do, however it is rounded.
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        if self.sample_time > 0.0 && self.sample_time < SHORTEST {
            return Err(TimingError::SampleTime(*self));
        }
        if self.under_way() > MOST_UNDER_WAY as f64 * (1.0 + ROUNDING) {
            return Err(TimingError::Latency(*self));
        }
        Ok(())
    }

    /// The least time from one sample to the next (s). Samples that are taken whenever it suits are thinned out, so that
    /// all that are under way have room.
    pub(crate) fn spacing(&self) -> f64 {
        if self.sample_time == 0.0 { self.latency / MOST_UNDER_WAY as f64 } else { 0.0 }
    }
}

impl TimingError {
    /// The name of what is refused.
    #[must_use]
    pub fn quantity(&self) -> &'static str {
        match self {
            Self::SampleTime(_) => "sample_time",
            Self::Latency(_) => "latency",
        }
    }
}

/// As it goes on after the name of what is refused.
impl fmt::Display for TimingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SampleTime(Timing { sample_time, .. }) => {
                write!(f, "is {sample_time} s; it must be 0 or at least {SHORTEST} s")
            }
            Self::Latency(Timing { sample_time, latency }) => write!(
                f,
                "is {latency} s; with a sample every {sample_time} s there is room for {MOST_UNDER_WAY} that are under \
                 way: it must be at most {} s, or sample_time at least {} s",
                MOST_UNDER_WAY as f64 * sample_time,
                latency / MOST_UNDER_WAY as f64,
            ),
        }
    }
}

impl Error for TimingError {}
