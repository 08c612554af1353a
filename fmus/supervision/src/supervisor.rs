//! The supervisor: it looks, latches what must stay, and lets the axes go as far as is safe.

use serde::{Deserialize, Serialize};

use crate::limits::{Range, SlowZone};
use crate::{AXES, Braking, Fault, Finding, Observation, Reading, Settings, Sight, State, Times, UNPHYSICAL};

/// No time between samples is longer (s).
const LONGEST: f64 = 1e6;

/// What keeps a crane safe.
///
/// A second sample at the same instant takes the place of the first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
pub struct Supervisor {
    /// When the last sample was taken, and the one before (s).
    last: Option<f64>,
    previous: Option<f64>,
    /// What held before the last sample, and what holds.
    before: Now,
    now: Now,
}

/// What a supervisor is serialized as.
#[derive(Deserialize)]
struct Parts {
    last: Option<f64>,
    previous: Option<f64>,
    before: Now,
    now: Now,
}

impl TryFrom<Parts> for Supervisor {
    type Error = &'static str;

    fn try_from(Parts { last, previous, before, now }: Parts) -> Result<Self, Self::Error> {
        let times = [last, previous].into_iter().flatten().all(f64::is_finite);
        let sound = times && before.is_sound() && now.is_sound();
        sound.then_some(Self { last, previous, before, now }).ok_or("what the supervisor remembers is not finite")
    }
}

impl Default for Supervisor {
    fn default() -> Self {
        Self { last: None, previous: None, before: Now::START, now: Now::START }
    }
}

impl Supervisor {
    /// The velocities that are safe until the next sample.
    #[must_use]
    pub fn velocities(&self) -> [f64; AXES] {
        self.now.velocity
    }

    /// What the crane may do.
    #[must_use]
    pub fn state(&self) -> State {
        self.now.state
    }

    /// The fault that holds, if one does.
    #[must_use]
    pub fn finding(&self) -> Finding {
        self.now.finding
    }

    /// How often state or fault have changed.
    #[must_use]
    pub fn events(&self) -> i32 {
        self.now.events
    }

    /// Whether what happens is to be recorded.
    #[must_use]
    pub fn records(&self) -> bool {
        self.now.records
    }

    /// Takes a sample.
    pub fn sample(&mut self, times: Times, settings: &Settings, seen: &Observation) {
        if self.last != Some(times.now) {
            let is_second = self.last.is_some() && self.previous.is_none();
            (self.previous, self.before) = (self.last, self.now);
            if is_second {
                // The first may have seen what inputs are declared to be, before anybody has set them.
                self.before.sight.iter_mut().for_each(Sight::doubt);
            }
            self.last = Some(times.now);
        }
        let since = self.previous.map_or(0.0, |previous| (times.now - previous).clamp(0.0, LONGEST));
        // A time that is told is taken for what has passed as well: differences of instants are rounded.
        let interval = if times.interval > 0.0 { times.interval.min(LONGEST) } else { since };
        let elapsed = if self.previous.is_some() { interval } else { 0.0 };
        let mut now = self.before;
        let found = now.look(elapsed, settings, seen);
        now.latch(found, settings, seen);
        now.drive(interval, settings, seen);
        now.tell(elapsed, &self.before, settings, seen);
        self.now = now;
    }
}

/// What holds at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Now {
    /// The velocities that are given out.
    velocity: [f64; AXES],
    sight: [Sight; AXES],
    /// The time for which the hook has not been seen (s), and the swing when it was.
    blind: f64,
    swing: f64,
    /// Whether the emergency stop holds, and the fault that does.
    stopped: bool,
    finding: Finding,
    /// Whether the reset was pressed.
    reset: bool,
    state: State,
    events: i32,
    /// Whether it is recorded, and for how long still (s).
    records: bool,
    recording: f64,
}

impl Now {
    /// At rest. A reset that is pressed from the beginning is no press.
    const START: Self = Self {
        velocity: [0.0; AXES],
        sight: [Sight::NONE; AXES],
        blind: 0.0,
        swing: 0.0,
        stopped: false,
        finding: Finding::NONE,
        reset: true,
        state: State::Ready,
        events: 0,
        records: false,
        recording: 0.0,
    };

    /// Whether all is finite.
    fn is_sound(&self) -> bool {
        let numbers = [self.blind, self.swing, self.recording].iter().all(|number| number.is_finite());
        // A greater velocity could grow beyond all numbers.
        numbers && self.velocity.iter().all(|v| is_physical(*v)) && self.sight.iter().all(Sight::is_sound)
    }

