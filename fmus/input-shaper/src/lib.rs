//! `InputShaper`: shapes the command of one axis so that the payload does not swing (thesis 1.2).

use serde::{Deserialize, Serialize};
use swayless_export::{Environment, Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_shaping::{Design, DesignError, Mode, ModeError, Shaper, Trains, design};

mod variables;

use variables::{Discrete, FrequencySource, Inputs, Kind, Parameters};

/// Room for impulses on their way: a ramp seen every 10 ms through a shaper of four impulses, 40 s long.
const PENDING: usize = 16_384;

/// The model.
struct InputShaper;

/// What the shaper remembers between events.
#[derive(Serialize, Deserialize)]
struct Memory {
    trains: Trains,
    shaper: Shaper,
    /// When sampling began (s), and how many samples have been taken.
    begin: f64,
    samples: f64,
}

/// Of no shaper at all, until the parameters are known.
impl Default for Memory {
    fn default() -> Self {
        Self { trains: Trains::new(0.0, 0), shaper: Shaper::unshaped(), begin: 0.0, samples: 0.0 }
    }
}

/// Copying into a memory uses its room again: it happens in every step that has an event.
impl Clone for Memory {
    fn clone(&self) -> Self {
        Self { trains: self.trains.clone(), shaper: self.shaper.clone(), ..*self }
    }

    fn clone_from(&mut self, source: &Self) {
        self.trains.clone_from(&source.trains);
        self.shaper.clone_from(&source.shaper);
        (self.begin, self.samples) = (source.begin, source.samples);
    }
}

/// Why there is no shaper for a mode.
enum Refusal {
    Mode(ModeError),
    Design(DesignError),
}

fn kind(kind: Kind) -> swayless_shaping::Kind {
    match kind {
        Kind::None => swayless_shaping::Kind::None,
        Kind::ZV => swayless_shaping::Kind::ZV,
        Kind::ZVD => swayless_shaping::Kind::ZVD,
        Kind::ZVDD => swayless_shaping::Kind::ZVDD,
        Kind::EI => swayless_shaping::Kind::EI,
        Kind::UMZV => swayless_shaping::Kind::UMZV,
    }
}

/// The shaper for the mode as it is at a suspension length.
fn shaper(p: &Parameters<f64>, length: f64) -> Result<Shaper, Refusal> {
    if p.kind == Kind::None {
        return Ok(Shaper::unshaped());
    }
    let frequency = match p.frequency_source {
        FrequencySource::Parameter => p.mode.frequency[0],
        FrequencySource::Length => (p.gravity / length).sqrt(),
    };
    let mode = Mode::new(frequency, p.mode.damping_ratio[0]).map_err(Refusal::Mode)?;
    design(kind(p.kind), mode, p.vibration_limit).map_err(Refusal::Design)
}

/// What is connected together.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "command",
        description: "The command to be shaped",
        kind: "command",
        members: &[("command", "command")],
    },
    Terminal {
        name: "hoist",
        description: "The hoisting axis, for a frequency that follows its position",
        kind: "axis",
        members: &[("hoist.length", "position")],
    },
    Terminal { name: "shaped", description: "The shaped command", kind: "command", members: &[("shaped", "command")] },
];

impl Model for InputShaper {
    const INFO: Info = Info {
        name: "InputShaper",
        description: "Input shaper for the command of one axis: None, ZV, ZVD, ZVDD, EI, UMZV",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Memory;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        let mut problems = Vec::new();
        for (name, values) in [("frequency", p.mode.frequency), ("damping_ratio", p.mode.damping_ratio)] {
            if values[1] != 0.0 {
                let message = format!("is {}; {:?} shapes one mode only, so it must be 0", values[1], p.kind);
                problems.push(Problem::new(format!("mode.{name}[2]"), message));
            }
        }
        // At 1 m for a frequency that follows the length: what it is then is not known before the run.
        match shaper(p, 1.0) {
            Ok(_) => {}
            Err(Refusal::Mode(error)) => {
                problems.push(Problem::new("mode.frequency[1]", format!("cannot be used: {error}")))
            }
            Err(Refusal::Design(error)) => {
                problems.push(Problem::new("mode.damping_ratio[1]", format!("cannot be used: {error}")))
            }
        }
        problems
    }

    fn memory(p: &Parameters<f64>, _: &Environment<'_>) -> Result<Memory, Problem> {
        Ok(Memory { trains: Trains::new(p.command_start, PENDING), ..Memory::default() })
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let (p, u, d, memory) = (at.p, at.u, &mut *at.d, &mut *at.memory);
        if at.initial {
            memory.begin = at.t;
        }
        let sample = memory.begin + memory.samples * p.sample_time;
        let looking = p.sample_time == 0.0 || sample <= at.t;
        d.shaped = memory.trains.advance(at.t);
        if looking && (at.initial || u.command != memory.trains.command()) {
            match shaper(p, u.hoist.length) {
                Ok(shaper) => {
                    memory.shaper = shaper;
                    d.valid = true;
                }
                Err(_) => d.valid = false,
            }
            show(&memory.shaper, d);
            d.shaped = if p.enabled {
                memory.trains.set_command(at.t, u.command, &memory.shaper.clone().into())
            } else {
                memory.trains.set_command(at.t, u.command, &Design::unshaped())
            };
        }
        if p.sample_time == 0.0 {
            return memory.trains.next_time();
        }
        if looking {
            memory.samples = ((at.t - memory.begin) / p.sample_time).floor().max(memory.samples) + 1.0;
        }
        let sample = memory.begin + memory.samples * p.sample_time;
        Some(memory.trains.next_time().map_or(sample, |impulse| impulse.min(sample)))
    }
}

/// Shows the design in the outputs.
fn show(shaper: &Shaper, d: &mut Discrete<f64>) {
    d.duration = shaper.duration();
    d.impulse.amplitude.fill(0.0);
    d.impulse.time.fill(0.0);
    d.impulse.count = 0;
    for (i, impulse) in shaper.impulses().iter().enumerate() {
        d.impulse.amplitude[i] = impulse.amplitude;
        d.impulse.time[i] = impulse.time;
        d.impulse.count += 1;
    }
}

export_fmu!(InputShaper);
