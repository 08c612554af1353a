//! Anti-sway and positioning of one axis (thesis 6.2.3, fig. 6.9).

use serde::{Deserialize, Serialize};
use swayless_shaping::Shaper;

use self::designed::Designed;
use self::now::Now;
use self::sample::Sample;
use crate::pace::Pace;
use crate::shaped::Shaped;

mod designed;
mod now;
mod sample;
mod settings;

pub use settings::{Form, Goal, Measured, Settings, Shown};

/// The controller of one axis.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
pub struct PositionControl {
    now: Now,
    /// As it was before the last sample: a second one at the same time takes the place of the first.
    before: Now,
    pace: Pace,
    shaped: Shaped,
    #[serde(skip)]
    designed: Option<Designed>,
}

/// What a controller is serialized as.
#[derive(Deserialize)]
struct Parts {
    now: Now,
    before: Now,
    pace: Pace,
    shaped: Shaped,
}

impl TryFrom<Parts> for PositionControl {
    type Error = &'static str;

    fn try_from(Parts { now, before, pace, shaped }: Parts) -> Result<Self, Self::Error> {
        if !(now.is_possible() && before.is_possible()) {
            return Err("a controller commands what no crane can do");
        }
        if !pace.is_possible() {
            return Err("the time of the last sample is not finite");
        }
        Ok(Self { now, before, pace, shaped, designed: None })
    }
}

/// Copying into a controller uses its room again.
impl Clone for PositionControl {
    fn clone(&self) -> Self {
        Self { shaped: self.shaped.clone(), designed: self.designed.clone(), ..*self }
    }

    fn clone_from(&mut self, source: &Self) {
        self.shaped.clone_from(&source.shaped);
        self.designed.clone_from(&source.designed);
        (self.now, self.before) = (source.now, source.before);
        self.pace = source.pace;
    }
}

impl PositionControl {
    /// One that has seen nothing and commands nothing.
    #[must_use]
    pub fn new() -> Self {
        Self { shaped: Shaped::new(), ..Self::default() }
    }

    /// The shaper that commands go through (with the settings of the last sample).
    #[must_use]
    pub fn shaper(&self) -> Option<&Shaper> {
        self.designed.as_ref().map(|designed| &designed.shaper)
    }

    /// Takes a sample at `time` (s), as it is done every `period` (s; 0 for whenever it suits), and says what to command from
    /// now on.
    pub fn step(&mut self, time: f64, period: f64, settings: &Settings, goal: Goal, measured: Measured) -> Shown {
        if self.pace.tick(time, period) {
            self.now = self.before;
        } else {
            self.before = self.now;
        }
        let interval = self.pace.interval();
        let wanted = (settings.crane, settings.form, settings.feedback);
        if self.designed.as_ref().is_none_or(|designed| designed.of != wanted) {
            self.designed = Some(Designed::new(wanted.0, wanted.1, wanted.2));
        }
        let Some(designed) = &self.designed else { return Shown::default() };
        let mut sample = Sample { interval, settings, designed, now: &mut self.now, shaped: &mut self.shaped };
        sample.observe(measured);
        let correction = match goal {
            Goal::Off => sample.rest(),
            goal => sample.follow(goal),
        };
        sample.now.command =
            settings.limits.towards(sample.now.planned_command + correction, sample.now.command, sample.interval);
        sample.shown(goal, measured, correction)
    }
}
