//! `LuffRigging`: the ropes that luff a boom and hoist its payload (thesis 2.3), as kinematic and as inertia filter.

use swayless_crane::{STRONGEST, are_physical, cut, cut_acceleration, terminals};
use swayless_export::{Event, Info, Model, Point, Scalar, Terminal, Variables, export_fmu};
use swayless_mechanics::{Hanging, LuffLoad, Luffing, Motion, Rigging};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, Reaction};

/// No suspension is longer (m).
const LONGEST: f64 = 1e4;

/// The model.
struct LuffRigging;

fn rigging<R: Scalar>(p: &Parameters<R>) -> Rigging<R> {
    Rigging { boom: p.boom.length, jib: p.jib.length, sheave: p.hoist_sheave.distance, jib_angle: p.jib.angle }
}

fn load<R: Scalar>(p: &Parameters<R>) -> LuffLoad<R> {
    LuffLoad {
        length: p.boom.length,
        inertia: p.boom.inertia,
        moment: p.boom.mass * p.boom.center,
        payload: p.payload.mass,
        gravity: p.gravity,
        without_reaction: p.reaction == Reaction::Thesis,
    }
}

fn line<R: Scalar>(speed: R, acceleration: R) -> Motion<R> {
    Motion { rate: cut(speed), acceleration: cut_acceleration(acceleration) }
}

/// Whether all inputs are within what is not cut, but for the luff angle.
fn is_physical(u: &Inputs<f64>) -> bool {
    let accelerations = [u.luff.line_acceleration, u.hoist.line_acceleration];
    are_physical(&[u.luff.line_speed, u.hoist.line_speed, u.swing.radial_rate])
        && accelerations.iter().all(|acceleration| acceleration.abs() <= STRONGEST)
        && (0.0..=LONGEST).contains(&u.hoist.length)
        && u.swing.radial.abs() <= std::f64::consts::PI
}

/// What is connected together: a drive's axis with each line, and the axes of the crane with what the lines make of it.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "luff_line",
        description: "The luff line and its drive",
        kind: "axis",
        members: &[("luff.line_speed", "rate"), ("luff.line_acceleration", "acceleration")],
    },
    Terminal {
        name: "luff_load",
        description: "What the luff line's drive has to move",
        kind: "load",
        members: &[("luff.line_force_static", "force"), ("luff.line_mass", "mass")],
    },
    Terminal {
        name: "hoist_line",
        description: "The hoist line and its drive",
        kind: "axis",
        members: &[("hoist.line_speed", "rate"), ("hoist.line_acceleration", "acceleration")],
    },
    Terminal {
        members: &[("luff.rate", "rate"), ("luff.acceleration", "acceleration"), ("luff.angle", "position")],
        ..terminals::LUFF
    },
    Terminal {
        members: &[("hoist.rate", "rate"), ("hoist.acceleration", "acceleration"), ("hoist.length", "position")],
        ..terminals::HOIST
    },
    Terminal { members: &[("swing.radial", "radial"), ("swing.radial_rate", "radial_rate")], ..terminals::SWING },
];

impl Model for LuffRigging {
    const INFO: Info = Info {
        name: "LuffRigging",
        description: "Luffing and hoisting ropes of a boom crane: from rope speeds to joint rates, and the forces they take",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 10.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete;
    type Memory = ();
    type Indicators = [f64; 2];

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let Point { p, u, .. } = *at;
        let (load, ropes) = (load(p), rigging(p).at(u.luff.angle));
        let Luffing { luff_line, hoist_line, .. } = ropes;
        let boom = ropes.boom(line(u.luff.line_speed, u.luff.line_acceleration));
        let suspension = ropes.suspension(boom, line(u.hoist.line_speed, u.hoist.line_acceleration));
        let hanging = Hanging {
            swing: u.swing.radial.clamp(-std::f64::consts::PI, std::f64::consts::PI),
            swing_rate: cut(u.swing.radial_rate),
            length: u.hoist.length.clamp(0.0, LONGEST),
        };
        let tension = load.tension(&ropes, hanging, boom, suspension.acceleration);
        let mut y = Outputs::start();
        (y.luff.rate, y.luff.acceleration) = (boom.rate, boom.acceleration);
        (y.hoist.rate, y.hoist.acceleration) = (suspension.rate, suspension.acceleration);
        (y.luff.line_length, y.hoist.line_length) = (luff_line.length, hoist_line.length);
        y.luff.line_force = load.line_force(&ropes, hanging.swing, tension, boom.acceleration);
        y.luff.line_force_static = load.static_force(&ropes, hanging);
        y.luff.line_mass = load.line_mass(&ropes, hanging.swing);
        y.hoist.line_force = tension;
        y
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 2] {
        rigging(at.p).from_dead_angles(at.u.luff.angle)
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.singular = rigging(at.p).from_dead_angles(at.u.luff.angle).iter().any(|way| *way <= 0.0);
        at.d.at_limit = !is_physical(at.u);
        None
    }
}

export_fmu!(LuffRigging);
