//! Co-simulation: one communication step.

use crate::backup::Backup;
use crate::flow::{Field, Stuck};
use crate::instance::{Instance, NOT_INITIALIZED, Refusal, is_due};
use crate::layout::Layout;
use crate::model::Model;

/// More events than this in one step mean that the model switches without end.
const MOST_EVENTS: usize = 100_000;
/// How far the importer's time may lie from the instance's, relative to it.
const SAME_TIME: f64 = 1e-9;

/// How a step ended that did not fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StepEnd {
    /// There is an event at its end, for the importer to handle in Event Mode.
    pub event: bool,
    /// It ended before the next communication point.
    pub early: bool,
}

impl<M: Model> Instance<M> {
    /// Makes the room that steps need.
    pub(crate) fn prepare_steps(&mut self) {
        self.backup = self.memory.as_ref().map_or_else(Backup::default, |memory| Backup::of(&self.x, &self.d, memory));
    }

    /// Steps from `current` to `current + step`. On a refusal nothing has changed.
    pub fn do_step(&mut self, current: f64, step: f64) -> Result<StepEnd, Refusal> {
        if !(step > 0.0 && step.is_finite()) {
            return Err(Refusal::error(format!("communicationStepSize is {step} s; it must be positive")));
        }
        // A master may compute the point anew, so that its last bits differ from where the last step ended.
        let apart = (current - self.t).abs();
        if apart.is_nan() || apart > SAME_TIME * current.abs().max(self.t.abs()).max(step) {
            return Err(Refusal::error(format!(
                "currentCommunicationPoint is {current} s, but the instance is at {} s",
                self.t
            )));
        }
        if self.disturbed {
            self.check_inputs()?;
        }
        let (t, next_event, disturbed) = (self.t, self.next_event, self.disturbed);
        let wanted = self.flow.wanted_step();
        self.backup.begin(&self.x);
        self.course.begin(current, &self.u);
        self.t = current;
        let done = self.run_to(current + step);
        if done.is_err() {
            if let Some(u) = self.course.base() {
                self.u.clone_from(u);
            }
            self.backup.restore(&mut self.x, &mut self.d, self.memory.as_mut());
            (self.t, self.next_event, self.disturbed) = (t, next_event, disturbed);
            self.moved();
            self.flow.begin_anew_with(wanted);
        }
        // Derivatives of inputs are for one step (FMI 2.0.5, 4.2.1); the inputs stay where they have got to.
        self.course.hold();
        done
    }

    fn run_to(&mut self, end: f64) -> Result<StepEnd, Refusal> {
        let mut events = 0;
        // What the importer has set since the last step is an event, whether or not it knows of event modes.
        if self.disturbed || self.next_event.is_some_and(|due| due <= self.t) {
            self.step_event()?;
            self.disturbed = false;
        }
        while self.t < end {
            let due = self.next_event.filter(|due| is_due(*due, end));
            let crossed = self.advance(due.map_or(end, |due| due.min(end)))?;
            if crossed || due.is_some_and(|due| is_due(due, self.t)) {
                let early = self.t < end;
                if self.event_mode.used && (!early || self.event_mode.early_return) {
                    // Should the importer not enter Event Mode, the next step begins with the event.
                    self.disturbed = true;
                    return Ok(StepEnd { event: true, early });
                }
                self.step_event()?;
                events += 1;
                if events > MOST_EVENTS {
                    return Err(Refusal::error(format!("more than {MOST_EVENTS} events in one step, at {} s", self.t)));
                }
            }
        }
        Ok(StepEnd::default())
    }

    /// Integrates to `target` or to the first state event before it. Returns whether an event was found.
    fn advance(&mut self, target: f64) -> Result<bool, Refusal> {
        self.moved();
        if Layout::<M>::STATE_COUNT == 0 {
            self.t = target;
            if !self.course.is_held() {
                self.course.at(target, &mut self.u);
            }
            return Ok(false);
        }
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        let field = Field { p: &self.p, u: &self.u, course: &self.course, d: &self.d, memory };
        let found = self.flow.advance(&field, &mut self.x, &mut self.t, target, self.tolerance);
        if !self.course.is_held() {
            self.course.at(self.t, &mut self.u);
        }
        found.map_err(|Stuck(t)| {
            Refusal::discard(format!(
                "the equations cannot be integrated beyond {t} s: look for an input or a start value that is out of \
                 any physical range"
            ))
        })
    }

    /// An event within a step: keeps what it changes, for the case that the step fails later.
    fn step_event(&mut self) -> Result<(), Refusal> {
        if let Some(memory) = &self.memory {
            self.backup.keep(&self.d, memory);
        }
        self.event(false)?;
        Ok(())
    }
}
