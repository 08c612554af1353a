//! Co-simulation: one communication step.

use crate::backup::Backup;
use crate::flow::{Field, Stuck};
use crate::instance::{Instance, NOT_INITIALIZED, Refusal, is_due};
use crate::layout::Layout;
use crate::model::Model;

/// More events than this in one step, or at one time, mean that the model switches without end.
pub(crate) const MOST_EVENTS: usize = 100_000;
/// A step with more time events than this, seconds of computing, does not end in useful time.
const MOST_TIME_EVENTS: usize = 10_000_000;
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

/// A step under way: where it goes, and what it must give back when it fails.
#[derive(Debug)]
pub struct Stride {
    end: f64,
    /// Whether it pauses after each accepted step of the integrator.
    pauses: bool,
    begun: bool,
    events: usize,
    time_events: usize,
    last_event: f64,
    /// Where the importer wants it to end instead.
    return_at: Option<f64>,
    t: f64,
    next_event: Option<f64>,
    disturbed: bool,
    wanted: f64,
}

impl Stride {
    /// Ends the step at this time, or at once if that has passed.
    pub fn return_at(&mut self, t: f64) {
        self.return_at = Some(self.return_at.map_or(t, |before| before.min(t)).min(self.end));
    }

    /// Where the step was to end.
    pub fn end(&self) -> f64 {
        self.end
    }
}

/// How far a step has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// It waits to be continued.
    Paused,
    /// It is over.
    Ended(StepEnd),
}

impl<M: Model> Instance<M> {
    /// Makes the room that steps need.
    pub(crate) fn prepare_steps(&mut self) {
        self.backup = self
            .memory
            .as_ref()
            .map_or_else(Backup::default, |memory| Backup::of(&self.x, &self.d, memory, &self.schedule));
    }

    /// Steps from `current` to `current + step`. On a refusal nothing has changed.
    pub fn do_step(&mut self, current: f64, step: f64) -> Result<StepEnd, Refusal> {
        let mut stride = self.begin_step(current, step, false)?;
        loop {
            if let Progress::Ended(end) = self.continue_step(&mut stride)? {
                return Ok(end);
            }
        }
    }

    /// Begins a step that goes on with [`continue_step`](Self::continue_step).
    pub fn begin_step(&mut self, current: f64, step: f64, pauses: bool) -> Result<Stride, Refusal> {
        if !(step > 0.0 && step.is_finite()) {
            return Err(Refusal::error(format!("communicationStepSize is {step} s; it must be positive")));
        }
        // A master may compute the point anew, so that its last bits differ from where the last step ended.
        let apart = (current - self.t).abs();
        if !apart.is_finite() || apart > SAME_TIME * current.abs().max(self.t.abs()).max(step) {
            return Err(Refusal::error(format!(
                "currentCommunicationPoint is {current} s, but the instance is at {} s",
                self.t
            )));
        }
        let end = current + step;
        if !end.is_finite() {
            return Err(Refusal::error(format!("a step of {step} s from {current} s has no end")));
        }
        if self.disturbed {
            self.check_inputs()?;
        }
        let stride = Stride {
            end,
            pauses,
            begun: false,
            events: 0,
            time_events: 0,
            last_event: f64::NEG_INFINITY,
            return_at: None,
            t: self.t,
            next_event: self.next_event,
            disturbed: self.disturbed,
            wanted: self.flow.wanted_step(),
        };
        self.backup.begin(&self.x);
        self.course.begin(current, &self.u);
        self.t = current;
        Ok(stride)
    }

    /// Goes on with a step: to its end, or to the next accepted step of the integrator if it pauses there. On a refusal
    /// nothing has changed since the step began.
    pub fn continue_step(&mut self, stride: &mut Stride) -> Result<Progress, Refusal> {
        let done = self.run(stride);
        if done.is_err() {
            if let Some(u) = self.course.base() {
                self.u.clone_from(u);
            }
            self.backup.restore(&mut self.x, &mut self.d, self.memory.as_mut(), &mut self.schedule);
            (self.t, self.next_event) = (stride.t, stride.next_event);
            // What an intermediate update has set stays set.
            self.disturbed |= stride.disturbed;
            self.moved();
            self.flow.begin_anew_with(stride.wanted);
        }
        if matches!(done, Ok(Progress::Ended(_))) {
            // Derivatives of inputs are for one step (FMI 2.0.5, 4.2.1), which may be tried again where it failed; the
            // inputs stay where they have got to.
            self.course.hold();
        }
        done
    }

    fn run(&mut self, stride: &mut Stride) -> Result<Progress, Refusal> {
        // What the importer has set since the last step is an event, whether or not it knows of event modes.
        let restless = !self.clocked && self.schedule.is_restless();
        if !stride.begun && (self.disturbed || restless || self.next_event.is_some_and(|due| due <= self.t)) {
            self.step_event()?;
            self.disturbed = false;
        }
        stride.begun = true;
        if stride.pauses {
            self.check_inputs()?;
        }
        loop {
            let end = stride.return_at.unwrap_or(stride.end);
            if self.t >= end {
                return Ok(Progress::Ended(StepEnd { event: false, early: self.t < stride.end }));
            }
            let due = self.next_event.filter(|due| is_due(*due, end));
            let crossed = self.advance(due.map_or(end, |due| due.min(end)), stride.pauses)?;
            if crossed || due.is_some_and(|due| is_due(due, self.t)) {
                let early = self.t < stride.end;
                if self.event_mode.used && (!early || self.event_mode.early_return) {
                    // Should the importer not enter Event Mode, the next step begins with the event.
                    self.disturbed = true;
                    return Ok(Progress::Ended(StepEnd { event: true, early }));
                }
                self.step_event()?;
                // So close that more than can be fit into the step: it need not be tried all the way.
                let stays = (self.t - stride.last_event) * MOST_TIME_EVENTS as f64 <= stride.end - stride.t;
                stride.last_event = self.t;
                let (count, most) = if crossed || stays {
                    (&mut stride.events, MOST_EVENTS)
                } else {
                    (&mut stride.time_events, MOST_TIME_EVENTS)
                };
                *count += 1;
                if *count > most {
                    return Err(Refusal::error(format!("more than {most} events in one step, at {} s", self.t)));
                }
            }
            if stride.pauses {
                return Ok(Progress::Paused);
            }
        }
    }

    /// Integrates to `target` or to the first state event before it, or for one accepted step. Returns whether an event
    /// was found.
    fn advance(&mut self, target: f64, one_step: bool) -> Result<bool, Refusal> {
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
        let idle = self.sizes.as_ref().map_or(&[][..], |sizes| sizes.idle());
        let field = Field { p: &self.p, u: &self.u, course: &self.course, d: &self.d, memory, idle };
        let found = self.flow.advance(&field, &mut self.x, &mut self.t, (target, one_step), self.tolerance);
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
            self.backup.keep(&self.d, memory, &self.schedule);
        }
        self.event()
    }
}
