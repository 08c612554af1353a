//! Entire functions of a squared argument, cosh √y and its kin: the same on either branch of the root and smooth at 0.

use nalgebra::Complex;

/// cosh √y, σ(y) = sinh √y / √y and σ′(y) = (cosh √y − σ)/(2y).
pub(crate) struct Even {
    pub cosh: Complex<f64>,
    pub sinhc: Complex<f64>,
    pub sinhc_slope: Complex<f64>,
}

impl Even {
    pub fn at(y: Complex<f64>) -> Self {
        let root = y.sqrt();
        let cosh = root.cosh();
        if y.norm_sqr() > 1.0 {
            let sinhc = root.sinh() / root;
            return Self { cosh, sinhc, sinhc_slope: (cosh - sinhc) / (2.0 * y) };
        }
        // σ = Σ yⁿ/(2n+1)!, σ′ = Σ n yⁿ⁻¹/(2n+1)!; for |y| ≤ 1 the first term left out is below 1e-19
        let (mut term, mut sinhc, mut sinhc_slope) = (Complex::new(1.0, 0.0), Complex::ZERO, Complex::ZERO);
        for n in 0..10 {
            let k = f64::from(n);
            sinhc += term;
            let next = term / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
            sinhc_slope += next * (k + 1.0);
            term = next * y;
        }
        Self { cosh, sinhc, sinhc_slope }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_form_agree_where_they_meet() {
        for angle in 0..12 {
            let y = Complex::from_polar(1.0, f64::from(angle));
            let (inside, outside) = (Even::at(y * (1.0 - 1e-12)), Even::at(y * (1.0 + 1e-12)));
            assert!((inside.sinhc - outside.sinhc).norm() < 1e-11);
            assert!((inside.sinhc_slope - outside.sinhc_slope).norm() < 1e-11);
        }
    }

    #[test]
    fn limits_at_zero() {
        let zero = Even::at(Complex::ZERO);
        assert_eq!((zero.cosh.re, zero.sinhc.re), (1.0, 1.0));
        assert!((zero.sinhc_slope.re - 1.0 / 6.0).abs() < 1e-16);
    }
}
