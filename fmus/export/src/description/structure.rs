//! `ModelStructure`.

use std::collections::BTreeMap;

use swayless_modeldesc::types::{Causality, DependencyKind, Initial, ModelStructure, Unknown};
use swayless_scalar::How;

use super::variables::Entry;
use crate::layout::Block;
use crate::model::Model;
use crate::structure::{Set, Structure, set_of};

/// The structure over variables, which are arrays or their elements.
pub fn of<M: Model>(entries: &[Entry]) -> ModelStructure {
    let traced = Structure::of::<M>();
    // The positions of variables by the numbers of their scalars.
    let position =
        |number: usize| entries.iter().position(|entry| (entry.first..entry.first + entry.count).contains(&number));
    let unknown = |place: usize, dependencies: Option<Vec<(usize, DependencyKind)>>| Unknown {
        variable: place,
        dependencies_kind: dependencies.as_ref().map(|found| found.iter().map(|(_, kind)| *kind).collect()),
        dependencies: dependencies.map(|found| found.into_iter().map(|(place, _)| place).collect()),
        ..Unknown::default()
    };
    // Of the elements of an array the most intricate dependence counts.
    let gather = |sets: Vec<&Set>, kind: fn(How) -> DependencyKind| {
        let mut found: BTreeMap<usize, How> = BTreeMap::new();
        for (number, how) in sets.into_iter().flatten() {
            if let Some(place) = position(*number) {
                found.entry(place).and_modify(|known| *known = (*known).max(*how)).or_insert(*how);
            }
        }
        found.into_iter().map(|(place, how)| (place, kind(how))).collect::<Vec<_>>()
    };
    let running = |place: usize, entry: &Entry| {
        let numbers = entry.first..entry.first + entry.count;
        if entry.block == Block::Clocks {
            return unknown(place, None);
        }
        if entry.block == Block::States {
            // A state is itself.
            let itself = set_of(numbers, How::Constant);
            return unknown(place, Some(gather(vec![&itself], kind)));
        }
        unknown(place, Some(gather(numbers.map(|number| traced.running(number)).collect(), kind)))
    };
    let initial = |place: usize, entry: &Entry| {
        let sets = (entry.first..entry.first + entry.count).map(|number| traced.initial(number));
        let found = sets.collect::<Option<Vec<_>>>().map(|sets| {
            let mut found = gather(sets, initial_kind);
            // A calculated state is an unknown itself, not something to depend on.
            found.retain(|(place, _)| entries[*place].variable.initial != Some(Initial::Calculated));
            found
        });
        unknown(place, found)
    };
    let places = || entries.iter().enumerate();
    let is_output = |entry: &Entry| entry.variable.causality == Causality::Output;
    // What a clock computes need not be known before it ticks (FMI 3.0.2, 2.2.8.3).
    let is_unknown = |entry: &Entry| {
        let clocked = entry.block == Block::Clocks || !entry.variable.clocks.is_empty();
        let exposed = is_output(entry) || matches!(entry.block, Block::States | Block::Derivatives);
        exposed && !clocked && entry.variable.initial == Some(Initial::Calculated)
    };
    ModelStructure {
        outputs: places().filter(|(_, e)| is_output(e)).map(|(i, e)| running(i, e)).collect(),
        derivatives: places().filter(|(_, e)| e.block == Block::Derivatives).map(|(i, e)| running(i, e)).collect(),
        initial_unknowns: places().filter(|(_, e)| is_unknown(e)).map(|(i, e)| initial(i, e)).collect(),
        clocked_states: Vec::new(),
        // What an indicator depends on is not said, since it changes with the discrete state.
        event_indicators: places()
            .filter(|(_, e)| e.block == Block::Indicators)
            .map(|(i, _)| unknown(i, None))
            .collect(),
    }
}

fn kind(how: How) -> DependencyKind {
    match how {
        How::Constant => DependencyKind::Constant,
        How::Fixed => DependencyKind::Fixed,
        How::Tunable => DependencyKind::Tunable,
        How::Discrete => DependencyKind::Discrete,
        How::Dependent => DependencyKind::Dependent,
    }
}

/// Before the simulation runs, a factor is constant or it is not (FMI 3.0.2, 2.4.8).
fn initial_kind(how: How) -> DependencyKind {
    if how == How::Constant { DependencyKind::Constant } else { DependencyKind::Dependent }
}
