//! When clocks tick: at `base + n·interval`, never summed up, or when the model says.

use serde::{Deserialize, Serialize};

use crate::clocks::{Clock, Interval};
use crate::instance::is_due;
use crate::model::{Model, Point};

/// Where a clock is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timer {
    /// The tick from which the next ones are counted (s), and how many have followed it.
    base: f64,
    count: f64,
    /// The next tick of an aperiodic clock (s).
    due: Option<f64>,
    /// Interval and shift that the importer has set (s).
    set_interval: Option<f64>,
    set_shift: Option<f64>,
    /// What the importer was told last, and whether there is news since.
    told: Option<f64>,
    fresh: bool,
    /// The last activation in scheduled execution (s).
    activated: Option<f64>,
}

/// What the importer is told of an interval. The numbers are the standard's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Qualifier {
    /// Not known yet.
    NotYetKnown = 0,
    /// What was told before still holds.
    Unchanged = 1,
    /// It is new.
    Changed = 2,
}

/// The clocks of an instance.
#[derive(Debug, Clone)]
pub struct Schedule {
    clocks: &'static [Clock],
    /// The clocks in the order in which they are computed when they tick at once.
    order: Vec<usize>,
    timers: Vec<Timer>,
    /// The interval of each periodic clock now (s); 0 means at every event and communication point.
    intervals: Vec<f64>,
}

const STOPPED: Timer = Timer {
    base: 0.0,
    count: 0.0,
    due: None,
    set_interval: None,
    set_shift: None,
    told: None,
    fresh: false,
    activated: None,
};

/// The clocks that are members of a set of bits.
pub fn members(set: u64, of: &[usize]) -> impl Iterator<Item = usize> {
    of.iter().copied().filter(move |clock| set >> clock & 1 == 1)
}

impl Schedule {
    /// Of clocks that have not been started.
    pub fn new(clocks: &'static [Clock]) -> Self {
        // A general sort is 5 kB of code, and clocks are few.
        let mut order = Vec::with_capacity(clocks.len());
        for (clock, Clock { priority, .. }) in clocks.iter().enumerate() {
            let before = order.iter().filter(|other: &&usize| clocks[**other].priority <= *priority).count();
            order.insert(before, clock);
        }
        let intervals = clocks.iter().map(|clock| clock.interval.declared().unwrap_or(0.0)).collect();
        Self { clocks, order, timers: vec![STOPPED; clocks.len()], intervals }
    }

    /// The clocks in the order in which they are computed.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// The interval of each clock (s).
    pub fn intervals(&self) -> &[f64] {
        &self.intervals
    }

    /// The state of each clock, for snapshots.
    pub fn parts(&self) -> (&[Timer], &[f64]) {
        (&self.timers, &self.intervals)
    }

    /// Goes on from another schedule of the same clocks.
    pub fn set_parts(&mut self, timers: &[Timer], intervals: &[f64]) {
        self.timers.clone_from_slice(timers);
        self.intervals.copy_from_slice(intervals);
    }

    /// Goes on from another schedule of the same clocks, without new room.
    pub fn take(&mut self, other: &Self) {
        self.timers.clone_from_slice(&other.timers);
        self.intervals.copy_from_slice(&other.intervals);
    }

    /// Starts the periodic clocks, before the first event.
    pub fn start_periodic<M: Model>(&mut self, t: f64, p: &M::Parameters<f64>) {
        for (i, timer) in self.timers.iter_mut().enumerate() {
            let clock = &self.clocks[i];
            timer.activated = None;
            if clock.interval.is_periodic() {
                let of_model = || positive(M::interval(i, p));
                self.intervals[i] = timer.set_interval.or(clock.interval.declared()).unwrap_or_else(of_model);
                timer.base = t + timer.set_shift.unwrap_or(clock.shift);
                timer.count = 0.0;
                timer.fresh = timer.told != Some(self.intervals[i]);
            }
        }
    }

    /// Starts the clocks whose ticks the model knows, after the first event.
    pub fn start_aperiodic<M: Model>(&mut self, at: &Point<'_, M, f64>) {
        for (i, timer) in self.timers.iter_mut().enumerate() {
            if matches!(self.clocks[i].interval, Interval::Changing | Interval::Countdown) {
                timer.due = M::next_tick(i, at);
                timer.fresh = timer.due.is_some_and(|due| timer.told != Some(ahead(due, at.t)));
            }
        }
    }

    /// The clocks that tick at an event, one bit each: those that are due, and those that tick always.
    pub fn ticking(&self, t: f64) -> u64 {
        self.due(t) | self.set_of(|clock| self.ticks_always(clock))
    }

    /// The clocks whose time has come, one bit each.
    pub fn due(&self, t: f64) -> u64 {
        self.set_of(|clock| self.next_of(clock).is_some_and(|next| is_due(next, t)))
    }

    fn set_of(&self, is_member: impl Fn(usize) -> bool) -> u64 {
        (0..self.clocks.len()).filter(|clock| is_member(*clock)).fold(0, |set, clock| set | 1 << clock)
    }

