//! From start values to the begin of the simulation: the frame of the experiment, checks, the first event.

use crate::declaration::Declaration;
use crate::instance::{Instance, Refusal, TOLERANCE};
use crate::layout::Block;
use crate::model::{Environment, Model};
use crate::phase::{Interface, Phase};
use crate::variables::{Value, Variables};

impl<M: Model> Instance<M> {
    /// Takes the frame of the experiment. A stop time is nothing the models need to know.
    pub fn setup_experiment(&mut self, tolerance: Option<f64>, start: f64, stop: Option<f64>) -> Result<(), Refusal> {
        if !start.is_finite() {
            return Err(Refusal::error(format!("startTime is {start}; it must be a finite number")));
        }
        if let Some(stop) = stop
            && (stop.is_nan() || stop < start)
        {
            return Err(Refusal::error(format!("stopTime is {stop}; it must not be less than startTime {start}")));
        }
        // Importers without a tolerance of their own pass 0 or leave it undefined.
        self.tolerance = tolerance.filter(|tolerance| *tolerance > 0.0).unwrap_or(TOLERANCE).clamp(1e-14, 1e-2);
        self.t = start;
        Ok(())
    }

    /// To Initialization Mode.
    pub fn enter_initialization(&mut self) {
        self.phase = Phase::Initialization;
        self.uninitialized = true;
    }

    /// Checks the parameters, initializes, and goes on to Event Mode or Step Mode.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        self.check_inputs()?;
        let problems = self.check_start();
        if !problems.is_empty() {
            return Err(Refusal::error(problems.join("; ")));
        }
        self.initialize()?;
        self.disturbed = false;
        self.prepare_steps();
        self.phase = match self.interface {
            Interface::CoSimulation if !self.event_mode.used => Phase::Step,
            Interface::ScheduledExecution => Phase::ClockActivation,
            _ => Phase::Event,
        };
        Ok(())
    }

    /// Everything that is wrong with parameters and start values.
    pub(crate) fn check_start(&self) -> Vec<String> {
        let mut problems = self.out_of_bounds(&self.p, &self.declared, |block, index| self.has(block, index));
        if problems.is_empty() {
            problems.extend(M::check(&self.p, &self.declared).iter().map(ToString::to_string));
        }
        problems
    }

    /// Of parameters and start values, those that are there and lie outside of their declared bounds.
    pub(crate) fn out_of_bounds(
        &self,
        p: &M::Parameters<f64>,
        declared: &M::States<f64>,
        has: impl Fn(Block, usize) -> bool,
    ) -> Vec<String> {
        let mut problems = bounds(&self.parameter_declarations, p, |index| has(Block::Parameters, index));
        problems.extend(bounds(&self.state_declarations, declared, |index| has(Block::States, index)));
        problems
    }

    /// Calculates x, d and the memory from the start values, if they have changed.
    pub(crate) fn initialize(&mut self) -> Result<(), Refusal> {
        if !self.uninitialized {
            return Ok(());
        }
        let environment = Environment { resources: self.resources.as_deref() };
        let memory = M::memory(&self.p, &environment).map_err(|problem| Refusal::error(problem.to_string()))?;
        self.memory = Some(memory);
        self.d = Variables::start();
        self.x = M::start(&self.p, &self.u, &self.declared);
        self.flow.restart();
        self.first_event()?;
        self.uninitialized = false;
        Ok(())
    }
}

/// The declared bounds that start values lie outside of.
fn bounds(declarations: &[Declaration], values: &impl Variables<f64>, has: impl Fn(usize) -> bool) -> Vec<String> {
    let mut problems = Vec::new();
    for declaration in declarations {
        for element in 0..declaration.count() {
            let Value::Real(value) = values.get(declaration.first + element) else { continue };
            if has(declaration.first + element) && !declaration.allows(value) {
                let index = if declaration.dimension.is_some() { format!("[{}]", element + 1) } else { String::new() };
                problems.push(format!("{}{index} is {value}; {}", declaration.name, range(declaration)));
            }
        }
    }
    problems
}

/// The allowed range of a variable, in words.
pub(crate) fn range(declaration: &Declaration) -> String {
    let unit = declaration.unit.filter(|unit| unit.symbol != "1");
    let unit = unit.map_or_else(String::new, |unit| format!(" {}", unit.symbol));
    match (declaration.min, declaration.max) {
        (Some(min), Some(max)) => format!("it must lie between {min} and {max}{unit}"),
        (Some(min), None) => format!("it must be at least {min}{unit}"),
        (None, Some(max)) => format!("it must be at most {max}{unit}"),
        (None, None) => "it must be a finite number".to_string(),
    }
}
