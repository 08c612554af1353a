//! A pendulum under a cart that moves up and down, and the counterweight rig that moves it (thesis 2.5).
//!
//! The swing is written by u = Lθ̇, the payload's velocity across the rod as the cart sees it. Seen from the ground it is
//! u + ż sin θ across the rod, and nothing but gravity acts there: u̇ + z̈ sin θ = −g sin θ, (2.35). When the cart is
//! stopped within no time, the rod's blow acts along the rod, so u + ż sin θ stays: u jumps by what ż sin θ loses.

use swayless_scalar::Scalar;

/// No friction brakes a cart with a shorter time constant (s).
pub const FASTEST_BRAKING: f64 = 1e-3;

/// A point mass on a rigid rod without mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalPendulum<R: Scalar> {
    /// θ, from the vertical (rad).
    pub swing: R,
    /// u = Lθ̇ (m/s).
    pub across: R,
    /// L, from the cart to the payload (m).
    pub length: R,
}

impl<R: Scalar> VerticalPendulum<R> {
    /// θ̇ (rad/s).
    pub fn swing_rate(&self) -> R {
        self.across / self.length
    }

    /// u̇ = −(g + z̈) sin θ − d u (m/s²); `pull` is g + z̈, `damping` is d (1/s), for small swing 2ζω.
    pub fn across_rate(&self, pull: R, damping: R) -> R {
        -self.swing.sin() * pull - self.across * damping
    }

    /// u after the cart has lost a velocity within no time (m/s).
    pub fn after_stop(&self, lost: R) -> R {
        self.across + lost * self.swing.sin()
    }

    /// The amplitude (rad) the payload would swing with under a cart without acceleration:
    /// 2·asin √min(1, sin²(θ/2) + u²/(4gL)).
    pub fn amplitude(&self, gravity: R) -> R {
        let half = (self.swing * 0.5).sin();
        let kinetic = self.across * self.across / (gravity * self.length * 4.0);
        (half * half + kinetic).clamp(0.0, 1.0).sqrt().asin() * 2.0
    }
}

/// A cart on a cable over a pulley, balanced by a counterweight (fig. 2.23).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CounterweightRig<R: Scalar> {
    /// M (kg).
    pub counterweight: R,
    /// m, all that hangs on the other side (kg).
    pub mass: R,
    /// b, viscous (kg/s).
    pub friction: R,
}

impl<R: Scalar> CounterweightRig<R> {
    /// z̈ = ((M − m) g − b ż)/(M + m) (2.38), with friction cut where it brakes faster than anything.
    pub fn acceleration(&self, velocity: R, gravity: R) -> R {
        let total = self.counterweight + self.mass;
        let braking = (self.friction / total).clamp(0.0, 1.0 / FASTEST_BRAKING);
        (self.counterweight - self.mass) * gravity / total - braking * velocity
    }
}

#[cfg(test)]
mod tests {
    use swayless_scalar::Dual;

    use super::*;

    /// Energy seen from the ground: gravity does all the work while the cart is uniform, and the cart's inertia force
    /// −m z̈ does the rest when it is seen from the cart.
    #[test]
    fn energy_changes_by_the_work_of_the_carts_inertia() {
        let (length, gravity) = (0.7, 9.81);
        for (swing, across, lift) in [(0.3, 0.8, 2.0), (-2.4, 0.1, -5.0), (1.2, -1.7, 0.0)] {
            let pendulum = VerticalPendulum { swing, across, length };
            let rate = pendulum.across_rate(gravity + lift, 0.0);
            let (angle, speed) = (Dual::new(swing, pendulum.swing_rate()), Dual::new(across, rate));
            let energy = speed * speed * 0.5 - angle.cos() * (gravity * length);
            // −z̈ times the payload's rise relative to the cart.
            let work = -lift * swing.sin() * across;
            assert!((energy.tangent - work).abs() < 1e-13, "{} W/kg, work {work}", energy.tangent);
        }
    }

    /// The velocity across the rod, from coordinates, is the same just before and just after a stop.
    #[test]
    fn a_stop_leaves_the_velocity_across_the_rod() {
        for (swing, across, velocity) in [(0.3, 0.8, 1.5), (-1.1, -0.2, -2.0)] {
            let pendulum = VerticalPendulum { swing, across, length: 0.7 };
            let (sin, cos) = f64::sin_cos(swing);
            // From x = L sin θ, z = z_cart − L cos θ; the rod's normal is (cos θ, sin θ).
            let seen = |across: f64, cart: f64| across * cos * cos + (cart + across * sin) * sin;
            assert!((seen(pendulum.after_stop(velocity), 0.0) - seen(across, velocity)).abs() < 1e-15);
        }
    }

    #[test]
    fn the_amplitude_is_where_the_pendulum_turns() {
        let at_rest = VerticalPendulum { swing: 0.9, across: 0.0, length: 2.0 };
        assert!((at_rest.amplitude(9.81) - 0.9).abs() < 1e-15);
        // (2.48): θ̇₀² = 2ω²(cos θ₀ − cos β).
        let (beta, theta) = (0.9_f64, 0.4_f64);
        let rate = (2.0 * 9.81 / 2.0 * (theta.cos() - beta.cos())).sqrt();
        let moving = VerticalPendulum { swing: theta, across: 2.0 * rate, length: 2.0 };
        assert!((moving.amplitude(9.81) - beta).abs() < 1e-14);
        assert_eq!(VerticalPendulum { across: 1e3, ..moving }.amplitude(9.81), core::f64::consts::PI);
    }

    #[test]
    fn the_rig_accelerates_by_the_difference_of_its_masses() {
        let rig = CounterweightRig { counterweight: 3.0, mass: 2.5, friction: 0.4 };
        assert!((rig.acceleration(0.0, 9.81) - 9.81 * 0.5 / 5.5).abs() < 1e-15);
        let terminal = 0.5 * 9.81 / 0.4;
        assert!(rig.acceleration(terminal, 9.81).abs() < 1e-15);
        let sticky = CounterweightRig { friction: 1e12, ..rig };
        assert!((sticky.acceleration(1.0, 9.81) + 1e3).abs() < 1.0);
    }
}
