//! Model exchange: the importer integrates and says when events are; and Event Mode, which co-simulation can have too.

use crate::instance::{Instance, Refusal};
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::phase::{Interface, Phase};
use crate::sizes::Sizes;
use crate::variables::{Value, Variables};

/// What an event has changed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EventOutcome {
    /// A state has jumped.
    pub states_changed: bool,
    /// When the next time event is due.
    pub next_event: Option<f64>,
}

impl<M: Model> Instance<M> {
    /// Sets the time of what is evaluated next.
    pub fn set_time(&mut self, t: f64) -> Result<(), Refusal> {
        if !t.is_finite() {
            return Err(Refusal::error(format!("time is {t}; it must be a finite number")));
        }
        self.touch();
        self.t = t;
        self.moved();
        Ok(())
    }

    /// Sets the continuous states.
    pub fn set_states(&mut self, x: &[f64]) -> Result<(), Refusal> {
        self.count(x.len(), self.state_count(), "continuous states")?;
        match &self.sizes {
            None => self.x.read_reals(x),
            Some(sizes) => sizes.states().iter().zip(x).for_each(|(state, value)| {
                self.x.set(*state, Value::Real(*value));
            }),
        }
        self.moved();
        Ok(())
    }

    /// Reads the continuous states.
    pub fn states(&mut self, x: &mut [f64]) -> Result<(), Refusal> {
        self.count(x.len(), self.state_count(), "continuous states")?;
        self.ready()?;
        write_states(self.sizes.as_deref(), &self.x, x);
        Ok(())
    }

    /// Reads the derivatives of the continuous states.
    pub fn derivatives(&mut self, dx: &mut [f64]) -> Result<(), Refusal> {
        self.count(dx.len(), self.state_count(), "derivatives")?;
        self.ready()?;
        if self.derivatives_stale {
            self.check_inputs()?;
        }
        self.refresh_derivatives()?;
        write_states(self.sizes.as_deref(), &self.dx, dx);
        Ok(())
    }

    /// Reads the event indicators.
    pub fn event_indicators(&mut self, z: &mut [f64]) -> Result<(), Refusal> {
        self.ready()?;
        let now = M::indicators(&self.point()?);
        let now = now.as_ref();
        self.count(z.len(), now.len(), "event indicators")?;
        z.copy_from_slice(now);
        Ok(())
    }

    /// Reads the nominal values of the continuous states.
    pub fn nominals(&self, nominals: &mut [f64]) -> Result<(), Refusal> {
        self.count(nominals.len(), self.state_count(), "nominal values")?;
        let mut places = nominals.iter_mut();
        for declaration in &self.state_declarations {
            let there = (declaration.first..declaration.first + declaration.count())
                .filter(|index| self.has(Block::States, *index));
            for (_, place) in there.zip(&mut places) {
                *place = declaration.nominal.unwrap_or(1.0);
            }
        }
        Ok(())
    }

    /// How many continuous states there are now.
    pub fn state_count(&self) -> usize {
        self.sizes.as_ref().map_or(Layout::<M>::STATE_COUNT, |sizes| sizes.states().len())
    }

    /// Updates what is discrete; once is enough, since a model resolves its event in one go.
    pub fn update_discrete_states(&mut self) -> Result<EventOutcome, Refusal> {
        let states_changed = self.conclude()?;
        self.disturbed = false;
        Ok(EventOutcome { states_changed, next_event: self.next_event })
    }

    /// To Continuous-Time Mode.
    pub fn enter_continuous_time(&mut self) {
        self.leave_event();
        self.phase = Phase::ContinuousTime;
    }

    /// To Event Mode.
    pub fn enter_event(&mut self) -> Result<(), Refusal> {
        if self.interface == Interface::CoSimulation && !self.event_mode.used {
            return Err(Refusal::error(
                "EnterEventMode is not allowed: the instance was made with eventModeUsed = false",
            ));
        }
        if self.phase == Phase::Event {
            return Ok(());
        }
        self.phase = Phase::Event;
        (self.active, self.ticked, self.fired) = (0, 0, 0);
        self.pending = true;
        Ok(())
    }

    /// An event that the importer does not end has not been, and clocks that it has activated have not ticked.
    fn leave_event(&mut self) {
        self.withdraw();
        self.pending = false;
        (self.active, self.fired) = (0, 0);
    }

    /// To Step Mode.
    pub fn enter_step(&mut self) {
        self.leave_event();
        self.phase = Phase::Step;
    }

    fn count(&self, given: usize, wanted: usize, what: &str) -> Result<(), Refusal> {
        if given == wanted {
            return Ok(());
        }
        Err(Refusal::error(format!("the model has {wanted} {what}, but the array has room for {given}")))
    }
}

/// Copies the states that are there.
fn write_states(sizes: Option<&Sizes>, values: &impl Variables<f64>, into: &mut [f64]) {
    match sizes {
        None => values.write_reals(into),
        Some(sizes) => sizes.states().iter().zip(into).for_each(|(state, place)| {
            if let Value::Real(value) = values.get(*state) {
                *place = value;
            }
        }),
    }
}
