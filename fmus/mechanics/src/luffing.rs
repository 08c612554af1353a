//! The ropes that luff a boom and hoist its payload (thesis 2.3 and 3.2, eqs. 2.19, 2.25–2.28, 3.9–3.13).
//!
//! A jib stands fixed above the boom's foot. The luff line runs from its end to the boom's tip; the hoist line runs from
//! a sheave on the jib to the tip and down to the payload. Reeling in the luff line raises the boom, and with the hoist
//! line held the payload then comes down relative to the tip.

use swayless_scalar::Scalar;

/// How close boom and jib may come to lying in one line (rad). There the luff line has no lever on the boom; beyond, the
/// ropes are those at this angle.
pub const DEAD_ANGLE: f64 = 0.01;

/// A rope from a point of the jib to the boom's tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rope<R: Scalar> {
    /// Its length (m).
    pub length: R,
    /// How much shorter it gets as the boom rises (m/rad), which is its lever arm about the boom's foot.
    pub arm: R,
    /// How the arm changes as the boom rises (m/rad²).
    pub arm_slope: R,
}

impl<R: Scalar> Rope<R> {
    /// The rope from a point of the jib at the distance A from the boom's foot, to the tip of a boom of length r, with
    /// the angle δ between them: B² = A² + r² − 2Ar cos δ (2.19), a = A r sin δ/B (2.26), da/dγ = (a² − A r cos δ)/B.
    pub fn new(anchor: R, boom: R, angle: R) -> Self {
        let (sin, cos) = angle.sin_cos();
        let half = (angle * 0.5).sin();
        let (gap, product) = (boom - anchor, boom * anchor);
        // B² without the cancellation that the law of cosines has for small δ.
        let length = (gap * gap + product * half * half * 4.0).sqrt();
        let arm = product * sin / length;
        Self { length, arm, arm_slope: (arm * arm - product * cos) / length }
    }
}

/// How something moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R: Scalar> {
    /// Its speed (rad/s or m/s).
    pub rate: R,
    /// Its acceleration (rad/s² or m/s²).
    pub acceleration: R,
}

/// The dimensions of boom and jib.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigging<R: Scalar> {
    /// r, the boom's length (m).
    pub boom: R,
    /// H, from the boom's foot to the end of the jib, where the luff line begins (m).
    pub jib: R,
    /// A, from the boom's foot to the sheave of the hoist line on the jib (m).
    pub sheave: R,
    /// Ψ, the jib's angle above the horizontal on the boom's side (rad).
    pub jib_angle: R,
}

/// The ropes at a luff angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Luffing<R: Scalar> {
    /// γ (rad), cut where boom and jib lie almost in one line.
    pub angle: R,
    /// The luff line: length C, arm 1/K.
    pub luff_line: Rope<R>,
    /// The hoist line from sheave to tip: length B.
    pub hoist_line: Rope<R>,
}

impl<R: Scalar> Rigging<R> {
    /// The ropes with the boom at γ.
    pub fn at(&self, luff: R) -> Luffing<R> {
        let between = (self.jib_angle - luff).clamp(DEAD_ANGLE, core::f64::consts::PI - DEAD_ANGLE);
        Luffing {
            angle: self.jib_angle - between,
            luff_line: Rope::new(self.jib, self.boom, between),
            hoist_line: Rope::new(self.sheave, self.boom, between),
        }
    }
}

impl Rigging<f64> {
    /// How far the angle between boom and jib is above the least (rad) and below the greatest at which the luff line has
    /// a lever.
    pub fn from_dead_angles(&self, luff: f64) -> [f64; 2] {
        let between = self.jib_angle - luff;
        [between - DEAD_ANGLE, core::f64::consts::PI - DEAD_ANGLE - between]
    }
}

impl<R: Scalar> Luffing<R> {
    /// How the boom moves when the luff line is reeled in (2.25): γ̇ = C'/c, γ̈ = (C̈' − c' γ̇²)/c with C' = −Ċ and its
    /// arm c. That is γ̇ = K C', γ̈ = K C̈' + dK/dγ γ̇ C' with K = 1/c.
    pub fn boom(&self, reeled_in: Motion<R>) -> Motion<R> {
        let Rope { arm, arm_slope, .. } = self.luff_line;
        let rate = reeled_in.rate / arm;
        Motion { rate, acceleration: (reeled_in.acceleration - arm_slope * rate * rate) / arm }
    }

    /// How the suspension's length changes when the boom moves and the hoist line is paid out (3.11): ℓ̇ = L̇ + a γ̇,
    /// ℓ̈ = L̈ + a γ̈ + a' γ̇² with the hoist line's arm a.
    pub fn suspension(&self, boom: Motion<R>, paid_out: Motion<R>) -> Motion<R> {
        let Rope { arm, arm_slope, .. } = self.hoist_line;
        Motion {
            rate: paid_out.rate + arm * boom.rate,
            acceleration: paid_out.acceleration + arm * boom.acceleration + arm_slope * boom.rate * boom.rate,
        }
    }
}

