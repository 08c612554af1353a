//! `BoomCrane`: a mobile boom crane with a suspended payload, driven by rates (thesis 2.1).

use swayless_crane::{SwingOutputs, are_physical, cut, cut_acceleration, suspended, terminals};
use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{Boom, BoomAccelerations, BoomRates, Payload, Suspension, SwingFrame, Vector};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// The model.
struct BoomCrane;

/// Whether all inputs are within what is not cut.
fn is_physical(p: &Parameters<f64>, u: &Inputs<f64>) -> bool {
    let base = &u.base;
    let rates = [base.velocity.x, base.velocity.y, base.yaw_rate, u.slew.rate, u.luff.rate, u.hoist.rate, u.boom.rate];
    are_physical(&rates) && u.wind.is_physical(p.payload.mass)
}

/// What the equations share at one point in time.
struct Motion<R: Scalar> {
    boom: Boom<R>,
    rates: BoomRates<R>,
    frame: SwingFrame<R>,
    payload: Payload<R>,
    suspension: Suspension<R>,
    pull: Vector<R>,
}

fn motion<R: Scalar>(at: &Point<'_, BoomCrane, R>) -> Motion<R> {
    let Point { p, u, x, d, .. } = *at;
    let boom = Boom {
        base: [x.base.x, x.base.y],
        yaw: x.base.yaw,
        slew: x.slew.angle,
        luff: x.luff.angle,
        length: p.boom.length + x.boom.extension,
        offset: p.boom.offset,
        height: p.boom.height,
    };
    let rates = BoomRates {
        base: [cut(u.base.velocity.x), cut(u.base.velocity.y)],
        yaw: cut(u.base.yaw_rate),
        slew: cut(u.slew.rate),
        luff: R::select(d.luff.stopped, R::zero(), cut(u.luff.rate)),
        length: R::select(d.boom.stopped, R::zero(), cut(u.boom.rate)),
    };
    let frame = boom.swing_frame(&rates);
    let length_rate = R::select(d.hoist.stopped, R::zero(), cut(u.hoist.rate));
    let suspension = Suspension { pivot: boom.tip_velocity(&frame, &rates), length: x.hoist.length, length_rate };
    let pull = u.wind.pull(p.payload.mass, p.gravity);
    Motion { boom, rates, frame, payload: suspended(&x.cable, &x.payload), suspension, pull }
}

/// The cable's tension per mass of the payload (m/s²).
fn tension<R: Scalar>(at: &Point<'_, BoomCrane, R>, motion: &Motion<R>) -> R {
    let Point { u, d, .. } = *at;
    let accelerations = BoomAccelerations {
        base: [cut_acceleration(u.base.acceleration.x), cut_acceleration(u.base.acceleration.y)],
        yaw: cut_acceleration(u.base.yaw_acceleration),
        slew: cut_acceleration(u.slew.acceleration),
        luff: R::select(d.luff.stopped, R::zero(), cut_acceleration(u.luff.acceleration)),
        length: R::select(d.boom.stopped, R::zero(), cut_acceleration(u.boom.acceleration)),
    };
    let hoist = R::select(d.hoist.stopped, R::zero(), cut_acceleration(u.hoist.acceleration));
    let tip = motion.boom.tip_acceleration(&motion.frame, &motion.rates, &accelerations);
    motion.payload.tension(&motion.suspension, motion.pull, tip, hoist)
}

/// What is connected together; a drive's axis has the same member names.
const TERMINALS: &[Terminal] = &[
    Terminal {
        members: &[("slew.rate", "rate"), ("slew.acceleration", "acceleration"), ("slew.angle", "position")],
        ..terminals::SLEW
    },
    Terminal {
        members: &[("luff.rate", "rate"), ("luff.acceleration", "acceleration"), ("luff.angle", "position")],
        ..terminals::LUFF
    },
    Terminal {
        members: &[("hoist.rate", "rate"), ("hoist.acceleration", "acceleration"), ("hoist.length", "position")],
        ..terminals::HOIST
    },
    Terminal {
        name: "boom",
        description: "Telescoping axis",
        kind: "axis",
        members: &[("boom.rate", "rate"), ("boom.acceleration", "acceleration"), ("boom.extension", "position")],
    },
    Terminal {
        name: "base",
        description: "Motion of the base on the ground",
        kind: "base",
        members: &[
            ("base.velocity.x", "velocity.x"),
            ("base.velocity.y", "velocity.y"),
            ("base.yaw_rate", "yaw_rate"),
            ("base.acceleration.x", "acceleration.x"),
            ("base.acceleration.y", "acceleration.y"),
            ("base.yaw_acceleration", "yaw_acceleration"),
            ("base.x", "x"),
            ("base.y", "y"),
            ("base.yaw", "yaw"),
        ],
    },
    terminals::WIND,
    terminals::TIP,
    terminals::PAYLOAD,
    terminals::SWING,
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
    type Indicators = [f64; 7];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let joints = [
            ("luff.angle", p.luff.limits(), declared.luff.angle),
            ("hoist.length", p.hoist.limits(), declared.hoist.length),
            ("boom.extension", p.boom.limits(), declared.boom.extension),
        ];
        joints.into_iter().filter_map(|(name, limits, start)| Some(Problem::new(name, limits.check(start)?))).collect()
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        let payload = p.swing.started(declared.base.yaw + declared.slew.angle, declared.hoist.length);
        States { cable: payload.into(), payload: payload.into(), ..declared.clone() }
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let Motion { rates, payload, suspension, pull, .. } = motion(at);
        let payload = payload.rates(&suspension, pull, at.p.swing.damping);
        let mut dx = at.x.clone();
        [dx.base.x, dx.base.y] = rates.base;
        dx.base.yaw = rates.yaw;
        dx.slew.angle = rates.slew;
        dx.luff.angle = rates.luff;
        dx.hoist.length = suspension.length_rate;
        dx.boom.extension = rates.length;
        States { cable: payload.into(), payload: payload.into(), ..dx }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let motion = motion(at);
        let tip = motion.boom.tip(&motion.frame);
        Outputs {
            swing: SwingOutputs::of(&motion.payload, &motion.suspension, &motion.frame, at.p.gravity),
            tip: tip.into(),
            payload: (tip + motion.payload.unit() * motion.suspension.length).into(),
            tension: tension(at, &motion) * at.p.payload.mass,
        }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 7] {
        let [lowest, highest] = at.p.luff.limits().indicators(at.x.luff.angle, at.u.luff.rate);
        let [shortest, longest] = at.p.hoist.limits().indicators(at.x.hoist.length, at.u.hoist.rate);
        let [retracted, extended] = at.p.boom.limits().indicators(at.x.boom.extension, at.u.boom.rate);
        [lowest, highest, shortest, longest, retracted, extended, tension(at, &motion(at))]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.luff.stopped = at.p.luff.limits().hold(&mut at.x.luff.angle, at.u.luff.rate);
        at.d.hoist.stopped = at.p.hoist.limits().hold(&mut at.x.hoist.length, at.u.hoist.rate);
        at.d.boom.stopped = at.p.boom.limits().hold(&mut at.x.boom.extension, at.u.boom.rate);
        let stopped = at.d.luff.stopped || at.d.hoist.stopped || at.d.boom.stopped;
        at.d.at_limit = stopped || !is_physical(at.p, at.u);
        let here = at.point();
        // Not `< 0`: an event may be found where the tension is exactly 0.
        at.d.slack = tension(&here, &motion(&here)) <= 0.0;
        None
    }
}

export_fmu!(BoomCrane);
