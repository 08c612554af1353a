//! Getting and setting variables by value reference.

use crate::course::{HIGHEST_ORDER, Term};
use crate::declaration::{Declaration, Kind};
use crate::initialization::range;
use crate::instance::{Instance, NOT_INITIALIZED, Refusal};
use crate::layout::{Block, Layout};
use crate::log::Category;
use crate::model::Model;
use crate::phase::{Interface, Phase};
use crate::variables::{Value, Variables};

impl<M: Model> Instance<M> {
    /// Where a value reference points.
    pub(crate) fn locate(&self, reference: u32) -> Result<(Block, usize), Refusal> {
        Layout::<M>::locate(reference)
            .filter(|(block, index)| self.has(*block, *index))
            .ok_or_else(|| Refusal::error(format!("there is no variable with value reference {reference}")))
    }

    /// Initializes, if start values have been set since: outputs must be consistent whenever they are read. Models may
    /// rely on what has been checked, so that values which leave no outputs are refused; they can still be corrected.
    pub(crate) fn ready(&mut self) -> Result<(), Refusal> {
        match self.phase {
            Phase::Initialization if self.uninitialized => {
                self.check_inputs()?;
                let problems = self.check_start();
                if !problems.is_empty() {
                    return Err(Refusal::discard(problems.join("; ")));
                }
                self.initialize()
            }
            // Where initialization has failed, what models rely on has not been checked.
            _ if self.uninitialized => Err(Refusal::error(NOT_INITIALIZED)),
            Phase::Event => self.evaluate(),
            _ => Ok(()),
        }
    }

