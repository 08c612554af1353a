//! Hook and payload below it: a double pendulum in three dimensions from a moving pivot (thesis 6.1.1).
//!
//! As with one payload, what cables cannot pull at is carried as state – here the momentum of hook and payload together
//! across the upper cable, and that of the payload across the lower one – so that no acceleration appears and a jump in
//! the pivot's velocity is exact.

use swayless_scalar::Scalar;

use crate::payload::across;
use crate::{Payload, Suspension, Vector};

/// The state of hook and payload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoublePayload<R: Scalar> {
    /// n₁, from the pivot to the hook, and w₁, the velocity of the centre of mass of hook and payload across n₁ (m/s).
    pub hook: Payload<R>,
    /// n₂, from the hook to the payload, and w₂, the payload's velocity across n₂ (m/s).
    pub payload: Payload<R>,
}

/// What moves them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleSuspension<R: Scalar> {
    /// The pivot and the upper cable.
    pub upper: Suspension<R>,
    /// ℓ₂, from the hook to the payload (m).
    pub rigging: R,
    /// μ, the payload's mass over the hook's; 0 where there is no payload.
    pub mass_ratio: R,
}

/// Velocities of the two masses (m/s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleVelocity<R: Scalar> {
    /// v₁.
    pub hook: Vector<R>,
    /// v₂.
    pub payload: Vector<R>,
}

impl<R: Scalar> DoubleSuspension<R> {
    /// The payload's part of both masses, μ/(1 + μ).
    pub fn share(&self) -> R {
        self.mass_ratio / (self.mass_ratio + 1.0)
    }

    /// V, the velocity of both masses together.
    fn mean(&self, velocity: &DoubleVelocity<R>) -> Vector<R> {
        velocity.hook + (velocity.payload - velocity.hook) * self.share()
    }
}

impl<R: Scalar> DoublePayload<R> {
    /// At rest under a resting pivot, but for directions and their rates (1/s), each of the hook, then of the payload.
    pub fn started(suspension: &DoubleSuspension<R>, directions: [Vector<R>; 2], rates: [Vector<R>; 2]) -> Self {
        let hook = rates[0] * suspension.upper.length;
        let velocity = DoubleVelocity { hook, payload: hook + rates[1] * suspension.rigging };
        let [n1, n2] = directions;
        Self {
            hook: Payload { direction: n1, velocity: across(suspension.mean(&velocity), n1) },
            payload: Payload { direction: n2, velocity: across(velocity.payload, n2) },
        }
    }

    /// v₁ and v₂ from the momenta. With s₁ = n₁·v + ℓ̇, the rate at which the upper cable draws the hook, and the part
    /// e of n₂ across n₁:
    ///
    ///   b = (1 + μ) w₁ − μ (w₂⊥₁ + s₁ (n₁·n₂) e)
    ///   v₁ = s₁ n₁ + b − μ e (e·b)/(1 + μ e²)
    ///   v₂ = w₂ + (n₂·v₁) n₂
    pub fn velocity(&self, suspension: &DoubleSuspension<R>) -> DoubleVelocity<R> {
        let (n1, n2) = (self.hook.unit(), self.payload.unit());
        let (w1, w2) = (across(self.hook.velocity, n1), across(self.payload.velocity, n2));
        let Suspension { pivot, length_rate, .. } = suspension.upper;
        let mu = suspension.mass_ratio;
        let s1 = n1.dot(&pivot) + length_rate;
        let cosine = n1.dot(&n2);
        let e = n2 - n1 * cosine;
        let b = w1 * (mu + 1.0) - (across(w2, n1) + e * (s1 * cosine)) * mu;
        let hook = n1 * s1 + b - e * (mu * e.dot(&b) / (mu * e.dot(&e) + 1.0));
        DoubleVelocity { hook, payload: w2 + n2 * n2.dot(&hook) }
    }

