//! Dependencies of single elements, as an importer asks for them (FMI 3.0.2, 2.2.9).

use swayless_scalar::How;

use crate::instance::{Instance, Refusal};
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::phase::Phase;
use crate::structure::Structure;

/// An element depends on an element. Elements count from 1; 0 means the variable is a scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dependency {
    /// The element of the dependent variable.
    pub element: usize,
    /// The value reference of what it depends on.
    pub on: u32,
    /// The element of that.
    pub on_element: usize,
    /// `fmi3DependencyKind`.
    pub kind: u8,
}

const DEPENDENT: u8 = How::Dependent as u8;

impl<M: Model> Instance<M> {
    /// What a variable depends on now: in initialization before it ends, while the simulation runs after.
    pub fn dependencies(&mut self, reference: u32) -> Result<Vec<Dependency>, Refusal> {
        let starting = matches!(self.phase, Phase::Instantiated | Phase::Initialization);
        if self.clock(reference).is_ok_and(|(_, clock)| clock.interval.is_output()) {
            return Ok(self.everything(starting));
        }
        let (block, index) = self.locate(reference)?;
        if block == Block::Indicators {
            return Ok(self.everything(starting));
        }
        let first = Layout::<M>::first(block) + index;
        let count = Layout::<M>::extent(block, index);
        if count == 0 || !matches!(block, Block::States | Block::Derivatives | Block::Outputs | Block::Discrete) {
            let name = Layout::<M>::name(block, index);
            return Err(Refusal::error(format!("{name} has no dependencies: it is no output and no state derivative")));
        }
        let structure = self.structure.take().unwrap_or_else(|| Box::new(Structure::of::<M>()));
        let mut found = Vec::new();
        for number in (first..first + count).filter(|number| self.there(*number)) {
            let element = if count > 1 { number - first + 1 } else { 0 };
            let mut add = |on: usize, kind: u8| {
                if self.there(on) {
                    let (on, on_element) = head::<M>(on);
                    found.push(Dependency { element, on, on_element, kind });
                }
            };
            if starting {
                match structure.initial(number) {
                    // Before the simulation runs, a factor is constant or it is not (FMI 3.0.2, 2.4.8).
                    Some(set) => set.iter().for_each(|(on, how)| {
                        add(*on, if *how == How::Constant { How::Constant as u8 } else { DEPENDENT });
                    }),
                    None => (Layout::<M>::PARAMETERS..Layout::<M>::DERIVATIVES).for_each(|on| add(on, DEPENDENT)),
                }
            } else if block == Block::States {
                add(number, How::Constant as u8);
            } else {
                structure.running(number).iter().for_each(|(on, how)| add(*on, *how as u8));
            }
        }
        self.structure = Some(structure);
        Ok(found)
    }

    /// What a scalar depends on of which nothing more is known: indicators switch, and clocks tick as the model says.
    fn everything(&self, starting: bool) -> Vec<Dependency> {
        let first = if starting { Layout::<M>::PARAMETERS } else { Layout::<M>::INPUTS };
        let numbers = std::iter::once(0).chain(first..Layout::<M>::DERIVATIVES).filter(|number| self.there(*number));
        let on = |number| {
            let (on, on_element) = head::<M>(number);
            Dependency { element: 0, on, on_element, kind: DEPENDENT }
        };
        numbers.map(on).collect()
    }

    /// Whether a scalar is there, with the lengths that arrays have now.
    fn there(&self, number: usize) -> bool {
        self.sizes.as_ref().is_none_or(|sizes| sizes.has(number))
    }
}

/// The value reference of the variable that a scalar belongs to, and its place in it.
fn head<M: Model>(number: usize) -> (u32, usize) {
    // A model has far fewer variables than a value reference can tell apart.
    let reference = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
    let Some((block, index)) = Layout::<M>::locate(reference(number)) else { return (reference(number), 0) };
    let mut first = index;
    while first > 0 && Layout::<M>::extent(block, first) == 0 {
        first -= 1;
    }
    let head = reference(number - (index - first));
    if Layout::<M>::extent(block, first) > 1 { (head, index - first + 1) } else { (head, 0) }
}