    /// The value of a scalar.
    #[inline]
    pub fn get(&mut self, block: Block, index: usize) -> Result<Value<'_, f64>, Refusal> {
        let given = matches!(block, Block::Time | Block::Parameters | Block::Inputs);
        if self.uninitialized && !given || self.pending {
            if self.phase == Phase::Instantiated && block == Block::States {
                return Ok(self.declared.get(index));
            }
            self.ready()?;
        }
        if self.phase == Phase::Intermediate {
            self.check_intermediate(block, index, false)?;
        }
        Ok(match block {
            Block::Time => Value::Real(self.t),
            Block::Parameters => self.p.get(index),
            Block::Inputs => self.u.get(index),
            Block::States => self.x.get(index),
            Block::Derivatives => {
                self.refresh_derivatives()?;
                self.dx.get(index)
            }
            Block::Outputs => {
                self.refresh_outputs()?;
                self.y.get(index)
            }
            Block::Discrete => self.d.get(index),
            Block::Clocks => return Err(Refusal::error("a clock has no value but through fmi3GetClock")),
            Block::Indicators => Value::Real(M::indicators(&self.point()?).as_ref()[index]),
        })
    }

    /// Discards a value that a tunable parameter cannot have while the simulation runs. All values of a call are asked
    /// for before the first is set, since a call that is discarded changes nothing.
    #[inline]
    pub fn admit(&self, block: Block, index: usize, value: Value<'_, f64>) -> Result<(), Refusal> {
        let Value::Real(value) = value else { return Ok(()) };
        let may_tune = matches!(self.phase, Phase::Event | Phase::Step | Phase::ClockActivation);
        if block != Block::Parameters || !may_tune {
            return Ok(());
        }
        let found = covering(&self.parameter_declarations, index);
        match found.filter(|parameter| parameter.tunable && !parameter.allows(value)) {
            Some(parameter) => {
                let name = Layout::<M>::name(block, index);
                Err(Refusal::discard(format!("{name} is {value}; {}", range(parameter))))
            }
            None => Ok(()),
        }
    }

    /// Sets a scalar, where the phase allows it; its value has been [admitted](Self::admit).
    #[inline]
    pub fn set(&mut self, block: Block, index: usize, value: Value<'_, f64>) -> Result<(), Refusal> {
        match self.phase {
            Phase::Configuration | Phase::Reconfiguration => return self.configure(block, index, value),
            Phase::Intermediate => self.check_intermediate(block, index, true)?,
            _ => {}
        }
        let starting = matches!(self.phase, Phase::Instantiated | Phase::Initialization);
        match block {
            Block::Inputs => {
                if self.u.get(index) == value {
                    return Ok(());
                }
                if self.phase == Phase::ContinuousTime && self.input(index).is_none_or(|input| input.discrete) {
                    // Not an error: while it integrates, FMPy applies its signals to all inputs, and just behind an
                    // event once more with their values before it.
                    if self.log.wants(Category::Events) {
                        let name = Layout::<M>::name(block, index);
                        let held = format!("{name} keeps its value: a discrete input changes in Event Mode only");
                        self.log.write(&self.name, Category::Events, &held);
                    }
                    return Ok(());
                }
                if !self.u.set(index, value) {
                    return self.wrong_type(block, index, value);
                }
                self.disturbed = true;
                self.uninitialized |= starting;
                self.touch();
                self.moved();
                if self.phase == Phase::Intermediate {
                    self.flow.begin_anew();
                }
            }
            Block::Parameters => {
                let Some(declaration) = covering(&self.parameter_declarations, index) else {
                    return Err(Refusal::error(format!("there is no parameter {index}")));
                };
                if declaration.kind == Kind::Size {
                    return self.not_now(block, index, "a structural parameter is set in Configuration Mode");
                }
                if !starting {
                    if !declaration.tunable {
                        return self.not_now(block, index, "a fixed parameter is set before initialization ends");
                    }
                    if self.phase == Phase::ContinuousTime {
                        return self.not_now(block, index, "a tunable parameter changes in Event Mode only");
                    }
                }
                if !self.p.set(index, value) {
                    return self.wrong_type(block, index, value);
                }
                self.disturbed = true;
                self.uninitialized |= starting;
                self.touch();
                self.moved();
            }
            Block::States => {
                if !starting {
                    return self.not_now(block, index, "a start value is set before initialization ends");
                }
                if covering(&self.state_declarations, index).is_none_or(|state| state.calculated) {
                    return self.not_now(block, index, "its initial value is calculated");
                }
                if !self.declared.set(index, value) {
                    return self.wrong_type(block, index, value);
                }
                self.uninitialized = true;
                self.moved();
            }
            Block::Time | Block::Derivatives | Block::Outputs | Block::Discrete | Block::Indicators | Block::Clocks => {
                return self.not_now(block, index, "it is calculated by the FMU");
            }
        }
        Ok(())
    }

    /// Refuses a variable that is not for intermediate updates: continuous inputs and outputs are, and of these, if the
    /// importer has named any, those it has named.
    fn check_intermediate(&self, block: Block, index: usize, set: bool) -> Result<(), Refusal> {
        let continuous = match block {
            Block::Inputs => {
                matches!(self.u.get(index), Value::Real(_)) && self.input(index).is_some_and(|input| !input.discrete)
            }
            Block::States => !set && covering(&self.state_declarations, index).is_some_and(|state| state.output),
            Block::Outputs => !set,
            _ => false,
        };
        let number = Layout::<M>::first(block) + index;
        if continuous && (self.intermediate.is_empty() || self.intermediate.contains(&number)) {
            return Ok(());
        }
        let name = Layout::<M>::name(block, index);
        let verb = if set { "set" } else { "read" };
        Err(Refusal::error(format!(
            "{name} cannot be {verb} in an intermediate update: it is none of the requiredIntermediateVariables, or not \
             marked for it"
        )))
    }

    /// Takes the variables that the importer wants in intermediate updates.
    pub fn require_intermediate(&mut self, references: &[u32]) -> Result<(), Refusal> {
        let mut required = Vec::new();
        for reference in references {
            let (block, index) = self.locate(*reference)?;
            self.check_intermediate(block, index, false)?;
            let first = Layout::<M>::first(block) + index;
            required.extend(first..first + Layout::<M>::extent(block, index));
        }
        self.intermediate = required;
        Ok(())
    }

    /// Sets a derivative of a continuous input at the begin of the next step.
    pub fn set_input_derivative(&mut self, reference: u32, order: i32, value: f64) -> Result<(), Refusal> {
        let (block, index) = self.locate(reference)?;
        let continuous = block == Block::Inputs
            && matches!(self.u.get(index), Value::Real(_))
            && self.input(index).is_some_and(|input| !input.discrete);
        let name = || Layout::<M>::name(block, index);
        if !continuous {
            return Err(Refusal::error(format!("{} has no derivative to set: it is no continuous input", name())));
        }
        let Some(order) = u32::try_from(order).ok().filter(|order| (1..=HIGHEST_ORDER).contains(order)) else {
            let name = name();
            return Err(Refusal::error(format!(
                "{name}: order {order} of a derivative; 1 to {HIGHEST_ORDER} are known"
            )));
        };
        if !value.is_finite() {
            return Err(Refusal::discard(format!(
                "the derivative of {} is {value}; it must be a finite number",
                name()
            )));
        }
        self.course.set(Term { index, order, value });
        Ok(())
    }

    /// Whether a variable that can be set is an enumeration.
    pub(crate) fn is_enumeration(&self, reference: u32) -> bool {
        let value = match Layout::<M>::locate(reference) {
            Some((Block::Parameters, index)) => self.p.get(index),
            Some((Block::Inputs, index)) => self.u.get(index),
            _ => return false,
        };
        matches!(value, Value::Enumeration(_))
    }

    fn input(&self, index: usize) -> Option<&Declaration> {
        covering(&self.input_declarations, index)
    }

    pub(crate) fn not_now(&self, block: Block, index: usize, why: &str) -> Result<(), Refusal> {
        let mode = match self.interface {
            Interface::ModelExchange => "model exchange",
            Interface::CoSimulation => "co-simulation",
            Interface::ScheduledExecution => "scheduled execution",
        };
        let name = Layout::<M>::name(block, index);
        Err(Refusal::error(format!("{name} cannot be set in phase {:?} of {mode}: {why}", self.phase)))
    }

    pub(crate) fn wrong_type(&self, block: Block, index: usize, value: Value<'_, f64>) -> Result<(), Refusal> {
        let name = Layout::<M>::name(block, index);
        Err(Refusal::error(format!("{name} does not take {value:?}: it is of another type or has no such item")))
    }
}

fn covering(declarations: &[Declaration], index: usize) -> Option<&Declaration> {
    declarations.iter().find(|d| (d.first..d.first + d.count()).contains(&index))
}
