//! What the master sees of an FMU: a model that can be instantiated, and an instance that can be stepped.
//!
//! Both FMI versions hide behind these traits, and so do the mock slaves that the algorithms are tested with.

use std::fmt;
use std::path::Path;

use swayless_modeldesc::types::{DataType, ModelDescription};

use crate::error::Result;

/// What instances are made from: a loaded FMU, or Rust code in a test.
pub trait Model: Send + Sync {
    /// Where it comes from, for messages.
    fn path(&self) -> &Path;

    /// Its description.
    fn description(&self) -> &ModelDescription;

    /// Makes an instance for co-simulation. Names are unique within a system; `logging` asks for debug messages.
    fn instantiate(&self, name: &str, logging: bool) -> Result<Box<dyn Slave>>;
}

/// What an instance is told about the run before it is initialized.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Experiment {
    /// `startTime` (s).
    pub start_time: f64,
    /// `stopTime` (s); steps never go beyond it.
    pub stop_time: f64,
    /// The relative tolerance of the instance's integrator, if one is asked for.
    pub tolerance: Option<f64>,
}

/// An instance for co-simulation.
///
/// Values travel in slices, in the order of the value references; an array variable contributes all its elements in
/// row-major order. Every number of a call has the one type that is given with it. No call allocates once it has been
/// made with slices of the same length, unless it fails.
pub trait Slave {
    /// Enters the mode in which structural parameters are set; in FMI 2.0 there is none.
    fn enter_configuration_mode(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    /// Leaves the mode in which structural parameters are set.
    fn exit_configuration_mode(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    /// Sets up the experiment and enters initialization mode.
    fn enter_initialization_mode(&mut self, experiment: &Experiment) -> Result<(), Failure>;

    /// Ends initialization; the instance can then be stepped.
    fn exit_initialization_mode(&mut self) -> Result<(), Failure>;

    /// Gets floats of either width.
    fn get_float(&mut self, data_type: DataType, references: &[u32], values: &mut [f64]) -> Result<(), Failure>;

    /// Sets floats of either width.
    fn set_float(&mut self, data_type: DataType, references: &[u32], values: &[f64]) -> Result<(), Failure>;

    /// Gets integers of any width or enumerations. A `UInt64` travels as its bits.
    fn get_integer(&mut self, data_type: DataType, references: &[u32], values: &mut [i64]) -> Result<(), Failure>;

    /// Sets integers of any width or enumerations; a value that does not fit the type is refused.
    fn set_integer(&mut self, data_type: DataType, references: &[u32], values: &[i64]) -> Result<(), Failure>;

    /// Gets Booleans.
    fn get_boolean(&mut self, references: &[u32], values: &mut [bool]) -> Result<(), Failure>;

    /// Sets Booleans.
    fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), Failure>;

    /// Gets strings, into those that are there.
    fn get_string(&mut self, references: &[u32], values: &mut [String]) -> Result<(), Failure>;

    /// Sets strings.
    fn set_string(&mut self, references: &[u32], values: &[String]) -> Result<(), Failure>;

    /// Steps from `time` to `time + step_size` (s). After Discard the instance is at the failure's
    /// `last_successful_time`, which in FMI 3.0 is `time`, and can be stepped again from there, with other inputs or a
    /// shorter step; an instance that does not tell where it is can only be terminated.
    fn do_step(&mut self, time: f64, step_size: f64) -> Result<Step, Failure>;

    /// Ends the run; values can still be got.
    fn terminate(&mut self) -> Result<(), Failure>;

    /// Goes back to the state after instantiation.
    fn reset(&mut self) -> Result<(), Failure>;

    /// Hands over the messages that were logged since the last call.
    fn take_messages(&mut self) -> Vec<LogMessage> {
        Vec::new()
    }
}

/// How a step ended that did not fail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// The instance is at the step's end.
    Completed,
    /// The instance wants the run to end, at this time (s).
    Terminated(f64),
}

/// The status of a call that went wrong, or of a log message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// All well.
    Ok,
    /// Not quite right, but the computation goes on.
    Warning,
    /// The call was refused; the instance is as it was.
    Discard,
    /// The instance cannot go on.
    Error,
    /// All instances of the FMU are broken.
    Fatal,
    /// An asynchronous step is under way (FMI 2.0).
    Pending,
    /// A number that the standard does not define.
    Undefined(i32),
    /// The call was not made: it would have been wrong.
    NotCalled,
}

impl From<i32> for Status {
    fn from(status: i32) -> Self {
        match status {
            0 => Self::Ok,
            1 => Self::Warning,
            2 => Self::Discard,
            3 => Self::Error,
            4 => Self::Fatal,
            5 => Self::Pending,
            other => Self::Undefined(other),
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ok => f.write_str("OK"),
            Self::Warning => f.write_str("Warning"),
            Self::Discard => f.write_str("Discard"),
            Self::Error => f.write_str("Error"),
            Self::Fatal => f.write_str("Fatal"),
            Self::Pending => f.write_str("Pending"),
            Self::Undefined(status) => write!(f, "the undefined status {status}"),
            Self::NotCalled => f.write_str("not called"),
        }
    }
}

/// A message that an FMU logged.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogMessage {
    /// The instance that logged it.
    pub instance: String,
    /// Its status.
    pub status: Status,
    /// Its category, empty if it has none.
    pub category: String,
    /// The text.
    pub text: String,
}

impl fmt::Display for LogMessage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}] {}", self.status, self.text)
    }
}

/// A call that failed.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// The function of the standard.
    pub call: &'static str,
    /// What it returned.
    pub status: Status,
    /// How far a step got, if the instance says (s).
    pub last_successful_time: Option<f64>,
    /// What the instance logged, or why the call was not made.
    pub messages: Vec<LogMessage>,
}

impl Failure {
    /// A failed call with one message.
    pub fn new(call: &'static str, status: Status, text: impl Into<String>) -> Self {
        let message = LogMessage { instance: String::new(), status, category: String::new(), text: text.into() };
        Self { call, status, last_successful_time: None, messages: vec![message] }
    }

    /// The call and its status, without the messages.
    pub(crate) fn summary(&self) -> String {
        match self.status {
            Status::NotCalled => format!("{} was not called", self.call),
            status => format!("{} returned {status}", self.call),
        }
    }
}
