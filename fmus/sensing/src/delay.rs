//! A delay line: what has been sampled and not yet been given out, each with its time.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use crate::MOST_UNDER_WAY;

/// Room beyond what is under way: for one that is due when the next is taken, and for times that are rounded.
const SPARE: usize = 8;

/// A reading on its way; none where there was nothing to read.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Delayed<T> {
    /// When it is given out (s).
    pub due: f64,
    /// What it says.
    pub reading: Option<T>,
}

/// Readings on their way, the oldest first.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct DelayLine<T> {
    /// How many there is room for.
    room: usize,
    line: VecDeque<Delayed<T>>,
}

impl<T: Copy> DelayLine<T> {
    /// One that is empty, with room for so many.
    pub fn new(under_way: usize) -> Self {
        Self::with_room(under_way.min(MOST_UNDER_WAY) + SPARE)
    }

    fn with_room(room: usize) -> Self {
        Self { room, line: VecDeque::with_capacity(room) }
    }

    /// The same readings with the room there should be; none if they are more, or in no order.
    pub fn restored(&self) -> Option<Self> {
        let Self { room, line } = self;
        let in_order = line.iter().all(|d| d.due.is_finite()) && line.iter().is_sorted_by(|a, b| a.due <= b.due);
        let fits = line.len() <= *room && *room <= MOST_UNDER_WAY + SPARE;
        (in_order && fits).then(|| self.clone())
    }

    /// What is on its way, the oldest first.
    pub fn readings(&self) -> impl Iterator<Item = &T> {
        self.line.iter().filter_map(|delayed| delayed.reading.as_ref())
    }

    /// Whether there is no room left.
    pub fn is_full(&self) -> bool {
        self.line.len() >= self.room
    }

    /// Sends a reading on its way, if there is room; one that is due at the same time is replaced if `again`.
    pub fn send(&mut self, due: f64, reading: Option<T>, again: bool) {
        // Time runs backwards only where an importer makes it; readings stay in order even so.
        let due = self.line.back().map_or(due, |last| last.due.max(due));
        let is_full = self.is_full();
        match self.line.back_mut() {
            Some(last) if again && last.due == due => last.reading = reading,
            _ if is_full => {}
            _ => self.line.push_back(Delayed { due, reading }),
        }
    }

    /// When the next reading is due (s).
    pub fn next(&self) -> Option<f64> {
        self.line.front().map(|delayed| delayed.due)
    }

    /// The next reading, if it is due at `t` (s).
    pub fn take_due(&mut self, t: f64) -> Option<Option<T>> {
        self.line.pop_front_if(|delayed| delayed.due <= t).map(|delayed| delayed.reading)
    }
}

/// A clone has the same room, and copying uses room again, so that neither allocates later.
impl<T: Copy> Clone for DelayLine<T> {
    fn clone(&self) -> Self {
        let mut clone = Self::with_room(self.room);
        clone.clone_from(self);
        clone
    }

    fn clone_from(&mut self, source: &Self) {
        self.room = source.room;
        self.line.clear();
        self.line.reserve(self.room);
        self.line.extend(&source.line);
    }
}