    /// Whether the crane is held.
    fn is_held(&self) -> bool {
        self.stopped || self.finding.is_fault()
    }

    /// Looks at all there is. Tells the first thing that is wrong.
    fn look(&mut self, elapsed: f64, settings: &Settings, seen: &Observation) -> Finding {
        let mut found = Finding::NONE;
        for axis in 0..AXES {
            let limits = &settings.axes[axis];
            let travelled = (elapsed, self.velocity[axis]);
            let fault = self.sight[axis].read(reading(seen, axis), travelled, limits, settings.within);
            let fault = if is_physical(seen.command[axis]) { fault } else { Fault::Input };
            found = found.or(Finding { fault, axis: axis as u8 + 1 });
        }
        let mut hook = Fault::None;
        if !is_physical(seen.swing) {
            hook = Fault::Input;
        } else if seen.hook_valid {
            (self.blind, self.swing) = (0.0, seen.swing.abs());
        } else {
            self.blind += elapsed;
            hook = if settings.within.is_too_long(self.blind) { Fault::HookInvalid } else { hook };
        }
        found.or(Finding { fault: hook, axis: 0 })
    }

    /// Keeps a stop and the first fault, until both are reset.
    fn latch(&mut self, found: Finding, settings: &Settings, seen: &Observation) {
        self.stopped |= seen.emergency_stop;
        self.finding = self.finding.or(found);
        let pressed = seen.reset && !self.reset;
        self.reset = seen.reset;
        if pressed && self.may_go_on(seen) {
            (self.stopped, self.finding) = (false, Finding::NONE);
            for axis in 0..AXES {
                self.sight[axis] = Sight::NONE;
                self.sight[axis].read(reading(seen, axis), (0.0, 0.0), &settings.axes[axis], settings.within);
            }
        }
    }

    /// Whether nothing holds the crane any more: it is at rest and asked for nothing, the button is released, and all
    /// sensors are there.
    fn may_go_on(&self, seen: &Observation) -> bool {
        let at_rest = self.velocity.iter().chain(&seen.command).all(|velocity| *velocity == 0.0);
        let positions = (0..AXES).all(|axis| seen.position_valid[axis] && is_physical(seen.position[axis]));
        at_rest && !seen.emergency_stop && positions && seen.hook_valid && is_physical(seen.swing)
    }

    /// Lets the axes go as far as is safe.
    fn drive(&mut self, interval: f64, settings: &Settings, seen: &Observation) {
        // Nothing moves until it is known for how long.
        if interval <= 0.0 {
            return;
        }
        let held = self.is_held();
        let swings = self.swing > settings.swing_limit;
        for axis in 0..AXES {
            let limits = &settings.axes[axis];
            let braking = Braking { deceleration: limits.deceleration, interval, reaction: settings.reaction };
            let slow = settings.slow_share * limits.velocity;
            let sight = &self.sight[axis];
            let velocity = self.velocity[axis];
            let wanted = if held {
                velocity - velocity.clamp(-braking.step(), braking.step())
            } else {
                let mut range = Range::FREE;
                if !sight.is_clear() {
                    range = range.and(Range::no_faster(velocity, 0.0));
                }
                if swings {
                    range = range.and(Range::no_faster(velocity, slow));
                }
                range.cut(seen.command[axis])
            };
            let zone = SlowZone { length: settings.slow_zone, speed: slow };
            self.velocity[axis] = limits.range(braking, zone, sight.position()).cut(wanted);
        }
    }

    /// Says what state that is, and whether it is recorded.
    fn tell(&mut self, elapsed: f64, before: &Self, settings: &Settings, seen: &Observation) {
        self.state = if self.stopped {
            State::Stopped
        } else if self.finding.is_fault() {
            State::Fault
        } else if self.velocity == seen.command {
            State::Ready
        } else {
            State::Limited
        };
        let changed = (self.state, self.finding) != (before.state, before.finding);
        self.events = self.events.saturating_add(i32::from(changed));
        let moves = self.velocity.iter().chain(&seen.command).any(|velocity| *velocity != 0.0);
        if moves && !self.is_held() || changed {
            (self.records, self.recording) = (true, settings.record_time);
        } else {
            self.recording = (self.recording - elapsed).max(0.0);
            self.records = self.recording > 0.0;
        }
    }
}

fn reading(seen: &Observation, axis: usize) -> Reading {
    Reading { position: seen.position[axis], valid: seen.position_valid[axis] }
}

/// Whether a number can be one of a crane's.
fn is_physical(number: f64) -> bool {
    number.abs() <= UNPHYSICAL
}
