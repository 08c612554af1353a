//! A lightly damped mode on a moving base, such as a flexible rod on a carriage (thesis 5.3).

use swayless_scalar::Scalar;

/// A mode of vibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode<R: Scalar> {
    /// ω (rad/s).
    pub frequency: R,
    /// ζ.
    pub damping_ratio: R,
}

/// Where a mode is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeState<R: Scalar> {
    /// y, relative to the base (m).
    pub deflection: R,
    /// p = ẏ + v, relative to the ground (m/s). A jump of the base's velocity v leaves it as it is.
    pub velocity: R,
}

impl<R: Scalar> ModeState<R> {
    /// ẏ = p − v, for the base's velocity v (m/s).
    pub fn rate(&self, base: R) -> R {
        self.velocity - base
    }
}

impl<R: Scalar> Mode<R> {
    /// ẏ = p − v, ṗ = −2ζω ẏ − ω² y: that is ÿ + 2ζω ẏ + ω² y = −v̇ without an acceleration in it.
    pub fn rates(&self, state: &ModeState<R>, base: R) -> ModeState<R> {
        let (omega, rate) = (self.frequency, state.rate(base));
        let pull = rate * self.damping_ratio * omega * 2.0 + state.deflection * omega * omega;
        ModeState { deflection: rate, velocity: -pull }
    }

    /// √(y² + ẏ²/ω²): what the mode would swing with if the base kept its velocity and nothing were damped.
    pub fn amplitude(&self, state: &ModeState<R>, base: R) -> R {
        let turned = state.rate(base) / self.frequency;
        (state.deflection * state.deflection + turned * turned).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// d/dt ½(ẏ² + ω² y²) = −2ζω ẏ² on a base that moves evenly, and ÿ = ṗ there.
    #[test]
    fn energy_goes_into_damping_alone() {
        for (omega, zeta, y, p, base) in
            [(6.3, 0.01, 0.2, -0.4, 0.1), (25.0, 0.3, -0.05, 0.7, -2.0), (1.0, 0.0, 1.0, 1.0, 0.5)]
        {
            let mode = Mode { frequency: omega, damping_ratio: zeta };
            let state = ModeState { deflection: y, velocity: p };
            let change = mode.rates(&state, base);
            let rate = p - base;
            assert_eq!(change.deflection, rate);
            let power = rate * change.velocity + omega * omega * y * change.deflection;
            let lost = 2.0 * zeta * omega * rate * rate;
            assert!((power + lost).abs() < 1e-13 * omega * omega, "{power} and {lost}");
            let energy = 0.5 * (rate * rate + omega * omega * y * y);
            let amplitude = mode.amplitude(&state, base);
            assert!((0.5 * (omega * amplitude).powi(2) / energy - 1.0).abs() < 1e-14);
        }
    }
}
