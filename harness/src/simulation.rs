//! Runs a system from its start to its stop time.

use std::time::{Duration, Instant};

use crate::error::{Error, Result};
use crate::master::AlgorithmKind;
use crate::recorder::Observer;
use crate::run::{Run, Sampler, start};
use crate::slave::{Experiment, LogMessage};
use crate::system::{System, Wiring};

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
    let begin = Instant::now();
    if system.instances().is_empty() {
        return Err(Error::Option("the system has no instances".to_owned()));
    }
    let wiring = Wiring::of(system)?;
    let clock = Clock::of(system, options)?;
    let experiment = Experiment { start_time: clock.start, stop_time: clock.stop, tolerance: clock.tolerance };
    let mut run = start(system, &wiring, &experiment, options.logging)?;

    let stepping = Instant::now();
    let stepped = step(system, &mut run, &wiring, options, &clock, observer);
    let stepping_time = stepping.elapsed();
    let terminated = run.terminate();
    let messages = run.take_messages();
    let (steps, stop_time) = stepped?;
    terminated?;
    observer.end()?;
    let terminated_by = run.terminated().map(|(name, _)| name.to_owned());
    drop(run);
    Ok(Summary {
        start_time: clock.start,
        stop_time,
        step_size: clock.step_size,
        steps,
        terminated_by,
        wall_time: begin.elapsed(),
        stepping_time,
        messages,
    })
}

/// Steps to the end; returns how many steps were taken and where the run ended.
fn step(
    system: &System,
    run: &mut Run,
    wiring: &Wiring,
    options: &Options,
    clock: &Clock,
    observer: &mut dyn Observer,
) -> Result<(u64, f64)> {
    let mut sampler = match observer.records() {
        true => Some(Sampler::new(system, wiring, run, &options.output_variables)?),
        false => None,
    };
    if let Some(sampler) = &mut sampler {
        observer.begin(sampler.columns())?;
        sampler.sample(run, clock.start, observer)?;
    }
    let mut algorithm = options.algorithm.make(run);
    let stride = (clock.steps / 1000).max(1);
    for index in 0..clock.steps {
        let (time, step_size, next) = clock.step(index);
        run.take_signals(time);
        algorithm.step(run, time, step_size)?;
        let terminated = run.terminated().map(|(_, at)| at);
        if let Some(sampler) = &mut sampler
            && (clock.is_sampled(index + 1) || terminated.is_some())
            && terminated.is_none_or(|at| at >= next)
        {
            sampler.sample(run, next, observer)?;
        }
        if let Some(at) = terminated {
            observer.progress(1.0);
            return Ok((index + 1, at));
        }
        if observer.stops() {
            return Err(Error::Interrupted { time: next });
        }
        if (index + 1).is_multiple_of(stride) || index + 1 == clock.steps {
            observer.progress((index + 1) as f64 / clock.steps as f64);
        }
    }
    Ok((clock.steps, clock.stop))
}

/// The communication points of a run.
#[derive(Debug, Clone, PartialEq)]
struct Clock {
    start: f64,
    stop: f64,
    step_size: f64,
    tolerance: Option<f64>,
    /// How many steps there are, the last of which may be shorter.
    steps: u64,
    /// Every how many steps a sample is taken.
    interval: u64,
}

impl Clock {
    /// From the options, the system and the default experiments of its FMUs, in this order.
    fn of(system: &System, options: &Options) -> Result<Self> {
        let fmus = || {
            let descriptions = system.instances().iter().map(|instance| instance.model.description());
            descriptions.filter_map(|description| description.default_experiment)
        };
        let own = &system.default_experiment;
        let start = options.start_time.or(own.start_time);
        let start = start.or_else(|| fmus().find_map(|fmu| fmu.start_time)).unwrap_or(0.0);
        let stop = options.stop_time.or(own.stop_time);
        let stop = stop.or_else(|| fmus().filter_map(|fmu| fmu.stop_time).reduce(f64::max)).unwrap_or(start + 1.0);
        let wanted = options.step_size.or(own.step_size);
        let step_size = wanted.or_else(|| fmus().filter_map(|fmu| fmu.step_size).reduce(f64::min));
        let step_size = step_size.unwrap_or((stop - start) / 1000.0);
        let tolerance = options.tolerance.or(own.tolerance);
        let wrong = |text: String| Err(Error::Option(text));
        if !start.is_finite() || !stop.is_finite() || stop <= start {
            return wrong(format!("the stop time ({stop} s) must lie after the start time ({start} s)"));
        }
        if !step_size.is_finite() || step_size <= 0.0 || start + step_size == start {
            return wrong(format!("the step size ({step_size} s) must be greater than 0"));
        }
        if tolerance.is_some_and(|tolerance| !tolerance.is_finite() || tolerance <= 0.0) {
            return wrong("the tolerance must be greater than 0".to_owned());
        }
        // A step that is missing or left over by less than this is rounding.
        const ROUNDING: f64 = 1e-6;
        let count = (stop - start) / step_size;
        let whole = (count - count.round()).abs() < ROUNDING;
        let steps = if whole { count.round() } else { count.ceil() };
        if steps > 2f64.powi(52) {
            return wrong(format!("{steps:e} steps are too many; take a larger step size than {step_size} s"));
        }
        if !whole {
            let rigid = system.instances().iter().find(|instance| {
                let interface = instance.model.description().co_simulation.as_ref();
                interface.is_some_and(|interface| !interface.can_handle_variable_communication_step_size)
            });
            if let Some(rigid) = rigid {
                return wrong(format!(
                    "the last step to {stop} s would be shorter than {step_size} s, which `{}` cannot handle; choose a \
                     stop time that is a whole number of steps away",
                    rigid.name
                ));
            }
        }
        let interval = match options.output_interval {
            None => 1.0,
            Some(interval) => interval / step_size,
        };
        if !(interval.round() >= 1.0 && (interval - interval.round()).abs() < ROUNDING * interval) {
            let interval = interval * step_size;
            return wrong(format!(
                "the output interval ({interval} s) is no multiple of the step size ({step_size} s)"
            ));
        }
        Ok(Self { start, stop, step_size, tolerance, steps: steps as u64, interval: interval.round() as u64 })
    }

    /// When a step begins, how long it is, when it ends (s). Times are multiplied, never summed up.
    fn step(&self, index: u64) -> (f64, f64, f64) {
        let at = |index: u64| self.start + index as f64 * self.step_size;
        let (time, next) = (at(index), at(index + 1));
        let last = index + 1 == self.steps;
        if last && (next - self.stop).abs() > 0.5e-6 * self.step_size {
            return (time, self.stop - time, self.stop);
        }
        (time, self.step_size, if last { self.stop } else { next })
    }

    /// Whether a sample is taken at a communication point; the last one always is.
    fn is_sampled(&self, index: u64) -> bool {
        index.is_multiple_of(self.interval) || index == self.steps
    }
}

#[cfg(test)]
mod tests;
