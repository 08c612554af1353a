//! EI with damping: the extra-insensitive shaper, solved rather than fitted.
//!
//! Three impulses 1 − A₂ − A₃, A₂, A₃ at 0, t₂, T_d. At the design frequency ω₀ they leave just the vibration allowed; at one
//! frequency below and one above, both with the mode's damping ratio, they leave none. With κ = r + j, r = ζω/ω_d, phases
//! x = ω_d t (so x₃ = 2π) and frequencies w in units of ω₀, the train answers with
//!
//! F(w) = A₁ + A₂ e^{κwx₂} + A₃ e^{κwx₃},  V(w) = e^{−rwx₃} |F(w)|.
//!
//! Five real equations for the five unknowns A₂, A₃, x₂, m, q, the zeros being at w = m ± √q:
//!
//! - F(m + √q) + F(m − √q) = 0, complex;
//! - F(m + √q) − F(m − √q) = 0, complex, divided by 2κ√q so that it stays regular where the zeros meet (q → 0 as V → 0; the
//!   shaper is then ZVD) and so that everything is a smooth function of q;
//! - V(1) = V_lim, with the sign of Re(F(1)/−κ²), the side on which F(1) lies when it is inside the two zeros (q > 0).
//!
//! These are the conditions behind the published fits (t₃ = T_d is theirs). Without damping they reduce to the amplitudes
//! (1 + V)/4, (1 − V)/2, (1 + V)/4 at 0, T/2, T. With damping the hump of V between the zeros peaks slightly beside ω₀ and
//! slightly above V_lim: by 0.06 % of it at ζ = 0.1, 1.1 % at ζ = 0.3 (V_lim = 5 %).

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, SMatrix, SVector};

use crate::continuation::{Pace, confirmed};
use crate::even::Even;
use crate::{DesignError, Kind, Mode, Shaper, binomial};

pub(crate) fn design(mode: Mode, limit: f64) -> Result<Shaper, DesignError> {
    if !(0.0..1.0).contains(&limit) {
        return Err(DesignError::VibrationLimit { value: limit });
    }
    if limit == 0.0 {
        return Ok(binomial::design::<3>(mode));
    }
    let zeta = mode.damping_ratio();
    let solution = if zeta == 0.0 {
        undamped(limit)
    } else {
        solve(zeta, limit).map_err(|nearest| DesignError::NoSolution {
            kind: Kind::EI,
            damping_ratio: zeta,
            vibration_limit: Some(limit),
            nearest_damping_ratio: Some(confirmed(nearest, |zeta| solve(zeta, limit))),
        })?
    };
    let [a2, a3, x2, ..] = solution.0;
    let t2 = x2 / mode.damped_frequency();
    Ok(Shaper::of([(0.0, 1.0 - a2 - a3), (t2, a2), (mode.damped_period(), a3)]))
}

/// A₂, A₃, x₂ = ω_d t₂, m, q
#[derive(Clone, Copy)]
struct Unknowns([f64; 5]);

fn solve(zeta: f64, limit: f64) -> Result<Unknowns, f64> {
    newton(fit(zeta, limit), zeta, limit).map_or_else(|| continuation(zeta, limit), Ok)
}

/// The undamped shaper: V(w) = |(1 − V)/2 + (1 + V)/2 cos πw| is 0 where cos πw = −(1 − V)/(1 + V).
fn undamped(limit: f64) -> Unknowns {
    let spread = half_spread(limit);
    Unknowns([0.5 * (1.0 - limit), 0.25 * (1.0 + limit), PI, 1.0, spread * spread])
}

fn half_spread(limit: f64) -> f64 {
    // acos((1 − V)/(1 + V)) = 2 atan √V, exact for small V as well
    2.0 * limit.sqrt().atan() / PI
}

