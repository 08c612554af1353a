//! Which variable depends on which, and how: traced through the model's own equations.

use std::collections::BTreeMap;

use swayless_scalar::{Dependence, How};

use crate::declaration::Kind;
use crate::layout::{Block, Layout};
use crate::model::{Environment, Model, Point};
use crate::variables::{Value, Variables, lift};

/// The numbers of what a scalar depends on, and how.
pub type Set = BTreeMap<usize, How>;

/// A set of numbers on which something depends in the same way.
pub fn set_of(numbers: impl IntoIterator<Item = usize>, how: How) -> Set {
    // One after the other: collecting would sort them first, with 5 kB of code for it.
    let mut set = Set::new();
    set.extend(numbers.into_iter().map(|number| (number, how)));
    set
}

/// The dependencies of a model.
pub struct Structure {
    /// Of ẋ, y and d on t, u and x, while the simulation runs.
    running: Vec<Set>,
    /// Of x, ẋ, y and d on t, p, u and start values, when initialization ends. `None` means on all of them.
    initial: Vec<Option<Set>>,
}

impl Structure {
    /// Traces the equations of a model.
    pub fn of<M: Model>() -> Self {
        let end = Layout::<M>::END;
        let direct = discrete_dependencies::<M>();
        let mut running = vec![Set::new(); end];
        let mut initial = vec![Some(Set::new()); end];
        let p = widest::<M>();
        // A model whose memory cannot be made without a file can be traced without it: the trace asks for no values.
        let memory = M::memory(&p, &Environment { resources: None }).ok();
        for window in (0..end).step_by(Dependence::WINDOW) {
            let Some(memory) = &memory else { break };
            trace::<M>(window, memory, &direct, &mut running, &mut initial);
        }
        for (offset, set) in direct.into_iter().enumerate() {
            running[Layout::<M>::DISCRETE + offset] = set;
            // What happens in the first event is not traced.
            initial[Layout::<M>::DISCRETE + offset] = None;
        }
        let untraced = untraced_parameters::<M>();
        initial
            .iter_mut()
            .flatten()
            .for_each(|set| set.extend(untraced.iter().map(|number| (*number, How::Dependent))));
        Self { running, initial }
    }

    /// What a scalar depends on while the simulation runs: time, inputs and states.
    pub fn running(&self, number: usize) -> &Set {
        &self.running[number]
    }

    /// What a scalar depends on when initialization ends; `None` means on everything.
    pub fn initial(&self, number: usize) -> Option<&Set> {
        self.initial[number].as_ref()
    }
}

/// Parameters that are no numbers of the equations: which branch a condition takes, or what is read from a file, is not
/// traced, so that everything that is computed is taken to depend on them.
fn untraced_parameters<M: Model>() -> Vec<usize> {
    let declarations = Layout::<M>::declarations(Block::Parameters);
    let untraced = declarations.into_iter().filter(|d| !matches!(d.kind, Kind::Real | Kind::Size));
    untraced.flat_map(|d| (d.first..d.first + d.count()).map(|index| Layout::<M>::PARAMETERS + index)).collect()
}

/// The inputs and states that each scalar of d depends on, as declared.
fn discrete_dependencies<M: Model>() -> Vec<Set> {
    let of = |block| Layout::<M>::declarations(block);
    let numbers = |block: Block, first: usize, count: usize| {
        let begin = Layout::<M>::first(block) + first;
        begin..begin + count
    };
    let known: Vec<_> = [Block::Inputs, Block::States]
        .into_iter()
        .flat_map(|block| of(block).into_iter().map(move |d| (d.name.clone(), numbers(block, d.first, d.count()))))
        .collect();
    let mut sets = Vec::new();
    for declaration in of(Block::Discrete) {
        let numbers: Vec<usize> = match declaration.depends_on {
            None => known.iter().flat_map(|(_, numbers)| numbers.clone()).collect(),
            Some(names) => {
                let named = |name: &&str| known.iter().find(|(known, _)| known == name);
                names.iter().filter_map(named).flat_map(|(_, numbers)| numbers.clone()).collect()
            }
        };
        sets.extend(std::iter::repeat_n(set_of(numbers, How::Dependent), declaration.count()));
    }
    sets
}

