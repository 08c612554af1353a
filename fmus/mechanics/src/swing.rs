//! Swing angles, measured in a frame that turns with the crane.
//!
//! radial φ = asin n_r, positive away from the slewing axis; tangential β = atan2(n_t, −n_z), positive towards
//! increasing slew. This is the order "β, then φ" of the thesis (2.8–2.9): n = (sin φ, cos φ sin β, −cos φ cos β).

use swayless_scalar::Scalar;

use crate::Vector;

/// Swing angles or their rates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing<R: Scalar> {
    /// φ (rad or rad/s).
    pub radial: R,
    /// β (rad or rad/s).
    pub tangential: R,
}

/// The frame that swing is measured in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwingFrame<R: Scalar> {
    radial: Vector<R>,
    tangential: Vector<R>,
    turning: R,
}

impl<R: Scalar> SwingFrame<R> {
    /// The frame of a crane that points to `yaw` (rad) and turns with `turning` (rad/s).
    pub fn new(yaw: R, turning: R) -> Self {
        let (sin, cos) = yaw.sin_cos();
        Self { radial: Vector::new(cos, sin, R::zero()), tangential: Vector::new(-sin, cos, R::zero()), turning }
    }

    /// The unit vector away from the slewing axis.
    pub fn radial(&self) -> Vector<R> {
        self.radial
    }

    /// The unit vector towards increasing slew.
    pub fn tangential(&self) -> Vector<R> {
        self.tangential
    }

    /// The velocity of what is out on the crane (m/s), `reach` (m) from the slewing axis and getting farther with
    /// `reach_rate` (m/s): Ṙ e_r + R Ω e_t.
    pub fn swept(&self, reach: R, reach_rate: R) -> Vector<R> {
        self.radial * reach_rate + self.tangential * (reach * self.turning)
    }

    /// The direction from pivot to payload of swing angles.
    pub fn direction(&self, swing: Swing<R>) -> Vector<R> {
        let (sin_phi, cos_phi) = swing.radial.sin_cos();
        let (sin_beta, cos_beta) = swing.tangential.sin_cos();
        self.vector(sin_phi, cos_phi * sin_beta, -cos_phi * cos_beta)
    }

    /// How fast the direction changes when the angles change at `rates` and the frame does not turn.
    pub fn direction_rate(&self, swing: Swing<R>, rates: Swing<R>) -> Vector<R> {
        let (sin_phi, cos_phi) = swing.radial.sin_cos();
        let (sin_beta, cos_beta) = swing.tangential.sin_cos();
        let (phi, beta) = (rates.radial, rates.tangential);
        self.vector(
            cos_phi * phi,
            cos_phi * cos_beta * beta - sin_phi * sin_beta * phi,
            cos_phi * sin_beta * beta + sin_phi * cos_beta * phi,
        )
    }

    /// The swing angles of a unit direction.
    pub fn angles(&self, n: Vector<R>) -> Swing<R> {
        Swing { radial: n.dot(&self.radial).asin(), tangential: n.dot(&self.tangential).atan2(-n.z) }
    }

    /// The time derivatives of the angles, for the direction's rate in the world.
    pub fn rates(&self, n: Vector<R>, rate: Vector<R>) -> Swing<R> {
        let (n_r, n_t) = (n.dot(&self.radial), n.dot(&self.tangential));
        // Seen from the turning frame: ė_r = Ω e_t, ė_t = −Ω e_r.
        let radial = rate.dot(&self.radial) + self.turning * n_t;
        let tangential = rate.dot(&self.tangential) - self.turning * n_r;
        // 1 − n_r² for a unit vector, but exact where n_r is close to 1.
        let rest = n_t * n_t + n.z * n.z;
        Swing { radial: radial / rest.sqrt(), tangential: (n_t * rate.z - n.z * tangential) / rest }
    }

    fn vector(&self, radial: R, tangential: R, up: R) -> Vector<R> {
        self.radial * radial + self.tangential * tangential + Vector::new(R::zero(), R::zero(), up)
    }
}
