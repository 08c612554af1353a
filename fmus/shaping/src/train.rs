//! Shaping a command that changes at any time: one impulse train per change, at exact times.

use serde::{Deserialize, Serialize};

use crate::{Design, Shaper};

/// A part of a command that is still to come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pending {
    /// When it comes, in seconds.
    pub time: f64,
    /// By how much the shaped command changes then.
    pub amount: f64,
}

/// The impulse trains that a command has set going and that have not all arrived.
///
/// Each change of the command is shaped with the design given for it, whatever later changes use. The shaped command is the
/// command less all that is pending: once nothing is, it *is* the command, to the last bit, and rounding never accumulates.
///
/// Time is expected not to run backwards; a value once passed on stays so.
#[derive(Debug, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
pub struct Trains {
    command: f64,
    value: f64,
    /// When of those trains that should be alone the last one ends, and the one before (s).
    ends: [f64; 2],
    /// Latest first, so that the next one is at the end.
    pending: Vec<Pending>,
}

/// What trains are serialized as.
#[derive(Deserialize)]
struct Parts {
    command: f64,
    value: f64,
    ends: [f64; 2],
    pending: Vec<Pending>,
}

impl TryFrom<Parts> for Trains {
    type Error = &'static str;

    fn try_from(Parts { command, value, ends, pending }: Parts) -> Result<Self, Self::Error> {
        let finite = |pending: &Pending| pending.time.is_finite() && pending.amount.is_finite();
        if !command.is_finite() || !value.is_finite() || !pending.iter().all(finite) {
            return Err("a command or pending impulse is not finite");
        }
        if !ends.iter().all(|end| end.is_finite()) || ends[0] < ends[1] {
            return Err("the ends of trains are not in order");
        }
        if !pending.is_sorted_by(|a, b| a.time >= b.time) {
            return Err("the pending impulses are not in order");
        }
        Ok(Self { command, value, ends, pending })
    }
}

/// A clone has the same room, so that it allocates as little later as the original.
impl Clone for Trains {
    fn clone(&self) -> Self {
        let mut clone = Self::new(self.command, self.pending.capacity());
        clone.clone_from(self);
        clone
    }

    fn clone_from(&mut self, source: &Self) {
        self.command = source.command;
        self.value = source.value;
        self.ends = source.ends;
        self.pending.clone_from(&source.pending);
    }
}

impl Trains {
    /// Starts with the command's present value, all of it passed on, and room for `capacity` pending impulses. More than that
    /// are possible, but make room by allocating.
    #[must_use]
    pub fn new(command: f64, capacity: usize) -> Self {
        Self { command, value: command, ends: [f64::MIN; 2], pending: Vec::with_capacity(capacity) }
    }

    /// The command has a new value from `time` on; the change spawns a train of `design`. Impulses due at `time` act at once.
    /// Returns the shaped command.
    ///
    /// Where a design has another train for braking, a change from u⁻ to u⁺ that makes the command grow in magnitude is
    /// accelerating and one that makes it shrink braking. One that changes its sign is both at once, −u⁻ and +u⁺.
    pub fn set_command(&mut self, time: f64, command: f64, design: &Design) -> f64 {
        let before = self.command;
        let change = command - before;
        self.command = command;
        match design.braking() {
            Some(braking) if before != 0.0 && command != 0.0 && (before < 0.0) != (command < 0.0) => {
                self.spawn(time, -before, braking, design.adds_up());
                self.spawn(time, command, design.shaper(), design.adds_up());
            }
            Some(braking) if command.abs() < before.abs() => self.spawn(time, change, braking, design.adds_up()),
            _ if change != 0.0 => self.spawn(time, change, design.shaper(), design.adds_up()),
            _ => {}
        }
        self.release(time);
        self.value = self.sum();
        self.value
    }

    /// Passes on what is due up to `time`, that time included, and returns the shaped command. Costs next to nothing when
    /// nothing is due.
    pub fn advance(&mut self, time: f64) -> f64 {
        if self.release(time) {
            self.value = self.sum();
        }
        self.value
    }

    /// The command last set.
    #[must_use]
    pub fn command(&self) -> f64 {
        self.command
    }

    /// The shaped command at the time last set or advanced to.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value
    }

    /// Whether at a time, not before that last set or advanced to, trains overlap that are exact only alone.
    #[must_use]
    pub fn interfere(&self, time: f64) -> bool {
        !is_due(self.ends[1], time)
    }

    /// When the next impulse is due; `None` when all trains have finished.
    #[must_use]
    pub fn next_time(&self) -> Option<f64> {
        self.pending.last().map(|next| next.time)
    }

    /// What is still to come, the next one first.
    pub fn pending(&self) -> impl ExactSizeIterator<Item = Pending> {
        self.pending.iter().rev().copied()
    }

    /// How many pending impulses there is room for without allocating.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.pending.capacity()
    }

    /// Merges the train of one change into the queue, from its end, where the next ones are. Of impulses at the same time the
    /// one spawned first comes first.
    fn spawn(&mut self, start: f64, delta: f64, shaper: &Shaper, adds_up: bool) {
        if !adds_up {
            let end = start + shaper.duration();
            let [last, before] = self.ends;
            self.ends = if end > last { [end, last] } else { [last, before.max(end)] };
        }
        let later = shaper.impulses().iter().skip_while(|impulse| is_due(start + impulse.time, start));
        let mut new =
            later.map(|impulse| Pending { time: start + impulse.time, amount: delta * impulse.amplitude }).peekable();
        let mut old = self.pending.len();
        let mut free = old + new.clone().count();
        self.pending.resize(free, Pending::default());
        while let Some(next) = new.peek() {
            free -= 1;
            if old > 0 && self.pending[old - 1].time <= next.time {
                old -= 1;
                self.pending[free] = self.pending[old];
            } else {
                self.pending[free] = *next;
                new.next();
            }
        }
    }

    /// Drops what is due from the queue; whether there was something.
    fn release(&mut self, time: f64) -> bool {
        let before = self.pending.len();
        while self.pending.pop_if(|next| is_due(next.time, time)).is_some() {}
        self.pending.len() < before
    }

    fn sum(&self) -> f64 {
        self.pending.iter().fold(self.command, |rest, pending| rest - pending.amount)
    }
}

/// An impulse time is a sum and so is a step's end; the two may differ by rounding where they mean the same.
fn is_due(impulse: f64, time: f64) -> bool {
    impulse <= time + 4.0 * f64::EPSILON * time.abs()
}
