//! Master algorithms: in which order instances exchange values and step.

use std::fmt;
use std::str::FromStr;

use crate::error::{Error, Result};
use crate::run::Run;

/// A master algorithm with a fixed step.
pub trait Algorithm {
    /// Takes all instances from `time` by `step_size` (s). Before and after, the outputs that were got last are those
    /// of the communication point, and the inputs driven by signals are those at `time`.
    fn step(&mut self, run: &mut Run, time: f64, step_size: f64) -> Result<()>;
}

/// All instances step at once, each with the others' outputs from the step's start: parallel, first order.
#[derive(Debug, Clone, Copy, Default)]
pub struct Jacobi;

impl Algorithm for Jacobi {
    fn step(&mut self, run: &mut Run, time: f64, step_size: f64) -> Result<()> {
        for instance in 0..run.count() {
            run.transfer(instance, time)?;
        }
        for instance in 0..run.count() {
            run.set_inputs(instance, time)?;
        }
        for instance in 0..run.count() {
            run.do_step(instance, time, step_size)?;
        }
        (0..run.count()).try_for_each(|instance| run.get_outputs(instance, time + step_size))
    }
}

/// The instances step one after the other, each with the fresh outputs of those before it.
#[derive(Debug, Clone)]
pub struct GaussSeidel {
    order: Vec<usize>,
}

impl GaussSeidel {
    /// In the order of the flow through the instances.
    pub fn new(run: &Run) -> Self {
        Self { order: run.order().to_vec() }
    }
}

impl Algorithm for GaussSeidel {
    fn step(&mut self, run: &mut Run, time: f64, step_size: f64) -> Result<()> {
        for &instance in &self.order {
            run.transfer(instance, time)?;
            run.set_inputs(instance, time)?;
            run.do_step(instance, time, step_size)?;
            run.get_outputs(instance, time + step_size)?;
        }
        Ok(())
    }
}

/// Which master algorithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AlgorithmKind {
    /// [`Jacobi`].
    Jacobi,
    /// [`GaussSeidel`].
    #[default]
    GaussSeidel,
}

impl AlgorithmKind {
    /// The algorithm itself, for a run.
    pub fn make(self, run: &Run) -> Box<dyn Algorithm> {
        match self {
            Self::Jacobi => Box::new(Jacobi),
            Self::GaussSeidel => Box::new(GaussSeidel::new(run)),
        }
    }
}

impl fmt::Display for AlgorithmKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Jacobi => "jacobi",
            Self::GaussSeidel => "gauss-seidel",
        })
    }
}

impl FromStr for AlgorithmKind {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "jacobi" => Ok(Self::Jacobi),
            "gauss-seidel" => Ok(Self::GaussSeidel),
            _ => Err(Error::Option(format!("there is no algorithm `{text}`; there are jacobi and gauss-seidel"))),
        }
    }
}
