//! `VerticalPendulum`: a pendulum under a cart that moves up and down, and the cart's counterweight rig (thesis 2.5).

use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, Variables, export_fmu};
use swayless_mechanics as mechanics;
use swayless_mechanics::{CounterweightRig, FASTEST_BRAKING, Limits};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// No cart accelerates more (m/s²): beyond, the input is cut, so that a step of any input ends in useful time.
const STRONGEST: f64 = 1e3;

/// The model.
struct VerticalPendulum;

fn pendulum<R: Scalar>(p: &Parameters<R>, x: &States<R>) -> mechanics::VerticalPendulum<R> {
    mechanics::VerticalPendulum { swing: x.swing, across: x.payload.velocity_across, length: p.length }
}

/// (2.38).
fn rig_acceleration<R: Scalar>(p: &Parameters<R>, velocity: R) -> R {
    let rig = CounterweightRig { counterweight: p.rig.counterweight_mass, mass: p.rig.mass, friction: p.rig.friction };
    rig.acceleration(velocity, p.gravity)
}

/// z̈.
fn acceleration<R: Scalar>(at: &Point<'_, VerticalPendulum, R>) -> R {
    let rig = R::select(at.d.cart.stopped, R::zero(), rig_acceleration(at.p, at.x.cart.velocity));
    R::select(at.p.rig.enabled, rig, at.u.acceleration.clamp(-STRONGEST, STRONGEST))
}

fn travel(p: &Parameters<f64>) -> Limits {
    Limits { min: 0.0, max: p.rig.travel }
}

/// Whether neither acceleration nor friction is cut.
fn is_physical(p: &Parameters<f64>, u: &Inputs<f64>) -> bool {
    if p.rig.enabled {
        p.rig.friction * FASTEST_BRAKING <= p.rig.counterweight_mass + p.rig.mass
    } else {
        u.acceleration.abs() <= STRONGEST
    }
}

/// What is connected together.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "cart",
        description: "Motion of the cart, up and down",
        kind: "axis",
        members: &[("acceleration", "acceleration"), ("cart.z", "position")],
    },
    Terminal {
        name: "swing",
        description: "Swing of the payload",
        kind: "swing",
        members: &[("swing", "radial"), ("swing.rate", "radial_rate"), ("swing.amplitude", "amplitude")],
    },
];

impl Model for VerticalPendulum {
    const INFO: Info = Info {
        name: "VerticalPendulum",
        description: "Pendulum under a cart that moves up and down, and the counterweight rig that moves the cart",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 10.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete;
    type Memory = ();
    type Indicators = [f64; 2];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let outside = travel(p).check(declared.cart.z).filter(|_| p.rig.enabled);
        outside.map(|why| Problem::new("cart.z", why)).into_iter().collect()
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        let mut x = declared.clone();
        x.swing = p.swing_start;
        x.payload.velocity_across = p.swing.rate_start * p.length;
        x
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let pendulum = pendulum(at.p, at.x);
        let acceleration = acceleration(at);
        let mut dx = at.x.clone();
        dx.swing = pendulum.swing_rate();
        dx.payload.velocity_across = pendulum.across_rate(at.p.gravity + acceleration, at.p.swing.damping);
        dx.cart.z = at.x.cart.velocity;
        dx.cart.velocity = acceleration;
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let pendulum = pendulum(at.p, at.x);
        let mut y = Outputs::start();
        y.swing.rate = pendulum.swing_rate();
        y.swing.amplitude = pendulum.amplitude(at.p.gravity);
        y.cart.acceleration = acceleration(at);
        y
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 2] {
        if at.p.rig.enabled { travel(at.p).indicators(at.x.cart.z, at.x.cart.velocity) } else { [1.0; 2] }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let Event { p, x, d, .. } = at;
        d.cart.stopped = false;
        if p.rig.enabled && travel(p).hold(&mut x.cart.z, x.cart.velocity) {
            x.payload.velocity_across = pendulum(p, x).after_stop(x.cart.velocity);
            x.cart.velocity = 0.0;
            // It stays where the heavier side pulls it to.
            let pulled = rig_acceleration(p, 0.0);
            d.cart.stopped = if x.cart.z > 0.0 { pulled >= 0.0 } else { pulled <= 0.0 };
        }
        d.at_limit = d.cart.stopped || !is_physical(p, at.u);
        None
    }
}

export_fmu!(VerticalPendulum);