/// The published fits, less what they give for V = 0, where the shaper is known: it is ZVD.
fn fit(z: f64, v: f64) -> Unknowns {
    let k = (-PI * z / ((1.0 - z) * (1.0 + z)).sqrt()).exp();
    let whole = (1.0 + k) * (1.0 + k);
    let a1 = 1.0 / whole + v * (0.249623 + z * (1.23328 + z * 3.17316));
    let a3 = k * k / whole + v * (0.21474 + z * (1.41498 - z * 4.90094));
    let t2 =
        0.5 + v * z * (0.461586 + z * (4.26169 + z * 1.75601)) + v * v * z * (8.57843 + z * (-108.644 + z * 336.989));
    let spread = half_spread(v) * (1.0 + z); // the zeros move apart with damping
    Unknowns([1.0 - a1 - a3, a3, TAU * t2, 1.0, spread * spread])
}

/// Follows the solution from ζ = 0, where it is known. Where it ends before, the last damping ratio that has one.
fn continuation(zeta: f64, limit: f64) -> Result<Unknowns, f64> {
    let pace = Pace { first: 0.25 * zeta, growth: 1.5, shrinkage: 0.5, finest: 1e-4, most: 200 };
    let start = SVector::from(undamped(limit).0);
    let solve =
        |guess: &SVector<f64, 5>, zeta| newton(Unknowns((*guess).into()), zeta, limit).map(|found| found.0.into());
    pace.follow(zeta, |_| start, solve).map(|solution| Unknowns(solution.into()))
}

/// Newton's method; `None` unless it ends at a shaper, that is at positive impulses in order, the design frequency between
/// the two zeros.
fn newton(start: Unknowns, zeta: f64, limit: f64) -> Option<Unknowns> {
    let system = System::new(zeta, limit);
    let mut unknowns = SVector::<f64, 5>::from(start.0);
    let mut last = f64::INFINITY;
    for _ in 0..30 {
        let (residual, jacobian) = system.at(&unknowns);
        let size = residual.amax();
        if size <= TOLERANCE && size >= 0.5 * last {
            break; // rounding is all that is left
        }
        last = size;
        let step = jacobian.lu().solve(&residual)?;
        unknowns -= step;
        if !unknowns.iter().all(|value| value.abs() < 100.0) {
            return None;
        }
    }
    let [a2, a3, x2, m, q] = unknowns.into();
    let (residual, _) = system.at(&unknowns);
    let positive = a2 > 0.0 && a3 > 0.0 && a2 + a3 < 1.0;
    let inside = q > 0.0 && (1.0 - m).abs() < q.sqrt() && m > q.sqrt();
    (residual.amax() <= TOLERANCE && positive && inside && 0.0 < x2 && x2 < TAU).then_some(Unknowns([a2, a3, x2, m, q]))
}

/// Largest constraint residual accepted, in units of V.
const TOLERANCE: f64 = 1e-12;

/// The five equations, all scaled by e^{−2πr}, which is V's own factor e^{−ζωt₃} at the design frequency.
struct System {
    kappa: Complex<f64>,
    scale: f64,
    limit: f64,
}

impl System {
    fn new(zeta: f64, limit: f64) -> Self {
        let r = zeta / ((1.0 - zeta) * (1.0 + zeta)).sqrt();
        Self { kappa: Complex::new(r, 1.0), scale: (-TAU * r).exp(), limit }
    }

