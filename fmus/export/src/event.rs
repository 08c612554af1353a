//! Events: what is discrete is computed, by the ticks of clocks and by the model's own events.
//!
//! In Event Mode an importer may set, look, and set again before it says that the event is over. So what is computed
//! for looking is given back when something else is set, and kept when the event is over.

use crate::co_simulation::MOST_EVENTS;
use crate::instance::{Instance, NOT_INITIALIZED, Refusal, is_due};
use crate::log::Category;
use crate::model::{Event, Model, Point};
use crate::phase::Phase;
use crate::schedule::members;

/// What has been computed of an event that is not over.
#[derive(Debug, Clone, Copy)]
pub struct Tentative {
    ticked: u64,
    next_event: Option<f64>,
}

impl<M: Model> Instance<M> {
    /// The event that ends initialization.
    pub(crate) fn first_event(&mut self) -> Result<(), Refusal> {
        (self.fired, self.next_event) = (0, None);
        self.schedule.start_periodic::<M>(self.t, &self.p);
        let mut next = self.compute(true, 0)?;
        if let Some(memory) = &self.memory {
            let at = Point::<M, f64> { t: self.t, p: &self.p, u: &self.u, x: &self.x, d: &self.d, memory };
            self.schedule.start_aperiodic(&at);
        }
        let ticking = self.ticking();
        if ticking != 0 {
            next = self.compute(false, ticking)?;
        }
        self.settle(Tentative { ticked: ticking, next_event: next })?;
        self.follow()?;
        Ok(())
    }

    /// An event within a step of co-simulation.
    pub(crate) fn event(&mut self) -> Result<(), Refusal> {
        let ticked = self.ticking();
        let next_event = self.compute(false, ticked)?;
        self.settle(Tentative { ticked, next_event })?;
        self.follow()?;
        Ok(())
    }

    /// What an event has made due at its own time, such as a countdown of 0 s, follows it at once. Returns whether a
    /// state has jumped.
    fn follow(&mut self) -> Result<bool, Refusal> {
        let mut jumped = false;
        for _ in 0..MOST_EVENTS {
            let ticked = if self.clocked { 0 } else { self.schedule.due(self.event_time()) };
            if ticked == 0 {
                return Ok(jumped);
            }
            let next_event = self.compute(false, ticked)?;
            jumped |= self.flow.states_differ(&self.x);
            self.settle(Tentative { ticked, next_event })?;
        }
        Err(Refusal::error(format!("more than {MOST_EVENTS} events at the same time, {} s", self.t)))
    }

    /// A model partition of scheduled execution.
    pub(crate) fn partition(&mut self, clock: usize) -> Result<(), Refusal> {
        let ticked = 1 << clock;
        let next_event = self.compute(false, ticked)?;
        self.settle(Tentative { ticked, next_event })
    }

    /// Brings what is discrete up to date in Event Mode, so that it can be looked at.
    pub(crate) fn evaluate(&mut self) -> Result<(), Refusal> {
        if !self.pending || self.tentative.is_some() {
            return Ok(());
        }
        self.check_inputs()?;
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        self.backup.begin(&self.x);
        self.backup.keep(&self.d, memory, &self.schedule);
        let ticked = self.ticking();
        self.tentative = Some(Tentative { ticked, next_event: None });
        let next_event = self.compute(false, ticked)?;
        self.tentative = Some(Tentative { ticked, next_event });
        Ok(())
    }

    /// Gives back what was computed for looking.
    pub(crate) fn withdraw(&mut self) {
        if self.tentative.take().is_some() {
            self.backup.restore(&mut self.x, &mut self.d, self.memory.as_mut(), &mut self.schedule);
            self.fired = 0;
            self.moved();
        }
    }

    /// Something that Event Mode depends on has changed.
    pub(crate) fn touch(&mut self) {
        if self.phase == Phase::Event {
            self.withdraw();
            self.pending = true;
        }
    }

    /// Ends the event. Returns whether a state has jumped.
    pub(crate) fn conclude(&mut self) -> Result<bool, Refusal> {
        self.pending = true;
        self.evaluate()?;
        let mut jumped = self.flow.states_differ(&self.x);
        if let Some(tentative) = self.tentative.take() {
            self.settle(tentative)?;
        }
        jumped |= self.follow()?;
        self.pending = false;
        self.ticked |= self.active;
        self.active = 0;
        self.fired = 0;
        Ok(jumped)
    }

    /// The clocks that tick at this event: those the importer has activated, or those whose time has come.
    fn ticking(&self) -> u64 {
        if self.clocked { self.active } else { self.schedule.ticking(self.event_time()) }
    }

    /// An event that is due counts as being at its own time.
    fn event_time(&self) -> f64 {
        self.next_event.filter(|due| *due > self.t && is_due(*due, self.t)).unwrap_or(self.t)
    }

    /// Computes ticks and the model's event. Returns when the model's next time event is due.
    fn compute(&mut self, initial: bool, ticking: u64) -> Result<Option<f64>, Refusal> {
        let t = self.event_time();
        let Some(memory) = &mut self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        self.flow.remember_states(&self.x);
        let (p, u, x, d) = (&self.p, &self.u, &mut self.x, &mut self.d);
        let (intervals, fired) = (self.schedule.intervals(), &mut self.fired);
        let at = &mut Event { t, initial, p, u, x, d, memory, intervals, fired };
        for clock in members(ticking, self.schedule.order()) {
            M::tick(clock, at);
        }
        let next = M::event(at);
        self.moved();
        self.flow.begin_anew();
        Ok(next)
    }

    /// Keeps what an event has computed: when the next one is due.
    fn settle(&mut self, event: Tentative) -> Result<(), Refusal> {
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        let t = self.event_time();
        let at = Point::<M, f64> { t, p: &self.p, u: &self.u, x: &self.x, d: &self.d, memory };
        self.schedule.after(event.ticked, &at);
        self.next_event = event.next_event;
        if !self.clocked
            && let Some(tick) = self.schedule.next()
        {
            self.next_event = Some(event.next_event.map_or(tick, |next| next.min(tick)));
        }
        if self.clocked && self.schedule.is_restless() {
            return Err(Refusal::error(
                "a periodic clock has an interval of 0 s; in an FMU with clocks it must be positive",
            ));
        }
        if self.log.wants(Category::Events) && self.phase != Phase::Initialization {
            let next = self.next_event.map_or_else(|| "none".to_string(), |next| format!("at {next} s"));
            self.log.write(&self.name, Category::Events, &format!("event at {} s, next time event: {next}", self.t));
        }
        Ok(())
    }
}