#[cfg(test)]
mod tests {
    use swayless_scalar::Dual;

    use super::*;

    /// Table 2.3.
    const RIG: Rigging<f64> = Rigging { boom: 0.89, jib: 0.33, sheave: 0.29, jib_angle: 137.0 * DEGREE };
    const DEGREE: f64 = core::f64::consts::PI / 180.0;

    /// The same rig at an angle that moves by 1 rad.
    fn moving(luff: f64) -> Luffing<Dual> {
        let constant = Dual::from;
        let (boom, jib) = (constant(RIG.boom), constant(RIG.jib));
        let (sheave, jib_angle) = (constant(RIG.sheave), constant(RIG.jib_angle));
        Rigging { boom, jib, sheave, jib_angle }.at(Dual::new(luff, 1.0))
    }

    /// The distance between two points of the plane, from coordinates instead of angles.
    fn distance(from: f64, luff: f64) -> f64 {
        let (sin, cos) = RIG.jib_angle.sin_cos();
        (RIG.boom * luff.cos() - from * cos).hypot(RIG.boom * luff.sin() - from * sin)
    }

    #[test]
    fn ropes_are_as_long_as_the_way_between_their_ends() {
        for degrees in 11..=80 {
            let luff = f64::from(degrees) * DEGREE;
            let Luffing { luff_line, hoist_line, .. } = RIG.at(luff);
            assert!((luff_line.length - distance(RIG.jib, luff)).abs() < 1e-15);
            assert!((hoist_line.length - distance(RIG.sheave, luff)).abs() < 1e-15);
        }
    }

    #[test]
    fn arms_and_slopes_are_the_derivatives_over_the_luff_angle() {
        for degrees in [-20.0, 11.0, 45.0, 80.0, 120.0] {
            let Luffing { luff_line, hoist_line, .. } = moving(degrees * DEGREE);
            for rope in [luff_line, hoist_line] {
                assert!((rope.length.tangent + rope.arm.value).abs() < 1e-14);
                assert!((rope.arm.tangent - rope.arm_slope.value).abs() < 1e-13);
            }
        }
    }

    /// dK/dγ as the thesis's symbols give it: [(dC/dγ) S + C cos(Ψ − γ)]/(H r S²), and K = C/(H r S).
    #[test]
    fn the_boom_accelerates_by_k_and_its_slope() {
        let (reeled, reeling) = (0.12, 0.7);
        for degrees in [11.0, 40.0, 80.0] {
            let luff = degrees * DEGREE;
            let c = distance(RIG.jib, luff);
            let (s, cos) = (RIG.jib_angle - luff).sin_cos();
            let product = RIG.jib * RIG.boom;
            let k = c / (product * s);
            let slope = (-product * s / c * s + c * cos) / (product * s * s);
            let boom = RIG.at(luff).boom(Motion { rate: reeled, acceleration: reeling });
            assert!((boom.rate - k * reeled).abs() < 1e-14);
            assert!((boom.acceleration - (k * reeling + slope * boom.rate * reeled)).abs() < 1e-13);
        }
    }

    /// The rate and acceleration of a length are those of the length itself along the motion.
    #[test]
    fn with_both_lines_held_nothing_moves_and_with_the_hoist_held_the_lengths_add_up() {
        let held = Motion { rate: 0.0, acceleration: 0.0 };
        let ropes = RIG.at(0.8);
        assert_eq!(ropes.suspension(ropes.boom(held), held), held);
        let boom = ropes.boom(Motion { rate: 0.1, acceleration: 0.3 });
        let suspension = ropes.suspension(boom, held);
        // l + B is constant: B over time to the fourth order.
        let h = 1e-3;
        let at = |t: f64| distance(RIG.sheave, 0.8 + boom.rate * t + 0.5 * boom.acceleration * t * t);
        let first = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
        let second = (16.0 * (at(h) + at(-h)) - (at(2.0 * h) + at(-2.0 * h)) - 30.0 * at(0.0)) / (12.0 * h * h);
        assert!((suspension.rate + first).abs() < 1e-11);
        assert!((suspension.acceleration + second).abs() < 1e-8);
    }

    #[test]
    fn beyond_the_dead_angles_ropes_stay_finite() {
        for luff in [-1e300, RIG.jib_angle - core::f64::consts::PI, RIG.jib_angle, 1e300] {
            let equal = Rigging { jib: RIG.boom, sheave: RIG.boom, ..RIG };
            for rig in [RIG, equal] {
                let boom = rig.at(luff).boom(Motion { rate: 1.0, acceleration: 1.0 });
                assert!(boom.rate > 0.0 && boom.rate < 1e4 && boom.acceleration.is_finite(), "{boom:?} at {luff}");
                assert!(rig.from_dead_angles(luff).iter().any(|way| *way <= 0.0));
            }
        }
        assert!(RIG.from_dead_angles(0.8).iter().all(|way| *way > 0.0));
    }
}
