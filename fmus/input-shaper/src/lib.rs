//! `InputShaper`: shapes the command of one axis so that the payload does not swing (thesis 1.2).

use swayless_export::{Environment, Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_shaping::{Design, MAX_IMPULSES, Shaper};

mod memory;
mod variables;
mod wanted;

use memory::{Memory, cut};
use variables::{Discrete, Inputs, Parameters};

/// The model.
struct InputShaper;

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
        description: "Input shaper for the command of one axis",
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
        wanted::check(p)
    }

    fn memory(p: &Parameters<f64>, _: &Environment<'_>) -> Result<Memory, Problem> {
        Ok(Memory::new(p))
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    // No clock: with the interval of 0 that is declared an importer that ticks the clocks itself would refuse it.
    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let (p, u, d, memory) = (at.p, at.u, &mut *at.d, &mut *at.memory);
        if at.initial {
            memory.begin = at.t;
            show(&memory.design, d);
        }
        let sample = memory.begin + memory.samples * p.sample_time;
        let looking = p.sample_time == 0.0 || sample <= at.t;
        d.shaped = memory.trains.advance(at.t);
        let command = cut(u.command);
        if looking && (at.initial || command != memory.trains.command()) {
            (d.shaped, d.valid) = memory.set_command((at.t, command), p, u.hoist.length, |design| show(design, d));
        }
        d.interference = memory.trains.interfere(at.t);
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
fn show(design: &Design, d: &mut Discrete<f64>) {
    d.duration = design.duration();
    let impulses = design.shaper().impulses();
    for i in 0..MAX_IMPULSES {
        let shown = impulses.get(i).copied().unwrap_or_default();
        (d.impulse.amplitude[i], d.impulse.time[i]) = (shown.amplitude, shown.time);
    }
    d.impulse.count = impulses.len() as i32;
    let braking = design.braking().map_or(&[][..], Shaper::impulses);
    for (time, impulse) in d.braking.impulse.time.iter_mut().zip(braking) {
        *time = impulse.time;
    }
}

export_fmu!(InputShaper);
