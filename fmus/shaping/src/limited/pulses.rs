//! Three pulses of acceleration and what a mode answers, with Newton's method for a double zero.
//!
//! Pulse i has the share Aᵢ of the bare ramp, whose half length is h, and its middle dᵢ behind that of the first, all in phases
//! x = ω_d t. With κ = r + j, r = ζω/ω_d, at w times the mode's frequency and counted from the middle of the first,
//!
//! P(w) = Σ Aᵢ e^{κwdᵢ} σ(κwAᵢh), σ(z) = sinh z/z,
//!
//! a train of impulses for h = 0.

use std::f64::consts::TAU;

use nalgebra::{Complex, SMatrix, SVector};

use crate::even::Even;

/// A₁, A₃, d₂, d₃; A₂ = 1 − A₁ − A₃ and d₁ = 0.
#[derive(Clone, Copy)]
pub(super) struct Unknowns(pub SVector<f64, 4>);

impl Unknowns {
    fn amplitudes(&self) -> [f64; 3] {
        [self.0[0], 1.0 - self.0[0] - self.0[1], self.0[1]]
    }

    /// Phases at which the pulses start, and their shares; symmetric to the last bit if wanted.
    pub fn train(&self, half: f64, symmetric: bool) -> [[f64; 3]; 2] {
        let [mut first, mut second, mut third] = self.amplitudes();
        let (mut middle, end) = (self.0[2], self.0[3]);
        if symmetric {
            first = 0.5 * (first + third);
            third = first;
            second = 1.0 - 2.0 * first;
            middle = 0.5 * end;
        }
        [[0.0, middle + (first - second) * half, end + (first - third) * half], [first, second, third]]
    }

    /// Whether the shares are positive and the pulses apart.
    fn are_pulses(&self, half: f64) -> bool {
        let [first, second, third] = self.amplitudes();
        let (middle, end) = (self.0[2], self.0[3]);
        let positive = first > 0.0 && second > 0.0 && third > 0.0;
        positive && middle > (first + second) * half && end - middle > (second + third) * half
    }
}

/// The equations for a half ramp h and a vibration limit V.
pub(super) struct Pulses {
    kappa: Complex<f64>,
    half: f64,
    limit: f64,
    bare: Even,
}

impl Pulses {
    pub fn new(r: f64, half: f64, limit: f64) -> Self {
        let kappa = Complex::new(r, 1.0);
        Self { kappa, half, limit, bare: Even::at(kappa * kappa * (half * half)) }
    }

