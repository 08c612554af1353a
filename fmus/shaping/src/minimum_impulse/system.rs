//! The equations of a train of three impulses for two damped modes, regular where impulses meet and where modes are equal.
//!
//! With σ = ζω + jω√(1 − ζ²) both modes ask for ΣAᵢe^{σtᵢ} = 0. Impulses may meet: a train of two, which is what remains without
//! damping where f₂ = 3f₁, becomes one of three when damping splits one of them, by a distance that grows as √ζ. So two
//! neighbours are written as a pair, of sum S, half distance h, with E = h times the difference of their amplitudes and q = h²,
//! in which all is smooth:
//!
//! Ae^{σ(c−h)} + A′e^{σ(c+h)} = e^{σc}(S cosh σh + E sinh σh / h).
//!
//! The third impulse is 1 − S, at a distance d from the pair's centre. If it is the first, that makes
//! (1 − S)e^{−σd} + S cosh σh + E sinh σh / h = 0; if it is the last, S and E stand the other way round in time, and
//! (1 − S) + e^{−σd}(S cosh σh − E sinh σh / h) = 0. In both no exponent is positive but those of ±σh.
//!
//! Where modes are equal V shall be zero with its slope. So the equations are the mean over both modes and the divided difference
//! over σ, for which every term is carried as such a [`Both`].

use nalgebra::{Complex, SMatrix, SVector};

use crate::even::Even;

/// A function of σ at the two modes: its mean, and its difference over that of σ.
#[derive(Clone, Copy)]
struct Both {
    mean: Complex<f64>,
    slope: Complex<f64>,
}

impl Both {
    fn plus(self, other: Self) -> Self {
        Self { mean: self.mean + other.mean, slope: self.slope + other.slope }
    }

    fn times(self, factor: f64) -> Self {
        Self { mean: self.mean * factor, slope: self.slope * factor }
    }

    fn less(self, constant: f64) -> Self {
        Self { mean: self.mean - constant, ..self }
    }
}

/// Two modes and which impulse is alone.
pub(super) struct System {
    /// σ of both modes is m ± δ.
    middle: Complex<f64>,
    /// δ²
    square: Complex<f64>,
    pair_first: bool,
}

impl System {
    pub fn new([slow, fast]: [Complex<f64>; 2], pair_first: bool) -> Self {
        let half = (fast - slow) * 0.5;
        Self { middle: (slow + fast) * 0.5, square: half * half, pair_first }
    }

    fn product(&self, a: Both, b: Both) -> Both {
        Both { mean: a.mean * b.mean + self.square * a.slope * b.slope, slope: a.mean * b.slope + a.slope * b.mean }
    }

    /// e^{−σd}
    fn decay(&self, distance: f64) -> Both {
        let even = Even::at(self.square * (distance * distance));
        let middle = (-self.middle * distance).exp();
        Both { mean: middle * even.cosh, slope: -middle * even.sinhc * distance }
    }

    /// cosh σh, Z = sinh σh / h and dZ/dq.
    fn pair(&self, q: f64) -> [Both; 3] {
        let (m, m2, square) = (self.middle, self.middle * self.middle, self.square);
        let (inner, outer) = (Even::at(m2 * q), Even::at(square * q));
        let cosh = Both { mean: inner.cosh * outer.cosh, slope: m * inner.sinhc * outer.sinhc * q };
        let sinhc = Both { mean: m * inner.sinhc * outer.cosh, slope: inner.cosh * outer.sinhc };
        let bend = Both {
            mean: m * (m2 * inner.sinhc_slope * outer.cosh + square * inner.sinhc * outer.sinhc * 0.5),
            slope: m2 * inner.sinhc * outer.sinhc * 0.5 + square * inner.cosh * outer.sinhc_slope,
        };
        [cosh, sinhc, bend]
    }

    /// Residuals, and their derivatives with respect to S, E, d and q.
    pub fn at(&self, unknowns: &SVector<f64, 4>) -> (SVector<f64, 4>, SMatrix<f64, 4, 4>) {
        let [sum, skew, distance, q] = (*unknowns).into();
        let skew = if self.pair_first { -skew } else { skew };
        let sigma = Both { mean: self.middle, slope: Complex::ONE };
        let decay = self.decay(distance);
        let decay_by_d = self.product(sigma, decay).times(-1.0);
        let [cosh, sinhc, bend] = self.pair(q);
        let pair = cosh.times(sum).plus(sinhc.times(skew));
        let pair_by_q = self.product(sigma, sinhc).times(0.5 * sum).plus(bend.times(skew));
        let (residual, [by_sum, by_skew, by_d, by_q]) = if self.pair_first {
            let residual = self.product(decay, pair).less(sum - 1.0);
            let by_sum = self.product(decay, cosh).less(1.0);
            let by_skew = self.product(decay, sinhc).times(-1.0);
            (residual, [by_sum, by_skew, self.product(decay_by_d, pair), self.product(decay, pair_by_q)])
        } else {
            let residual = decay.times(1.0 - sum).plus(pair);
            (residual, [cosh.plus(decay.times(-1.0)), sinhc, decay_by_d.times(1.0 - sum), pair_by_q])
        };
        let rows = |both: Both| [both.mean.re, both.mean.im, both.slope.re, both.slope.im];
        (SVector::from(rows(residual)), SMatrix::from([by_sum, by_skew, by_d, by_q].map(rows)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_those_of_the_train_and_derivatives_are_theirs() {
        let sigma = [Complex::new(0.05, 0.4), Complex::new(0.2, 1.6)];
        let [sum, skew, distance, q] = [0.7, 0.2, 2.1, 0.3];
        for pair_first in [false, true] {
            let system = System::new(sigma, pair_first);
            let at = SVector::from([sum, skew, distance, q]);
            let (residual, jacobian) = system.at(&at);
            let (h, lean) = (q.sqrt(), skew / q.sqrt());
            let train = [(0.0, 1.0 - sum), (distance - h, 0.5 * (sum - lean)), (distance + h, 0.5 * (sum + lean))];
            let values = sigma.map(|sigma| {
                let (sigma, end) = if pair_first { (-sigma, 0.0) } else { (sigma, distance) };
                train
                    .map(|(time, amplitude)| (sigma * (time - end)).exp() * amplitude)
                    .into_iter()
                    .sum::<Complex<f64>>()
            });
            let mean = (values[0] + values[1]) * 0.5;
            let slope = (values[1] - values[0]) / (sigma[1] - sigma[0]);
            let expected = SVector::from([mean.re, mean.im, slope.re, slope.im]);
            assert!((residual - expected).amax() < 1e-14, "{residual} {expected}");
            for unknown in 0..4 {
                let moved = |by: f64| {
                    let mut at = at;
                    at[unknown] += by;
                    system.at(&at).0
                };
                // central difference: error ~ step² times a third derivative below 10
                let slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                assert!((slope - jacobian.column(unknown)).amax() < 1e-8, "unknown {unknown}");
            }
        }
    }

    #[test]
    fn equal_modes_ask_for_value_and_slope() {
        let sigma = Complex::new(0.1, 1.0);
        let at = SVector::from([0.7, 0.2, 2.1, 0.3]);
        let (equal, _) = System::new([sigma; 2], false).at(&at);
        let (near, _) = System::new([sigma * (1.0 - 1e-5), sigma * (1.0 + 1e-5)], false).at(&at);
        assert!((equal - near).amax() < 1e-9);
    }
}
