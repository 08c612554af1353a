//! Where a value reference points: the variables of a model, numbered once for both FMI versions.
//!
//! 0 is time; then follow, scalar by scalar, p, u, x, ẋ, y, d and z. An array has the number of its first element in
//! FMI 3.0; in FMI 2.0 each element has its own.

use core::marker::PhantomData;

use crate::declaration::{Declaration, Declarer};
use crate::model::{Indicators, Model};
use crate::variables::Variables;

/// A block of variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// t.
    Time,
    /// p.
    Parameters,
    /// u.
    Inputs,
    /// x.
    States,
    /// ẋ.
    Derivatives,
    /// y.
    Outputs,
    /// d.
    Discrete,
    /// z.
    Indicators,
    /// Clocks, in an FMU with clocks; they are reached by functions of their own.
    Clocks,
}

/// The numbering of a model's variables.
pub struct Layout<M>(PhantomData<M>);

impl<M: Model> Layout<M> {
    /// The first parameter.
    pub const PARAMETERS: usize = 1;
    /// The first input.
    pub const INPUTS: usize = Self::PARAMETERS + <M::Parameters<f64> as Variables<f64>>::COUNT;
    /// The first state.
    pub const STATES: usize = Self::INPUTS + <M::Inputs<f64> as Variables<f64>>::COUNT;
    /// How many states there are.
    pub const STATE_COUNT: usize = <M::States<f64> as Variables<f64>>::COUNT;
    /// How many event indicators there are.
    pub const INDICATOR_COUNT: usize = <M::Indicators as Indicators>::COUNT;
    /// The first derivative.
    pub const DERIVATIVES: usize = Self::STATES + Self::STATE_COUNT;
    /// The first output.
    pub const OUTPUTS: usize = Self::DERIVATIVES + Self::STATE_COUNT;
    /// The first discrete variable.
    pub const DISCRETE: usize = Self::OUTPUTS + <M::Outputs<f64> as Variables<f64>>::COUNT;
    /// The first event indicator.
    pub const INDICATORS: usize = Self::DISCRETE + <M::Discrete<f64> as Variables<f64>>::COUNT;
    /// The number behind the last variable.
    pub const END: usize = Self::INDICATORS + Self::INDICATOR_COUNT;
    /// The first clock, in an FMU with clocks.
    pub const CLOCKS: usize = Self::END;

    /// The block of a value reference and the index in it.
    #[inline]
    pub fn locate(reference: u32) -> Option<(Block, usize)> {
        let n = reference as usize;
        Some(if n >= Self::END {
            return None;
        } else if n >= Self::INDICATORS {
            (Block::Indicators, n - Self::INDICATORS)
        } else if n >= Self::DISCRETE {
            (Block::Discrete, n - Self::DISCRETE)
        } else if n >= Self::OUTPUTS {
            (Block::Outputs, n - Self::OUTPUTS)
        } else if n >= Self::DERIVATIVES {
            (Block::Derivatives, n - Self::DERIVATIVES)
        } else if n >= Self::STATES {
            (Block::States, n - Self::STATES)
        } else if n >= Self::INPUTS {
            (Block::Inputs, n - Self::INPUTS)
        } else if n >= Self::PARAMETERS {
            (Block::Parameters, n - Self::PARAMETERS)
        } else {
            (Block::Time, 0)
        })
    }

    /// The number of the first variable of a block.
    pub fn first(block: Block) -> usize {
        match block {
            Block::Time => 0,
            Block::Parameters => Self::PARAMETERS,
            Block::Inputs => Self::INPUTS,
            Block::States => Self::STATES,
            Block::Derivatives => Self::DERIVATIVES,
            Block::Outputs => Self::OUTPUTS,
            Block::Discrete => Self::DISCRETE,
            Block::Indicators => Self::INDICATORS,
            Block::Clocks => Self::CLOCKS,
        }
    }

    /// How many scalars the variable has that begins at a place: 0 inside an array.
    pub fn extent(block: Block, index: usize) -> usize {
        match block {
            Block::Time | Block::Indicators | Block::Clocks => 1,
            Block::Parameters => <M::Parameters<f64> as Variables<f64>>::extent(index),
            Block::Inputs => <M::Inputs<f64> as Variables<f64>>::extent(index),
            Block::States | Block::Derivatives => <M::States<f64> as Variables<f64>>::extent(index),
            Block::Outputs => <M::Outputs<f64> as Variables<f64>>::extent(index),
            Block::Discrete => <M::Discrete<f64> as Variables<f64>>::extent(index),
        }
    }

    /// The declarations of a block; time, derivatives and indicators have none of their own.
    pub fn declarations(block: Block) -> Vec<Declaration> {
        let mut into = Declarer::default();
        match block {
            Block::Time | Block::Derivatives | Block::Indicators | Block::Clocks => {}
            Block::Parameters => <M::Parameters<f64> as Variables<f64>>::declare(&mut into),
            Block::Inputs => <M::Inputs<f64> as Variables<f64>>::declare(&mut into),
            Block::States => <M::States<f64> as Variables<f64>>::declare(&mut into),
            Block::Outputs => <M::Outputs<f64> as Variables<f64>>::declare(&mut into),
            Block::Discrete => <M::Discrete<f64> as Variables<f64>>::declare(&mut into),
        }
        into.into_declarations()
    }

    /// The name of a scalar, with its index when it is an element of an array; for messages.
    pub fn name(block: Block, index: usize) -> String {
        let declarations = match block {
            Block::Time => return "time".into(),
            Block::Derivatives => return format!("der({})", Self::name(Block::States, index)),
            Block::Indicators => return format!("event_indicator[{}]", index + 1),
            Block::Clocks => return M::CLOCKS.get(index).map_or("clock", |clock| clock.name).to_string(),
            other => Self::declarations(other),
        };
        match declarations.iter().find(|d| (d.first..d.first + d.count()).contains(&index)) {
            Some(declaration) if declaration.dimension.is_some() => {
                format!("{}[{}]", declaration.name, index - declaration.first + 1)
            }
            Some(declaration) => declaration.name.clone(),
            None => format!("variable {index}"),
        }
    }
}
