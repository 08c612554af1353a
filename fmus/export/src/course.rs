//! The course of inputs within a co-simulation step, from their derivatives (FMI 2.0.5, 4.2.1).

use crate::model::Model;
use crate::variables::{Value, Variables};

/// No importer knows derivatives of a higher order; the time that a step takes grows with it.
pub const HIGHEST_ORDER: u32 = 20;

/// A derivative of an input at the begin of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// The input.
    pub index: usize,
    /// Which derivative.
    pub order: u32,
    /// Its value.
    pub value: f64,
}

/// Inputs that move within a step: u(t) = u + Σ u⁽ᵏ⁾ (t − t₀)ᵏ/k!. Without terms they are held.
pub struct Course<M: Model> {
    terms: Vec<Term>,
    base: M::Inputs<f64>,
    begin: f64,
}

impl<M: Model> Course<M> {
    /// Of inputs that are held.
    pub fn held() -> Self {
        Self { terms: Vec::new(), base: Variables::start(), begin: 0.0 }
    }

    /// Whether all inputs are held.
    #[inline]
    pub fn is_held(&self) -> bool {
        self.terms.is_empty()
    }

    /// What moves.
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Sets a derivative; 0 takes it away.
    pub fn set(&mut self, term: Term) {
        self.terms.retain(|other| (other.index, other.order) != (term.index, term.order));
        if term.value != 0.0 {
            self.terms.push(term);
        }
    }

    /// Holds all inputs.
    pub fn hold(&mut self) {
        self.terms.clear();
    }

    /// Begins a step.
    pub fn begin(&mut self, t: f64, u: &M::Inputs<f64>) {
        if !self.is_held() {
            self.begin = t;
            self.base.clone_from(u);
        }
    }

    /// The inputs at the begin of the step, if they move.
    pub fn base(&self) -> Option<&M::Inputs<f64>> {
        (!self.is_held()).then_some(&self.base)
    }

    /// Puts the inputs at a time into `u`.
    pub fn at(&self, t: f64, u: &mut M::Inputs<f64>) {
        u.clone_from(&self.base);
        for Term { index, order, value } in &self.terms {
            if let Value::Real(input) = u.get(*index) {
                let power: f64 = (1..=*order).map(|k| (t - self.begin) / f64::from(k)).product();
                u.set(*index, Value::Real(input + value * power));
            }
        }
    }
}
