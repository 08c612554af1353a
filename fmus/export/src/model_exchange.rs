//! Model exchange: the importer integrates and says when events are; and Event Mode, which co-simulation can have too.

use crate::instance::{Instance, Refusal};
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::phase::{Interface, Phase};
use crate::variables::Variables;

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
        self.t = t;
        self.moved();
        Ok(())
    }

    /// Sets the continuous states.
    pub fn set_states(&mut self, x: &[f64]) -> Result<(), Refusal> {
        self.count(x.len(), Layout::<M>::STATE_COUNT, "continuous states")?;
        self.x.read_reals(x);
        self.moved();
        Ok(())
    }

    /// Reads the continuous states.
    pub fn states(&mut self, x: &mut [f64]) -> Result<(), Refusal> {
        self.count(x.len(), Layout::<M>::STATE_COUNT, "continuous states")?;
        self.ready()?;
        self.x.write_reals(x);
        Ok(())
    }

    /// Reads the derivatives of the continuous states.
    pub fn derivatives(&mut self, dx: &mut [f64]) -> Result<(), Refusal> {
        self.count(dx.len(), Layout::<M>::STATE_COUNT, "derivatives")?;
        self.ready()?;
        if self.derivatives_stale {
            self.check_inputs()?;
        }
        self.refresh_derivatives()?;
        self.dx.write_reals(dx);
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
        self.count(nominals.len(), Layout::<M>::STATE_COUNT, "nominal values")?;
        for declaration in Layout::<M>::declarations(Block::States) {
            nominals[declaration.first..declaration.first + declaration.count()]
                .fill(declaration.nominal.unwrap_or(1.0));
        }
        Ok(())
    }

    /// Updates what is discrete; once is enough, since a model resolves its event in one go.
    pub fn update_discrete_states(&mut self) -> Result<EventOutcome, Refusal> {
        self.check_inputs()?;
        let states_changed = self.event(false)?;
        self.disturbed = false;
        Ok(EventOutcome { states_changed, next_event: self.next_event })
    }

    /// To Continuous-Time Mode.
    pub fn enter_continuous_time(&mut self) {
        self.phase = Phase::ContinuousTime;
    }

    /// To Event Mode.
    pub fn enter_event(&mut self) -> Result<(), Refusal> {
        if self.interface == Interface::CoSimulation && !self.event_mode.used {
            return Err(Refusal::error(
                "EnterEventMode is not allowed: the instance was made with eventModeUsed = false",
            ));
        }
        self.phase = Phase::Event;
        Ok(())
    }

    /// To Step Mode.
    pub fn enter_step(&mut self) {
        self.phase = Phase::Step;
    }

    fn count(&self, given: usize, wanted: usize, what: &str) -> Result<(), Refusal> {
        if given == wanted {
            return Ok(());
        }
        Err(Refusal::error(format!("the model has {wanted} {what}, but the array has room for {given}")))
    }
}
