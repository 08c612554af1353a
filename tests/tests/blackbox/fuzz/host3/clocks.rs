//! Intervals and shifts of clocks.

use super::Instance;
use crate::fuzz::call::{Access, Answer, Timing};
use crate::fuzz::library::{UNTOUCHED, array, array_mut};

impl Instance {
    pub fn get_timing(&self, of: Timing, clocks: &Access) -> Option<Answer> {
        let (f, i, n) = (&self.f, self.instance, clocks.references.len());
        let references = array(&clocks.references, false);
        let mut times = vec![UNTOUCHED; n];
        let (mut counters, mut resolutions, mut qualifiers) = (vec![0; n], vec![1; n], vec![0; n]);
        let time = array_mut(&mut times, clocks.null);
        let [counter, resolution] = [&mut counters, &mut resolutions].map(|values| array_mut(values, clocks.null));
        let qualifier = array_mut(&mut qualifiers, false);
        // SAFETY: an instance; as many references and places as announced, or NULL.
        let status = unsafe {
            match (of.shift, of.fraction) {
                (false, false) => f.fmi3GetIntervalDecimal?(i, references, n, time, qualifier),
                (false, true) => f.fmi3GetIntervalFraction?(i, references, n, counter, resolution, qualifier),
                (true, false) => f.fmi3GetShiftDecimal?(i, references, n, time),
                (true, true) => f.fmi3GetShiftFraction?(i, references, n, counter, resolution),
            }
        };
        let bits = times.into_iter().map(f64::to_bits).chain(counters).chain(resolutions);
        Some(Answer {
            status,
            bits: bits.chain(qualifiers.into_iter().map(|q| q as u64)).collect(),
            ..Answer::default()
        })
    }

    pub fn set_timing(&self, of: Timing, clocks: &Access, times: &[f64]) -> Option<Answer> {
        let (f, i, n) = (&self.f, self.instance, clocks.references.len());
        let references = array(&clocks.references, false);
        let (counters, resolutions): (Vec<_>, Vec<_>) = times.iter().map(|time| ((time * 1e3) as u64, 1000)).unzip();
        let time = array(times, clocks.null);
        let [counter, resolution] = [&counters, &resolutions].map(|values| array(values, clocks.null));
        // SAFETY: as above.
        let status = unsafe {
            match (of.shift, of.fraction) {
                (false, false) => f.fmi3SetIntervalDecimal?(i, references, n, time),
                (false, true) => f.fmi3SetIntervalFraction?(i, references, n, counter, resolution),
                (true, false) => f.fmi3SetShiftDecimal?(i, references, n, time),
                (true, true) => f.fmi3SetShiftFraction?(i, references, n, counter, resolution),
            }
        };
        Some(Answer { status, ..Answer::default() })
    }
}
