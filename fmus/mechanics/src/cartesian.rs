//! From the velocity of a load to the rates of the joints that give it (thesis 3.1, 3.2 and 3.5): T of a boom crane (3.6),
//! of a tower crane (3.22) and of a boom lift (3.23, corrected), and V·T with the speeds of the ropes (3.14).
//!
//! The velocity is one in the crane's own directions – radial, tangential, upwards – relative to the slewing axis. At a
//! singular position some velocity would take an infinite rate; near to one, [`Machine::ranges`] says what is left.

use crate::axes::{Axis, AxisRates};
use crate::{Luffing, Vector};

/// A crane as far as a velocity of its load is concerned: where its joints are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Machine {
    /// A boom from whose tip a load hangs.
    Boom {
        /// r, length of the boom (m).
        length: f64,
        /// γ, its angle above the horizontal (rad).
        luff: f64,
        /// Its ropes at that angle.
        ropes: Luffing<f64>,
    },
    /// A trolley on a jib, from which a load hangs.
    Tower {
        /// R, from the slewing axis (m).
        radius: f64,
    },
    /// A boom that extends and has its load at its tip.
    BoomLift {
        /// r + ρ, length of the boom with its extension (m).
        length: f64,
        /// γ, its angle above the horizontal (rad).
        luff: f64,
    },
}

/// The least magnitude of what is divided by: at a singular position the map is that of one right beside it.
const LEAST: f64 = 1e-12;

/// A number, but not 0.
pub(crate) fn off_zero(x: f64) -> f64 {
    if x < 0.0 { x.min(-LEAST) } else { x.max(LEAST) }
}

