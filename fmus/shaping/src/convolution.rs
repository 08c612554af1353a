//! Two shapers in series as one train.

use crate::{Impulse, MAX_IMPULSES, Shaper, ShaperError};

/// The train of two shapers in series: every impulse of one, each passed through the other. What either leaves without
/// vibration, the product does. It is as long as both together. Does not allocate.
///
/// Impulses at the same time, to rounding, become one.
///
/// # Errors
/// [`ShaperError::Count`] if that makes more than [`MAX_IMPULSES`]; [`ShaperError::Time`] or [`ShaperError::Amplitude`] if a sum
/// of times or a product of amplitudes is no longer a finite number.
pub fn convolve(first: &Shaper, second: &Shaper) -> Result<Shaper, ShaperError> {
    let same = SAME * first.duration() + SAME * second.duration();
    // A row for each impulse of the first, ascending in time; the next of all rows is the earliest of their heads.
    let mut heads = [0; MAX_IMPULSES];
    let mut train = [Impulse::default(); MAX_IMPULSES];
    let mut count = 0;
    let mut last = None;
    loop {
        let rows = first.impulses().iter().zip(&mut heads);
        let next = rows.filter_map(|(outer, head)| {
            let inner = second.impulses().get(*head)?;
            Some((head, Impulse { time: outer.time + inner.time, amplitude: outer.amplitude * inner.amplitude }))
        });
        let Some((head, impulse)) = next.min_by(|(_, a), (_, b)| a.time.total_cmp(&b.time)) else { break };
        *head += 1;
        let merges = last.is_some_and(|last| impulse.time - last <= same);
        if !merges {
            count += 1;
            last = Some(impulse.time);
        }
        match train.get_mut(count - 1) {
            Some(held) if merges => held.amplitude += impulse.amplitude,
            Some(free) => *free = impulse,
            None => {}
        }
    }
    Shaper::new(train.get(..count).ok_or(ShaperError::Count { count })?)
}

/// Times closer than this share of the duration are equal but for rounding.
const SAME: f64 = 8.0 * f64::EPSILON;
