//! `SwayDamper`: feedback of swing to a commanded velocity (thesis 3.3, fig. 3.5).

use swayless_control::{Damping, SwayDamping};
use swayless_export::{Clock, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};

mod variables;

use variables::{Discrete, Inputs, Parameters};

/// The model.
struct SwayDamper;

const SAMPLE: usize = 0;

/// No controller samples faster (s).
const FASTEST: f64 = 1e-5;
/// A swing is a horizontal direction: nothing swings wider (rad), and nothing is asked to be faster (m/s).
const WIDEST: f64 = std::f64::consts::PI;
const GREATEST: f64 = 1e6;
/// Nothing is turned farther (rad).
const MOST_TURNS: f64 = 1e9;

/// The measured swing in the world's axes (rad).
fn swing(u: &Inputs<f64>) -> Option<[f64; 2]> {
    let (sin, cos) =
        [u.slew.angle, u.base.yaw].map(|angle| angle.clamp(-MOST_TURNS, MOST_TURNS)).iter().sum::<f64>().sin_cos();
    let [radial, tangential] = [u.swing.radial, u.swing.tangential].map(|angle| angle.clamp(-WIDEST, WIDEST));
    u.valid.then_some([cos * radial - sin * tangential, sin * radial + cos * tangential])
}

/// A velocity in one direction of the world.
const fn along(
    name: &'static str,
    description: &'static str,
    member: &'static [(&'static str, &'static str)],
) -> Terminal {
    Terminal { name, description, kind: "command", members: member }
}

/// What is connected together.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "swing",
        description: "Swing of the payload as it is measured",
        kind: "swing",
        members: &[("swing.radial", "radial"), ("swing.tangential", "tangential"), ("valid", "valid")],
    },
    Terminal {
        name: "slew",
        description: "Slewing axis, with which the swing's directions turn",
        kind: "axis",
        members: &[("slew.angle", "position")],
    },
    Terminal {
        name: "base",
        description: "Base, with which the swing's directions turn",
        kind: "base",
        members: &[("base.yaw", "yaw")],
    },
    along("command_x", "Commanded velocity in world x", &[("command.x", "command")]),
    along("command_y", "Commanded velocity in world y", &[("command.y", "command")]),
    along("velocity_x", "Velocity in world x that damps the swing", &[("velocity.x", "command")]),
    along("velocity_y", "Velocity in world y that damps the swing", &[("velocity.y", "command")]),
];

impl Model for SwayDamper {
    const INFO: Info = Info {
        name: "SwayDamper",
        description: "Feedback of swing to a commanded velocity",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    const CLOCKS: &'static [Clock] = &[Clock::new("sample", "Computes a velocity", Interval::OfFixedParameters)];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = SwayDamping;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        let too_fast = p.sample_time > 0.0 && p.sample_time < FASTEST;
        let message = || format!("is {} s; it must be 0 or at least {FASTEST} s", p.sample_time);
        too_fast.then(|| Problem::new("sample_time", message())).into_iter().collect()
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.sample_time
    }

    fn tick(_: usize, at: &mut Event<'_, Self>) {
        let (p, u, d) = (at.p, at.u, &mut *at.d);
        let damping = Damping {
            gain: p.gain,
            lead_time: p.lead_time,
            filter_time: p.filter_time,
            correction_limit: p.correction_limit,
            fade_time: p.fade_time,
        };
        let [x, y] = at.memory.step(at.t, at.intervals[SAMPLE], &damping, swing(u));
        d.velocity.x = u.command.x.clamp(-GREATEST, GREATEST) + x;
        d.velocity.y = u.command.y.clamp(-GREATEST, GREATEST) + y;
    }
}

export_fmu!(SwayDamper);
