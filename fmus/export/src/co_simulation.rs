//! Co-simulation: one communication step.

use crate::instance::{Instance, Refusal};
use crate::model::Model;
use crate::variables::Variables;

/// More events than this in one step mean that the model switches without end.
const MOST_EVENTS: usize = 100_000;
/// How far the importer's time may lie from the instance's, relative to it.
const SAME_TIME: f64 = 1e-9;

/// What a step may have changed and must give back when it fails. Its buffers are reused.
pub(crate) struct Backup<M: Model> {
    x: M::States<f64>,
    discrete: Option<(M::Discrete<f64>, M::Memory)>,
    changed: bool,
}

impl<M: Model> Backup<M> {
    pub(crate) fn new() -> Self {
        Self { x: Variables::start(), discrete: None, changed: false }
    }
}

impl<M: Model> Instance<M> {
    /// Makes the room that steps need.
    pub(crate) fn prepare_steps(&mut self) {
        self.backup.discrete = self.memory.as_ref().map(|memory| (self.d.clone(), memory.clone()));
    }

    /// Steps from `current` to `current + step`. On a refusal nothing has changed.
    pub fn do_step(&mut self, current: f64, step: f64) -> Result<(), Refusal> {
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
        self.backup.x.clone_from(&self.x);
        self.backup.changed = false;
        self.t = current;
        let done = self.run_to(current + step);
        if done.is_err() {
            self.x.clone_from(&self.backup.x);
            if self.backup.changed
                && let Some((d, memory)) = &self.backup.discrete
            {
                self.d.clone_from(d);
                if let Some(current) = &mut self.memory {
                    current.clone_from(memory);
                }
            }
            (self.t, self.next_event, self.disturbed) = (t, next_event, disturbed);
            self.moved();
            self.flow.restart();
        }
        done
    }

    fn run_to(&mut self, end: f64) -> Result<(), Refusal> {
        let mut events = 0;
        // What the importer has set since the last step is an event, whether or not it knows of event modes.
        if self.disturbed || self.next_event.is_some_and(|due| due <= self.t) {
            self.step_event()?;
            self.disturbed = false;
        }
        while self.t < end {
            let due = self.next_event.filter(|due| *due <= end);
            let crossed = self.advance(due.unwrap_or(end))?;
            if crossed || due.is_some_and(|due| due <= self.t) {
                self.step_event()?;
                events += 1;
                if events > MOST_EVENTS {
                    return Err(Refusal::error(format!("more than {MOST_EVENTS} events in one step, at {} s", self.t)));
                }
            }
        }
        Ok(())
    }

    /// An event within a step: keeps what it changes, for the case that the step fails later.
    fn step_event(&mut self) -> Result<(), Refusal> {
        if !self.backup.changed
            && let (Some(memory), Some((d, kept))) = (&self.memory, &mut self.backup.discrete)
        {
            d.clone_from(&self.d);
            kept.clone_from(memory);
            self.backup.changed = true;
        }
        self.event(false)?;
        Ok(())
    }
}
