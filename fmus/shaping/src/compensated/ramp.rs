//! UMZVc for the exact ramps of (5.25), without the assumption that each is over before the next begins.

use nalgebra::{Complex, Matrix2, Vector2};

use super::error::CompensatedError;
use crate::continuation::{Pace, confirmed};
use crate::mode::damped_share;
use crate::{Mode, Shaper};

/// Follows the times from UMZV, whose time constants are equal, in steps as large as Newton's method takes without leaving the
/// branch.
pub(super) fn train(mode: Mode, unity: &Shaper, growing: f64, falling: f64) -> Result<Shaper, CompensatedError> {
    let (omega, zeta) = (mode.frequency(), mode.damping_ratio());
    let pole = Complex::new(zeta, damped_share(zeta));
    let at = |share: f64| Ramps { pole, growing: growing * omega * share, falling: falling * omega * share };
    let start = Vector2::new(unity.impulses()[1].time * omega, unity.impulses()[2].time * omega);
    let near = |guess: &Vector2<f64>, share| at(share).newton(*guess).filter(|times| (times - guess).amax() < NEAR);
    // of that share of both time constants
    let solve = |whole: f64| {
        let follow = PACE.follow(1.0, |_| start, |guess, share| near(guess, whole * share));
        follow.map_err(|share| whole * share)
    };
    let times = solve(1.0).map_err(|share| CompensatedError::NotFound {
        damping_ratio: zeta,
        acceleration_time_constant: growing,
        braking_time_constant: falling,
        feasible_share: confirmed(share, solve),
    })?;
    Ok(Shaper::of([(0.0, 1.0), (times.x / omega, -1.0), (times.y / omega, 1.0)]))
}

/// Farther from the guess, in radians, it might be another branch.
const NEAR: f64 = 0.2;

/// Doubling takes it over all scales.
const PACE: Pace = Pace { first: 1.0, growth: 2.0, shrinkage: 0.5, finest: 1e-4, most: 300 };

/// All in units of 1/ω: σ = ζ + j√(1 − ζ²), ωτ_a, ωτ_b.
struct Ramps {
    pole: Complex<f64>,
    growing: f64,
    falling: f64,
}

impl Ramps {
    /// The mode's answer ∫v̇ e^{σt}dt to the whole train, times 1 − τ_aσ. With p = v(t₂) = 1 − e^{−t₂/τ_a}, q = v(t₃) =
    /// p e^{−(t₃−t₂)/τ_b} and the ramps of (5.25) between,
    ///
    /// 1 − e^{σt₂} + e^{σt₃} + c (p e^{σt₂} − q e^{σt₃}), c = σ(τ_a − τ_b)/(1 − τ_bσ),
    ///
    /// which is UMZV's for equal time constants; and its derivatives with respect to t₂ and t₃.
    fn at(&self, times: Vector2<f64>) -> (Complex<f64>, [Complex<f64>; 2]) {
        let sigma = self.pole;
        let c = sigma * (self.growing - self.falling) / (ONE - sigma * self.falling);
        let [e2, e3] = [times.x, times.y].map(|time| (sigma * time).exp());
        let rise = Decay::new(times.x, self.growing);
        let fall = Decay::new(times.y - times.x, self.falling);
        let p = rise.gone;
        let q = p * fall.left;
        let p2 = rise.rate;
        let q3 = -p * fall.rate;
        let q2 = p2 * fall.left - q3;
        let residual = ONE - e2 + e3 + c * (e2 * p - e3 * q);
        let by_second = -sigma * e2 + c * (e2 * p2 + sigma * e2 * p - e3 * q2);
        let by_third = sigma * e3 - c * (e3 * q3 + sigma * e3 * q);
        (residual, [by_second, by_third])
    }

    fn newton(&self, start: Vector2<f64>) -> Option<Vector2<f64>> {
        let mut times = start;
        let mut last = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            if !(0.0 < times.x && times.x < times.y && times.y < LATEST) {
                return None;
            }
            let (residual, [second, third]) = self.at(times);
            let size = residual.norm() * (-self.pole.re * times.y).exp();
            if size <= TOLERANCE && size >= 0.5 * last {
                return Some(times); // rounding is all that is left
            }
            last = size;
            let jacobian = Matrix2::new(second.re, third.re, second.im, third.im);
            times -= jacobian.try_inverse()? * Vector2::new(residual.re, residual.im);
        }
        None
    }
}

const ONE: Complex<f64> = Complex::ONE;

/// Newton converges in four or five iterations if at all.
const MAX_ITERATIONS: usize = 20;

/// Largest residual accepted, relative to one impulse's.
const TOLERANCE: f64 = 1e-12;

/// Times beyond two periods belong to another branch.
const LATEST: f64 = 12.6;

/// e^{−t/τ}, what that leaves of 1, and its rate e^{−t/τ}/τ, for τ = 0 as well.
struct Decay {
    left: f64,
    gone: f64,
    rate: f64,
}

impl Decay {
    fn new(time: f64, constant: f64) -> Self {
        let gone = -(-time / constant).exp_m1();
        let left = (-time / constant).exp();
        Self { left, gone, rate: if left > 0.0 { left / constant } else { 0.0 } }
    }
}
