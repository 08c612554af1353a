//! What a command leaves and what it may leave.

use nalgebra::Complex;

use super::FLOOR;
use crate::specified::{Jet, Response};

/// Pulses of full acceleration, each from one place to another, in ascending order. Places are those of [`Response`]: distances from
/// the middle or from the end.
pub(super) type Command = Vec<[f64; 2]>;

/// Value and first two derivatives over frequency.
pub(super) type Answer = [Complex<f64>; 3];

#[derive(Clone, Copy)]
pub(super) struct Problem {
    pub response: Response,
    pub low: f64,
    pub high: f64,
    /// ∫u over the places.
    pub on_time: f64,
    pub limit: f64,
}

impl Problem {
    pub fn new(response: Response, low: f64, high: f64, on_time: f64, limit: f64) -> Self {
        Self { response, low, high, on_time, limit }
    }

    /// ∫e(ω, τ)dτ from 0 to a place, over the whole on-time. As it is a function of ωτ over ω, (ω∫e)′ = τe.
    pub fn integral(&self, omega: f64, place: f64) -> Answer {
        let e = self.response.derivatives(omega, place);
        let whole = match self.response {
            Response::Symmetric => Complex::from((omega * place).sin() / omega),
            Response::Damped(kappa) => (-(-kappa * (omega * place)).exp() + 1.0) / (kappa * omega),
        };
        let slope = (e.value * place - whole) / omega;
        let curvature = (e.by_omega * place - slope * 2.0) / omega;
        [whole, slope, curvature].map(|part| part / self.on_time)
    }

    /// What a command leaves, as a share of an ideal step.
    pub fn answer(&self, command: &Command, omega: f64) -> Answer {
        command.iter().fold([Complex::ZERO; 3], |sum, [from, to]| {
            let (on, off) = (self.integral(omega, *from), self.integral(omega, *to));
            std::array::from_fn(|i| sum[i] + off[i] - on[i])
        })
    }

    /// |B|² + ε², what the bare ramp counts for.
    pub fn level(&self, omega: f64) -> Jet {
        let [value, slope, curvature] = squared(self.integral(omega, self.on_time));
        [value + FLOOR * FLOOR, slope, curvature]
    }

    /// |F|²/(|B|² + ε²).
    pub fn ratio(&self, answer: Answer, omega: f64) -> Jet {
        let (q, n) = (squared(answer), self.level(omega));
        let value = q[0] / n[0];
        let slope = (q[1] - value * n[1]) / n[0];
        [value, slope, (q[2] - 2.0 * slope * n[1] - value * n[2]) / n[0]]
    }
}

fn squared([value, slope, curvature]: Answer) -> Jet {
    let part = |a: Complex<f64>, b: Complex<f64>| 2.0 * (a.conj() * b).re;
    [value.norm_sqr(), part(value, slope), part(slope, slope) + part(value, curvature)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_ratio() {
        const STEP: f64 = 1e-5;
        for response in [Response::Symmetric, Response::damped(0.2)] {
            let problem = Problem::new(response, 0.8, 1.2, 1.3, 0.05);
            let command = vec![[0.0, 0.5], [1.4, 2.0], [3.1, 3.3]];
            let at = |omega: f64| problem.ratio(problem.answer(&command, omega), omega);
            let (before, here, after) = (at(0.9 - STEP), at(0.9), at(0.9 + STEP));
            for order in [1, 2] {
                let difference = (after[order - 1] - before[order - 1]) / (2.0 * STEP);
                // central differences: error ~ STEP² and rounding ~ 1e-15/STEP
                assert!((here[order] - difference).abs() < 1e-8, "{} {difference}", here[order]);
            }
        }
    }
}
