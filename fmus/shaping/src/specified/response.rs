//! What one impulse leaves of the vibration, as a function of its place in the train.

use nalgebra::Complex;

use crate::mode::damped_share;

/// e(ω, τ), so that V(ω) = |Σ xₖ e(ω, τₖ)| for impulses xₖ ≥ 0 at places τₖ.
#[derive(Clone, Copy)]
pub(crate) enum Response {
    /// Without damping, for a train that is symmetric in time: e = cos ωτ, τ the distance from the centre; xₖ is shared by
    /// the impulses at ±τₖ.
    Symmetric,
    /// With damping somewhere: e = e^{−κωτ}, κ = ζ + j√(1 − ζ²), τ the time before the last impulse.
    Damped(Complex<f64>),
}

impl Response {
    pub fn damped(damping_ratio: f64) -> Self {
        Self::Damped(Complex::new(damping_ratio, damped_share(damping_ratio)))
    }

    pub fn value(self, omega: f64, tau: f64) -> Complex<f64> {
        match self {
            Self::Symmetric => Complex::new((omega * tau).cos(), 0.0),
            Self::Damped(kappa) => (-kappa * (omega * tau)).exp(),
        }
    }

    /// How many times longer than the largest τ the train is.
    pub fn duration_per_place(self) -> f64 {
        match self {
            Self::Symmetric => 2.0,
            Self::Damped(_) => 1.0,
        }
    }

    pub fn derivatives(self, omega: f64, tau: f64) -> Derivatives {
        match self {
            Self::Symmetric => {
                let (sin, cos) = (omega * tau).sin_cos();
                let real = |value| Complex::new(value, 0.0);
                Derivatives {
                    value: real(cos),
                    by_tau: real(-omega * sin),
                    by_omega: real(-tau * sin),
                    by_tau_tau: real(-omega * omega * cos),
                    by_omega_tau: real(-sin - omega * tau * cos),
                    by_omega_omega: real(-tau * tau * cos),
                }
            }
            Self::Damped(kappa) => {
                let value = self.value(omega, tau);
                let square = kappa * kappa * value;
                Derivatives {
                    value,
                    by_tau: -kappa * value * omega,
                    by_omega: -kappa * value * tau,
                    by_tau_tau: square * (omega * omega),
                    by_omega_tau: square * (omega * tau) - kappa * value,
                    by_omega_omega: square * (tau * tau),
                }
            }
        }
    }
}

/// e and its derivatives.
#[derive(Clone, Copy)]
pub(crate) struct Derivatives {
    pub value: Complex<f64>,
    pub by_tau: Complex<f64>,
    pub by_omega: Complex<f64>,
    pub by_tau_tau: Complex<f64>,
    pub by_omega_tau: Complex<f64>,
    pub by_omega_omega: Complex<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_response() {
        const STEP: f64 = 1e-5;
        for response in [Response::Symmetric, Response::damped(0.2)] {
            let at = |omega, tau| response.derivatives(omega, tau);
            let here = at(0.9, 2.3);
            assert_eq!(here.value, response.value(0.9, 2.3));
            // central differences of values and slopes below 10: error ~ STEP² and rounding ~ 1e-16/STEP
            let by_tau = |part: fn(&Derivatives) -> Complex<f64>| {
                (part(&at(0.9, 2.3 + STEP)) - part(&at(0.9, 2.3 - STEP))) / (2.0 * STEP)
            };
            let by_omega = |part: fn(&Derivatives) -> Complex<f64>| {
                (part(&at(0.9 + STEP, 2.3)) - part(&at(0.9 - STEP, 2.3))) / (2.0 * STEP)
            };
            for (derivative, difference) in [
                (here.by_tau, by_tau(|e| e.value)),
                (here.by_omega, by_omega(|e| e.value)),
                (here.by_tau_tau, by_tau(|e| e.by_tau)),
                (here.by_omega_tau, by_tau(|e| e.by_omega)),
                (here.by_omega_omega, by_omega(|e| e.by_omega)),
            ] {
                assert!((derivative - difference).norm() < 1e-8, "{derivative} {difference}");
            }
        }
    }
}
