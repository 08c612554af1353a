//! The vibratory mode that a shaper is designed for.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use crate::ModeError;

/// A second-order mode, s² + 2ζωs + ω² = 0, underdamped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    frequency: f64,
    damping_ratio: f64,
}

impl Mode {
    /// A mode with its undamped natural frequency ω in rad/s and its damping ratio ζ.
    ///
    /// # Errors
    /// [`ModeError`] unless ω is finite and greater than 0 and 0 ≤ ζ < 1. A frequency so extreme that a period is no longer
    /// a normal number is refused, too.
    pub fn new(frequency: f64, damping_ratio: f64) -> Result<Self, ModeError> {
        if !(0.0..1.0).contains(&damping_ratio) {
            return Err(ModeError::DampingRatio { value: damping_ratio });
        }
        let mode = Self { frequency, damping_ratio };
        // So that a train's times are numbers, too, and none of them subnormal.
        let usable = frequency > 0.0 && frequency.is_finite();
        if !(usable && (1e-3 * mode.damped_period()).is_normal() && (1e3 * mode.damped_period()).is_finite()) {
            return Err(ModeError::Frequency { value: frequency });
        }
        Ok(mode)
    }

    /// Undamped natural frequency ω in rad/s.
    #[must_use]
    pub fn frequency(self) -> f64 {
        self.frequency
    }

    /// Damping ratio ζ.
    #[must_use]
    pub fn damping_ratio(self) -> f64 {
        self.damping_ratio
    }

    /// Damped natural frequency ω_d = ω√(1 − ζ²) in rad/s.
    #[must_use]
    pub fn damped_frequency(self) -> f64 {
        self.frequency * damped_share(self.damping_ratio)
    }

    /// Undamped period T = 2π/ω in seconds.
    #[must_use]
    pub fn period(self) -> f64 {
        TAU / self.frequency
    }

    /// Damped period T_d = 2π/ω_d in seconds.
    #[must_use]
    pub fn damped_period(self) -> f64 {
        TAU / self.damped_frequency()
    }

    /// K = exp(−ζπ/√(1 − ζ²)): what is left of an oscillation's amplitude after half a damped period.
    #[must_use]
    pub fn half_period_decay(self) -> f64 {
        (-PI * self.decay_angle()).exp()
    }

    /// The mode with the same damping ratio at 1 rad/s.
    pub(crate) fn at_unit_frequency(self) -> Self {
        self.in_units_of(self.frequency)
    }

    /// The same mode with that frequency as the unit of frequency.
    pub(crate) fn in_units_of(self, frequency: f64) -> Self {
        Self { frequency: self.frequency / frequency, ..self }
    }

    /// The same mode without its damping.
    pub(crate) fn undamped(self) -> Self {
        Self { damping_ratio: 0.0, ..self }
    }

    /// σ = ζω + jω_d with that share of the damping ratio: an impulse's vibration dies away and turns as e^{−σt}.
    pub(crate) fn rate(self, share: f64) -> Complex<f64> {
        let damping_ratio = share * self.damping_ratio;
        Complex::new(damping_ratio, damped_share(damping_ratio)) * self.frequency
    }

    /// r = ζω/ω_d = ζ/√(1 − ζ²): the decay per radian of damped oscillation.
    pub(crate) fn decay_angle(self) -> f64 {
        self.damping_ratio / damped_share(self.damping_ratio)
    }
}

/// √(1 − ζ²), without the cancellation of 1 − ζ² next to 1.
pub(crate) fn damped_share(damping_ratio: f64) -> f64 {
    ((1.0 - damping_ratio) * (1.0 + damping_ratio)).sqrt()
}
