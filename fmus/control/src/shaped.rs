//! A velocity that changes all the time, through a shaper that may change too.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};
use swayless_shaping::Shaper;

use crate::crane::BOUND;

/// Room for so many samples of the past; where they come more densely, some are left out.
const ROOM: usize = 2048;

/// The past of a velocity, linear from sample to sample, and what a shaper makes of it: v_s(t) = Σ Aᵢ v(t − tᵢ).
///
/// For a velocity that jumps, `swayless_shaping::Trains` is exact; this is for one that runs in ramps, of which every sample
/// would be a train.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct Shaped {
    /// Time (s) and velocity, the oldest first.
    past: VecDeque<[f64; 2]>,
}

impl TryFrom<Vec<[f64; 2]>> for Shaped {
    type Error = &'static str;

    fn try_from(past: Vec<[f64; 2]>) -> Result<Self, Self::Error> {
        if past.len() > ROOM || !past.iter().flatten().all(|number| number.abs() <= BOUND) {
            return Err("a past has too much in it");
        }
        if !past.is_sorted_by(|a, b| a[0] < b[0]) {
            return Err("a past is not in order");
        }
        let mut shaped = Self::new();
        shaped.past.extend(past);
        Ok(shaped)
    }
}

impl From<Shaped> for Vec<[f64; 2]> {
    fn from(shaped: Shaped) -> Self {
        shaped.past.into()
    }
}

/// A clone has the same room, and copying uses room again.
impl Clone for Shaped {
    fn clone(&self) -> Self {
        let mut clone = Self { past: VecDeque::with_capacity(self.past.capacity()) };
        clone.clone_from(self);
        clone
    }

    fn clone_from(&mut self, source: &Self) {
        self.past.clear();
        self.past.reserve(source.past.capacity());
        self.past.extend(&source.past);
    }
}

impl Shaped {
    /// Nothing yet, with all the room there will be.
    #[must_use]
    pub fn new() -> Self {
        Self { past: VecDeque::with_capacity(ROOM) }
    }

    /// Forgets the past: it has always been 0, until `time` (s).
    pub fn rest(&mut self, time: f64) {
        self.past.clear();
        self.past.push_back([time, 0.0]);
    }

    /// The velocity at `time` (s), the latest yet; a second one at the same time takes the place of the first. Of what is older
    /// than `duration` (s) only as much is kept as a shaper needs that gets longer.
    pub fn push(&mut self, time: f64, velocity: f64, duration: f64) {
        const KEPT: f64 = 1.5;
        let spacing = KEPT * duration / (ROOM - 8) as f64;
        // Where time runs backwards, which only an importer can make it, what was to come never was.
        while self.past.pop_back_if(|[newest, _]| *newest >= time).is_some() {}
        if let Some(before) = self.past.len().checked_sub(2)
            && time - self.past[before][0] < spacing
        {
            self.past.pop_back();
        }
        while self.past.len() >= ROOM || (self.past.len() > 1 && self.past[1][0] <= time - KEPT * duration) {
            self.past.pop_front();
        }
        self.past.push_back([time, velocity]);
    }

    /// The velocity at a time (s) gone by.
    fn at(&self, time: f64) -> f64 {
        let after = self.past.partition_point(|[then, _]| *then <= time);
        let Some(&[before, value]) = after.checked_sub(1).and_then(|before| self.past.get(before)) else {
            return self.past.front().map_or(0.0, |[_, oldest]| *oldest);
        };
        match self.past.get(after) {
            Some(&[next, next_value]) => value + (next_value - value) * ((time - before) / (next - before)),
            None => value,
        }
    }

    /// The shaped velocity at a time (s), the latest that there was a velocity for.
    #[must_use]
    pub fn value(&self, time: f64, shaper: &Shaper) -> f64 {
        shaper.impulses().iter().map(|impulse| impulse.amplitude * self.at(time - impulse.time)).sum()
    }

    /// The way (m) from one time (s) to a later one.
    fn way(&self, from: f64, to: f64) -> f64 {
        let first = self.past.partition_point(|[then, _]| *then <= from);
        let inside = self.past.range(first..).take_while(|[then, _]| *then < to).copied();
        let (mut way, mut before) = (0.0, [from, self.at(from)]);
        for next in inside.chain([[to, self.at(to)]]) {
            way += 0.5 * (before[1] + next[1]) * (next[0] - before[0]);
            before = next;
        }
        way
    }

