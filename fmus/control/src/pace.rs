//! When samples are taken, and how long one lasts.

use serde::{Deserialize, Serialize};

/// Nothing is sampled less often (s).
const LONGEST: f64 = 1e6;

/// The pace of a sampled controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pace {
    last: Option<f64>,
    interval: f64,
}

impl Pace {
    /// A sample is taken at `time` (s); they are taken every `period` (s), or, if that is 0, whenever it suits. Returns whether
    /// it is another at the same instant, which takes the place of the one before.
    ///
    /// Of a period it is the period that counts: who tells the time may have added it up and be off by its rounding.
    pub fn tick(&mut self, time: f64, period: f64) -> bool {
        if self.last == Some(time) {
            return true;
        }
        self.interval = match self.last {
            None => 0.0,
            Some(_) if period > 0.0 => period,
            Some(last) => (time - last).clamp(0.0, LONGEST),
        };
        self.last = Some(time);
        false
    }

    /// From the sample before to the last one (s); 0 for the first.
    #[must_use]
    pub fn interval(&self) -> f64 {
        self.interval
    }

    /// Whether these can be times.
    #[must_use]
    pub fn is_possible(&self) -> bool {
        self.last.is_none_or(f64::is_finite) && (0.0..=LONGEST).contains(&self.interval)
    }
}
