//! Kinematics of a boom on a moving, turning base (thesis 2.1, eqs. 2.1–2.7).

use swayless_scalar::Scalar;

use crate::{SwingFrame, Vector};

/// Where a boom crane's joints are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boom<R: Scalar> {
    /// Position of the base's reference point, x and y in the world (m).
    pub base: [R; 2],
    /// ψ, yaw of the base (rad).
    pub yaw: R,
    /// θ, relative to the base (rad).
    pub slew: R,
    /// γ, above the horizontal (rad).
    pub luff: R,
    /// r, the boom's length, telescopes included (m).
    pub length: R,
    /// a, from the base's reference point to the slewing axis, along the base (m).
    pub offset: R,
    /// h, height of the boom's foot above the reference point (m).
    pub height: R,
}

/// How fast they move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoomRates<R: Scalar> {
    /// Velocity of the base's reference point, x and y in the world (m/s).
    pub base: [R; 2],
    /// ψ̇ (rad/s).
    pub yaw: R,
    /// θ̇ (rad/s).
    pub slew: R,
    /// γ̇ (rad/s).
    pub luff: R,
    /// ṙ (m/s).
    pub length: R,
}

/// How fast that changes: the same, once more derived by time.
pub type BoomAccelerations<R> = BoomRates<R>;

impl<R: Scalar> Boom<R> {
    /// The frame that the payload's swing is measured in: it turns with the base and the slew.
    pub fn swing_frame(&self, rates: &BoomRates<R>) -> SwingFrame<R> {
        SwingFrame::new(self.yaw + self.slew, rates.yaw + rates.slew)
    }

    /// Position of the boom's tip (m): base + a b₁ + h z + r cos γ e_r + r sin γ z.
    pub fn tip(&self, frame: &SwingFrame<R>) -> Vector<R> {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_luff, cos_luff) = self.luff.sin_cos();
        let [x, y] = self.base;
        Vector::new(x + self.offset * cos_yaw, y + self.offset * sin_yaw, self.height + self.length * sin_luff)
            + frame.radial() * (self.length * cos_luff)
    }

    /// Velocity of the boom's tip (m/s): v_base + a ψ̇ b₂ + Ṙ e_r + R (ψ̇ + θ̇) e_t + ż z, with the tip's reach
    /// R = r cos γ and height z = r sin γ.
    pub fn tip_velocity(&self, frame: &SwingFrame<R>, rates: &BoomRates<R>) -> Vector<R> {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_luff, cos_luff) = self.luff.sin_cos();
        let [x, y] = rates.base;
        let turning = self.offset * rates.yaw;
        // Along the boom and across it, upwards.
        let (along, across) = (rates.length, self.length * rates.luff);
        Vector::new(x - turning * sin_yaw, y + turning * cos_yaw, along * sin_luff + across * cos_luff)
            + frame.swept(self.length * cos_luff, along * cos_luff - across * sin_luff)
    }

    /// Acceleration of the boom's tip (m/s²; thesis 2.11): a_base + a (ψ̈ b₂ − ψ̇² b₁) + (R̈ − R Ω²) e_r +
    /// (R Ω̇ + 2 Ṙ Ω) e_t + z̈ z, with Ω = ψ̇ + θ̇.
    pub fn tip_acceleration(
        &self,
        frame: &SwingFrame<R>,
        rates: &BoomRates<R>,
        accelerations: &BoomAccelerations<R>,
    ) -> Vector<R> {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_luff, cos_luff) = self.luff.sin_cos();
        let [x, y] = accelerations.base;
        let (ahead, left) = (-self.offset * rates.yaw * rates.yaw, self.offset * accelerations.yaw);
        let along = accelerations.length - self.length * rates.luff * rates.luff;
        let across = self.length * accelerations.luff + rates.length * rates.luff * 2.0;
        let (reach, reach_rate) =
            (self.length * cos_luff, rates.length * cos_luff - self.length * rates.luff * sin_luff);
        let (turning, turning_rate) = (rates.yaw + rates.slew, accelerations.yaw + accelerations.slew);
        Vector::new(
            x + ahead * cos_yaw - left * sin_yaw,
            y + ahead * sin_yaw + left * cos_yaw,
            along * sin_luff + across * cos_luff,
        ) + frame.radial() * (along * cos_luff - across * sin_luff - reach * turning * turning)
            + frame.tangential() * (reach * turning_rate + reach_rate * turning * 2.0)
    }
}
