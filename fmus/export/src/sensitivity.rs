//! Directional and adjoint derivatives, exact (FMI 2.0.5, 2.1.9; FMI 3.0.2, 2.2.11).
//!
//! One evaluation of the equations over dual numbers gives the derivatives of all unknowns in one direction of the
//! knowns. Variables are named here by the numbers of their scalars.
//!
//! While the simulation runs, what is discrete is held. In Initialization Mode it follows from what is set, by the first
//! event, which is no equation over dual numbers: there it is differenced, to the sixth order.

use std::hint::black_box;

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
        let tangents = self.tangents(&|number| {
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
            let tangents = self.tangents(&|number| if number == *known { 1.0 } else { 0.0 })?;
            *place = unknowns.iter().zip(seed).map(|(unknown, seed)| seed * tangents.of(*unknown)).sum();
        }
        Ok(())
    }

    /// The time derivatives of outputs, with the inputs held.
    pub fn output_derivatives(&mut self, outputs: &[usize], values: &mut [f64]) -> Result<(), Refusal> {
        same_length("values", values.len(), "outputs", outputs.len())?;
        for output in outputs {
            let (block, index) = self.located(*output)?;
            // A discrete number does not change between events.
            let real = match block {
                Block::Discrete => matches!(self.d.get(index), Value::Real(_)),
                other => matches!(other, Block::States | Block::Outputs),
            };
            if !real {
                return Err(unusable::<M>(block, index, "unknown", "a real output"));
            }
        }
        self.ready()?;
        self.refresh_derivatives()?;
        let states = Layout::<M>::STATES..Layout::<M>::DERIVATIVES;
        let rates = self.dx.clone();
        let tangents = self.tangents(&|number| match number {
            0 => 1.0,
            state if states.contains(&state) => match rates.get(state - states.start) {
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

    /// Where a scalar is, if it is there with the lengths that arrays have now.
    fn located(&self, number: usize) -> Result<(Block, usize), Refusal> {
        // A number too great for a value reference is beyond the last variable as well.
        self.locate(u32::try_from(number).unwrap_or(u32::MAX))
    }

    fn prepare_derivative(&mut self, unknowns: &[usize], knowns: &[usize]) -> Result<(), Refusal> {
        self.ready()?;
        self.check_inputs()?;
        for unknown in unknowns {
            let (block, index) = self.located(*unknown)?;
            if !matches!(block, Block::States | Block::Derivatives | Block::Outputs) {
                return Err(unusable::<M>(block, index, "unknown", "a continuous output or a state derivative"));
            }
        }
        for known in knowns {
            let (block, index) = self.located(*known)?;
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
    fn tangents(&mut self, direction: &dyn Fn(usize) -> f64) -> Result<Tangents<M>, Refusal> {
        self.tangents_in(black_box(direction))
    }

    /// Compiled once for all callers: the equations are the greater part of a library. Where the compiler knows whose
    /// direction it is, it makes a copy for each.
    #[inline(never)]
    fn tangents_in(&mut self, direction: &dyn Fn(usize) -> f64) -> Result<Tangents<M>, Refusal> {
        let starting = self.phase == Phase::Initialization;
        let (jumps, changes) = if starting { self.differences(direction)? } else { Default::default() };
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        let seeded = |block: Block| {
            let first = Layout::<M>::first(block);
            move |index: usize, value: f64| Dual::new(value, direction(first + index))
        };
        let p: M::Parameters<Dual> = lift(&self.p, seeded(Block::Parameters));
        let u: M::Inputs<Dual> = lift(&self.u, seeded(Block::Inputs));
        let d: M::Discrete<Dual> =
            lift(&self.d, |index, value| Dual::new(value, changes.get(index).copied().unwrap_or(0.0)));
        // In Initialization Mode the states follow from their start values, where the first event leaves them alone.
        let x: M::States<Dual> = if starting {
            let from_start: M::States<Dual> = M::start(&p, &u, &lift(&self.declared, seeded(Block::States)));
            lift(&self.x, |index, value| match from_start.get(index) {
                Value::Real(dual) if dual.value == value => dual,
                _ => Dual::new(value, jumps.get(index).copied().unwrap_or(0.0)),
            })
        } else {
            lift(&self.x, seeded(Block::States))
        };
        let at = Point { t: Dual::new(self.t, direction(0)), p: &p, u: &u, x: &x, d: &d, memory };
        let (dx, y) = (M::derivatives(&at), M::outputs(&at));
        Ok(Tangents { x, dx, y })
    }
}

/// Distance of the points that differences are taken over, relative to a value's magnitude.
const SPREAD: f64 = 1e-3;
/// Offsets and weights of the sixth-order central difference, times 60.
const STENCIL: [(f64, f64); 6] = [(-3.0, -1.0), (-2.0, 9.0), (-1.0, -45.0), (1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];

impl<M: Model> Instance<M> {
    /// How states and discrete numbers change when initialization is repeated with what is set moved in a direction.
    fn differences(&mut self, direction: &dyn Fn(usize) -> f64) -> Result<(Vec<f64>, Vec<f64>), Refusal> {
        let (p, u, declared, t) = (self.p.clone(), self.u.clone(), self.declared.clone(), self.t);
        let mut h = f64::INFINITY;
        let mut reach = |number: usize, value: Value<'_, f64>| {
            if let (Value::Real(value), seed) = (value, direction(number).abs())
                && seed > 0.0
            {
                h = (SPREAD * value.abs().max(0.1) / seed).min(h);
            }
        };
        let known = Layout::<M>::PARAMETERS..Layout::<M>::DERIVATIVES;
        for number in known {
            match place::<M>(number) {
                Ok((Block::Parameters, index)) => reach(number, p.get(index)),
                Ok((Block::Inputs, index)) => reach(number, u.get(index)),
                Ok((Block::States, index)) => reach(number, declared.get(index)),
                _ => {}
            }
        }
        reach(0, Value::Real(t));
        let mut sums =
            (vec![0.0; Layout::<M>::STATE_COUNT], vec![0.0; Layout::<M>::INDICATORS - Layout::<M>::DISCRETE]);
        if !h.is_finite() {
            return Ok(sums);
        }
        let mut outcome = Ok(());
        for (offset, weight) in STENCIL {
            let moved = |block: Block| {
                let first = Layout::<M>::first(block);
                move |index: usize, value: f64| value + offset * h * direction(first + index)
            };
            self.p = lift(&p, moved(Block::Parameters));
            self.u = lift(&u, moved(Block::Inputs));
            self.declared = lift(&declared, moved(Block::States));
            self.t = t + offset * h * direction(0);
            self.uninitialized = true;
            outcome = outcome.and_then(|()| self.initialize());
            add(&mut sums.0, &self.x, weight);
            add(&mut sums.1, &self.d, weight);
        }
        (self.p, self.u, self.declared, self.t) = (p, u, declared, t);
        self.uninitialized = true;
        self.initialize()?;
        outcome.map_err(|refusal| {
            Refusal::discard(format!(
                "there is no derivative here, at the edge of what can be set: {}",
                refusal.message
            ))
        })?;
        for sum in sums.0.iter_mut().chain(&mut sums.1) {
            *sum /= 60.0 * h;
        }
        Ok(sums)
    }
}

/// Adds the real numbers of some values, times a weight.
fn add<V: Variables<f64>>(sums: &mut [f64], values: &V, weight: f64) {
    for (index, sum) in sums.iter_mut().enumerate() {
        if let Value::Real(value) = values.get(index) {
            *sum += weight * value;
        }
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
