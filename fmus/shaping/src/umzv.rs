//! UMZV with damping: impulses +1, −1, +1 whose times are solved for.

use std::f64::consts::PI;

use nalgebra::Complex;

use crate::{DesignError, Kind, Mode, Shaper};

/// Solves 1 − e^{s̄t₂} + e^{s̄t₃} = 0 with s̄ = ζω + jω_d, thesis (1.3) at ζ = 0.
///
/// With θ = ω_d t, κ = r + j, r = ζω/ω_d and u = e^{−κθ₂} the equation reads e^{κ(θ₃−θ₂)} = 1 − u. Its argument gives
/// θ₃ = θ₂ + arg(1 − u); its modulus then leaves one real equation for θ₂,
///
/// g(θ₂) = ln|1 − u| − r arg(1 − u) = 0, with g′ = −(1 + r²) Im u / |1 − u|².
///
/// On 0 < θ₂ < π, Im u = −e^{−rθ₂} sin θ₂ is negative, so g rises from −∞ to ln(1 + e^{−rπ}) > 0: there is exactly one root for
/// every damping. Newton starts from the published fit and a bracket keeps it in the interval. As ζ → 1, t₃ − t₂ falls to nothing;
/// beyond ζ ≈ 0.995 it is lost in rounding, and that is an error.
pub(crate) fn design(mode: Mode) -> Result<Shaper, DesignError> {
    let (zeta, r) = (mode.damping_ratio(), mode.decay_angle());
    if zeta == 0.0 {
        let sixth = mode.period() / 6.0;
        return Ok(train(sixth, 2.0 * sixth));
    }
    let fit = 0.16658 + zeta * (0.29277 + zeta * (0.075438 + zeta * 0.21335));
    let (mut low, mut high) = (0.0, PI);
    let mut theta = fit * mode.period() * mode.damped_frequency();
    for _ in 0..MAX_ITERATIONS {
        if !(low < theta && theta < high) {
            theta = 0.5 * (low + high);
        }
        let u = phasor(theta, r);
        let rest = (-2.0 * u.re + u.norm_sqr()).ln_1p(); // ln|1 − u|², exact for small u
        let g = 0.5 * rest - r * argument(u);
        let step = g * rest.exp() / ((1.0 + r * r) * u.im);
        if step.abs() <= STEP_TOLERANCE * theta {
            let second = theta + step;
            let third = second + argument(phasor(second, r));
            let per_radian = 1.0 / mode.damped_frequency();
            let (second, third) = (second * per_radian, third * per_radian);
            if second < third {
                return Ok(train(second, third));
            }
            break;
        }
        if g < 0.0 {
            low = theta;
        } else {
            high = theta;
        }
        theta += step;
    }
    Err(DesignError::NoSolution {
        kind: Kind::UMZV,
        damping_ratio: zeta,
        vibration_limit: None,
        nearest_damping_ratio: Some(RESOLVED),
    })
}

/// A damping ratio up to which t₃ − t₂ is not lost in rounding.
const RESOLVED: f64 = 0.99;

/// Newton needs four iterations from the fit; bisection of the whole bracket needs fifty.
const MAX_ITERATIONS: usize = 100;

/// Newton converges quadratically: after a step this small the root is exact to rounding.
const STEP_TOLERANCE: f64 = 1e-9;

/// u = e^{−κθ}
fn phasor(theta: f64, r: f64) -> Complex<f64> {
    Complex::from_polar((-r * theta).exp(), -theta)
}

/// arg(1 − u) = ω_d (t₃ − t₂)
fn argument(u: Complex<f64>) -> f64 {
    (-u.im).atan2(1.0 - u.re)
}

fn train(second: f64, third: f64) -> Shaper {
    Shaper::of([(0.0, 1.0), (second, -1.0), (third, 1.0)])
}
