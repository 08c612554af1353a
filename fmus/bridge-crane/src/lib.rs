//! `BridgeCrane`: trolley, bridge and hoist with hook and payload, driven by rates (thesis 6.1.1).

use swayless_crane::{are_physical, cut, terminals};
use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{DoublePayload, DoubleSuspension, Payload, Suspension, SwingFrame, Vector};

mod variables;

use variables::{AngleOutputs, Discrete, Displacement, Inputs, MassOutputs, Outputs, Parameters, States, SwingOutputs};

/// No payload is heavier than so many hooks: the second mode gets faster with the square root of it.
const HEAVIEST: f64 = 1000.0;

/// The model.
struct BridgeCrane;

/// The world's axes: a bridge crane does not turn.
fn frame<R: Scalar>() -> SwingFrame<R> {
    SwingFrame::new(R::zero(), R::zero())
}

fn either<R: Scalar>(condition: bool, a: Vector<R>, b: Vector<R>) -> Vector<R> {
    a.zip_map(&b, |a, b| R::select(condition, a, b))
}

/// What the wind pushes.
fn exposed<R: Scalar>(p: &Parameters<R>, d: &Discrete) -> R {
    R::select(d.payload.attached, p.payload.mass, p.hook.mass)
}

/// What the equations share at one point in time.
struct Motion<R: Scalar> {
    masses: DoublePayload<R>,
    suspension: DoubleSuspension<R>,
}

fn motion<R: Scalar>(at: &Point<'_, BridgeCrane, R>) -> Motion<R> {
    let Point { p, u, x, d, .. } = *at;
    let moving = |stopped: bool, rate: R| R::select(stopped, R::zero(), cut(rate));
    let trolley = moving(d.trolley.stopped, u.trolley.rate);
    let bridge = moving(d.bridge.stopped, u.bridge.rate);
    let length_rate = moving(d.hoist.stopped, u.hoist.rate);
    let upper = Suspension { pivot: Vector::new(trolley, bridge, R::zero()), length: x.hoist.length, length_rate };
    Motion {
        masses: DoublePayload {
            hook: Payload {
                direction: Vector::from(x.cable.direction),
                velocity: Vector::from(x.cable.velocity_across),
            },
            payload: Payload {
                direction: Vector::from(x.rigging.direction),
                velocity: Vector::from(x.rigging.velocity_across),
            },
        },
        suspension: DoubleSuspension { upper, rigging: p.rigging.length, mass_ratio: p.payload.mass / p.hook.mass },
    }
}

/// What is seen of a mass at the end of a rope, and where it is relative to the trolley.
fn seen<R: Scalar>(at: &Point<'_, BridgeCrane, R>, n: Vector<R>, rate: Vector<R>, place: Vector<R>) -> MassOutputs<R> {
    let (angles, rates) = (frame().angles(n), frame().rates(n, rate));
    MassOutputs {
        swing: AngleOutputs {
            radial: angles.radial,
            tangential: angles.tangential,
            radial_rate: rates.radial,
            tangential_rate: rates.tangential,
        },
        displacement: Displacement { radial: place.x, tangential: place.y },
        x: at.x.trolley.x + place.x,
        y: at.x.bridge.y + place.y,
        z: at.p.rail.height + place.z,
    }
}

/// What is connected together; a drive's axis has the same member names.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "trolley",
        description: "Trolley, along world x",
        kind: "axis",
        members: &[("trolley.rate", "rate"), ("trolley.x", "position")],
    },
    Terminal {
        name: "bridge",
        description: "Bridge, along world y",
        kind: "axis",
        members: &[("bridge.rate", "rate"), ("bridge.y", "position")],
    },
    terminals::HOIST,
    terminals::WIND,
    Terminal {
        name: "hook",
        description: "Position of the hook",
        kind: "position",
        members: &[("hook.x", "x"), ("hook.y", "y"), ("hook.z", "z")],
    },
    terminals::PAYLOAD,
    Terminal {
        name: "hook_swing",
        description: "Swing of the hook",
        kind: "swing",
        members: &[
            ("hook.swing.radial", "radial"),
            ("hook.swing.tangential", "tangential"),
            ("hook.swing.radial_rate", "radial_rate"),
            ("hook.swing.tangential_rate", "tangential_rate"),
        ],
    },
    Terminal {
        name: "payload_swing",
        description: "Swing of the payload",
        kind: "swing",
        members: &[
            ("payload.swing.radial", "radial"),
            ("payload.swing.tangential", "tangential"),
            ("payload.swing.radial_rate", "radial_rate"),
            ("payload.swing.tangential_rate", "tangential_rate"),
        ],
    },
];

