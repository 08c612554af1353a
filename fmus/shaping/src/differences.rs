//! Divided differences of what an impulse train answers at a frequency, regular where the points meet.

use nalgebra::Complex;

/// Divided differences over one point, over two and so on, points being counted from w = 1:
/// F[w₀ … wₘ] = Σⱼ M_{m+j} hⱼ(δ₀ … δₘ), Mₖ = ΣAᵢ e^{μᵢ} μᵢᵏ/k!, with the complete homogeneous polynomials hⱼ. They are those of
/// e^{−rxₙ/2} e^{−κwxₙ/2} F, which has the same zeros: counting times from the train's middle, μ = κ(x − xₙ/2), keeps the terms small.
#[derive(Clone)]
pub(crate) struct Differences {
    moments: [Complex<f64>; TERMS],
    polynomials: [f64; TERMS],
    points: usize,
}

/// Terms of the series: where |μδ| is at most [`FARTHEST`], those left out are below 12⁶⁴/64! = 1e-20.
const TERMS: usize = 64;

/// Farther zeros |μδ| are not resolved: rounding of the series is up to e¹² roundings of its sum.
pub(crate) const FARTHEST: f64 = 12.0;

impl Differences {
    /// For impulses with the given phases and amplitudes.
    pub fn new(r: f64, phases: &[f64], amplitudes: &[f64]) -> Self {
        let kappa = Complex::new(r, 1.0);
        let end = phases[phases.len() - 1];
        let mut moments = [Complex::ZERO; TERMS];
        for (phase, amplitude) in phases.iter().zip(amplitudes) {
            let mu = kappa * (*phase - 0.5 * end);
            let mut term = (mu - 0.5 * r * end).exp() * amplitude;
            for (k, moment) in (1..).zip(&mut moments) {
                *moment += term;
                term *= mu / f64::from(k);
            }
        }
        let mut polynomials = [0.0; TERMS];
        polynomials[0] = 1.0;
        Self { moments, polynomials, points: 0 }
    }

    /// The difference over all points so far and this one: hⱼ(δ₀ … δₘ) = hⱼ(δ₀ … δₘ₋₁) + δₘ hⱼ₋₁(δ₀ … δₘ).
    pub fn over(&mut self, point: f64) -> Complex<f64> {
        let mut before = 0.0;
        for polynomial in &mut self.polynomials {
            *polynomial += point * before;
            before = *polynomial;
        }
        let later = &self.moments[self.points..];
        self.points += 1;
        later.iter().zip(&self.polynomials).map(|(moment, polynomial)| moment * *polynomial).sum()
    }
}
