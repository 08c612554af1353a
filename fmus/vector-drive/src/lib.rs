//! `VectorDrive`: the vector drive of one crane axis (thesis 6.1, fig. 6.3).
//!
//! Saturator, reversal switch (6.1), rate limiter and second-order response H(s) in series, and a motor with a load.

use swayless_crane::terminals;
use swayless_export::{Event, Info, Model, Point, Scalar, export_fmu};

mod load;
mod variables;

use variables::{BrakeOutputs, Discrete, Inputs, Outputs, Parameters, States};

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

/// How far from its target the limited rate may be torn before it runs to it again; a little more than where it begins
/// to track, so that it does not run and track at once.
fn reach(p: &Parameters<f64>) -> f64 {
    p.acceleration_limit * TRACKING * (1.0 + ARRIVED)
}

/// Whether a load may tear the limited rate away from its target: without smoothing, where it slows the axis down.
fn can_tear<R: Scalar>(p: &Parameters<R>, d: &Discrete<R>) -> bool {
    !p.smoothing && d.overloaded && !d.overload.lowering && !d.brake.closed
}

/// V_t, the velocity of the axis.
fn velocity<R: Scalar>(p: &Parameters<R>, x: &States<R>) -> R {
    R::select(p.smoothing, x.response.velocity, x.limiter.reference)
}

/// The acceleration that the drive wants, whether or not its motor can: A of the response, or the limiter's slope.
fn wanted_acceleration<R: Scalar>(p: &Parameters<R>, x: &States<R>, d: &Discrete<R>) -> R {
    R::select(p.smoothing, x.response.acceleration, reference_rate(x, d))
}

impl Model for VectorDrive {
    const INFO: Info = Info {
        name: "VectorDrive",
        description: "Vector drive of one crane axis: saturator, reversal switch, rate limiter, second-order response",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: &[terminals::COMMAND, terminals::DRIVEN_AXIS, terminals::DRIVEN_LOAD],
        stop_time: 10.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = ();
    type Indicators = [f64; 7];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let mut dx = at.x.clone();
        let (v, rate, omega) = (at.x.response.velocity, at.x.response.acceleration, at.p.natural_frequency);
        // H(s) = ω²/(s² + 2ζω s + ω²) of the limited rate r.
        let curvature = (at.x.limiter.reference - v) * omega * omega - rate * at.p.damping_ratio * omega * 2.0;
        let acceleration = load::acceleration(at, wanted_acceleration(at.p, at.x, at.d));
        // A closed brake resets the drive. Else the limiter and A go on by their own equations where the axis cannot
        // follow. A is bounded by the lag of V, so that it does not wind up; the force that it takes is continuous
        // together with its rate when the motor comes to its limit, so that this does not chatter.
        let reference = R::select(at.d.brake.closed, R::zero(), reference_rate(at.x, at.d));
        dx.limiter.reference = R::select(at.p.smoothing, reference, acceleration);
        dx.response.velocity = R::select(at.p.smoothing, acceleration, R::zero());
        dx.response.acceleration = R::select(at.p.smoothing && !at.d.brake.closed, curvature, R::zero());
        dx.position = velocity(at.p, at.x);
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let acceleration = load::acceleration(at, wanted_acceleration(at.p, at.x, at.d));
        let (motor, brake) = load::forces(at, acceleration);
        Outputs { velocity: velocity(at.p, at.x), acceleration, force: motor, brake: BrakeOutputs { force: brake } }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 7] {
        let limiter = &at.d.limiter;
        let against = at.d.switch.direction * velocity(at.p, at.x);
        let gap = limiter.target - at.x.limiter.reference;
        // The axis moves against the command, faster than the threshold, where this is not positive.
        let switch = if at.d.switch.direction == 0.0 { 1.0 } else { against + at.p.reversal_threshold };
        // The limited rate has met its target where this is not positive, or has been torn away from it.
        let met = match (limiter.tracking, can_tear(at.p, at.d)) {
            (false, _) => gap * limiter.slope.signum(),
            (true, true) => reach(at.p) - gap.abs(),
            (true, false) => 1.0,
        };
        let [push, pull, raise, lower, rest] = load::indicators(at);
        [switch, met, push, pull, raise, lower, rest]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let p = at.p;
        let command = if at.u.command.abs() <= p.dead_zone { 0.0 } else { at.u.command };
        let wanted = command.clamp(-p.velocity_limit, p.velocity_limit);
        let stopped = load::brake(at, wanted);

        let d = &mut *at.d;
        d.switch.direction = if wanted == 0.0 { 0.0 } else { wanted.signum() };
        // (6.1): V_r0 = Ṽ_r if it has the sign of V_t or |V_t| ≤ X, else 0.
        let against = d.switch.direction * velocity(p, at.x);
        d.switch.opposed = against < -p.reversal_threshold * (1.0 + ARRIVED);
        let target = if d.switch.opposed { 0.0 } else { wanted };

        let torn = d.limiter.tracking && can_tear(p, d);
        let limiter = &mut d.limiter;
        let gap = target - at.x.limiter.reference;
        if target != limiter.target || at.initial || stopped || (torn && gap.abs() >= reach(p)) {
            limiter.target = target;
            limiter.tracking = gap.abs() <= p.acceleration_limit * TRACKING;
            limiter.slope = if limiter.tracking { 0.0 } else { p.acceleration_limit * gap.signum() };
        } else if !limiter.tracking && gap * limiter.slope.signum() <= p.acceleration_limit * ARRIVED {
            at.x.limiter.reference = target;
            limiter.tracking = true;
            limiter.slope = 0.0;
        }
        // The limiter may just have brought the axis to rest.
        load::brake(at, wanted);
        load::limit(at);
        None
    }
}

export_fmu!(VectorDrive);
