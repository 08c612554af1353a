//! Arrays whose length a structural parameter sets (FMI 3.0.2, 2.4.7.5.1). Their room is fixed when they are compiled;
//! what lies beyond the length is not there for the importer.

use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::variables::{Value, Variables};

/// Which scalars are there, of a model that has such arrays.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sizes {
    /// By the numbers of the scalars.
    active: Vec<bool>,
    /// The states that are there, in order, and those that are not.
    states: Vec<usize>,
    idle: Vec<usize>,
}

impl Sizes {
    /// What these parameters say; `None` where every array has one length for good.
    pub fn of<M: Model>(p: &M::Parameters<f64>) -> Option<Self> {
        let lengths: Vec<_> = Layout::<M>::declarations(Block::Parameters)
            .into_iter()
            .filter_map(|d| match p.get(d.first) {
                Value::Size(length) => Some((d.name, length as usize)),
                _ => None,
            })
            .collect();
        if lengths.is_empty() {
            return None;
        }
        let mut active = vec![true; Layout::<M>::END];
        for block in
            [Block::Parameters, Block::Inputs, Block::States, Block::Derivatives, Block::Outputs, Block::Discrete]
        {
            let declared = if block == Block::Derivatives { Block::States } else { block };
            for declaration in Layout::<M>::declarations(declared) {
                let length = declaration.length.and_then(|name| lengths.iter().find(|(known, _)| known == name));
                let Some((_, length)) = length else { continue };
                let first = Layout::<M>::first(block) + declaration.first;
                active[first..first + declaration.count()].iter_mut().skip(*length).for_each(|it| *it = false);
            }
        }
        let states = Layout::<M>::STATES..Layout::<M>::DERIVATIVES;
        let (there, idle) = states.clone().partition(|number| active[*number]);
        let from_zero = |numbers: Vec<usize>| numbers.into_iter().map(|number| number - states.start).collect();
        Some(Self { states: from_zero(there), idle: from_zero(idle), active })
    }

    /// Whether all lengths lie within the room that there is.
    pub fn fit<M: Model>(p: &M::Parameters<f64>) -> bool {
        Layout::<M>::declarations(Block::Parameters).iter().all(|d| match p.get(d.first) {
            Value::Size(length) => d.allows(length.into()),
            _ => true,
        })
    }

    /// Whether a scalar is there.
    pub fn has(&self, number: usize) -> bool {
        self.active.get(number).copied().unwrap_or(false)
    }

    /// How many scalars are there, of `extent` from a number on.
    pub fn extent(&self, number: usize, extent: usize) -> usize {
        self.active[number..number + extent].iter().filter(|active| **active).count()
    }

    /// The states that are there.
    pub fn states(&self) -> &[usize] {
        &self.states
    }

    /// The states that are not.
    pub fn idle(&self) -> &[usize] {
        &self.idle
    }
}