impl Model for BridgeCrane {
    const INFO: Info = Info {
        name: "BridgeCrane",
        description: "Bridge crane with hook and payload, a double pendulum, driven by rates",
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
    type Indicators = [f64; 6];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let joints = [
            ("trolley.x", p.trolley.limits(), declared.trolley.x),
            ("bridge.y", p.bridge.limits(), declared.bridge.y),
            ("hoist.length", p.hoist.limits(), declared.hoist.length),
        ];
        let joints = joints.into_iter().filter_map(|(name, limits, start)| Some((name, limits.check(start)?)));
        let (mass, most) = (p.payload.mass, HEAVIEST * p.hook.mass);
        let heavy = (mass > most)
            .then(|| ("payload.mass", format!("is {mass}; it must be at most {HEAVIEST} times hook.mass, {most}")));
        joints.chain(heavy).map(|(name, why)| Problem::new(name, why)).collect()
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        let upper = Suspension { pivot: Vector::zeros(), length: declared.hoist.length, length_rate: R::zero() };
        let mass_ratio = p.payload.mass / p.hook.mass;
        let suspension = DoubleSuspension { upper, rigging: p.rigging.length, mass_ratio };
        let (hook, payload) = (p.hook.swing.direction(&frame()), p.payload.swing.direction(&frame()));
        let masses = DoublePayload::started(&suspension, [hook.0, payload.0], [hook.1, payload.1]);
        States { cable: masses.hook.into(), rigging: masses.payload.into(), ..declared.clone() }
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let Point { p, u, d, .. } = *at;
        let Motion { masses, suspension } = motion(at);
        let attached = d.payload.attached;
        // g + F/m of the mass that the wind pushes, and g + F/(m₁ + m₂).
        let one = u.wind.pull(exposed(p, d), p.gravity);
        let gravity = Vector::new(R::zero(), R::zero(), -p.gravity);
        let both = gravity + (one - gravity) * R::select(attached, suspension.share(), R::one());
        let change = masses.rates(&suspension, [both, one], p.swing.damping);
        let moving = |rate: Vector<R>| either(attached, rate, Vector::zeros());
        let payload =
            Payload { direction: moving(change.payload.direction), velocity: moving(change.payload.velocity) };
        let mut dx = at.x.clone();
        (dx.trolley.x, dx.bridge.y) = (suspension.upper.pivot.x, suspension.upper.pivot.y);
        dx.hoist.length = suspension.upper.length_rate;
        States { cable: change.hook.into(), rigging: payload.into(), ..dx }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let Motion { masses, suspension } = motion(at);
        let (n1, n2) = (masses.hook.unit(), masses.payload.unit());
        let [n1_rate, n2_rate] = masses.direction_rates(&suspension);
        let attached = at.d.payload.attached;
        let hook = n1 * suspension.upper.length;
        let payload = either(attached, hook + n2 * suspension.rigging, hook);
        Outputs {
            hook: seen(at, n1, n1_rate, hook),
            payload: seen(at, either(attached, n2, n1), either(attached, n2_rate, n1_rate), payload),
            swing: SwingOutputs { amplitude: masses.amplitude(&suspension, at.p.gravity) },
        }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 6] {
        let [left, right] = at.p.trolley.limits().indicators(at.x.trolley.x, at.u.trolley.rate);
        let [back, front] = at.p.bridge.limits().indicators(at.x.bridge.y, at.u.bridge.rate);
        let [shortest, longest] = at.p.hoist.limits().indicators(at.x.hoist.length, at.u.hoist.rate);
        [left, right, back, front, shortest, longest]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let (p, u, d) = (at.p, at.u, &mut *at.d);
        d.payload.attached = p.payload.mass > 0.0;
        d.trolley.stopped = p.trolley.limits().hold(&mut at.x.trolley.x, u.trolley.rate);
        d.bridge.stopped = p.bridge.limits().hold(&mut at.x.bridge.y, u.bridge.rate);
        d.hoist.stopped = p.hoist.limits().hold(&mut at.x.hoist.length, u.hoist.rate);
        let stopped = d.trolley.stopped || d.bridge.stopped || d.hoist.stopped;
        let physical = are_physical(&[u.trolley.rate, u.bridge.rate, u.hoist.rate]);
        d.at_limit = stopped || !physical || !u.wind.is_physical(exposed(p, d));
        None
    }
}

export_fmu!(BridgeCrane);