    /// Residuals and their derivatives with respect to the unknowns.
    fn at(&self, unknowns: &SVector<f64, 5>) -> (SVector<f64, 5>, SMatrix<f64, 5, 5>) {
        let &[a2, a3, x2, m, q] = unknowns.as_ref();
        let kappa = self.kappa;
        let second = Impulse::at(kappa, x2, m, q);
        let third = Impulse::at(kappa, TAU, m, q);

        let sum = (second.sum * a2 + third.sum * a3 + (1.0 - a2 - a3)) * self.scale;
        let difference = (second.difference * a2 + third.difference * a3) * self.scale;
        let (e2, e3) = ((kappa * x2).exp(), (kappa * TAU).exp());
        let middle = (e2 * a2 + e3 * a3 + (1.0 - a2 - a3)) * self.scale;

        // |F(1)| with its sign, and the direction in which it grows
        let side = if (middle * (-kappa * kappa).conj()).re < 0.0 { -1.0 } else { 1.0 };
        let size = middle.norm();
        let direction = if size > 0.0 { middle.conj() * (side / size) } else { Complex::ONE };

        let columns = [
            ((second.sum - 1.0), second.difference, e2 - 1.0),
            ((third.sum - 1.0), third.difference, e3 - 1.0),
            (second.sum_by_x * a2, second.difference_by_x * a2, kappa * e2 * a2),
            (
                second.sum_by_m * a2 + third.sum_by_m * a3,
                second.difference_by_m * a2 + third.difference_by_m * a3,
                Complex::ZERO,
            ),
            (
                second.sum_by_q * a2 + third.sum_by_q * a3,
                second.difference_by_q * a2 + third.difference_by_q * a3,
                Complex::ZERO,
            ),
        ];
        let residual = SVector::from([sum.re, sum.im, difference.re, difference.im, side * size - self.limit]);
        let jacobian = columns.map(|(sum, difference, middle)| {
            [sum.re, sum.im, difference.re, difference.im, (direction * middle).re].map(|entry| entry * self.scale)
        });
        (residual, SMatrix::from(jacobian))
    }
}

/// What an impulse at phase x contributes to the equations at the zeros m ± p, p² = q, with its derivatives:
/// sum = (e^{κ(m+p)x} + e^{κ(m−p)x})/2 and difference = (e^{κ(m+p)x} − e^{κ(m−p)x})/(2κp).
struct Impulse {
    sum: Complex<f64>,
    difference: Complex<f64>,
    sum_by_x: Complex<f64>,
    difference_by_x: Complex<f64>,
    sum_by_m: Complex<f64>,
    difference_by_m: Complex<f64>,
    sum_by_q: Complex<f64>,
    difference_by_q: Complex<f64>,
}

impl Impulse {
    fn at(kappa: Complex<f64>, x: f64, m: f64, q: f64) -> Self {
        let square = kappa * kappa;
        let even = Even::at(square * (q * x * x));
        let centre = (kappa * (m * x)).exp();
        let (sum, difference) = (centre * even.cosh, centre * even.sinhc * x);
        Self {
            sum,
            difference,
            sum_by_x: kappa * m * sum + square * q * difference,
            difference_by_x: kappa * m * difference + sum,
            sum_by_m: kappa * x * sum,
            difference_by_m: kappa * x * difference,
            sum_by_q: square * difference * (0.5 * x),
            difference_by_q: square * centre * even.sinhc_slope * x.powi(3),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn largest_difference(a: Unknowns, b: Unknowns) -> f64 {
        a.0.iter().zip(b.0).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// The fit might lead to another solution than the one that grows out of the undamped shaper.
    #[test]
    fn fit_and_continuation_lead_to_the_same_shaper() {
        for limit in [0.001, 0.01, 0.05, 0.1, 0.2] {
            for zeta in [1e-6, 0.01, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3] {
                // only limits much above those that the fit was made for need the continuation
                let Some(fitted) = newton(fit(zeta, limit), zeta, limit) else {
                    assert!(limit > 0.1, "ζ = {zeta}, V = {limit}");
                    continue;
                };
                let followed = continuation(zeta, limit).unwrap();
                assert!(largest_difference(fitted, followed) < 1e-9, "ζ = {zeta}, V = {limit}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_equations() {
        let system = System::new(0.1, 0.05);
        let at = SVector::from([0.4, 0.2, 3.2, 1.01, 0.03]);
        let (_, jacobian) = system.at(&at);
        for unknown in 0..5 {
            let step = 1e-5;
            let moved = |by: f64| {
                let mut at = at;
                at[unknown] += by;
                system.at(&at).0
            };
            // central difference: error ~ step² times a third derivative of about 60
            let slope = (moved(step) - moved(-step)) / (2.0 * step);
            assert!((slope - jacobian.column(unknown)).amax() < 1e-8, "unknown {unknown}");
        }
    }
}
