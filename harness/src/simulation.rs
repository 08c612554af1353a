//! Runs a system from its start to its stop time.

use std::time::Duration;

use crate::error::{Error, Result};
use crate::master::AlgorithmKind;
use crate::recorder::Observer;
use crate::slave::LogMessage;
use crate::system::System;

/// How to run a system. What is `None` is taken from the system, else from its FMUs' default experiments.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// When to start (s); 0 if nothing says otherwise.
    pub start_time: Option<f64>,
    /// When to stop (s); 1 s after the start if nothing says otherwise.
    pub stop_time: Option<f64>,
    /// The communication step size (s); a thousandth of the run if nothing says otherwise.
    pub step_size: Option<f64>,
    /// The relative tolerance of the FMUs' integrators.
    pub tolerance: Option<f64>,
    /// The time between two samples (s), a multiple of the step size; every step if not given.
    pub output_interval: Option<f64>,
    /// The variables to record, as `instance.variable`; all outputs if empty.
    pub output_variables: Vec<String>,
    /// The master algorithm.
    pub algorithm: AlgorithmKind,
    /// Whether the FMUs are asked for debug messages.
    pub logging: bool,
}

/// What a run was.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// When it started (s).
    pub start_time: f64,
    /// When it ended (s): the stop time, unless an FMU ended it earlier.
    pub stop_time: f64,
    /// The communication step size (s).
    pub step_size: f64,
    /// How many steps were taken.
    pub steps: u64,
    /// The instance that ended the run before its stop time, if one did.
    pub terminated_by: Option<String>,
    /// How long the whole run took, with instantiation and initialization.
    pub wall_time: Duration,
    /// How long the steps took, recording included.
    pub stepping_time: Duration,
    /// The FMUs' messages.
    pub messages: Vec<LogMessage>,
}

impl Summary {
    /// Simulated time over the time that the steps took.
    pub fn real_time_factor(&self) -> f64 {
        (self.stop_time - self.start_time) / self.stepping_time.as_secs_f64().max(f64::MIN_POSITIVE)
    }
}

/// Runs a system. The instances are made for this run and are always terminated and freed, also after an error.
pub fn simulate(system: &System, options: &Options, observer: &mut dyn Observer) -> Result<Summary> {
    system.check()?;
    let _ = (options, observer);
    Err(Error::Option("nothing runs yet".to_owned()))
}
