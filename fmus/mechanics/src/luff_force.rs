//! The forces in the ropes of a luffing boom (thesis 2.3, eqs. 2.21–2.24, corrected).
//!
//! Planar: boom, jib, ropes and payload in one vertical plane that does not turn. The payload is a point mass.

use swayless_scalar::Scalar;

use crate::luffing::{Luffing, Motion};

/// What luffs: boom and payload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LuffLoad<R: Scalar> {
    /// r, the boom's length (m).
    pub length: R,
    /// I_O, the boom's moment of inertia about its foot (kg m²).
    pub inertia: R,
    /// r̄ m_b, the boom's mass times the distance of its centre of mass from its foot (kg m).
    pub moment: R,
    /// m_p, the payload's mass (kg).
    pub payload: R,
    /// g (m/s²).
    pub gravity: R,
    /// Whether the pull of the hoist line between tip and jib is left out, as the thesis does in (2.23).
    pub without_reaction: bool,
}

/// How the payload hangs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hanging<R: Scalar> {
    /// φ, its radial swing (rad).
    pub swing: R,
    /// φ̇ (rad/s).
    pub swing_rate: R,
    /// ℓ, the suspension length (m).
    pub length: R,
}

impl<R: Scalar> LuffLoad<R> {
    /// r cos(γ − φ) − a (m): the payload's moment about the boom's foot over the tension. The hoist line pulls the tip
    /// down along the cable, and with its arm a towards the jib.
    fn payload_arm(&self, ropes: &Luffing<R>, swing: R) -> R {
        let reaction = R::select(self.without_reaction, R::zero(), ropes.hoist_line.arm);
        self.length * (ropes.angle - swing).cos() - reaction
    }

    /// The tension of the hoist line (N), (2.21) with the acceleration of tip and cable:
    /// F_p = m_p [g cos φ + ℓ φ̇² − ℓ̈ + r (γ̈ cos(γ − φ) − γ̇² sin(γ − φ))].
    pub fn tension(&self, ropes: &Luffing<R>, hanging: Hanging<R>, boom: Motion<R>, stretching: R) -> R {
        let Hanging { swing, swing_rate, length } = hanging;
        let (sin, cos) = (ropes.angle - swing).sin_cos();
        let tip = self.length * (boom.acceleration * cos - boom.rate * boom.rate * sin);
        self.payload * (self.gravity * swing.cos() + length * swing_rate * swing_rate - stretching + tip)
    }

    /// The luff line's force (N), (2.23) with the hoist line's reaction:
    /// F_c = [I_O γ̈ + F_p (r cos(γ − φ) − a) + r̄ m_b g cos γ]/c.
    pub fn line_force(&self, ropes: &Luffing<R>, swing: R, tension: R, acceleration: R) -> R {
        let boom = self.inertia * acceleration + self.moment * self.gravity * ropes.angle.cos();
        (boom + tension * self.payload_arm(ropes, swing)) / ropes.luff_line.arm
    }

    /// The luff line's force while both lines are held (N): γ̇ = γ̈ = ℓ̇ = ℓ̈ = 0.
    pub fn static_force(&self, ropes: &Luffing<R>, hanging: Hanging<R>) -> R {
        let held = Motion { rate: R::zero(), acceleration: R::zero() };
        let tension = self.tension(ropes, hanging, held, R::zero());
        self.line_force(ropes, hanging.swing, tension, R::zero())
    }

    /// What boom and payload weigh on the luff line as a mass (kg): K² [I_O + m_p (r cos(γ − φ) − a)²], K = 1/c.
    pub fn line_mass(&self, ropes: &Luffing<R>, swing: R) -> R {
        let arm = self.payload_arm(ropes, swing);
        (self.inertia + self.payload * arm * arm) / (ropes.luff_line.arm * ropes.luff_line.arm)
    }
}

#[cfg(test)]
mod tests {
    use swayless_scalar::Dual;

    use super::*;
    use crate::luffing::Rigging;

    /// A point of a motion: boom, payload and both lines.
    struct State {
        luff: f64,
        hanging: Hanging<f64>,
        reeled_in: Motion<f64>,
        paid_out: Motion<f64>,
    }

    const RIG: Rigging<f64> = Rigging { boom: 7.0, jib: 2.6, sheave: 2.1, jib_angle: 2.3 };
    const LOAD: LuffLoad<f64> =
        LuffLoad { length: 7.0, inertia: 900.0, moment: 190.0, payload: 35.0, gravity: 9.81, without_reaction: false };

    /// Numbers between −1 and 1 that look random.
    fn states() -> impl Iterator<Item = State> {
        let mut seed = 0.3_f64;
        let mut next = move || {
            seed = (seed * 997.0 + 0.1234567).fract();
            2.0 * seed - 1.0
        };
        (0..40).map(move |_| State {
            luff: 0.7 + 0.6 * next(),
            hanging: Hanging { swing: 0.6 * next(), swing_rate: next(), length: 3.0 + 2.0 * next() },
            reeled_in: Motion { rate: next(), acceleration: 2.0 * next() },
            paid_out: Motion { rate: next(), acceleration: 2.0 * next() },
        })
    }