/// Adds what lies in one window of numbers.
fn trace<M: Model>(
    window: usize,
    memory: &M::Memory,
    discrete: &[Set],
    running: &mut [Set],
    initial: &mut [Option<Set>],
) {
    let none = Dependence::number(How::Dependent);
    let on = |number: usize| number.checked_sub(window).map_or(none, Dependence::on);
    let seed = |block: Block| move |index: usize, _: f64| on(Layout::<M>::first(block) + index);
    let p = widest::<M>();
    let u: M::Inputs<f64> = Variables::start();
    let x: M::States<f64> = Variables::start();
    let d: M::Discrete<f64> = Variables::start();

    // While the simulation runs, parameters are factors that are fixed or tunable.
    let mut factors = Vec::new();
    for declaration in Layout::<M>::declarations(Block::Parameters) {
        let factor = if declaration.tunable { How::Tunable } else { How::Fixed };
        factors.extend(std::iter::repeat_n(Dependence::number(factor), declaration.count()));
    }
    let constants: M::Parameters<Dependence> = lift(&p, |index, _| factors[index]);
    let inputs: M::Inputs<Dependence> = lift(&u, seed(Block::Inputs));
    let states: M::States<Dependence> = lift(&x, seed(Block::States));
    let switched: M::Discrete<Dependence> = lift(&d, |index, _| {
        let changing = Dependence::number(How::Discrete);
        discrete[index].keys().map(|number| on(*number).bent()).fold(changing, |a, b| a + b)
    });
    let at = Point::<M, _> { t: on(0), p: &constants, u: &inputs, x: &states, d: &switched, memory };
    for (index, set) in evaluate::<M>(&at).into_iter().enumerate().skip(Layout::<M>::STATE_COUNT) {
        running[Layout::<M>::STATES + index].extend(members(set).map(|(member, how)| (window + member, how)));
    }

    // When initialization ends, they follow from the start values of p, u and x; d is taken to follow from all of it,
    // so what depends on d depends on everything.
    let everything = Dependence::everything();
    let parameters: M::Parameters<Dependence> = lift(&p, seed(Block::Parameters));
    let states = M::start(&parameters, &inputs, &states);
    let initially = |of_discrete: bool| {
        let d: M::Discrete<Dependence> = lift(&d, |_, _| if of_discrete { everything } else { none });
        evaluate::<M>(&Point { t: on(0), p: &parameters, u: &inputs, x: &states, d: &d, memory })
    };
    for (index, (with, without)) in initially(true).into_iter().zip(initially(false)).enumerate() {
        let place = &mut initial[Layout::<M>::STATES + index];
        // Only a dependence on d can make the whole window appear where it did not.
        let of_discrete = with.is_everything() && !without.is_everything();
        match place.as_mut().filter(|_| !of_discrete) {
            Some(known) => known.extend(members(without).map(|(member, how)| (window + member, how))),
            None => *place = None,
        }
    }
}

/// What x, ẋ and y depend on at a point. Compiled once for all callers: the equations are the greater part of a library.
#[inline(never)]
fn evaluate<M: Model>(at: &Point<'_, M, Dependence>) -> Vec<Dependence> {
    let mut sets = vec![Dependence::number(How::Constant); initial_count::<M>()];
    let n = Layout::<M>::STATE_COUNT;
    at.x.write_reals(&mut sets[..n]);
    M::derivatives(at).write_reals(&mut sets[n..2 * n]);
    M::outputs(at).write_reals(&mut sets[2 * n..]);
    sets
}

fn initial_count<M: Model>() -> usize {
    Layout::<M>::DISCRETE - Layout::<M>::STATES
}

fn members(set: Dependence) -> impl Iterator<Item = (usize, How)> {
    (0..Dependence::WINDOW).filter_map(move |member| Some((member, set.how(member)?)))
}

/// Parameters with which all that arrays have room for is there.
fn widest<M: Model>() -> M::Parameters<f64> {
    let mut p: M::Parameters<f64> = Variables::start();
    for declaration in Layout::<M>::declarations(Block::Parameters) {
        if let (Kind::Size, Some(max)) = (declaration.kind, declaration.max) {
            // An array has far fewer elements than a u32 can count.
            p.set(declaration.first, Value::Size(max as u32));
        }
    }
    p
}