    /// The earliest tick that is known (s).
    pub fn next(&self) -> Option<f64> {
        (0..self.clocks.len()).filter_map(|clock| self.next_of(clock)).reduce(f64::min)
    }

    /// Whether a clock ticks at every communication point.
    pub fn is_restless(&self) -> bool {
        (0..self.clocks.len()).any(|clock| self.ticks_always(clock))
    }

    fn ticks_always(&self, clock: usize) -> bool {
        self.clocks[clock].interval.is_periodic() && self.intervals[clock] == 0.0
    }

    fn next_of(&self, clock: usize) -> Option<f64> {
        let timer = &self.timers[clock];
        if !self.clocks[clock].interval.is_periodic() {
            timer.due
        } else if self.intervals[clock] > 0.0 {
            Some(timer.base + timer.count * self.intervals[clock])
        } else {
            None
        }
    }

    /// What follows from an event at which some clocks have ticked.
    pub fn after<M: Model>(&mut self, ticked: u64, at: &Point<'_, M, f64>) {
        for i in 0..self.clocks.len() {
            let has_ticked = ticked >> i & 1 == 1;
            let kind = self.clocks[i].interval;
            if kind == Interval::OfTunableParameters && self.intervals[i] != positive(M::interval(i, at.p)) {
                self.change_interval(i, at.t, positive(M::interval(i, at.p)));
                self.timers[i].fresh = true;
            } else if kind.is_periodic() && has_ticked {
                let timer = &mut self.timers[i];
                timer.count += 1.0;
                // Ticks that a long step has passed over are not made up for.
                let interval = self.intervals[i];
                let passed = ((at.t - timer.base) / interval).floor();
                if passed.is_finite() && is_due(timer.base + timer.count * interval, at.t) {
                    timer.count = passed + 1.0;
                    // The tick at this very time may lie a rounding behind.
                    timer.count += f64::from(is_due(timer.base + timer.count * interval, at.t));
                }
            } else if kind == Interval::Changing && has_ticked {
                self.timers[i].due = M::next_tick(i, at);
                self.timers[i].fresh = self.timers[i].due.is_some();
            } else if kind == Interval::Countdown {
                let due = M::next_tick(i, at);
                let timer = &mut self.timers[i];
                if has_ticked || due != timer.due {
                    timer.due = due;
                    timer.fresh = due.is_some();
                }
            }
        }
    }

    /// Whether there is news of a countdown that the importer has not been told.
    pub fn has_news_of_countdowns(&self) -> bool {
        let news = |(clock, timer): (&Clock, &Timer)| clock.interval == Interval::Countdown && timer.fresh;
        self.clocks.iter().zip(&self.timers).any(news)
    }

    /// A new interval, counted from now.
    fn change_interval(&mut self, clock: usize, t: f64, interval: f64) {
        self.intervals[clock] = interval;
        self.timers[clock].base = t;
        self.timers[clock].count = 1.0;
    }

    /// Takes the importer's interval; while the simulation runs it counts from now.
    pub fn set_interval(&mut self, clock: usize, interval: f64, now: Option<f64>) {
        self.timers[clock].set_interval = Some(interval);
        self.intervals[clock] = interval;
        if let Some(t) = now {
            self.change_interval(clock, t, interval);
        }
    }

    /// Takes the importer's shift.
    pub fn set_shift(&mut self, clock: usize, shift: f64) {
        self.timers[clock].set_shift = Some(shift);
    }

    /// How long after the start a periodic clock ticks first (s).
    pub fn shift(&self, clock: usize) -> f64 {
        self.timers[clock].set_shift.unwrap_or(self.clocks[clock].shift)
    }

    /// Tells the importer of an interval: the table "Allowed qualifiers for time-based Clocks" of FMI 3.0.2, 2.2.8.4.
    pub fn tell(&mut self, clock: usize, t: f64) -> (f64, Qualifier) {
        let kind = self.clocks[clock].interval;
        let timer = &mut self.timers[clock];
        let value = if kind.is_periodic() { Some(self.intervals[clock]) } else { timer.due.map(|due| ahead(due, t)) };
        let Some(value) = value else { return (0.0, Qualifier::NotYetKnown) };
        if kind.declared().is_some() {
            return (value, Qualifier::Unchanged);
        }
        if std::mem::take(&mut timer.fresh) {
            timer.told = Some(value);
            return (value, Qualifier::Changed);
        }
        (timer.told.unwrap_or(value), Qualifier::Unchanged)
    }

    /// Notes an activation in scheduled execution; refuses one that is not later than the last.
    pub fn activate(&mut self, clock: usize, t: f64) -> bool {
        let later = self.timers[clock].activated.is_none_or(|last| t > last);
        if later {
            self.timers[clock].activated = Some(t);
        }
        later
    }
}

/// How long it is until a tick, which may be late.
fn ahead(due: f64, t: f64) -> f64 {
    (due - t).max(0.0)
}

/// An interval that can be counted in; anything else means at every event.
fn positive(interval: f64) -> f64 {
    if interval > 0.0 && interval.is_finite() { interval } else { 0.0 }
}
