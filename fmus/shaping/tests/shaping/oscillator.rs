//! Residual vibration against a damped oscillator that is struck by the impulses, carried on by the matrix exponential.

use nalgebra::{Matrix2, Vector2};
use swayless_shaping::{Kind, Shaper, residual_vibration};

use crate::designed;

/// Amplitude after the last impulse, ẍ + 2ζωẋ + ω²x = Σ Aᵢ δ(t − tᵢ), relative to one impulse of amplitude 1.
fn struck(shaper: &Shaper, omega: f64, zeta: f64) -> f64 {
    let system = Matrix2::new(0.0, 1.0, -omega * omega, -2.0 * zeta * omega);
    let (mut state, mut now) = (Vector2::zeros(), 0.0);
    for impulse in shaper.impulses() {
        state = (system * (impulse.time - now)).exp() * state;
        state.y += impulse.amplitude;
        now = impulse.time;
    }
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let amplitude = |state: Vector2<f64>| state.x.hypot((state.y + zeta * omega * state.x) / damped);
    amplitude(state) / amplitude(Vector2::new(0.0, 1.0))
}

#[test]
fn residual_vibration_is_what_a_struck_oscillator_keeps() {
    for kind in Kind::OF_A_MODE {
        for design_damping in [0.0, 0.05, 0.25] {
            let shaper = designed(kind, 1.7, design_damping);
            for (omega, zeta) in [(1.7, design_damping), (1.7, 0.0), (1.2, 0.1), (2.5, 0.02), (5.1, 0.3), (0.01, 0.6)] {
                let (formula, simulated) = (residual_vibration(&shaper, omega, zeta), struck(&shaper, omega, zeta));
                // the exponential of a 2 × 2 matrix of norm ~30 is good to about 1e-14 of its terms
                assert!((formula - simulated).abs() < 1e-12, "{kind} at {omega}, {zeta}: {formula} {simulated}");
            }
        }
    }
}

#[test]
fn shaped_oscillators_come_to_rest() {
    for kind in [Kind::ZV, Kind::ZVD, Kind::ZVDD, Kind::ZVDDD, Kind::UMZV, Kind::UMZVD] {
        for zeta in [0.0, 0.01, 0.1, 0.3, 0.6] {
            let left = struck(&designed(kind, 0.99, zeta), 0.99, zeta);
            assert!(left < 1e-13, "{kind} at ζ = {zeta}: {left:e}");
        }
    }
}
