//! `BoomCrane`: a mobile boom crane with a suspended payload, driven by rates (thesis 2.1).

use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, Variables, export_fmu};
use swayless_mechanics::{Boom, BoomRates, Limits, Payload, Suspension, Swing, SwingFrame, Vector};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// No joint and no base is faster (rad/s, m/s): beyond, inputs are cut, so that a step of any input ends in useful time.
const FASTEST: f64 = 100.0;
/// No wind accelerates a payload more (m/s²).
const STRONGEST: f64 = 1e6;

/// The model.
struct BoomCrane;

/// Whether all inputs are within what is not cut.
fn is_physical(p: &Parameters<f64>, u: &Inputs<f64>) -> bool {
    let rates = [u.base.velocity.x, u.base.velocity.y, u.base.yaw_rate, u.slew.rate, u.luff.rate, u.hoist.rate];
    let wind = [u.wind.x, u.wind.y, u.wind.z];
    rates.iter().all(|rate| rate.abs() <= FASTEST) && wind.iter().all(|force| force.abs() <= STRONGEST * p.payload.mass)
}

/// What the equations share at one point in time.
struct Motion<R: Scalar> {
    boom: Boom<R>,
    rates: BoomRates<R>,
    frame: SwingFrame<R>,
    payload: Payload<R>,
    suspension: Suspension<R>,
}

fn motion<R: Scalar>(at: &Point<'_, BoomCrane, R>) -> Motion<R> {
    let Point { p, u, x, d, .. } = *at;
    let boom = Boom {
        base: [x.base.x, x.base.y],
        yaw: x.base.yaw,
        slew: x.slew.angle,
        luff: x.luff.angle,
        length: p.boom.length,
        offset: p.boom.offset,
        height: p.boom.height,
    };
    let cut = |rate: R| rate.clamp(-FASTEST, FASTEST);
    let rates = BoomRates {
        base: [cut(u.base.velocity.x), cut(u.base.velocity.y)],
        yaw: cut(u.base.yaw_rate),
        slew: cut(u.slew.rate),
        luff: R::select(d.luff.stopped, R::zero(), cut(u.luff.rate)),
    };
    let frame = boom.swing_frame(&rates);
    let payload =
        Payload { direction: Vector::from(x.cable.direction), velocity: Vector::from(x.payload.velocity_across) };
    let length_rate = R::select(d.hoist.stopped, R::zero(), cut(u.hoist.rate));
    let suspension = Suspension { pivot: boom.tip_velocity(&frame, &rates), length: x.hoist.length, length_rate };
    Motion { boom, rates, frame, payload, suspension }
}

fn luff_limits(p: &Parameters<f64>) -> Limits {
    Limits { min: p.luff.angle_min, max: p.luff.angle_max }
}

fn hoist_limits(p: &Parameters<f64>) -> Limits {
    Limits { min: p.hoist.length_min, max: p.hoist.length_max }
}

/// What is connected together; a drive's axis has the same member names.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "slew",
        description: "Slewing axis",
        kind: "axis",
        members: &[("slew.rate", "rate"), ("slew.angle", "position")],
    },
    Terminal {
        name: "luff",
        description: "Luffing axis",
        kind: "axis",
        members: &[("luff.rate", "rate"), ("luff.angle", "position")],
    },
    Terminal {
        name: "hoist",
        description: "Hoisting axis; it lengthens the suspension",
        kind: "axis",
        members: &[("hoist.rate", "rate"), ("hoist.length", "position")],
    },
    Terminal {
        name: "base",
        description: "Motion of the base on the ground",
        kind: "base",
        members: &[
            ("base.velocity.x", "velocity.x"),
            ("base.velocity.y", "velocity.y"),
            ("base.yaw_rate", "yaw_rate"),
            ("base.x", "x"),
            ("base.y", "y"),
            ("base.yaw", "yaw"),
        ],
    },
    Terminal {
        name: "wind",
        description: "Force on the payload",
        kind: "force",
        members: &[("wind.x", "x"), ("wind.y", "y"), ("wind.z", "z")],
    },
    Terminal {
        name: "tip",
        description: "Position of the boom tip",
        kind: "position",
        members: &[("tip.x", "x"), ("tip.y", "y"), ("tip.z", "z")],
    },
    Terminal {
        name: "payload",
        description: "Position of the payload",
        kind: "position",
        members: &[("payload.x", "x"), ("payload.y", "y"), ("payload.z", "z")],
    },
    Terminal {
        name: "swing",
        description: "Swing of the payload",
        kind: "swing",
        members: &[
            ("swing.radial", "radial"),
            ("swing.tangential", "tangential"),
            ("swing.radial_rate", "radial_rate"),
            ("swing.tangential_rate", "tangential_rate"),
            ("swing.amplitude", "amplitude"),
        ],
    },
];

