//! `CraneSupervisor`: what the PLC of a crane does (thesis 4.1.2).

use swayless_export::{Clock, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_sensing::Timing;
use swayless_supervision::{AXES, Fault, Limits, Observation, Settings, Supervisor, Times, Tolerances};

mod variables;

use variables::{Discrete, FaultCode, Inputs, Parameters, State};

/// The model.
struct CraneSupervisor;

/// What is connected together.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "axes",
        description: "The axes of the crane and their drives",
        kind: "axes",
        members: &[("command", "command"), ("velocity", "rate"), ("position", "position"), ("position.valid", "valid")],
    },
    Terminal {
        name: "swing",
        description: "Swing of the hook",
        kind: "swing",
        members: &[("swing.amplitude", "amplitude"), ("hook.valid", "valid")],
    },
];

fn settings(p: &Parameters<f64>) -> Settings {
    Settings {
        axes: std::array::from_fn(|axis| Limits {
            position_min: p.position_min[axis],
            position_max: p.position_max[axis],
            velocity: p.velocity_limit[axis],
            deceleration: p.deceleration[axis],
        }),
        slow_zone: p.slow_zone,
        slow_share: p.slow_share,
        reaction: p.reaction_time,
        swing_limit: p.swing_limit,
        within: Tolerances { fault_time: p.fault_time, jump_time: p.jump_time, frozen_time: p.frozen_time },
        record_time: p.record_time,
    }
}

fn observation(u: &Inputs<f64>) -> Observation {
    Observation {
        command: u.command,
        position: u.position,
        position_valid: u.position_valid,
        hook_valid: u.hook.valid,
        swing: u.swing.amplitude,
        emergency_stop: u.emergency_stop,
        reset: u.reset,
    }
}

fn state(state: swayless_supervision::State) -> State {
    match state {
        swayless_supervision::State::Ready => State::Ready,
        swayless_supervision::State::Limited => State::Limited,
        swayless_supervision::State::Stopped => State::Stopped,
        swayless_supervision::State::Fault => State::Fault,
    }
}

fn code(fault: Fault) -> FaultCode {
    match fault {
        Fault::None => FaultCode::None,
        Fault::Input => FaultCode::Input,
        Fault::PositionInvalid => FaultCode::PositionInvalid,
        Fault::PositionImplausible => FaultCode::PositionImplausible,
        Fault::PositionFrozen => FaultCode::PositionFrozen,
        Fault::HookInvalid => FaultCode::HookInvalid,
    }
}

/// Shows what has been decided.
fn show(supervisor: &Supervisor, d: &mut Discrete<f64>) {
    let finding = supervisor.finding();
    d.velocity = supervisor.velocities();
    d.state = state(supervisor.state());
    (d.fault.code, d.fault.axis) = (code(finding.fault), finding.axis.into());
    (d.record, d.event.count) = (supervisor.records(), supervisor.events());
}

impl Model for CraneSupervisor {
    const INFO: Info = Info {
        name: "CraneSupervisor",
        description: "Supervisor of a crane: limits of the axes, emergency stop, interlocks and sensor faults",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.02,
    };
    const CLOCKS: &'static [Clock] =
        &[Clock::new("sample", "Looks at the crane and says what its axes may do", Interval::OfFixedParameters)];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Supervisor;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        let ends = (0..AXES).filter(|axis| p.position_min[*axis] > p.position_max[*axis]).map(|axis| {
            let (min, max) = (p.position_min[axis], p.position_max[axis]);
            let message = format!("is {max}; it must be at least position_min[{}] of {min}", axis + 1);
            Problem::new(format!("position_max[{}]", axis + 1), message)
        });
        let timing = Timing { sample_time: p.sample_time, latency: 0.0 }.check();
        let timing = timing.err().map(|error| Problem::new(error.quantity(), error.to_string()));
        ends.chain(timing).collect()
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.sample_time
    }

    fn tick(_: usize, at: &mut Event<'_, Self>) {
        let times = Times { now: at.t, interval: at.p.sample_time };
        at.memory.sample(times, &settings(at.p), &observation(at.u));
        show(at.memory, at.d);
    }
}

export_fmu!(CraneSupervisor);
