//! All trains of three impulses that leave nothing of two undamped modes, in closed form.
//!
//! A₁ + A₂e^{ja} + A₃e^{jb} = 0 is a triangle of three sides, which fixes its angles but for a reflection. So both modes are
//! cancelled by the same amplitudes if and only if their phases at each impulse are equal, or are opposite: the impulses lie on the
//! comb Δ = 1/(f₂ − f₁) or on Δ = 1/(f₁ + f₂). On either, any impulses at 0, jΔ, kΔ will do, with
//!
//! A₁ : A₂ : A₃ = sin(b − a) : −sin b : sin a,  a = 2πf₁jΔ, b = 2πf₁kΔ,
//!
//! which normalised to ΣA = 1 is, with α = a/2, β = b/2, γ = β − α,
//!
//! A₁ = cos γ/(2 sin α sin β), A₂ = −cos β/(2 sin α sin γ), A₃ = cos α/(2 sin β sin γ).
//!
//! Where the triangle is flat (all phases are whole half turns, as with f₂ = 3f₁) amplitudes are free in part. Then those are taken
//! that they tend to as the frequencies do; they leave V of both modes with zero slope where they can.

use std::f64::consts::PI;

use super::{LARGEST, NEGLIGIBLE, Train};
use crate::Impulse;

/// Places 0, jΔ, kΔ on one of the combs.
#[derive(Clone, Copy)]
pub(super) struct Comb {
    /// Δ in seconds.
    spacing: f64,
    /// f₁Δ, turns of the slower mode from one place to the next.
    turns: f64,
    j: u32,
    k: u32,
}

impl Comb {
    /// Of two frequencies in rad/s, the slower one first: the combs on which the modes' phases are opposite, and equal.
    pub fn both([slow, fast]: [f64; 2]) -> [Self; 2] {
        [fast + slow, fast - slow].map(|sum| Self { spacing: 2.0 * PI / sum, turns: slow / sum, j: 1, k: 2 })
    }

    pub fn duration(&self) -> f64 {
        f64::from(self.k) * self.spacing
    }

    /// The next places: of those equally long, the one with the later second impulse comes first.
    pub fn advance(&mut self) {
        if self.j > 1 {
            self.j -= 1;
        } else {
            self.j = self.k;
            self.k += 1;
        }
    }

    /// The train, if its amplitudes are not so large that it is none, and start at time 0.
    pub fn train(&self) -> Option<Train> {
        let [alpha, beta, gamma] = [self.j, self.k, self.k - self.j].map(|n| sine_and_cosine(n, self.turns));
        let amplitudes = [
            gamma.1 / (2.0 * alpha.0 * beta.0),
            -beta.1 / (2.0 * alpha.0 * gamma.0),
            alpha.1 / (2.0 * beta.0 * gamma.0),
        ];
        let size: f64 = amplitudes.iter().map(|amplitude| amplitude.abs()).sum();
        let places = [0, self.j, self.k];
        let impulse = |i: usize| Impulse { time: f64::from(places[i]) * self.spacing, amplitude: amplitudes[i] };
        (size <= LARGEST && amplitudes[0].abs() > NEGLIGIBLE).then(|| Train::of([0, 1, 2].map(impulse)))
    }
}

/// sin and cos of n half turns times a share, with a small relative error even next to their zeros, for the same share at all n.
fn sine_and_cosine(n: u32, share: f64) -> (f64, f64) {
    let n = f64::from(n);
    let quarters = (2.0 * n * share).round();
    // exact, but for one rounding; a rest of zero everywhere is made to tend to it
    let rest = n.mul_add(share, -0.5 * quarters) + n * 1e-30;
    let (sin, cos) = (PI * rest).sin_cos();
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}
