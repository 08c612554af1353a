//! The motor under load. It has only so much force, and a brake for loads that this cannot hold:
//!
//! (motor.mass + load.mass) a = force + brake.force − load.force, with |force| ≤ force_limit.
//!
//! A load that the motor cannot hold is an overload. The axis may come to rest against it, then the brake closes; the
//! axis may go along with it, then the brake helps to slow it down; it is never driven by it.

use swayless_export::{Event, Point, Scalar};

use crate::variables::{Inputs, Parameters, States};
use crate::{VectorDrive, velocity, wanted_acceleration};

/// No load is heavier: beyond, it is cut, so that outputs stay finite.
const HEAVIEST: f64 = 1e9;
/// No load pulls more; more than any motor can hold.
const STRONGEST: f64 = 1e12;

fn load<R: Scalar>(u: &Inputs<R>) -> R {
    u.load.force.clamp(-STRONGEST, STRONGEST)
}

fn mass<R: Scalar>(p: &Parameters<R>, u: &Inputs<R>) -> R {
    p.motor.mass + u.load.mass.clamp(0.0, HEAVIEST)
}

/// What the axis does of the wanted acceleration.
pub fn acceleration<R: Scalar>(at: &Point<'_, VectorDrive, R>, wanted: R) -> R {
    let Point { p, u, d, .. } = *at;
    let allowed = (d.motor.saturation * p.force_limit - load(u)) / mass(p, u);
    let moving = R::select(d.limited && !d.brake.helping, allowed, wanted);
    R::select(d.brake.closed, R::zero(), moving)
}

/// The forces of motor and brake.
pub fn forces<R: Scalar>(at: &Point<'_, VectorDrive, R>, acceleration: R) -> (R, R) {
    let Point { p, u, d, .. } = *at;
    let needed = mass(p, u) * acceleration + load(u);
    let motor = R::select(d.limited, d.motor.saturation * p.force_limit, needed);
    let motor = R::select(d.brake.closed, R::zero(), motor);
    (motor, R::select(d.brake.closed || d.brake.helping, needed - motor, R::zero()))
}

/// How far a force is from where a motor with this limit cannot have it, either way: not positive where it is beyond.
/// That the limit itself is within makes this the whole truth, whichever mode the drive is in.
fn margins(limit: f64, force: f64) -> [f64; 2] {
    [limit.next_up() - force, limit.next_up() + force]
}

/// The sign of a force beyond the limit, 0 if it is within.
fn excess(limit: f64, force: f64) -> f64 {
    let [above, below] = margins(limit, force);
    f64::from(u8::from(above <= 0.0)) - f64::from(u8::from(below <= 0.0))
}

/// The force that the wanted acceleration takes.
fn needed(p: &Parameters<f64>, u: &Inputs<f64>, wanted: f64) -> f64 {
    mass(p, u) * wanted + load(u)
}

/// Indicators: what is wanted takes more force than there is, the load does, the axis comes to rest under an overload.
pub fn indicators(at: &Point<'_, VectorDrive, f64>) -> [f64; 5] {
    let Point { p, u, x, d, .. } = *at;
    let against = d.overload.direction * velocity(p, x);
    let rest = match (d.overload.direction == 0.0 || d.brake.closed, d.overload.lowering) {
        (true, _) => 1.0,
        (_, true) => f64::MIN_POSITIVE - against,
        (_, false) => against,
    };
    // A closed brake leaves the motor nothing to do.
    let effort = if d.brake.closed { 0.0 } else { needed(p, u, wanted_acceleration(p, x, d)) };
    let ([push, pull], [raise, lower]) = (margins(p.force_limit, effort), margins(p.force_limit, load(u)));
    [push, pull, raise, lower, rest]
}

/// Whether nothing in the drive moves.
fn is_at_rest(p: &Parameters<f64>, x: &States<f64>) -> bool {
    x.limiter.reference == 0.0 && velocity(p, x) == 0.0 && (x.response.acceleration == 0.0 || !p.smoothing)
}

/// Looks whether an overload has brought the axis to rest, or lets it go, with the command within its limits. Returns
/// whether drive and axis have been stopped: all that the drive was about is to be planned anew.
pub fn brake(at: &mut Event<'_, VectorDrive>, command: f64) -> bool {
    let (x, d) = (&mut *at.x, &mut *at.d);
    let direction = excess(at.p.force_limit, load(at.u));
    let fresh = at.initial || direction != d.overload.direction;
    d.overload.direction = direction;
    d.overloaded = direction != 0.0;
    let against = direction * velocity(at.p, x);
    let along = direction * command < 0.0;
    let rests = if !d.overloaded {
        false
    } else if fresh {
        against == 0.0
    } else if d.brake.closed {
        true
    } else if d.overload.lowering {
        against >= f64::MIN_POSITIVE || (!along && is_at_rest(at.p, x))
    } else {
        // Whoever has asked for it in time passes from raising to lowering without a stop.
        against <= 0.0 && !(along && direction * x.limiter.reference <= 0.0)
    };
    let stopped = rests && !d.brake.closed;
    if rests {
        (x.limiter.reference, x.response.velocity, x.response.acceleration) = (0.0, 0.0, 0.0);
    }
    d.brake.closed = rests && !along;
    d.overload.lowering = d.overloaded && !d.brake.closed && (rests || against < f64::MIN_POSITIVE);
    stopped
}

/// Looks whether the motor has the force for what is wanted, and whether the brake has to help.
pub fn limit(at: &mut Event<'_, VectorDrive>) {
    let (p, u, d) = (at.p, at.u, &mut *at.d);
    let wanted = wanted_acceleration(p, at.x, d);
    d.motor.saturation = if d.brake.closed { 0.0 } else { excess(p.force_limit, needed(p, u, wanted)) };
    d.limited = d.motor.saturation != 0.0;
    d.brake.helping = d.limited && d.overload.lowering && d.motor.saturation == d.overload.direction;
    d.valid = u.load.force.abs() <= STRONGEST && (0.0..=HEAVIEST).contains(&u.load.mass);
}
