//! What an importer may ask of an instance, whatever the version: the calls and what comes back.

use swayless_modeldesc::types::DataType;

/// A call with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub enum Call {
    SetDebugLogging {
        on: bool,
        categories: Vec<String>,
    },
    SetupExperiment(Experiment),
    EnterInitialization(Experiment),
    ExitInitialization,
    Terminate,
    Reset,
    Get(Access),
    Set(Access, Values),
    GetTiming(Timing, Access),
    SetTiming(Timing, Access, Vec<f64>),
    DoStep {
        time: f64,
        size: f64,
    },
    EnterEvent,
    Update,
    EnterContinuousTime,
    EnterStep,
    CompletedStep,
    SetTime(f64),
    SetStates(Vec<f64>),
    GetStates(usize),
    GetDerivatives(usize),
    GetIndicators(usize),
    GetNominals(usize),
    GetCounts,
    Directional(Sensitivity),
    Adjoint(Sensitivity),
    OutputDerivatives(Access, Vec<i32>),
    InputDerivatives(Access, Vec<i32>, Vec<f64>),
    GetState(usize),
    SetState(usize),
    FreeState(usize),
    Serialize(usize),
    Deserialize(usize, Vec<u8>),
    /// By one of the five functions, of one of the kinds.
    Status(u8, i32),
    CancelStep,
    EnterConfiguration,
    ExitConfiguration,
    EvaluateDiscrete,
    Activate(u32, f64),
    Dependencies(u32),
}

/// The frame of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Experiment {
    pub tolerance: Option<f64>,
    pub start: f64,
    pub stop: Option<f64>,
}

/// Variables to get or set by the functions of a type.
#[derive(Debug, Clone, PartialEq)]
pub struct Access {
    pub data_type: DataType,
    pub references: Vec<u32>,
    /// How many values there is room for: `nValues` in FMI 3.0, the number of references in FMI 2.0.
    pub count: usize,
    /// The values' array is NULL.
    pub null: bool,
}

/// What of clocks to get or set, and how it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Timing {
    /// Shifts, not intervals.
    pub shift: bool,
    /// As fractions, not as decimals.
    pub fraction: bool,
}

/// Values to set; as many as `count` says.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    Floats(Vec<f64>),
    Integers(Vec<i64>),
    /// Not only 0 and 1.
    Booleans(Vec<u8>),
    /// `None` is a NULL.
    Texts(Vec<Option<String>>),
}

/// Arguments of directional and adjoint derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    pub unknowns: Vec<u32>,
    pub knowns: Vec<u32>,
    pub seed: Vec<f64>,
    /// Room for the answer.
    pub count: usize,
}

/// What an instance answered.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answer {
    pub status: i32,
    /// Numbers as bits, so that every difference counts; texts as a hash.
    pub bits: Vec<u64>,
    /// A serialized state.
    pub bytes: Vec<u8>,
}

/// Reads bits back as floats.
pub fn floats(bits: &[u64]) -> impl Iterator<Item = f64> {
    bits.iter().map(|bits| f64::from_bits(*bits))
}
