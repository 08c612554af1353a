//! `MobileBase`: the front-steered, rear-driven base of a mobile crane (thesis 4.1).

use swayless_crane::{STRONGEST, cut_acceleration};
use swayless_export::{Event, Info, Model, Point, Scalar, Terminal, Variables, export_fmu};
use swayless_mechanics::{Driving, Vehicle};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// The model.
struct MobileBase;

/// A number as far as it is between ± a limit.
fn limited<R: Scalar>(value: R, limit: R) -> R {
    (value / limit).clamp(-1.0, 1.0) * limit
}

/// The base, and what it makes of the inputs: at a limit, nothing changes.
fn driven<R: Scalar>(at: &Point<'_, MobileBase, R>) -> (Vehicle<R>, Driving<R>) {
    let Point { p, u, x, d, .. } = *at;
    let change = |held: bool, rate: R| R::select(held, R::zero(), cut_acceleration(rate));
    let driving = Driving {
        speed: limited(u.speed, p.speed_limit),
        acceleration: change(d.cut.speed, u.acceleration),
        steering: limited(u.steering, p.steering_limit),
        steering_rate: change(d.cut.steering, u.steering_rate),
    };
    (Vehicle { wheelbase: p.wheelbase, yaw: x.base.yaw }, driving)
}

/// What is connected together: what moves the base of a crane. Where it is, the crane knows itself.
const TERMINALS: &[Terminal] = &[Terminal {
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
    ],
}];

impl Model for MobileBase {
    const INFO: Info = Info {
        name: "MobileBase",
        description: "Front-steered, rear-driven base of a mobile crane",
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
    type Indicators = [f64; 2];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let (vehicle, driving) = driven(at);
        let rates = vehicle.rates(&driving);
        let mut dx = at.x.clone();
        [dx.base.x, dx.base.y] = rates.along;
        dx.base.yaw = rates.yaw;
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let (vehicle, driving) = driven(at);
        let (rates, accelerations) = (vehicle.rates(&driving), vehicle.accelerations(&driving));
        let mut y = Outputs::start();
        [y.base.velocity.x, y.base.velocity.y] = rates.along;
        y.base.yaw_rate = rates.yaw;
        [y.base.acceleration.x, y.base.acceleration.y] = accelerations.along;
        y.base.yaw_acceleration = accelerations.yaw;
        y
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 2] {
        [at.u.speed.abs() - at.p.speed_limit, at.u.steering.abs() - at.p.steering_limit]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.cut.speed = at.u.speed.abs() > at.p.speed_limit;
        at.d.cut.steering = at.u.steering.abs() > at.p.steering_limit;
        let changes = [at.u.acceleration, at.u.steering_rate];
        let unphysical = changes.iter().any(|rate| rate.abs() > STRONGEST);
        at.d.at_limit = at.d.cut.speed || at.d.cut.steering || unphysical;
        None
    }
}

export_fmu!(MobileBase);
