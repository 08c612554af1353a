//! Clocks in the hands of the importer: activation in Event Mode and in scheduled execution, and intervals (FMI 3.0.2,
//! 2.2.8, 2.3.5 and 5.2).

use crate::clocks::Clock;
use crate::instance::{Instance, Refusal};
use crate::layout::Layout;
use crate::model::{Model, Point};
use crate::phase::{Interface, Phase};
use crate::schedule::Qualifier;

impl<M: Model> Instance<M> {
    /// The clock of a value reference.
    pub(crate) fn clock(&self, reference: u32) -> Result<(usize, &'static Clock), Refusal> {
        let found = (reference as usize).checked_sub(Layout::<M>::CLOCKS).filter(|_| self.clocked);
        found
            .and_then(|index| Some((index, M::CLOCKS.get(index)?)))
            .ok_or_else(|| Refusal::error(format!("there is no clock with value reference {reference}")))
    }

    /// Whether a clock is active. In Clock Update Mode an output clock says so once.
    pub fn get_clock(&mut self, reference: u32) -> Result<bool, Refusal> {
        let (index, clock) = self.clock(reference)?;
        if !clock.interval.is_output() {
            return Ok(self.active >> index & 1 == 1);
        }
        if self.phase == Phase::Event {
            self.evaluate()?;
        }
        let active = self.fired >> index & 1 == 1;
        if self.interface == Interface::ScheduledExecution {
            self.fired &= !(1 << index);
        }
        Ok(active)
    }

    /// Activates or deactivates an input clock.
    pub fn set_clock(&mut self, reference: u32, active: bool) -> Result<(), Refusal> {
        let (index, clock) = self.input_clock(reference)?;
        if self.interface == Interface::ScheduledExecution {
            return Err(Refusal::error(format!(
                "clock {} cannot be set in scheduled execution: its model partition is activated",
                clock.name
            )));
        }
        let bit = 1_u64 << index;
        if active && self.ticked & bit != 0 {
            return Err(Refusal::error(format!(
                "clock {} has ticked in this Event Mode already: a time-based clock ticks once",
                clock.name
            )));
        }
        let set = if active { self.active | bit } else { self.active & !bit };
        if set != self.active {
            self.touch();
            self.active = set;
        }
        Ok(())
    }

    /// The interval of an input clock (s), and what is to be known of it.
    pub fn tell_interval(&mut self, reference: u32) -> Result<(f64, Qualifier), Refusal> {
        let (index, _) = self.input_clock(reference)?;
        self.ready()?;
        // In scheduled execution no event follows when a tunable parameter changes.
        if let (Phase::ClockActivation, Some(memory)) = (self.phase, &self.memory) {
            let at = Point::<M, f64> { t: self.t, p: &self.p, u: &self.u, x: &self.x, d: &self.d, memory };
            self.schedule.after(0, &at);
        }
        Ok(self.schedule.tell(index, self.t))
    }

    /// Sets the interval of a clock whose interval the importer chooses (s).
    pub fn set_interval(&mut self, reference: u32, interval: f64) -> Result<(), Refusal> {
        let (index, clock) = self.input_clock(reference)?;
        let running = self.phase != Phase::Initialization;
        if !clock.interval.is_set_by_importer(running) {
            return Err(Refusal::error(format!("the interval of clock {} cannot be set now", clock.name)));
        }
        if !(interval > 0.0 && interval.is_finite()) {
            return Err(Refusal::error(format!(
                "the interval of clock {} is {interval} s; it must be positive",
                clock.name
            )));
        }
        self.touch();
        self.schedule.set_interval(index, interval, running.then_some(self.t));
        Ok(())
    }

    /// How long after the start a periodic clock ticks first (s).
    pub fn clock_shift(&mut self, reference: u32) -> Result<f64, Refusal> {
        let (index, _) = self.periodic_clock(reference)?;
        Ok(self.schedule.shift(index))
    }

    /// Sets how long after the start a periodic clock ticks first (s).
    pub fn set_clock_shift(&mut self, reference: u32, shift: f64) -> Result<(), Refusal> {
        let (index, clock) = self.periodic_clock(reference)?;
        if !clock.interval.is_set_by_importer(false) {
            return Err(Refusal::error(format!("the shift of clock {} cannot be set", clock.name)));
        }
        if !(shift >= 0.0 && shift.is_finite()) {
            return Err(Refusal::error(format!(
                "the shift of clock {} is {shift} s; it must not be negative",
                clock.name
            )));
        }
        self.schedule.set_shift(index, shift);
        self.uninitialized = true;
        Ok(())
    }

    /// Computes the model partition of a clock. Returns whether there is news of clocks for the importer.
    pub fn activate_partition(&mut self, reference: u32, t: f64) -> Result<bool, Refusal> {
        let (index, clock) = self.input_clock(reference)?;
        if !t.is_finite() {
            return Err(Refusal::error(format!("activationTime is {t}; it must be a finite number")));
        }
        self.check_inputs()?;
        if !self.schedule.activate(index, t) {
            return Err(Refusal::error(format!(
                "clock {} is activated at {t} s, but has been activated at that time or later before",
                clock.name
            )));
        }
        self.t = t;
        self.partition(index)?;
        Ok(self.fired != 0 || self.schedule.has_news_of_countdowns())
    }

    fn input_clock(&self, reference: u32) -> Result<(usize, &'static Clock), Refusal> {
        let (index, clock) = self.clock(reference)?;
        if clock.interval.is_output() {
            return Err(Refusal::error(format!("clock {} is an output: the FMU ticks it", clock.name)));
        }
        Ok((index, clock))
    }

    fn periodic_clock(&self, reference: u32) -> Result<(usize, &'static Clock), Refusal> {
        let (index, clock) = self.clock(reference)?;
        if !clock.interval.is_periodic() {
            return Err(Refusal::error(format!("clock {} has no shift: it is not periodic", clock.name)));
        }
        Ok((index, clock))
    }
}
