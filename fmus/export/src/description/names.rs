//! Names by which a declaration refers to others: those that lead nowhere.

use crate::declaration::Kind;
use crate::layout::{Block, Layout};
use crate::model::Model;

/// A bit for each clock must fit into a set.
const MOST_CLOCKS: usize = u64::BITS as usize;

/// What is wrong, one sentence each.
pub fn wrong<M: Model>() -> Vec<String> {
    let of = |block| Layout::<M>::declarations(block);
    let known: Vec<String> = [Block::Inputs, Block::States].into_iter().flat_map(of).map(|d| d.name).collect();
    let sizes: Vec<String> =
        of(Block::Parameters).into_iter().filter(|d| d.kind == Kind::Size).map(|d| d.name).collect();
    let is_clock = |name: &str| M::CLOCKS.iter().any(|clock| clock.name == name);
    let mut problems = Vec::new();
    for declaration in
        [Block::Parameters, Block::Inputs, Block::States, Block::Outputs, Block::Discrete].into_iter().flat_map(of)
    {
        let name = &declaration.name;
        for other in declaration.depends_on.unwrap_or_default() {
            if !known.iter().any(|known| known == other) {
                problems.push(format!("{name} has depends_on `{other}`, which is no input and no state"));
            }
        }
        if let Some(length) = declaration.length.filter(|length| !sizes.iter().any(|known| known == length)) {
            problems.push(format!("{name} has length `{length}`, which is no parameter of type u32"));
        }
        for clock in declaration.clocks().filter(|clock| !is_clock(clock)) {
            problems.push(format!("{name} has clock `{clock}`, which is not among the model's CLOCKS"));
        }
    }
    for clock in M::CLOCKS {
        for other in clock.by.iter().filter(|other| !is_clock(other)) {
            problems.push(format!("clock {} can tick by `{other}`, which is not among the model's CLOCKS", clock.name));
        }
    }
    if M::CLOCKS.len() > MOST_CLOCKS {
        problems.push(format!("the model has {} clocks; at most {MOST_CLOCKS} are supported", M::CLOCKS.len()));
    }
    problems
}
