//! A point mass on a cable from a moving pivot.
//!
//! The pivot's velocity v is an input and no acceleration appears, so a jump in v is exact: with the momentum of the
//! mass unchanged across the cable, w stays and ṅ jumps. That is eq. 5.7 of the thesis, θ = −(v_f/Lω) sin ωt, at once.
//! There is no singular swing angle.

use swayless_scalar::Scalar;

use crate::Vector;

/// The state of a payload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Payload<R: Scalar> {
    /// The unit vector from the pivot to the payload.
    pub direction: Vector<R>,
    /// The payload's velocity across the cable (m/s).
    pub velocity: Vector<R>,
}

/// What moves a payload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Suspension<R: Scalar> {
    /// Velocity of the pivot (m/s).
    pub pivot: Vector<R>,
    /// ℓ, from the pivot to the payload (m).
    pub length: R,
    /// ℓ̇ (m/s).
    pub length_rate: R,
}

impl<R: Scalar> Payload<R> {
    /// At rest under a resting pivot, but for a direction and its rate (1/s): w₀ = ℓ ṅ₀.
    pub fn started(direction: Vector<R>, rate: Vector<R>, length: R) -> Self {
        Self { direction, velocity: rate * length }
    }

    /// ṅ = (w − v⊥)/ℓ of the unit vector, where u⊥ is the part of u across n.
    pub fn direction_rate(&self, suspension: &Suspension<R>) -> Vector<R> {
        across(self.velocity - suspension.pivot, self.unit()) / suspension.length
    }

    /// ṅ and ẇ = (g + F/m)⊥ − (n·v + ℓ̇) ṅ − (w·ṅ) n − d ℓ ṅ.
    ///
    /// `pull` is g + F/m (m/s²), `damping` is d (1/s), for small swing 2ζω.
    ///
    /// Integration leaves |n| ≠ 1 and n·w ≠ 0. So that these errors neither grow nor matter, the equations are those of
    /// n/|n| and of w⊥ = w − s n/|n|: ṅ is scaled by |n|, and ẇ carries s along with s ṅ, which keeps |n| and s as they
    /// are. With n and w themselves an error of |n| would feed itself while the pivot moves along the cable.
    pub fn rates(&self, suspension: &Suspension<R>, pull: Vector<R>, damping: R) -> Self {
        let size = self.size();
        let n = self.direction / size;
        let Suspension { pivot: v, length, length_rate } = *suspension;
        let n_rate = across(self.velocity - v, n) / length;
        let along = n.dot(&self.velocity);
        let w_rate = across(pull, n)
            - n_rate * (n.dot(&v) + length_rate + damping * length - along)
            - n * self.velocity.dot(&n_rate);
        Self { direction: n_rate * size, velocity: w_rate }
    }

    /// The cable's tension per mass of the payload (m/s²): n·(g + F/m) + ℓ |ṅ|² − n·v̇ − ℓ̈, where v̇ is `acceleration`,
    /// of the pivot. Where it is negative, a cable would be slack.
    pub fn tension(
        &self,
        suspension: &Suspension<R>,
        pull: Vector<R>,
        acceleration: Vector<R>,
        length_acceleration: R,
    ) -> R {
        let rate = self.direction_rate(suspension);
        self.unit().dot(&(pull - acceleration)) + rate.dot(&rate) * suspension.length - length_acceleration
    }

    /// The amplitude (rad) the payload would swing with if the pivot kept its present velocity and the hoist stopped:
    /// 2·asin √min(1, sin²(θ/2) + |w − v⊥|²/(4gℓ)), with sin²(θ/2) = |n + z|²/4 so that small swing keeps its digits.
    pub fn amplitude(&self, suspension: &Suspension<R>, gravity: R) -> R {
        let n = self.unit();
        let above = Vector::new(n.x, n.y, n.z + 1.0);
        let relative = across(self.velocity - suspension.pivot, n);
        let potential = above.dot(&above) * 0.25;
        let kinetic = relative.dot(&relative) / (gravity * suspension.length * 4.0);
        (potential + kinetic).clamp(0.0, 1.0).sqrt().asin() * 2.0
    }

    /// n/|n|: integration lets the length drift by its error.
    pub fn unit(&self) -> Vector<R> {
        self.direction / self.size()
    }

    /// |n|.
    pub(crate) fn size(&self) -> R {
        self.direction.dot(&self.direction).sqrt()
    }
}

/// The part of u across the unit vector n.
pub(crate) fn across<R: Scalar>(u: Vector<R>, n: Vector<R>) -> Vector<R> {
    u - n * n.dot(&u)
}
