//! `VectorDrive`: the vector drive of one crane axis (thesis 6.1, fig. 6.3).
//!
//! Saturator, reversal switch (6.1), rate limiter and second-order response H(s) in series.

use swayless_export::{Event, Info, Model, Point, Scalar, Terminal, export_fmu};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// Time constant with which the limited rate follows its target once it has met it (s).
const TRACKING: f64 = 1e-3;
/// How close to its target the limited rate counts as arrived, as time at full acceleration (s): an importer's event
/// may lie this much before the crossing.
const ARRIVED: f64 = 1e-9;

/// The model.
struct VectorDrive;

/// ṙ: ±a until r meets the target, then (target − r)/1 ms.
fn reference_rate<R: Scalar>(x: &States<R>, d: &Discrete<R>) -> R {
    R::select(d.limiter.tracking, (d.limiter.target - x.limiter.reference) / TRACKING, d.limiter.slope)
}

/// V_t, the velocity of the axis.
fn velocity<R: Scalar>(p: &Parameters<R>, x: &States<R>) -> R {
    R::select(p.smoothing, x.response.velocity, x.limiter.reference)
}

/// What is connected together. The drive moves an axis and does not ask where it is, so its own travel has another name
/// than the position of the axis.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "command",
        description: "Commanded velocity",
        kind: "command",
        members: &[("command", "command")],
    },
    Terminal {
        name: "axis",
        description: "The axis that is driven",
        kind: "axis",
        members: &[("velocity", "rate"), ("acceleration", "acceleration"), ("position", "travel")],
    },
];

impl Model for VectorDrive {
    const INFO: Info = Info {
        name: "VectorDrive",
        description: "Vector drive of one crane axis: saturator, reversal switch, rate limiter, second-order response",
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
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = ();
    type Indicators = [f64; 2];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let mut dx = at.x.clone();
        let (v, rate, omega) = (at.x.response.velocity, at.x.response.acceleration, at.p.natural_frequency);
        // H(s) = ω²/(s² + 2ζω s + ω²) of the limited rate r.
        let curvature = (at.x.limiter.reference - v) * omega * omega - rate * at.p.damping_ratio * omega * 2.0;
        dx.limiter.reference = reference_rate(at.x, at.d);
        dx.response.velocity = R::select(at.p.smoothing, rate, R::zero());
        dx.response.acceleration = R::select(at.p.smoothing, curvature, R::zero());
        dx.position = velocity(at.p, at.x);
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        Outputs {
            velocity: velocity(at.p, at.x),
            acceleration: R::select(at.p.smoothing, at.x.response.acceleration, reference_rate(at.x, at.d)),
        }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 2] {
        let limiter = &at.d.limiter;
        let against = at.d.switch.direction * velocity(at.p, at.x);
        let gap = limiter.target - at.x.limiter.reference;
        [
            // The axis moves against the command, faster than the threshold, where this is not positive.
            if at.d.switch.direction == 0.0 { 1.0 } else { against + at.p.reversal_threshold },
            // The limited rate has met its target where this is not positive.
            if limiter.tracking { 1.0 } else { gap * limiter.slope.signum() },
        ]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let (p, d) = (at.p, &mut *at.d);
        let command = if at.u.command.abs() <= p.dead_zone { 0.0 } else { at.u.command };
        let wanted = command.clamp(-p.velocity_limit, p.velocity_limit);
        d.switch.direction = if wanted == 0.0 { 0.0 } else { wanted.signum() };
        // (6.1): V_r0 = Ṽ_r if it has the sign of V_t or |V_t| ≤ X, else 0.
        let against = d.switch.direction * velocity(p, at.x);
        d.switch.opposed = against < -p.reversal_threshold * (1.0 + ARRIVED);
        let target = if d.switch.opposed { 0.0 } else { wanted };

        let limiter = &mut d.limiter;
        let gap = target - at.x.limiter.reference;
        if target != limiter.target || at.initial {
            limiter.target = target;
            limiter.tracking = gap.abs() <= p.acceleration_limit * TRACKING;
            limiter.slope = if limiter.tracking { 0.0 } else { p.acceleration_limit * gap.signum() };
        } else if !limiter.tracking && gap * limiter.slope.signum() <= p.acceleration_limit * ARRIVED {
            at.x.limiter.reference = target;
            limiter.tracking = true;
            limiter.slope = 0.0;
        }
        None
    }
}

export_fmu!(VectorDrive);
