//! `TowerCrane`: a tower crane with a suspended payload, driven by rates (thesis 3.5, fig. 3.6).

use swayless_crane::{SwingOutputs, are_physical, cut, suspended, terminals};
use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{Jib, JibRates, Payload, Suspension, SwingFrame};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// The model.
struct TowerCrane;

/// What the equations share at one point in time.
struct Motion<R: Scalar> {
    jib: Jib<R>,
    rates: JibRates<R>,
    frame: SwingFrame<R>,
    payload: Payload<R>,
    suspension: Suspension<R>,
}

fn motion<R: Scalar>(at: &Point<'_, TowerCrane, R>) -> Motion<R> {
    let Point { p, u, x, d, .. } = *at;
    let jib = Jib { height: p.jib.height, slew: x.slew.angle, radius: x.trolley.radius };
    let rates =
        JibRates { slew: cut(u.slew.rate), radius: R::select(d.trolley.stopped, R::zero(), cut(u.trolley.rate)) };
    let frame = jib.swing_frame(&rates);
    let length_rate = R::select(d.hoist.stopped, R::zero(), cut(u.hoist.rate));
    let suspension = Suspension { pivot: jib.trolley_velocity(&frame, &rates), length: x.hoist.length, length_rate };
    Motion { jib, rates, frame, payload: suspended(&x.cable, &x.payload), suspension }
}

/// What is connected together; a drive's axis has the same member names.
const TERMINALS: &[Terminal] = &[
    terminals::SLEW,
    Terminal {
        name: "trolley",
        description: "Trolley axis",
        kind: "axis",
        members: &[("trolley.rate", "rate"), ("trolley.radius", "position")],
    },
    terminals::HOIST,
    terminals::WIND,
    Terminal {
        name: "pivot",
        description: "Position of the trolley",
        kind: "position",
        members: &[("trolley.x", "x"), ("trolley.y", "y"), ("trolley.z", "z")],
    },
    terminals::PAYLOAD,
    terminals::SWING,
];

impl Model for TowerCrane {
    const INFO: Info = Info {
        name: "TowerCrane",
        description: "Tower crane with a suspended payload, driven by rates",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 30.0,
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
        let joints = [
            ("trolley.radius", p.trolley.limits(), declared.trolley.radius),
            ("hoist.length", p.hoist.limits(), declared.hoist.length),
        ];
        joints.into_iter().filter_map(|(name, limits, start)| Some(Problem::new(name, limits.check(start)?))).collect()
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        let payload = p.swing.started(declared.slew.angle, declared.hoist.length);
        States { cable: payload.into(), payload: payload.into(), ..declared.clone() }
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let Motion { rates, payload, suspension, .. } = motion(at);
        let pull = at.u.wind.pull(at.p.payload.mass, at.p.gravity);
        let payload = payload.rates(&suspension, pull, at.p.swing.damping);
        let mut dx = at.x.clone();
        dx.slew.angle = rates.slew;
        dx.trolley.radius = rates.radius;
        dx.hoist.length = suspension.length_rate;
        States { cable: payload.into(), payload: payload.into(), ..dx }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let Motion { jib, frame, payload, suspension, .. } = motion(at);
        let trolley = jib.trolley(&frame);
        Outputs {
            swing: SwingOutputs::of(&payload, &suspension, &frame, at.p.gravity),
            trolley: trolley.into(),
            payload: (trolley + payload.unit() * suspension.length).into(),
        }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 4] {
        let [innermost, outermost] = at.p.trolley.limits().indicators(at.x.trolley.radius, at.u.trolley.rate);
        let [shortest, longest] = at.p.hoist.limits().indicators(at.x.hoist.length, at.u.hoist.rate);
        [innermost, outermost, shortest, longest]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.trolley.stopped = at.p.trolley.limits().hold(&mut at.x.trolley.radius, at.u.trolley.rate);
        at.d.hoist.stopped = at.p.hoist.limits().hold(&mut at.x.hoist.length, at.u.hoist.rate);
        let physical = are_physical(&[at.u.slew.rate, at.u.trolley.rate, at.u.hoist.rate]);
        let cut = !physical || !at.u.wind.is_physical(at.p.payload.mass);
        at.d.at_limit = at.d.trolley.stopped || at.d.hoist.stopped || cut;
        None
    }
}

export_fmu!(TowerCrane);