    /// The way (m) that has been asked for by a time (s) and that a shaper has still to let through.
    #[must_use]
    pub fn pending(&self, time: f64, shaper: &Shaper) -> f64 {
        shaper.impulses().iter().map(|impulse| impulse.amplitude * self.way(time - impulse.time, time)).sum()
    }

    /// Whether it has been what it is for as long as a shaper remembers, `duration` (s).
    #[must_use]
    pub fn is_steady(&self, time: f64, duration: f64) -> bool {
        // What is slower swings no load by as much as a micrometre.
        const STILL: f64 = 1e-6;
        let (since, now) = (time - duration, self.at(time));
        let is_same = |velocity: f64| (velocity - now).abs() <= STILL;
        is_same(self.at(since))
            && self.past.iter().rev().take_while(|[then, _]| *then > since).all(|[_, v]| is_same(*v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use swayless_shaping::{Kind, Mode, design};

    fn shaper() -> Shaper {
        design(Kind::ZVD, Mode::new(1.1, 0.1).expect("a mode"), 0.0).expect("a design")
    }

    /// Up and down again, in ramps whose corners are samples.
    fn ramps(time: f64) -> f64 {
        0.3 * (time.clamp(1.0, 3.0) - 1.0) - 0.2 * (time.clamp(6.0, 9.0) - 6.0)
    }

    #[test]
    fn ramps_are_shaped_exactly_whatever_the_samples() {
        let shaper = shaper();
        for interval in [0.25, 0.01, 1e-3] {
            let mut shaped = Shaped::new();
            shaped.rest(0.0);
            for i in 1..=(20.0 / interval) as u32 {
                let time = f64::from(i) * interval;
                shaped.push(time, ramps(time), shaper.duration());
                let wanted: f64 = shaper.impulses().iter().map(|a| a.amplitude * ramps(time - a.time)).sum();
                // Samples that are left out, where they are dense, may have been corners.
                let error = (shaped.value(time, &shaper) - wanted).abs();
                assert!(error < if interval < 5e-3 { 2e-3 } else { 1e-13 }, "{error} m/s at {time} s");
                // After the last corner and all that the shaper remembers.
                let steady =
                    (3.0 + shaper.duration()..6.0).contains(&time) || time > 9.0 + shaper.duration() + interval;
                assert!(!steady || shaped.is_steady(time, shaper.duration()), "{time} s");
                assert!(shaped.past.len() <= ROOM && shaped.past.capacity() >= ROOM);
            }
        }
    }

    /// What has gone in is what has come out and what is pending.
    #[test]
    fn nothing_is_lost_on_the_way() {
        let (shaper, interval) = (shaper(), 0.01);
        let mut shaped = Shaped::new();
        shaped.rest(0.0);
        let (mut way_in, mut way_out, mut before, mut most) = (0.0, 0.0, [0.0; 2], 0.0_f64);
        for i in 1..=2000 {
            let time = f64::from(i) * interval;
            shaped.push(time, ramps(time), shaper.duration());
            let now = [ramps(time), shaped.value(time, &shaper)];
            way_in += 0.5 * interval * (before[0] + now[0]);
            way_out += 0.5 * interval * (before[1] + now[1]);
            before = now;
            let pending = shaped.pending(time, &shaper);
            most = most.max(pending);
            // The sums take corners between samples as straight: 0.5 m/s² in an interval, at most 10 of them.
            assert!((way_in - way_out - pending).abs() < 1e-4, "{way_in} in, {way_out} out, {pending} m at {time} s");
        }
        assert!(most > 1.0 && shaped.pending(30.0, &shaper).abs() < 1e-12);
    }

    #[test]
    fn what_cannot_have_been_is_refused() {
        let past = |past: &[[f64; 2]]| Shaped::try_from(past.to_vec());
        assert!(past(&[[0.0, 1.0], [0.5, 2.0]]).is_ok());
        assert!(past(&[[0.5, 1.0], [0.0, 2.0]]).is_err());
        assert!(past(&[[0.0, f64::NAN]]).is_err());
        assert!(past(&[[f64::INFINITY, 1.0]]).is_err());
        let many: Vec<_> = (0..=ROOM).map(|i| [i as f64, 0.0]).collect();
        assert!(past(&many).is_err());
    }
}
