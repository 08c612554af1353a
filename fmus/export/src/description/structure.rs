//! `ModelStructure`.

use std::collections::BTreeSet;

use swayless_modeldesc::types::{Causality, Initial, ModelStructure, Unknown};

use super::variables::Entry;
use crate::layout::Block;
use crate::model::Model;
use crate::structure::Structure;

/// The structure over variables, which are arrays or their elements.
pub fn of<M: Model>(entries: &[Entry]) -> ModelStructure {
    let traced = Structure::of::<M>();
    // The positions of variables by the numbers of their scalars.
    let position =
        |number: usize| entries.iter().position(|entry| (entry.first..entry.first + entry.count).contains(&number));
    let unknown = |place: usize, dependencies: Option<BTreeSet<usize>>| Unknown {
        variable: place,
        dependencies: dependencies.map(|set| set.into_iter().collect()),
        ..Unknown::default()
    };
    let running = |place: usize, entry: &Entry| {
        let numbers: BTreeSet<usize> = if entry.block == Block::States {
            (entry.first..entry.first + entry.count).collect()
        } else {
            (entry.first..entry.first + entry.count).flat_map(|number| traced.running(number)).copied().collect()
        };
        unknown(place, Some(numbers.into_iter().filter_map(position).collect()))
    };
    let initial = |place: usize, entry: &Entry| {
        let mut all = Some(BTreeSet::new());
        for number in entry.first..entry.first + entry.count {
            match (traced.initial(number), &mut all) {
                (Some(numbers), Some(set)) => set.extend(
                    // A calculated state is an unknown itself, not something to depend on.
                    numbers
                        .iter()
                        .filter_map(|number| position(*number))
                        .filter(|place| entries[*place].variable.initial != Some(Initial::Calculated)),
                ),
                _ => all = None,
            }
        }
        unknown(place, all)
    };
    let places = || entries.iter().enumerate();
    let is_output = |entry: &Entry| entry.variable.causality == Causality::Output;
    let is_unknown = |entry: &Entry| {
        let exposed = is_output(entry) || matches!(entry.block, Block::States | Block::Derivatives);
        exposed && entry.variable.initial == Some(Initial::Calculated)
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
