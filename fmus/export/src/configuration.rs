//! Configuration and Reconfiguration Mode: structural parameters are set (FMI 3.0.2, 2.3.6 and 2.3.7).

use std::sync::Arc;

use crate::declaration::{Declaration, Kind};
use crate::initialization::range;
use crate::instance::{Instance, Refusal};
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::phase::{Interface, Phase};
use crate::sizes::Sizes;
use crate::variables::{Value, Variables};

impl<M: Model> Instance<M> {
    /// To Configuration Mode, or to Reconfiguration Mode while the simulation runs.
    pub fn enter_configuration(&mut self) -> Result<(), Refusal> {
        let starting = self.phase == Phase::Instantiated;
        // In co-simulation the way leads from and to Step Mode only (FMI 3.0.2, 2.3.7).
        let from_event = self.phase == Phase::Event && self.interface == Interface::CoSimulation;
        let of_size = |d: &&Declaration| d.kind == Kind::Size;
        let any = self.parameter_declarations.iter().filter(of_size).any(|d| starting || d.tunable);
        if !any || from_event {
            let which = if starting { "structural parameter" } else { "tunable structural parameter" };
            let why = if any { "Event Mode must be left first".into() } else { format!("the FMU has no {which}") };
            return Err(Refusal::error(format!("fmi3EnterConfigurationMode is not allowed: {why}")));
        }
        self.withdraw();
        self.pending = false;
        self.phase = if starting { Phase::Configuration } else { Phase::Reconfiguration };
        Ok(())
    }

    /// Sets a structural parameter.
    pub(crate) fn configure(&mut self, block: Block, index: usize, value: Value<'_, f64>) -> Result<(), Refusal> {
        let found = self.parameter_declarations.iter().find(|d| block == Block::Parameters && d.first == index);
        let Some(declaration) = found.filter(|d| d.kind == Kind::Size) else {
            return self.not_now(block, index, "Configuration Mode is for structural parameters");
        };
        if self.phase == Phase::Reconfiguration && !declaration.tunable {
            return self.not_now(block, index, "a fixed structural parameter is set before initialization");
        }
        if let Value::Size(length) = value
            && !declaration.allows(length.into())
        {
            return Err(Refusal::discard(format!("{} is {length}; {}", declaration.name, range(declaration))));
        }
        if !self.p.set(index, value) {
            return self.wrong_type(block, index, value);
        }
        self.resize();
        Ok(())
    }

    /// Gives arrays their new lengths. States that were not there before begin with their start values.
    fn resize(&mut self) {
        let before = self.sizes.take();
        self.sizes = Sizes::of::<M>(&self.p).map(Arc::new);
        if let (Some(before), Some(now)) = (before, &self.sizes) {
            for state in now.states().iter().filter(|state| !before.has(Layout::<M>::STATES + **state)) {
                self.x.set(*state, self.declared.get(*state));
            }
        }
        self.moved();
    }

    /// Back to where the mode was entered from.
    pub fn exit_configuration(&mut self) -> Result<(), Refusal> {
        if self.phase == Phase::Configuration {
            self.phase = Phase::Instantiated;
            self.uninitialized = true;
            return Ok(());
        }
        self.phase = match self.interface {
            Interface::ModelExchange => Phase::Event,
            Interface::CoSimulation => Phase::Step,
            Interface::ScheduledExecution => Phase::ClockActivation,
        };
        self.disturbed = true;
        self.pending = self.phase == Phase::Event;
        self.structure = None;
        self.moved();
        self.flow.restart();
        self.prepare_steps();
        Ok(())
    }

    /// Whether a scalar is there, with the lengths that arrays have now.
    pub(crate) fn has(&self, block: Block, index: usize) -> bool {
        self.sizes.as_ref().is_none_or(|sizes| sizes.has(Layout::<M>::first(block) + index))
    }
}
