//! The frequencies with which suspended loads swing.

/// Frequency ω = √(g/ℓ) in rad/s of a load on a cable of length ℓ (m) under gravity g (m/s²).
#[must_use]
pub fn pendulum(gravity: f64, length: f64) -> f64 {
    (gravity / length).sqrt()
}

/// Frequencies in rad/s, the lower first, of a hook on a cable of length ℓ (m) with a payload on a rigging of length ℓₚ (m)
/// below it, whose mass is M times the hook's (6.3, 6.4):
///
/// ω² = (g/2)[(1 + M)(1/ℓ + 1/ℓₚ) ∓ β], β² = (1 + M)²(1/ℓ + 1/ℓₚ)² − 4(1 + M)/(ℓℓₚ).
#[must_use]
pub fn double_pendulum(gravity: f64, length: f64, rigging_length: f64, mass_ratio: f64) -> [f64; 2] {
    let (hook, rigging) = (1.0 / length, 1.0 / rigging_length);
    let total = 1.0 + mass_ratio;
    // β² without its cancellation, and ω₁ from ω₁ω₂ = g√((1 + M)/(ℓℓₚ)) without the other
    let beta = (total * ((hook - rigging).powi(2) + mass_ratio * (hook + rigging).powi(2))).sqrt();
    let higher = (0.5 * gravity * (total * (hook + rigging) + beta)).sqrt();
    [gravity * (total * hook * rigging).sqrt() / higher, higher]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The linearised equations of motion (6.2) for θ_h and θ_p have the determinant ω⁴ − (a + d)ω² + ad − bc.
    #[test]
    fn double_pendulum_frequencies_solve_the_equations_of_motion() {
        for (length, rigging, ratio) in
            [(8.0, 3.0, 0.5), (6.0, 4.0, 2.0), (3.5, 1.8, 0.227), (5.0, 5.0, 1e-6), (40.0, 0.5, 9.0)]
        {
            let g = 9.81;
            let (a, b) = (g / length, -g * ratio / length);
            let (c, d) = (-g / length, g / rigging + g * ratio / rigging + g * ratio / length);
            let [low, high] = double_pendulum(g, length, rigging, ratio);
            assert!(low < high);
            for frequency in [low, high] {
                let square = frequency * frequency;
                let terms = [square * square, (a + d) * square, a * d, b * c];
                let determinant = terms[0] - terms[1] + terms[2] - terms[3];
                assert!(determinant.abs() <= 1e-14 * terms[1], "{determinant:e}");
            }
        }
        let [low, high] = double_pendulum(9.81, 8.0, 3.0, 0.5);
        assert!((low - 1.0284).abs() < 5e-5 && (high - 2.3847).abs() < 5e-5, "{low} {high}");
    }

    #[test]
    fn a_light_payload_leaves_the_hook_as_it_is() {
        let [low, high] = double_pendulum(9.81, 10.0, 2.0, 0.0);
        assert!((low - pendulum(9.81, 10.0)).abs() < 1e-15 && (high - pendulum(9.81, 2.0)).abs() < 1e-15);
    }
}
