//! What a co-simulation step may change and must give back when it fails. Room is made once and used again.

use crate::model::Model;
use crate::schedule::Schedule;
use crate::variables::Variables;

/// States, and what is discrete, as they were when the step began.
pub struct Backup<M: Model> {
    x: M::States<f64>,
    discrete: Option<(M::Discrete<f64>, M::Memory, Schedule)>,
    /// What is discrete has been kept in this step, since only an event changes it.
    kept: bool,
}

impl<M: Model> Default for Backup<M> {
    fn default() -> Self {
        Self { x: Variables::start(), discrete: None, kept: false }
    }
}

impl<M: Model> Backup<M> {
    /// With room for what is given.
    pub fn of(x: &M::States<f64>, d: &M::Discrete<f64>, memory: &M::Memory, schedule: &Schedule) -> Self {
        Self { x: x.clone(), discrete: Some((d.clone(), memory.clone(), schedule.clone())), kept: false }
    }

    /// Keeps the states at the begin of a step.
    pub fn begin(&mut self, x: &M::States<f64>) {
        self.x.clone_from(x);
        self.kept = false;
    }

    /// Keeps what is discrete, before the first event of a step.
    pub fn keep(&mut self, d: &M::Discrete<f64>, memory: &M::Memory, schedule: &Schedule) {
        if !self.kept
            && let Some((kept_d, kept_memory, kept_schedule)) = &mut self.discrete
        {
            kept_d.clone_from(d);
            kept_memory.clone_from(memory);
            kept_schedule.take(schedule);
            self.kept = true;
        }
    }

    /// Gives everything back.
    pub fn restore(
        &self,
        x: &mut M::States<f64>,
        d: &mut M::Discrete<f64>,
        memory: Option<&mut M::Memory>,
        schedule: &mut Schedule,
    ) {
        x.clone_from(&self.x);
        if let (true, Some((kept_d, kept_memory, kept_schedule)), Some(memory)) = (self.kept, &self.discrete, memory) {
            d.clone_from(kept_d);
            memory.clone_from(kept_memory);
            schedule.take(kept_schedule);
        }
    }
}
