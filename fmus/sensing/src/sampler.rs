//! Samples: taken at an instant, given out when their latency has passed.

use serde::{Deserialize, Serialize};

use crate::delay::DelayLine;
use crate::{Noise, Timing};

/// What a sampled sensor remembers. A reading `T` is an array of numbers, such as `[f64; 2]`; there is none where the
/// sensor saw nothing.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Parts<T>")]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Copy + AsRef<[f64]> + Deserialize<'de>"))]
pub struct Sampler<T> {
    noise: Noise,
    /// The noise as it was before the last sample, and when that was (s).
    before: Noise,
    last: Option<f64>,
    line: DelayLine<T>,
}

/// What a sampler is serialized as.
#[derive(Deserialize)]
struct Parts<T> {
    noise: Noise,
    before: Noise,
    last: Option<f64>,
    line: DelayLine<T>,
}

impl<T: Copy + AsRef<[f64]>> TryFrom<Parts<T>> for Sampler<T> {
    type Error = &'static str;

    fn try_from(Parts { noise, before, last, line }: Parts<T>) -> Result<Self, Self::Error> {
        if !last.is_none_or(f64::is_finite) {
            return Err("the time of the last sample is not finite");
        }
        if !line.readings().flat_map(AsRef::as_ref).all(|number| number.is_finite()) {
            return Err("a reading is not finite");
        }
        let line = line.restored().ok_or("the readings are not in order, or too many")?;
        Ok(Self { noise, before, last, line })
    }
}

impl<T: Copy> Sampler<T> {
    /// One that has taken no sample, with the noise that a seed gives, and room for samples that are taken like that.
    #[must_use]
    pub fn new(seed: u64, timing: Timing) -> Self {
        let noise = Noise::new(seed);
        Self { before: noise.clone(), noise, last: None, line: DelayLine::new(timing.under_way().ceil() as usize) }
    }

    /// Takes a sample at `t` (s). Returns what `measure` reads if there is no latency; otherwise it is on its way.
    ///
    /// A second sample at the same instant takes the place of the first and has the same noise. Where there is no room for
    /// a sample, none is taken.
    pub fn sample(
        &mut self,
        t: f64,
        timing: Timing,
        measure: impl FnOnce(&mut Noise) -> Option<T>,
    ) -> Option<Option<T>> {
        let again = self.last == Some(t);
        if again {
            self.noise.clone_from(&self.before);
        } else {
            let too_close = |last| (0.0..timing.spacing()).contains(&(t - last));
            if self.line.is_full() || self.last.is_some_and(too_close) {
                return None;
            }
            self.before.clone_from(&self.noise);
            self.last = Some(t);
        }
        let reading = measure(&mut self.noise);
        if timing.latency == 0.0 {
            return Some(reading);
        }
        self.line.send(t + timing.latency, reading, again);
        None
    }

    /// When the next reading is given out (s), if one is on its way.
    #[must_use]
    pub fn next_delivery(&self) -> Option<f64> {
        self.line.next()
    }

    /// Gives out the oldest reading, whose time has come, and all that are due with it at `t` (s).
    pub fn deliver(&mut self, t: f64, mut show: impl FnMut(Option<T>)) {
        // Who tells the time may have added it up and be off by its rounding.
        let due = self.line.next().map_or(t, |due| due.max(t));
        while let Some(reading) = self.line.take_due(due) {
            show(reading);
        }
    }
}

impl<T: Copy> Default for Sampler<T> {
    fn default() -> Self {
        Self::new(0, Timing { sample_time: 0.0, latency: 0.0 })
    }
}

/// Copying into a sampler uses its room again.
impl<T: Copy> Clone for Sampler<T> {
    fn clone(&self) -> Self {
        Self { noise: self.noise.clone(), before: self.before.clone(), last: self.last, line: self.line.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.noise.clone_from(&source.noise);
        self.before.clone_from(&source.before);
        self.last = source.last;
        self.line.clone_from(&source.line);
    }
}
