//! An impulse train of fixed capacity.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::ShaperError;

/// The most impulses a [`Shaper`] holds.
pub const MAX_IMPULSES: usize = 32;

/// One impulse of a shaper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Impulse {
    /// When it acts, in seconds after the change of the command.
    pub time: f64,
    /// The share of the change that it passes on.
    pub amplitude: f64,
}

/// An input shaper: impulses in strictly ascending order of time. It lives on the stack.
#[derive(Serialize, Deserialize)]
#[serde(try_from = "Vec<Impulse>", into = "Vec<Impulse>")]
pub struct Shaper {
    count: usize,
    /// Those beyond the count are never looked at.
    impulses: [Impulse; MAX_IMPULSES],
}

/// Copying into a shaper copies what there is, not what there is room for: it happens in every step that has an event.
impl Clone for Shaper {
    fn clone(&self) -> Self {
        Self::ordered(self.impulses())
    }

    fn clone_from(&mut self, source: &Self) {
        self.count = source.count;
        self.impulses[..source.count].copy_from_slice(source.impulses());
    }
}

impl Shaper {
    /// A shaper of the given impulses.
    ///
    /// # Errors
    /// [`ShaperError`] unless there are 1 to [`MAX_IMPULSES`] finite impulses whose times are at least 0 and strictly
    /// ascending. The amplitudes need not sum to 1.
    pub fn new(impulses: &[Impulse]) -> Result<Self, ShaperError> {
        if impulses.is_empty() || impulses.len() > MAX_IMPULSES {
            return Err(ShaperError::Count { count: impulses.len() });
        }
        let mut before = None;
        for (index, &Impulse { time, amplitude }) in impulses.iter().enumerate() {
            if !time.is_finite() || before.map_or(time < 0.0, |before| time <= before) {
                return Err(ShaperError::Time { index, value: time });
            }
            if !amplitude.is_finite() {
                return Err(ShaperError::Amplitude { index, value: amplitude });
            }
            before = Some(time);
        }
        Ok(Self::ordered(impulses))
    }

    /// The shaper that changes nothing: one impulse of amplitude 1 at time 0.
    #[must_use]
    pub fn unshaped() -> Self {
        Self::of([(0.0, 1.0)])
    }

    /// A shaper of (time, amplitude) pairs from a design, which knows them to be in order.
    pub(crate) fn of<const N: usize>(pairs: [(f64, f64); N]) -> Self {
        const { assert!(0 < N && N <= MAX_IMPULSES) }
        Self::ordered(&pairs.map(|(time, amplitude)| Impulse { time, amplitude }))
    }

    /// A shaper of impulses that are known to be in order, and no more than [`MAX_IMPULSES`].
    pub(crate) fn ordered(impulses: &[Impulse]) -> Self {
        let mut shaper = Self { count: impulses.len(), impulses: [Impulse::default(); MAX_IMPULSES] };
        shaper.impulses[..impulses.len()].copy_from_slice(impulses);
        debug_assert!(shaper.impulses().is_sorted_by(|a, b| a.time < b.time));
        shaper
    }

    /// A shaper for a unit frequency, at another one (rad/s): the same impulses, all times divided by it.
    pub(crate) fn at_frequency(mut self, frequency: f64) -> Self {
        self.impulses[..self.count].iter_mut().for_each(|impulse| impulse.time /= frequency);
        self
    }

    /// The same amplitudes at other times, which have the same order.
    pub(crate) fn map_times(&self, time: impl Fn(&Impulse) -> f64) -> Self {
        let mut mapped = self.clone();
        mapped.impulses[..self.count].iter_mut().for_each(|impulse| impulse.time = time(impulse));
        mapped
    }

    /// The impulses in order of time; at least one.
    #[must_use]
    pub fn impulses(&self) -> &[Impulse] {
        &self.impulses[..self.count]
    }

    /// Time of the last impulse in seconds: the delay that shaping adds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.impulses[self.count - 1].time
    }

    /// Sum of the amplitudes; 1 for every designed shaper, so that the command's end value is reached.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.impulses().iter().map(|impulse| impulse.amplitude).sum()
    }

    /// Whether no amplitude is negative: such a shaper never exceeds the range or the slope of the command.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.impulses().iter().all(|impulse| impulse.amplitude >= 0.0)
    }
}

impl TryFrom<Vec<Impulse>> for Shaper {
    type Error = ShaperError;

    fn try_from(impulses: Vec<Impulse>) -> Result<Self, Self::Error> {
        Self::new(&impulses)
    }
}

impl From<Shaper> for Vec<Impulse> {
    fn from(shaper: Shaper) -> Self {
        shaper.impulses().to_vec()
    }
}

impl PartialEq for Shaper {
    fn eq(&self, other: &Self) -> bool {
        self.impulses() == other.impulses()
    }
}

impl fmt::Debug for Shaper {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.impulses()).finish()
    }
}
