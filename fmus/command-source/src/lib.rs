//! `CommandSource`: an operator's command, from a formula or a recorded drive.

use swayless_export::{Environment, Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};

mod profile;
mod pulses;
mod table;
mod variables;

use profile::Segment;
use variables::{Discrete, Outputs, Parameters};

/// The model.
struct CommandSource;

/// What is connected together.
const TERMINALS: &[Terminal] =
    &[Terminal { name: "command", description: "The command", kind: "command", members: &[("command", "command")] }];

impl Model for CommandSource {
    const INFO: Info = Info {
        name: "CommandSource",
        description: "Source of an operator's command: constant, step, pulse, trapezoid, playback of a CSV file, partly shaped pulse or hoist pulses",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 10.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = ();
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    /// The whole command, piece by piece.
    type Memory = Vec<Segment>;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        profile::check(p)
    }

    fn memory(p: &Parameters<f64>, environment: &Environment<'_>) -> Result<Vec<Segment>, Problem> {
        profile::segments(p, environment)
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let segment = &at.d.segment;
        Outputs { command: segment.value + segment.slope * (at.t - segment.begin) }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let next = at.memory.partition_point(|segment| segment.begin <= at.t);
        // The first segment has always begun.
        let segment = *at.memory.get(next.checked_sub(1)?)?;
        at.d.segment.value = segment.value;
        at.d.segment.slope = segment.slope;
        // The first segment begins long ago and is level, so that any finite begin does.
        at.d.segment.begin = if segment.begin.is_finite() { segment.begin } else { 0.0 };
        at.memory.get(next).map(|segment| segment.begin)
    }
}

export_fmu!(CommandSource);
