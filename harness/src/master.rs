//! Master algorithms.

/// Which master algorithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AlgorithmKind {
    /// All instances step at once, each with the others' outputs from the step's start.
    Jacobi,
    /// The instances step one after the other, each with the fresh outputs of those before it.
    #[default]
    GaussSeidel,
}
