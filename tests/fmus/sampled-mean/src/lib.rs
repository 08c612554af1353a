//! `SampledMean`: a weighted mean of the last samples of a signal, with a clock of every kind; for tests of clocks,
//! arrays of variable length, random numbers in saved states, and variables of every type.

use serde::{Deserialize, Serialize};
use swayless_export::{Clock, Environment, Event, Info, Interval, Model, Point, Problem, Scalar, export_fmu};

mod variables;

use variables::{Discrete, Inputs, Level, Parameters, Weighting};

struct SampledMean;

const SAMPLE: usize = 0;
const HEARTBEAT: usize = 1;
const CHECK: usize = 2;
const TRIM: usize = 3;
const LOG: usize = 4;
const PULSE: usize = 5;
const ALARM: usize = 6;
const CROSSING: usize = 7;

/// What is remembered between ticks.
#[derive(Clone, Default, Serialize, Deserialize)]
struct Memory {
    /// The random generator (xorshift64*).
    random: u64,
    /// How many samples have been taken, and how many are there.
    taken: i32,
    filled: u32,
    /// When the pulse and the alarm tick next (s).
    pulse: f64,
    alarm: Option<f64>,
}

impl Memory {
    /// A random number in [−1, 1).
    fn noise(&mut self) -> f64 {
        self.random ^= self.random >> 12;
        self.random ^= self.random << 25;
        self.random ^= self.random >> 27;
        let bits = self.random.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        bits as f64 / f64::from(1_u32 << 26) / f64::from(1_u32 << 26) - 1.0
    }
}

impl Model for SampledMean {
    // Steps that meet no tick, so that importers who add steps up see the same.
    const INFO: Info = Info {
        stop_time: 9.9051,
        step_size: 0.0137,
        ..Info::new("SampledMean", "A weighted mean of the last samples of a signal")
    };
    const CLOCKS: &'static [Clock] = &[
        Clock { priority: 2, ..Clock::new("sample", "Takes a sample", Interval::OfTunableParameters) },
        Clock { shift: 0.05, ..Clock::new("heartbeat", "Counts", Interval::Constant(0.25)) },
        Clock::new("check", "Counts", Interval::Fixed(0.5)),
        Clock::new("trim", "Notes its interval", Interval::Tunable(0.4)),
        Clock { priority: 3, ..Clock::new("log", "Logs the mean", Interval::OfFixedParameters) },
        Clock::new("pulse", "Counts at growing intervals", Interval::Changing),
        Clock { priority: 1, ..Clock::new("alarm", "Raises the alarm", Interval::Countdown) },
        Clock {
            by: &["sample"],
            ..Clock::new("crossing", "The mean has crossed the threshold upwards", Interval::Triggered)
        },
    ];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Memory;
    type Indicators = [f64; 0];

    fn memory(p: &Parameters<f64>, _: &Environment<'_>) -> Result<Memory, Problem> {
        // Any seed but 0 will do for the generator.
        let random = 0x9E37_79B9_7F4A_7C15 ^ u64::from(p.seed.unsigned_abs());
        Ok(Memory { random, ..Memory::default() })
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(clock: usize, p: &Parameters<f64>) -> f64 {
        if clock == SAMPLE { p.sample_time } else { p.log_interval }
    }

    fn next_tick(clock: usize, at: &Point<'_, Self, f64>) -> Option<f64> {
        if clock == PULSE { Some(at.memory.pulse) } else { at.memory.alarm }
    }

    fn tick(clock: usize, at: &mut Event<'_, Self>) {
        match clock {
            SAMPLE => sample(at),
            HEARTBEAT => at.d.heartbeats = at.d.heartbeats.wrapping_add(1),
            CHECK => at.d.checks = at.d.checks.wrapping_add(1),
            TRIM => at.d.trim_interval = at.intervals[TRIM],
            LOG => {
                at.d.logged = at.d.mean;
                at.d.letters = i32::try_from(at.p.label.len()).unwrap_or(i32::MAX);
            }
            PULSE => {
                at.d.pulses = at.d.pulses.wrapping_add(1);
                at.memory.pulse = at.t + 0.1 * (f64::from(at.d.pulses) + 1.0);
            }
            ALARM => {
                at.d.alarmed = true;
                at.memory.alarm = None;
            }
            _ => {}
        }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        if at.initial {
            at.memory.pulse = at.t + 0.1;
        }
        None
    }
}

/// Takes a sample.
fn sample(at: &mut Event<'_, SampledMean>) {
    if at.u.paused {
        return;
    }
    let window = at.p.window as usize;
    at.memory.filled = (at.memory.filled + 1).min(at.p.window);
    at.memory.taken = at.memory.taken.wrapping_add(1);
    at.d.samples = at.memory.taken.wrapping_add(at.u.offset);
    at.d.history[..window].rotate_right(1);
    at.d.history[0] = at.u.signal + at.p.dither * at.memory.noise();
    let (mut sum, mut total) = (0.0, 0.0);
    for (value, weight) in at.d.history.iter().zip(at.p.weight).take(at.memory.filled as usize) {
        let weight = if at.p.weighting == Weighting::Uniform { 1.0 } else { weight };
        sum += weight * value;
        total += weight;
    }
    at.d.mean = if total > 0.0 { (sum / total).clamp(f64::MIN, f64::MAX) } else { 0.0 };
    let above = at.d.mean > at.p.threshold;
    if above && at.d.level == Level::Low {
        at.memory.alarm = Some(at.t + at.p.delay);
        at.fire(CROSSING);
    }
    at.d.level = if above { Level::High } else { Level::Low };
}

export_fmu!(SampledMean);
