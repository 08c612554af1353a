//! How much vibration a shaper leaves, at one frequency and over a range.

use std::ops::RangeInclusive;

use nalgebra::Complex;

use crate::Shaper;
use crate::mode::damped_share;
use crate::specified::minima;

/// Residual vibration V(ω, ζ) of a mode after the shaper's last impulse, as a share of what one impulse of amplitude 1 leaves:
///
/// V = e^{−ζωtₙ} √(C² + S²), C = ΣAᵢ e^{ζωtᵢ} cos ω_d tᵢ, S = ΣAᵢ e^{ζωtᵢ} sin ω_d tᵢ, ω_d = ω√(1 − ζ²).
///
/// `frequency` is the undamped ω in rad/s, at least 0; `damping_ratio` is ζ, at least 0 and less than 1. Outside of that
/// the result is NaN or meaningless.
#[must_use]
pub fn residual_vibration(shaper: &Shaper, frequency: f64, damping_ratio: f64) -> f64 {
    Residual::new(shaper, damping_ratio, 1.0).vibration(frequency)
}

/// One point of a sensitivity curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Undamped frequency of the mode, rad/s.
    pub frequency: f64,
    /// Its residual vibration V.
    pub vibration: f64,
}

/// The sensitivity curve: V at `points` equidistant frequencies (rad/s), both ends of the range included.
pub fn sensitivity_curve(
    shaper: &Shaper,
    damping_ratio: f64,
    frequencies: RangeInclusive<f64>,
    points: usize,
) -> impl ExactSizeIterator<Item = Sensitivity> {
    let residual = Residual::new(shaper, damping_ratio, 1.0);
    let (first, last) = frequencies.into_inner();
    let intervals = points.saturating_sub(1).max(1) as f64;
    (0..points).map(move |point| {
        let share = point as f64 / intervals;
        let frequency = first * (1.0 - share) + last * share;
        Sensitivity { frequency, vibration: residual.vibration(frequency) }
    })
}

/// Where V is highest over a range of frequencies (rad/s, at least 0), all with the same damping ratio.
///
/// The curve is sampled ten times per radian that the last impulse's phase turns by: time and memory grow with the range.
#[must_use]
pub fn highest_vibration(shaper: &Shaper, damping_ratio: f64, frequencies: RangeInclusive<f64>) -> Sensitivity {
    let residual = Residual::new(shaper, damping_ratio, 1.0);
    let first = *frequencies.start();
    let points = 16 + (10.0 * (frequencies.end() - first) * shaper.duration()) as usize;
    // The minima of −V² are the humps, and the ends where V falls from there.
    let humps = minima(frequencies, points, |frequency| {
        let [value, slope, curvature] = residual.derivatives(frequency);
        let bend = slope.norm_sqr() + (curvature * value.conj()).re;
        [-value.norm_sqr(), -2.0 * (slope * value.conj()).re, -2.0 * bend]
    });
    let highest = humps.into_iter().min_by(|(_, [a, ..]), (_, [b, ..])| a.total_cmp(b));
    let frequency = highest.map_or(first, |(frequency, _)| frequency);
    Sensitivity { frequency, vibration: residual.vibration(frequency) }
}

/// f(ω) = ΣAᵢ e^{κᵢω} with κᵢ = (ζ + j√(1 − ζ²))(tᵢ − tₙ): V = |f|, and no exponent is positive. ω is in units of `unit`.
pub(crate) struct Residual<'a> {
    shaper: &'a Shaper,
    rate: Complex<f64>,
    unit: f64,
}

impl<'a> Residual<'a> {
    pub fn new(shaper: &'a Shaper, damping_ratio: f64, unit: f64) -> Self {
        Self { shaper, rate: Complex::new(damping_ratio, damped_share(damping_ratio)), unit }
    }

    pub fn vibration(&self, frequency: f64) -> f64 {
        self.derivatives(frequency)[0].norm()
    }

    /// V² and its slope over ω.
    pub fn squared(&self, frequency: f64) -> (f64, f64) {
        let [value, slope, _] = self.derivatives(frequency);
        (value.norm_sqr(), 2.0 * (slope * value.conj()).re)
    }

    /// A bound on V over all frequencies: Σ|Aᵢ|.
    pub fn highest(&self) -> f64 {
        self.shaper.impulses().iter().map(|impulse| impulse.amplitude.abs()).sum()
    }

    /// A bound on |d²V²/dω²| over all frequencies from the given one up: as |κᵢ| = tₙ − tᵢ, it is 2B₁² + 2B₀B₂ with
    /// Bₖ = Σ|Aᵢ|(tₙ − tᵢ)ᵏ e^{−ζω(tₙ − tᵢ)}.
    pub fn curvature_bound(&self, frequency: f64) -> f64 {
        let end = self.shaper.duration();
        let [b0, b1, b2] = self.shaper.impulses().iter().fold([0.0; 3], |[b0, b1, b2], impulse| {
            let distance = (end - impulse.time) * self.unit;
            let size = impulse.amplitude.abs() * (-self.rate.re * frequency * distance).exp();
            [b0 + size, b1 + size * distance, b2 + size * distance * distance]
        });
        2.0 * b1 * b1 + 2.0 * b0 * b2
    }

    /// f with its first two derivatives over ω.
    fn derivatives(&self, frequency: f64) -> [Complex<f64>; 3] {
        let end = self.shaper.duration();
        self.shaper.impulses().iter().fold([Complex::ZERO; 3], |[value, slope, curvature], impulse| {
            let kappa = self.rate * ((impulse.time - end) * self.unit);
            let phasor = (kappa * frequency).exp() * impulse.amplitude;
            [value + phasor, slope + kappa * phasor, curvature + kappa * kappa * phasor]
        })
    }
}
