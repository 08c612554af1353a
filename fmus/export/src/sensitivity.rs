//! Directional and adjoint derivatives, exact (FMI 2.0.5, 2.1.9; FMI 3.0.2, 2.2.11).
//!
//! One evaluation of the equations over dual numbers gives the derivatives of all unknowns in one direction of the
//! knowns. Variables are named here by the numbers of their scalars.

use swayless_scalar::Dual;

use crate::instance::{Instance, NOT_INITIALIZED, Refusal};
use crate::layout::{Block, Layout};
use crate::model::{Model, Point};
use crate::phase::Phase;
use crate::variables::{Value, Variables, lift};

/// Everything continuous with its derivative in one direction.
struct Tangents<M: Model> {
    x: M::States<Dual>,
    dx: M::States<Dual>,
    y: M::Outputs<Dual>,
}

impl<M: Model> Instance<M> {
    /// J·v: how the unknowns change when the knowns change by `seed`.
    pub fn directional(
        &mut self,
        unknowns: &[usize],
        knowns: &[usize],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Refusal> {
        self.prepare_derivative(unknowns, knowns)?;
        same_length("seed", seed.len(), "knowns", knowns.len())?;
        same_length("sensitivity", sensitivity.len(), "unknowns", unknowns.len())?;
        let tangents = self.tangents(|number| {
            let hits = knowns.iter().zip(seed).filter(|(known, _)| **known == number);
            hits.map(|(_, seed)| seed).sum()
        })?;
        for (place, unknown) in sensitivity.iter_mut().zip(unknowns) {
            *place = tangents.of(*unknown);
        }
        Ok(())
    }

    /// vᵀ·J: how a sum of the unknowns, weighted by `seed`, changes with each of the knowns.
    pub fn adjoint(
        &mut self,
        unknowns: &[usize],
        knowns: &[usize],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Refusal> {
        self.prepare_derivative(unknowns, knowns)?;
        same_length("seed", seed.len(), "unknowns", unknowns.len())?;
        same_length("sensitivity", sensitivity.len(), "knowns", knowns.len())?;
        for (place, known) in sensitivity.iter_mut().zip(knowns) {
            let tangents = self.tangents(|number| if number == *known { 1.0 } else { 0.0 })?;
            *place = unknowns.iter().zip(seed).map(|(unknown, seed)| seed * tangents.of(*unknown)).sum();
        }
        Ok(())
    }

    /// The time derivatives of outputs, with the inputs held.
    pub fn output_derivatives(&mut self, outputs: &[usize], values: &mut [f64]) -> Result<(), Refusal> {
        same_length("values", values.len(), "outputs", outputs.len())?;
        for output in outputs {
            let (block, index) = place::<M>(*output)?;
            // A discrete number does not change between events.
            let real = match block {
                Block::Discrete => matches!(self.d.get(index), Value::Real(_)),
                other => matches!(other, Block::States | Block::Outputs),
            };
            if !real {
                return Err(unusable::<M>(block, index, "unknown", "a real output"));
            }
        }
        self.refresh_derivatives()?;
        let states = Layout::<M>::STATES..Layout::<M>::DERIVATIVES;
        let tangents = self.tangents(|number| match number {
            0 => 1.0,
            state if states.contains(&state) => match self.dx.get(state - states.start) {
                Value::Real(rate) => rate,
                _ => 0.0,
            },
            _ => 0.0,
        })?;
        for (place, output) in values.iter_mut().zip(outputs) {
            *place = tangents.of(*output);
        }
        Ok(())
    }

    fn prepare_derivative(&mut self, unknowns: &[usize], knowns: &[usize]) -> Result<(), Refusal> {
        self.ready()?;
        self.check_inputs()?;
        for unknown in unknowns {
            let (block, index) = place::<M>(*unknown)?;
            if !matches!(block, Block::States | Block::Derivatives | Block::Outputs) {
                return Err(unusable::<M>(block, index, "unknown", "a continuous output or a state derivative"));
            }
        }
        for known in knowns {
            let (block, index) = place::<M>(*known)?;
            let real = match block {
                Block::Parameters => matches!(self.p.get(index), Value::Real(_)),
                Block::Inputs => matches!(self.u.get(index), Value::Real(_)),
                Block::Time | Block::States => true,
                Block::Derivatives | Block::Outputs | Block::Discrete | Block::Indicators | Block::Clocks => false,
            };
            if !real {
                return Err(unusable::<M>(block, index, "known", "an input, a state or a real parameter"));
            }
        }
        Ok(())
    }

    /// Evaluates the equations with the derivative of each known in the direction.
    fn tangents(&self, direction: impl Fn(usize) -> f64) -> Result<Tangents<M>, Refusal> {
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        let seeded = |block: Block| {
            let (first, direction) = (Layout::<M>::first(block), &direction);
            move |index: usize, value: f64| Dual::new(value, direction(first + index))
        };
        let p: M::Parameters<Dual> = lift(&self.p, seeded(Block::Parameters));
        let u: M::Inputs<Dual> = lift(&self.u, seeded(Block::Inputs));
        let d: M::Discrete<Dual> = lift(&self.d, |_, value| value.into());
        // In Initialization Mode the states follow from their start values.
        let x: M::States<Dual> = if self.phase == Phase::Initialization {
            M::start(&p, &u, &lift(&self.declared, seeded(Block::States)))
        } else {
            lift(&self.x, seeded(Block::States))
        };
        let at = Point { t: Dual::new(self.t, direction(0)), p: &p, u: &u, x: &x, d: &d, memory };
        let (dx, y) = (M::derivatives(&at), M::outputs(&at));
        Ok(Tangents { x, dx, y })
    }
}

impl<M: Model> Tangents<M> {
    fn of(&self, number: usize) -> f64 {
        let value = match place::<M>(number) {
            Ok((Block::States, index)) => self.x.get(index),
            Ok((Block::Derivatives, index)) => self.dx.get(index),
            Ok((Block::Outputs, index)) => self.y.get(index),
            _ => return 0.0,
        };
        if let Value::Real(dual) = value { dual.tangent } else { 0.0 }
    }
}

fn place<M: Model>(number: usize) -> Result<(Block, usize), Refusal> {
    let found = u32::try_from(number).ok().and_then(Layout::<M>::locate);
    found.ok_or_else(|| Refusal::error(format!("there is no variable with value reference {number}")))
}

fn unusable<M: Model>(block: Block, index: usize, what: &str, wanted: &str) -> Refusal {
    let name = Layout::<M>::name(block, index);
    Refusal::error(format!("{name} cannot be the {what} of a derivative: that is {wanted}"))
}

fn same_length(what: &str, given: usize, of: &str, wanted: usize) -> Result<(), Refusal> {
    if given == wanted {
        return Ok(());
    }
    Err(Refusal::error(format!("{what} has {given} values, but the {of} have {wanted}")))
}