impl Machine {
    /// The rates that move the load with a velocity (m/s; radial, tangential, upwards) relative to the slewing axis.
    ///
    /// - Boom: γ̇ = −v_r/(r sin γ), θ̇ = v_t/(r cos γ), ℓ̇ = r cos γ γ̇ − v_z (3.6); −Ċ = c γ̇, L̇ = ℓ̇ − a γ̇ (3.12).
    /// - Tower: Ṙ = v_r, θ̇ = v_t/R, ℓ̇ = −v_z (3.22).
    /// - Boom lift: ρ̇ = cos γ v_r + sin γ v_z, γ̇ = (cos γ v_z − sin γ v_r)/(r + ρ), θ̇ = v_t/((r + ρ) cos γ) (3.23,
    ///   corrected).
    pub fn rates(&self, velocity: Vector<f64>) -> AxisRates {
        let [radial, tangential, up] = velocity.into();
        let mut rates = AxisRates::zeros();
        match *self {
            Self::Boom { length, luff, ropes } => {
                let (sin, cos) = luff.sin_cos();
                let luffing = -radial / (length * off_zero(sin));
                rates[Axis::Luff as usize] = luffing;
                rates[Axis::Slew as usize] = tangential / (length * off_zero(cos));
                rates[Axis::Hoist as usize] = length * cos * luffing - up;
                rates[Axis::LuffLine as usize] = ropes.luff_line.arm * luffing;
                rates[Axis::HoistLine as usize] = rates[Axis::Hoist as usize] - ropes.hoist_line.arm * luffing;
            }
            Self::Tower { radius } => {
                rates[Axis::Trolley as usize] = radial;
                rates[Axis::Slew as usize] = tangential / off_zero(radius);
                rates[Axis::Hoist as usize] = -up;
            }
            Self::BoomLift { length, luff } => {
                let (sin, cos) = luff.sin_cos();
                rates[Axis::Extension as usize] = cos * radial + sin * up;
                rates[Axis::Luff as usize] = (cos * up - sin * radial) / length;
                rates[Axis::Slew as usize] = tangential / (length * off_zero(cos));
            }
        }
        rates
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use nalgebra::Matrix3;
    use swayless_scalar::Dual;

    use super::*;
    use crate::{Boom, BoomRates, Jib, JibRates, Rigging, SwingFrame};

    /// Table 2.3.
    const RIG: Rigging<f64> = Rigging { boom: 0.89, jib: 0.33, sheave: 0.29, jib_angle: 137.0 * PI / 180.0 };

    fn boom(length: f64, luff: f64) -> Machine {
        Machine::Boom { length, luff, ropes: Rigging { boom: length, ..RIG }.at(luff) }
    }

    /// The rates of some axes for unit velocities along the world's x, y and z, as the columns of a matrix.
    fn matrix(machine: &Machine, slew: f64, axes: [Axis; 3]) -> Matrix3<f64> {
        let (sin, cos) = slew.sin_cos();
        // x, y and z as radial, tangential and upwards.
        let units = [Vector::new(cos, -sin, 0.0), Vector::new(sin, cos, 0.0), Vector::new(0.0, 0.0, 1.0)];
        let rates = units.map(|unit| machine.rates(unit));
        Matrix3::from_fn(|row, column| rates[column][axes[row] as usize])
    }

    /// (3.14) at γ = 45°, θ = 30° on the rig of Table 2.3, in the thesis's order and signs: Ċ, θ̇, L̇.
    #[test]
    fn the_rig_has_the_thesis_matrix() {
        let found = matrix(&boom(0.89, FRAC_PI_4), PI / 6.0, [Axis::LuffLine, Axis::Slew, Axis::HoistLine]);
        // Here the luff line is reeled in, −Ċ.
        let found = Matrix3::from_diagonal(&Vector::new(-1.0, 1.0, 1.0)) * found;
        let wanted = Matrix3::new(
            0.420_772_421_150_611_3,
            0.242_933_070_618_876,
            0.0,
            -0.794_502_001_333_199_4,
            1.376_117_833_024_257_4,
            0.0,
            -0.490_656_768_139_853_37,
            -0.283_280_817_165_256_1,
            -1.0,
        );
        assert!((found - wanted).abs().max() < 1e-14, "{found}");
    }

    /// (3.6), (3.22) and (3.23), the last corrected, as they are written.
    #[test]
    fn the_maps_are_those_of_the_thesis() {
        let (r, gamma, theta) = (18.0, 0.7_f64, 2.1_f64);
        let ((sin, cos), (s, c)) = (gamma.sin_cos(), theta.sin_cos());
        let found = matrix(&boom(r, gamma), theta, [Axis::Luff, Axis::Slew, Axis::Hoist]);
        let tan = gamma.tan();
        let wanted = Matrix3::new(
            -c / (r * sin),
            -s / (r * sin),
            0.0,
            -s / (r * cos),
            c / (r * cos),
            0.0,
            -c / tan,
            -s / tan,
            -1.0,
        );
        assert!((found - wanted).abs().max() < 1e-15, "{found}");
        let found = matrix(&Machine::Tower { radius: r }, theta, [Axis::Trolley, Axis::Slew, Axis::Hoist]);
        let wanted = Matrix3::new(c, s, 0.0, -s / r, c / r, 0.0, 0.0, 0.0, -1.0);
        assert!((found - wanted).abs().max() < 1e-15, "{found}");
        let lift = Machine::BoomLift { length: r, luff: gamma };
        let found = matrix(&lift, theta, [Axis::Extension, Axis::Slew, Axis::Luff]);
        let wanted = Matrix3::new(
            cos * c,
            cos * s,
            sin,
            -s / (r * cos),
            c / (r * cos),
            0.0,
            -sin * c / r,
            -sin * s / r,
            cos / r,
        );
        assert!((found - wanted).abs().max() < 1e-15, "{found}");
    }

    /// Some joint values, all over: luff, slew, length or radius.
    fn places() -> impl Iterator<Item = [f64; 3]> {
        (0..60).map(|i| {
            let i = f64::from(i);
            let angle = -3.0 + 0.097 * i;
            // No closer to a multiple of 90° than 0.01.
            let off = if (angle / FRAC_PI_2 - (angle / FRAC_PI_2).round()).abs() < 0.01 { 0.02 } else { 0.0 };
            [angle + off, 1.3 * i, 0.5 + 0.7 * i]
        })
    }

    /// T times the exact derivatives of the plants' own kinematics is the unit matrix.
    #[test]
    fn the_maps_are_the_inverse_of_the_kinematics() {
        let dual = |at: f64, moves: bool| Dual::new(at, f64::from(u8::from(moves)));
        let mut worst = 0.0_f64;
        for [luff, slew, length] in places() {
            // One column for each joint: the velocity of the load when that joint has rate 1.
            let tip = |joint: usize, hoists: bool| {
                let base = Boom {
                    base: [Dual::from(0.0); 2],
                    yaw: Dual::from(0.0),
                    slew: dual(slew, joint == 1),
                    luff: dual(luff, joint == 0),
                    length: dual(length, joint == 2 && !hoists),
                    offset: Dual::from(0.0),
                    height: Dual::from(1.5),
                };
                let tip = base.tip(&SwingFrame::new(base.slew, Dual::from(0.0))).map(|x| x.tangent);
                // The load hangs below.
                tip - Vector::new(0.0, 0.0, f64::from(u8::from(joint == 2 && hoists)))
            };
            let columns = |hoists| Matrix3::from_columns(&[tip(0, hoists), tip(1, hoists), tip(2, hoists)]);
            let error = |found: Matrix3<f64>| (found - Matrix3::identity()).abs().max();
            let found = matrix(&boom(length, luff), slew, [Axis::Luff, Axis::Slew, Axis::Hoist]) * columns(true);
            worst = worst.max(error(found));
            let lift = Machine::BoomLift { length, luff };
            worst = worst.max(error(matrix(&lift, slew, [Axis::Luff, Axis::Slew, Axis::Extension]) * columns(false)));

            let trolley = |joint: usize| {
                let jib =
                    Jib { height: Dual::from(40.0), slew: dual(slew, joint == 1), radius: dual(length, joint == 0) };
                let rates = JibRates { slew: Dual::from(0.0), radius: Dual::from(0.0) };
                jib.trolley(&jib.swing_frame(&rates)).map(|x| x.tangent)
            };
            let columns = Matrix3::from_columns(&[trolley(0), trolley(1), Vector::new(0.0, 0.0, -1.0)]);
            let tower = Machine::Tower { radius: length };
            worst = worst.max(error(matrix(&tower, slew, [Axis::Trolley, Axis::Slew, Axis::Hoist]) * columns));
        }
        // Rounding, times at most the 100 that 0.01 from a singular angle costs.
        assert!(worst < 1e-12, "{worst}");
    }

    /// The base's motion as well: T of the velocity of the load relative to the slewing axis, and less yaw rate.
    #[test]
    fn a_moving_base_is_made_up_for() {
        for [luff, slew, length] in places() {
            let (yaw, offset) = (0.4 * slew, 1.2);
            let base = Boom { base: [3.0, -2.0], yaw, slew, luff, length, offset, height: 1.5 };
            let (base_velocity, yaw_rate) = ([0.7, -0.3], 0.11);
            let axis = Vector::new(
                base_velocity[0] - offset * yaw_rate * yaw.sin(),
                base_velocity[1] + offset * yaw_rate * yaw.cos(),
                0.0,
            );
            let still = SwingFrame::new(yaw + slew, 0.0);
            let (radial, tangential) = (-axis.dot(&still.radial()), -axis.dot(&still.tangential()));
            let rates = boom(length, luff).rates(Vector::new(radial, tangential, 0.0));
            let rates = BoomRates {
                base: base_velocity,
                yaw: yaw_rate,
                slew: rates[Axis::Slew as usize] - yaw_rate,
                luff: rates[Axis::Luff as usize],
                length: 0.0,
            };
            let tip = base.tip_velocity(&base.swing_frame(&rates), &rates);
            assert!(tip.x.hypot(tip.y) < 1e-13, "{tip}");
        }
    }
}