    /// ṅ₁ = (v₁ − v)⊥₁/ℓ₁ and ṅ₂ = (v₂ − v₁)⊥₂/ℓ₂ of the unit vectors.
    pub fn direction_rates(&self, suspension: &DoubleSuspension<R>) -> [Vector<R>; 2] {
        let velocity = self.velocity(suspension);
        [self.hook_rate(suspension, &velocity), self.payload.direction_rate(&below(suspension, &velocity))]
    }

    /// ṅ and ẇ of both. With V = (m₁v₁ + m₂v₂)/(m₁ + m₂):
    ///
    ///   ẇ₁ = (g + (F₁ + F₂)/(m₁ + m₂))⊥₁ − (n₁·V) ṅ₁ − (ṅ₁·V) n₁ − d ℓ₁ ṅ₁
    ///   ẇ₂ = (g + F₂/m₂)⊥₂ − (n₂·v₂) ṅ₂ − (ṅ₂·v₂) n₂ − d ℓ₂ ṅ₂
    ///
    /// `pull` is g + (F₁ + F₂)/(m₁ + m₂) and g + F₂/m₂ (m/s²), `damping` is d (1/s). The payload is one on a cable from
    /// the hook, so its equation is that of [`Payload`]. As there, the equations are those of n/|n| and of the parts of
    /// w across it, the rest is carried along: errors of |n| and n·w neither grow nor matter.
    pub fn rates(&self, suspension: &DoubleSuspension<R>, pull: [Vector<R>; 2], damping: R) -> Self {
        let velocity = self.velocity(suspension);
        let n = self.hook.unit();
        let n_rate = self.hook_rate(suspension, &velocity);
        let mean = suspension.mean(&velocity);
        let drag = damping * suspension.upper.length;
        let along = n.dot(&self.hook.velocity);
        let w_rate = across(pull[0], n) - n_rate * (n.dot(&mean) + drag - along) - n * n_rate.dot(&self.hook.velocity);
        Self {
            hook: Payload { direction: n_rate * self.hook.size(), velocity: w_rate },
            payload: self.payload.rates(&below(suspension, &velocity), pull[1], damping),
        }
    }

    /// The angle (rad) at which hook and payload, in line and at rest, have the energy they have now, if the pivot keeps
    /// its present velocity and the hoist stops. For one mass it is the amplitude of its swing.
    ///
    /// (1 − cos A) (ℓ₁ + νℓ₂) = ℓ₁ (1 + n₁z) + νℓ₂ (1 + n₂z) + ((1 − ν) u₁² + ν u₂²)/(2g) with ν = m₂/(m₁ + m₂) and the
    /// velocities u relative to the pivot; by sin²(A/2), so that small swing keeps its digits.
    pub fn amplitude(&self, suspension: &DoubleSuspension<R>, gravity: R) -> R {
        let mut stopped = *suspension;
        stopped.upper.length_rate = R::zero();
        let velocity = self.velocity(&stopped);
        let (hook, payload) = (velocity.hook - stopped.upper.pivot, velocity.payload - stopped.upper.pivot);
        let nu = stopped.share();
        let (upper, lower) = (stopped.upper.length, stopped.rigging * nu);
        // 2 (1 + n_z) = |n + z|² for a unit vector.
        let above = |n: Vector<R>| n.x * n.x + n.y * n.y + (n.z + 1.0) * (n.z + 1.0);
        let potential = upper * above(self.hook.unit()) + lower * above(self.payload.unit());
        let kinetic = hook.dot(&hook) + (payload.dot(&payload) - hook.dot(&hook)) * nu;
        ((potential + kinetic / gravity) / ((upper + lower) * 4.0)).clamp(0.0, 1.0).sqrt().asin() * 2.0
    }

    fn hook_rate(&self, suspension: &DoubleSuspension<R>, velocity: &DoubleVelocity<R>) -> Vector<R> {
        across(velocity.hook - suspension.upper.pivot, self.hook.unit()) / suspension.upper.length
    }
}

/// What moves the payload: the hook is its pivot.
fn below<R: Scalar>(suspension: &DoubleSuspension<R>, velocity: &DoubleVelocity<R>) -> Suspension<R> {
    Suspension { pivot: velocity.hook, length: suspension.rigging, length_rate: R::zero() }
}
