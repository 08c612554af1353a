//! `PositionController`: anti-sway and positioning of one axis (thesis 6.2.3, fig. 6.9).

use swayless_control::{
    Crane, Drive, Feedback, Form, Goal, Limits, Measured, Pendulum, PositionControl, Settings, Shown, Uncertainty,
};
use swayless_export::{Clock, Environment, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};

mod variables;

use variables::{Discrete, Inputs, Mode, Parameters};

/// The model.
struct PositionController;

/// No crane is farther away (m).
const FARTHEST: f64 = 1e6;
/// Between these a hoist is taken as long as it says (m).
const SHORTEST: f64 = 0.1;
const LONGEST: f64 = 1e4;
const SAMPLE: usize = 0;

/// No controller samples faster (s).
const FASTEST: f64 = 1e-5;

fn settings(p: &Parameters<f64>, u: &Inputs<f64>) -> Settings {
    let pendulum = Pendulum {
        gravity: p.gravity,
        hoist: u.hoist.length.clamp(SHORTEST, LONGEST),
        rigging: p.rigging.length,
        mass_ratio: p.mass_ratio,
    };
    Settings {
        crane: Crane {
            pendulum,
            drive: Drive { natural_frequency: p.drive.natural_frequency, damping_ratio: p.drive.damping_ratio },
        },
        form: match p.form {
            variables::Form::Planned => Form::Planned,
            variables::Form::InLoop => Form::InLoop,
            variables::Form::PlainLoop => Form::PlainLoop,
        },
        limits: Limits { velocity: p.velocity_limit, acceleration: p.acceleration_limit },
        feedback: Feedback { position_gain: p.position_gain, sway_gain: p.sway_gain, lead_time: p.lead_time },
        correction_limit: p.correction_limit,
        uncertainty: Uncertainty {
            noise: p.hook.noise,
            disturbance: p.observer.disturbance,
            wander: 1e-3,
            start: 0.05,
            offset: 0.02,
        },
        hook_latency: p.hook.latency,
        position_latency: p.position.latency,
        position_filter: p.position.filter_time,
        fade_time: p.fade_time,
        position_tolerance: p.position_tolerance,
        swing_tolerance: p.swing_tolerance,
    }
}

/// What to do, if that can be done.
fn goal(p: &Parameters<f64>, u: &Inputs<f64>) -> Option<Goal> {
    if !u.enabled {
        return Some(Goal::Off);
    }
    let target = match u.target.index {
        0 => Some(u.target.position),
        index => usize::try_from(index).ok().and_then(|index| p.stored_target.get(index - 1)).copied(),
    };
    match u.mode {
        Mode::Manual => Some(Goal::Velocity(u.manual.velocity)),
        Mode::GoTo => target.filter(|target| target.abs() <= FARTHEST).map(Goal::Position),
        Mode::Hold => Some(Goal::Hold),
    }
}

fn measured(u: &Inputs<f64>, settings: &Settings) -> Measured {
    let Pendulum { hoist, .. } = settings.crane.pendulum;
    Measured {
        hook: Some(u.hook.displacement).filter(|hook| u.hook.valid && hook.abs() <= hoist),
        position: Some(u.crane.position).filter(|position| u.position.valid && position.abs() <= FARTHEST),
    }
}

fn show(shown: Shown, d: &mut Discrete<f64>) {
    d.velocity = shown.velocity;
    d.at_target = shown.at_target;
    d.settled = shown.settled;
    d.position_error = shown.position_error;
    d.correction = shown.correction;
    d.planned.position = shown.planned.motion.position;
    d.planned.displacement = shown.planned.hook()[0];
    d.estimated.position = shown.estimated.motion.position;
    d.estimated.displacement = shown.estimated.hook()[0];
}

/// What is connected together.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "manual",
        description: "Velocity that the operator wants",
        kind: "command",
        members: &[("manual.velocity", "command")],
    },
    Terminal {
        name: "swing",
        description: "Swing of the hook as a camera measures it, on a radial axis",
        kind: "swing",
        members: &[("hook.displacement", "displacement.radial"), ("hook.valid", "valid")],
    },
    Terminal { name: "hoist", description: "Hoisting axis", kind: "axis", members: &[("hoist.length", "position")] },
    Terminal {
        name: "axis",
        description: "The axis as its position is measured",
        kind: "axis",
        members: &[("crane.position", "position"), ("position.valid", "valid")],
    },
    Terminal {
        name: "command",
        description: "Commanded velocity",
        kind: "command",
        members: &[("velocity", "command")],
    },
];

impl Model for PositionController {
    const INFO: Info = Info {
        name: "PositionController",
        description: "Anti-sway and positioning controller of one axis",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.02,
    };
    const CLOCKS: &'static [Clock] = &[Clock::new("sample", "Computes a command", Interval::OfFixedParameters)];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = PositionControl;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        let too_fast = p.sample_time > 0.0 && p.sample_time < FASTEST;
        let message = || format!("is {} s; it must be 0 or at least {FASTEST} s", p.sample_time);
        too_fast.then(|| Problem::new("sample_time", message())).into_iter().collect()
    }

    fn memory(_: &Parameters<f64>, _: &Environment<'_>) -> Result<PositionControl, Problem> {
        Ok(PositionControl::new())
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.sample_time
    }

    fn tick(_: usize, at: &mut Event<'_, Self>) {
        let (p, u) = (at.p, at.u);
        let (settings, goal) = (settings(p, u), goal(p, u));
        let measured = measured(u, &settings);
        let shown = at.memory.step(at.t, at.intervals[SAMPLE], &settings, goal.unwrap_or(Goal::Hold), measured);
        let length_is_possible = (SHORTEST..=LONGEST).contains(&u.hoist.length);
        let seen_is_possible =
            u.hook.valid == measured.hook.is_some() && u.position.valid == measured.position.is_some();
        at.d.valid = goal.is_some() && length_is_possible && seen_is_possible && shown.is_stable;
        show(shown, at.d);
    }
}

export_fmu!(PositionController);