impl Model for BoomCrane {
    const INFO: Info = Info {
        name: "BoomCrane",
        description: "Mobile boom crane with a suspended payload, driven by rates",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete;
    type Memory = ();
    type Indicators = [f64; 4];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let luff = luff_limits(p).check(declared.luff.angle).map(|why| Problem::new("luff.angle", why));
        let hoist = hoist_limits(p).check(declared.hoist.length).map(|why| Problem::new("hoist.length", why));
        luff.into_iter().chain(hoist).collect()
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        let mut x = declared.clone();
        let frame = SwingFrame::new(x.base.yaw + x.slew.angle, R::zero());
        let angles = Swing { radial: p.swing.radial_start, tangential: p.swing.tangential_start };
        let rates = Swing { radial: p.swing.radial_rate_start, tangential: p.swing.tangential_rate_start };
        let payload = Payload::started(frame.direction(angles), frame.direction_rate(angles, rates), x.hoist.length);
        x.cable.direction = payload.direction.into();
        x.payload.velocity_across = payload.velocity.into();
        x
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let Motion { rates, payload, suspension, .. } = motion(at);
        let wind = |force: R| (force / at.p.payload.mass).clamp(-STRONGEST, STRONGEST);
        let wind = Vector::new(wind(at.u.wind.x), wind(at.u.wind.y), wind(at.u.wind.z));
        let pull = wind - Vector::new(R::zero(), R::zero(), at.p.gravity);
        let payload = payload.rates(&suspension, pull, at.p.swing.damping);
        let mut dx = at.x.clone();
        [dx.base.x, dx.base.y] = rates.base;
        dx.base.yaw = rates.yaw;
        dx.slew.angle = rates.slew;
        dx.luff.angle = rates.luff;
        dx.hoist.length = suspension.length_rate;
        dx.cable.direction = payload.direction.into();
        dx.payload.velocity_across = payload.velocity.into();
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let Motion { boom, frame, payload, suspension, .. } = motion(at);
        let n = payload.unit();
        let swing = frame.angles(n);
        let rates = frame.rates(n, payload.direction_rate(&suspension));
        let tip = boom.tip(&frame);
        let position = tip + n * suspension.length;
        let mut y = Outputs::start();
        (y.swing.radial, y.swing.tangential) = (swing.radial, swing.tangential);
        (y.swing.radial_rate, y.swing.tangential_rate) = (rates.radial, rates.tangential);
        y.swing.amplitude = payload.amplitude(&suspension, at.p.gravity);
        (y.tip.x, y.tip.y, y.tip.z) = (tip.x, tip.y, tip.z);
        (y.payload.x, y.payload.y, y.payload.z) = (position.x, position.y, position.z);
        y
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 4] {
        let [lowest, highest] = luff_limits(at.p).indicators(at.x.luff.angle, at.u.luff.rate);
        let [shortest, longest] = hoist_limits(at.p).indicators(at.x.hoist.length, at.u.hoist.rate);
        [lowest, highest, shortest, longest]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.luff.stopped = luff_limits(at.p).hold(&mut at.x.luff.angle, at.u.luff.rate);
        at.d.hoist.stopped = hoist_limits(at.p).hold(&mut at.x.hoist.length, at.u.hoist.rate);
        at.d.at_limit = at.d.luff.stopped || at.d.hoist.stopped || !is_physical(at.p, at.u);
        None
    }
}

export_fmu!(BoomCrane);
