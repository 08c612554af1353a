//! Clocks in `ModelVariables`.

use swayless_modeldesc::types::{Causality, Clock, DataType, IntervalVariability, Variability, Variable};

use super::variables::Entry;
use crate::clocks::Interval;
use crate::declaration::Declaration;
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::token::Variant;

/// The value reference of a clock.
fn clock_reference<M: Model>(index: usize) -> u32 {
    u32::try_from(Layout::<M>::CLOCKS + index).unwrap_or(u32::MAX)
}

/// The value references of the clocks that compute a variable.
pub fn clocks_of<M: Model>(declaration: &Declaration, variant: Variant) -> Vec<u32> {
    let own = |name: &str| declaration.clocks().any(|clock| clock == name);
    let computing = M::CLOCKS.iter().enumerate().filter(|(_, clock)| variant == Variant::Clocked && own(clock.name));
    computing.map(|(index, _)| clock_reference::<M>(index)).collect()
}

/// The clocks as variables.
pub fn clocks<M: Model>() -> impl Iterator<Item = Entry> {
    M::CLOCKS.iter().enumerate().map(|(index, clock)| {
        let causality = if clock.interval.is_output() { Causality::Output } else { Causality::Input };
        let reference = clock_reference::<M>(index);
        let mut variable = Variable::new(clock.name, reference, DataType::Clock, causality, Variability::Discrete);
        variable.description = Some(clock.description.to_string());
        variable.initial = None;
        let by = M::CLOCKS.iter().enumerate().filter(|(_, other)| clock.by.contains(&other.name));
        variable.clocks = by.map(|(index, _)| clock_reference::<M>(index)).collect();
        variable.clock = Some(described(clock));
        Entry { block: Block::Clocks, first: Layout::<M>::CLOCKS + index, count: 1, variable }
    })
}

fn described(clock: &crate::clocks::Clock) -> Clock {
    let interval = clock.interval;
    let variability = match interval {
        Interval::Constant(_) => IntervalVariability::Constant,
        Interval::Fixed(_) | Interval::OfFixedParameters => IntervalVariability::Fixed,
        Interval::Tunable(_) | Interval::OfTunableParameters => IntervalVariability::Tunable,
        Interval::Changing => IntervalVariability::Changing,
        Interval::Countdown => IntervalVariability::Countdown,
        Interval::Triggered => IntervalVariability::Triggered,
    };
    Clock {
        // An output clock has none; an input clock needs one in scheduled execution.
        priority: (!interval.is_output()).then_some(clock.priority),
        interval_decimal: interval.declared(),
        shift_decimal: interval.declared().map(|_| clock.shift),
        ..Clock::new(variability)
    }
}