    pub fn newton(&self, start: SVector<f64, 4>) -> Option<Unknowns> {
        let mut unknowns = start;
        let mut last = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let (residual, jacobian) = self.at(&unknowns);
            let size = residual.amax();
            if size <= TOLERANCE && size >= 0.5 * last {
                let found = Unknowns(unknowns);
                return found.are_pulses(self.half).then_some(found); // rounding is all that is left
            }
            last = size;
            unknowns -= jacobian.lu().solve(&residual)?;
            if !(unknowns.iter().all(|value| value.abs() < FARTHEST) && unknowns[3] > 0.0) {
                return None;
            }
        }
        None
    }

    /// Value and slope over w, at w = 1, of P(w) + V e^{εw} σ(κwh), scaled by e^{−rd₃}, and their derivatives with respect to the
    /// unknowns. From the middle of the first pulse, ε = r(d₃ + A₃h − h) + j(d₃ + A₃h − A₁h)/2.
    fn at(&self, unknowns: &SVector<f64, 4>) -> (SVector<f64, 4>, SMatrix<f64, 4, 4>) {
        let (kappa, half) = (self.kappa, self.half);
        let amplitudes = Unknowns(*unknowns).amplitudes();
        let [first, _, third] = amplitudes;
        let &[_, _, middle, end] = unknowns.as_ref();
        let scale = (-kappa.re * end).exp();

        let pulses = [0.0, middle, end].map(|delay| (kappa * delay).exp() * scale);
        let pulses: [Pulse; 3] = std::array::from_fn(|i| {
            let delay = [0.0, middle, end][i];
            Pulse::at(kappa, half, amplitudes[i], delay, pulses[i])
        });
        let [one, two, three] = &pulses;

        let epsilon = Complex::new(kappa.re * (end + (third - 1.0) * half), 0.5 * (end + (third - first) * half));
        let target = epsilon.exp() * (self.limit * scale);
        let bend = kappa * kappa * (2.0 * half * half) * self.bare.sinhc_slope;
        let (value, slope) = (target * self.bare.sinhc, target * (epsilon * self.bare.sinhc + bend));
        let by = |epsilon_by: Complex<f64>| [epsilon_by * value, epsilon_by * (slope + value)];

        let per_phase = Complex::new(kappa.re, 0.5);
        let [first_target, third_target, end_target] =
            [by(Complex::new(0.0, -0.5 * half)), by(per_phase * half), by(per_phase)];
        let less = |a: [Complex<f64>; 2], b: [Complex<f64>; 2]| [a[0] - b[0], a[1] - b[1]];
        let plus = |a: [Complex<f64>; 2], b: [Complex<f64>; 2]| [a[0] + b[0], a[1] + b[1]];
        let columns = [
            plus(less(one.by_amplitude, two.by_amplitude), first_target),
            plus(less(three.by_amplitude, two.by_amplitude), third_target),
            two.by_delay,
            plus(three.by_delay, end_target),
        ];
        let total = [one.answer, two.answer, three.answer].into_iter().fold([value, slope], plus);
        let real = |[value, slope]: [Complex<f64>; 2]| [value.re, value.im, slope.re, slope.im];
        (SVector::from(real(total)), SMatrix::from(columns.map(real)))
    }
}

/// Newton converges in four or five iterations if at all.
const MAX_ITERATIONS: usize = 20;

/// Largest residual accepted, relative to the sum of the impulses.
const TOLERANCE: f64 = 1e-12;

/// Unknowns beyond six periods belong to no branch.
const FARTHEST: f64 = 6.0 * TAU;

/// Value and slope over w, at w = 1, of one pulse's answer, and their derivatives.
struct Pulse {
    answer: [Complex<f64>; 2],
    by_amplitude: [Complex<f64>; 2],
    by_delay: [Complex<f64>; 2],
}

impl Pulse {
    /// `delayed` is e^{κd}, scaled.
    fn at(kappa: Complex<f64>, half: f64, amplitude: f64, delay: f64, delayed: Complex<f64>) -> Self {
        let square = kappa * kappa * (amplitude * half).powi(2); // z², z = κAh
        let even = Even::at(square);
        // w dσ(κwAh)/dw = 2z²σ′(z²), and d(Aσ)/dA = cosh z
        let bend = square * even.sinhc_slope * 2.0;
        let turn = kappa * delay;
        let slope = turn * even.sinhc + bend;
        Self {
            answer: [delayed * even.sinhc * amplitude, delayed * slope * amplitude],
            by_amplitude: [delayed * even.cosh, delayed * (turn * even.cosh + square * even.sinhc)],
            by_delay: [kappa * delayed * even.sinhc * amplitude, kappa * delayed * (even.sinhc + slope) * amplitude],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_equations() {
        let pulses = Pulses::new(0.1, 2.5, 0.05);
        let at = SVector::from([0.2, 0.23, 3.3, 6.8]);
        let (_, jacobian) = pulses.at(&at);
        for unknown in 0..4 {
            let step = 1e-5;
            let moved = |by: f64| {
                let mut moved = at;
                moved[unknown] += by;
                // the scale is held: it is that of the middle
                pulses.at(&moved).0 * (0.1 * (moved[3] - at[3])).exp()
            };
            // central difference: error ~ step² times a third derivative of about 60
            let slope = (moved(step) - moved(-step)) / (2.0 * step);
            assert!((slope - jacobian.column(unknown)).amax() < 1e-8, "unknown {unknown}");
        }
    }
}
