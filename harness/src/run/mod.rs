//! A system made ready to run: its instances, and flat buffers between them, laid out once so that a step neither
//! searches nor allocates.

mod initialize;
mod layout;
mod sampler;
mod store;

use std::sync::Arc;

use crate::error::{Error, Result};
use crate::signals::{Cursor, InputSignals};
use crate::slave::{Failure, LogMessage, Slave, Step};

pub(crate) use initialize::start;
pub(crate) use sampler::Sampler;
use store::{Batch, Store, Transfers};

/// The instances of a running system, their outputs at the present communication point and the inputs made of them.
///
/// The standard forbids to get outputs after inputs were set until the next step. A [master algorithm](crate::master)
/// therefore gets the outputs of an instance right after its step, and transfers and sets its inputs right before.
pub struct Run {
    instances: Vec<Instance>,
    outputs: Store,
    inputs: Store,
    signals: Signals,
    order: Vec<usize>,
    terminated: Option<(usize, f64)>,
}

/// An instance with what has to be got and set in every step.
struct Instance {
    name: String,
    slave: Box<dyn Slave>,
    gets: Vec<Batch>,
    sets: Vec<Batch>,
    transfers: Transfers,
}

/// The input signals and where their columns go.
#[derive(Default)]
struct Signals {
    signals: Option<Arc<InputSignals>>,
    drives: Vec<store::Drive>,
    cursor: Cursor,
}

impl Run {
    /// How many instances there are.
    pub fn count(&self) -> usize {
        self.instances.len()
    }

    /// The instances in the order of the flow through them.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// Computes the inputs of an instance from the outputs that were got last; `time` (s) is for a message about NaN.
    pub fn transfer(&mut self, instance: usize, time: f64) -> Result<()> {
        let transfers = &self.instances[instance].transfers;
        transfers.apply(&self.outputs, &mut self.inputs).map_err(|slot| self.not_a_number(slot, time))
    }

    /// Sets the inputs of an instance.
    pub fn set_inputs(&mut self, instance: usize, time: f64) -> Result<()> {
        let Instance { slave, sets, name, .. } = &mut self.instances[instance];
        for batch in sets {
            batch.set(&mut **slave, &self.inputs).map_err(|failure| failed(name, Some(time), failure))?;
        }
        Ok(())
    }

    /// Steps an instance from `time` by `step_size` (s). It may want the run to end.
    pub fn do_step(&mut self, instance: usize, time: f64, step_size: f64) -> Result<()> {
        let Instance { slave, name, .. } = &mut self.instances[instance];
        match slave.do_step(time, step_size) {
            Ok(Step::Completed) => Ok(()),
            Ok(Step::Terminated(at)) => {
                self.terminated.get_or_insert((instance, at));
                Ok(())
            }
            Err(failure) => Err(Error::StepFailed {
                instance: name.clone(),
                time,
                step_size,
                last_successful_time: failure.last_successful_time,
                failure: Box::new(failure),
            }),
        }
    }

    /// Gets the outputs of an instance that others need.
    pub fn get_outputs(&mut self, instance: usize, time: f64) -> Result<()> {
        let Instance { slave, gets, name, .. } = &mut self.instances[instance];
        for batch in gets {
            batch.get(&mut **slave, &mut self.outputs).map_err(|failure| failed(name, Some(time), failure))?;
        }
        Ok(())
    }

    /// The instance that wants the run to end, and since when (s).
    pub(crate) fn terminated(&self) -> Option<(&str, f64)> {
        self.terminated.map(|(instance, time)| (self.instances[instance].name.as_str(), time))
    }

    /// Takes the inputs that signals drive from their columns.
    pub(crate) fn take_signals(&mut self, time: f64) {
        let Signals { signals, drives, cursor } = &mut self.signals;
        if let Some(signals) = signals {
            cursor.advance(&signals.times, time);
            for drive in drives {
                drive.apply(&signals.columns, cursor, &mut self.inputs);
            }
        }
    }

    /// Terminates all instances, whatever some of them answer; the first failure is returned.
    pub(crate) fn terminate(&mut self) -> Result<()> {
        let mut result = Ok(());
        for Instance { name, slave, .. } in &mut self.instances {
            if let Err(failure) = slave.terminate() {
                result = result.and(Err(failed(name, None, failure)));
            }
        }
        result
    }

    /// The messages that the instances logged since the last call.
    pub(crate) fn take_messages(&mut self) -> Vec<LogMessage> {
        self.instances.iter_mut().flat_map(|instance| instance.slave.take_messages()).collect()
    }

    /// The slot of a value among the inputs, if something drives it.
    fn input_slot(&self, name: &str) -> Option<usize> {
        self.instances.iter().flat_map(|instance| &instance.sets).find_map(|batch| {
            let index = batch.names.iter().position(|candidate| candidate == name)?;
            Some(batch.slots.start + index)
        })
    }

    fn not_a_number(&self, slot: usize, time: f64) -> Error {
        let named = self.instances.iter().find_map(|instance| {
            let batch = instance.gets.iter().find(|batch| batch.holds_float(slot))?;
            Some(batch.name_of(slot))
        });
        Error::NotANumber { variable: named.unwrap_or_default(), time }
    }
}

fn failed(instance: &str, time: Option<f64>, failure: Failure) -> Error {
    Error::Call { instance: instance.to_owned(), time, failure: Box::new(failure) }
}
