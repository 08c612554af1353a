//! Kinematics of a trolley on a jib that turns about a vertical axis (thesis 3.5, fig. 3.6).

use swayless_scalar::Scalar;

use crate::{SwingFrame, Vector};

/// Where a tower crane's joints are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jib<R: Scalar> {
    /// h, height of the trolley (m).
    pub height: R,
    /// θ (rad).
    pub slew: R,
    /// R, from the slewing axis to the trolley (m).
    pub radius: R,
}

/// How fast they move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JibRates<R: Scalar> {
    /// θ̇ (rad/s).
    pub slew: R,
    /// Ṙ (m/s).
    pub radius: R,
}

impl<R: Scalar> Jib<R> {
    /// The frame that the payload's swing is measured in: it turns with the jib.
    pub fn swing_frame(&self, rates: &JibRates<R>) -> SwingFrame<R> {
        SwingFrame::new(self.slew, rates.slew)
    }

    /// Position of the trolley (m): R e_r + h z.
    pub fn trolley(&self, frame: &SwingFrame<R>) -> Vector<R> {
        Vector::new(R::zero(), R::zero(), self.height) + frame.radial() * self.radius
    }

    /// Velocity of the trolley (m/s): Ṙ e_r + R θ̇ e_t.
    pub fn trolley_velocity(&self, frame: &SwingFrame<R>, rates: &JibRates<R>) -> Vector<R> {
        frame.swept(self.radius, rates.radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (3.22): T maps the trolley's velocity and the payload's sinking to Ṙ, θ̇, ℓ̇.
    #[test]
    fn the_thesis_maps_velocities_back_to_rates() {
        for (slew, radius, slew_rate, radius_rate) in
            [(0.3, 12.0, 0.2, -0.5), (-2.0, 40.0, -0.05, 0.8), (1.6, 3.0, 1.0, 0.0)]
        {
            let jib = Jib { height: 30.0, slew, radius };
            let rates = JibRates { slew: slew_rate, radius: radius_rate };
            let frame = jib.swing_frame(&rates);
            let v = jib.trolley_velocity(&frame, &rates);
            let (sin, cos) = f64::sin_cos(slew);
            assert!((cos * v.x + sin * v.y - radius_rate).abs() < 1e-14);
            assert!(((cos * v.y - sin * v.x) / radius - slew_rate).abs() < 1e-14);
            assert_eq!(v.z, 0.0);
            // And it is the derivative of the position.
            let at = |dt: f64| {
                let jib = Jib { slew: slew + dt * slew_rate, radius: radius + dt * radius_rate, ..jib };
                jib.trolley(&jib.swing_frame(&rates))
            };
            let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!((difference - v).norm() < 1e-8, "{difference} and {v}");
        }
    }
}