    /// Energy of boom and payload from positions and velocities: a dual number carries its rate of change.
    fn energy(luff: [Dual; 2], swing: [Dual; 2], length: [Dual; 2]) -> Dual {
        let ([luff, luff_rate], [swing, swing_rate], [length, length_rate]) = (luff, swing, length);
        let (r, m, g) = (LOAD.length, LOAD.payload, LOAD.gravity);
        let x = -luff.sin() * luff_rate * r + swing.cos() * swing_rate * length + swing.sin() * length_rate;
        let z = luff.cos() * luff_rate * r + swing.sin() * swing_rate * length - swing.cos() * length_rate;
        let height = luff.sin() * r - swing.cos() * length;
        luff_rate * luff_rate * (0.5 * LOAD.inertia)
            + (x * x + z * z) * (0.5 * m)
            + (luff.sin() * LOAD.moment + height * m) * g
    }

    /// What the lines' forces do is what boom and payload gain: F_c C' − F_p L̇ = Ė, whatever the swing does. The thesis's
    /// force fails this.
    #[test]
    fn the_power_of_both_lines_is_the_rate_of_energy() {
        let mut missed = 0.0_f64;
        for State { luff, hanging, reeled_in, paid_out } in states() {
            let ropes = RIG.at(luff);
            let boom = ropes.boom(reeled_in);
            let suspension = ropes.suspension(boom, paid_out);
            let Hanging { swing, swing_rate, length } = hanging;
            // (2.29) for a length that changes: the payload across the cable by Newton's law.
            let (sin, cos) = (luff - swing).sin_cos();
            let across = LOAD.length * (boom.acceleration * sin + boom.rate * boom.rate * cos)
                - LOAD.gravity * swing.sin()
                - 2.0 * suspension.rate * swing_rate;
            let gain = energy(
                [Dual::new(luff, boom.rate), Dual::new(boom.rate, boom.acceleration)],
                [Dual::new(swing, swing_rate), Dual::new(swing_rate, across / length)],
                [Dual::new(length, suspension.rate), Dual::new(suspension.rate, suspension.acceleration)],
            );
            let tension = LOAD.tension(&ropes, hanging, boom, suspension.acceleration);
            let power = |load: LuffLoad<f64>| {
                load.line_force(&ropes, swing, tension, boom.acceleration) * reeled_in.rate - tension * paid_out.rate
            };
            assert!((power(LOAD) - gain.tangent).abs() < 1e-9, "{} W, gained {} W", power(LOAD), gain.tangent);
            missed = missed.max((power(LuffLoad { without_reaction: true, ..LOAD }) - gain.tangent).abs());
        }
        assert!(missed > 10.0, "the missing reaction does {missed} W");
    }

    /// The drive's load: with the hoist line held, the force rises by the mass times the line's acceleration.
    #[test]
    fn force_is_static_force_and_mass() {
        let still = Motion { rate: 0.0, acceleration: 0.0 };
        for State { luff, hanging, reeled_in, .. } in states() {
            let ropes = RIG.at(luff);
            let boom = ropes.boom(Motion { rate: 0.0, ..reeled_in });
            let stretching = ropes.suspension(boom, still).acceleration;
            let tension = LOAD.tension(&ropes, hanging, boom, stretching);
            let force = LOAD.line_force(&ropes, hanging.swing, tension, boom.acceleration);
            let parts =
                LOAD.static_force(&ropes, hanging) + LOAD.line_mass(&ropes, hanging.swing) * reeled_in.acceleration;
            assert!((force - parts).abs() < 1e-9, "{force} N, of its parts {parts} N");
        }
    }

    /// (2.22), two components of force and one moment about the centre of mass, solved for the force, with the moment
    /// of inertia about that centre. The hoist line's pull towards the sheave is left out, as there.
    #[test]
    fn the_thesis_form_solves_its_three_rows() {
        let load = LuffLoad { without_reaction: true, ..LOAD };
        let (mass, center) = (50.0, 3.8);
        assert_eq!(mass * center, load.moment);
        let about_center = load.inertia - mass * center * center;
        for State { luff, hanging, reeled_in, paid_out } in states() {
            let ropes = RIG.at(luff);
            let boom = ropes.boom(reeled_in);
            let stretching = ropes.suspension(boom, paid_out).acceleration;
            let tension = load.tension(&ropes, hanging, boom, stretching);
            // α, the luff line's angle to the boom at the tip (2.20).
            let alpha = (ropes.luff_line.arm / load.length).asin();
            let (sin, cos) = luff.sin_cos();
            let (sin_p, cos_p) = (luff - hanging.swing).sin_cos();
            let rows = nalgebra::Matrix3::new(
                cos,
                sin,
                -alpha.cos(),
                -sin,
                cos,
                alpha.sin(),
                center * sin,
                -center * cos,
                (load.length - center) * alpha.sin(),
            );
            let weight = mass * load.gravity;
            let right = nalgebra::Vector3::new(
                -mass * center * boom.rate * boom.rate + weight * sin + tension * sin_p,
                mass * center * boom.acceleration + weight * cos + tension * cos_p,
                about_center * boom.acceleration + tension * (load.length - center) * cos_p,
            );
            let wanted = rows.lu().solve(&right).expect("a solution").z;
            let found = load.line_force(&ropes, hanging.swing, tension, boom.acceleration);
            assert!((found - wanted).abs() < 1e-9, "{found} N, of the rows {wanted} N");
        }
    }
}
