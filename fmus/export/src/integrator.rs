//! Dormand–Prince 5(4): one step with its error estimate.
//!
//! Coefficients: J. R. Dormand, P. J. Prince, "A family of embedded Runge–Kutta formulae", Journal of Computational
//! and Applied Mathematics 6 (1980) 19–26, table 2. The last stage of a step is the first of the next.

const C: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];
const A: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Fifth-order weights less fourth-order ones.
const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// The stages of a step; nothing is allocated after [`new`](Self::new).
pub struct DormandPrince {
    k: [Vec<f64>; 7],
    stage: Vec<f64>,
    /// The states at the end of the step last taken.
    pub end: Vec<f64>,
}

impl DormandPrince {
    /// For `n` states.
    pub fn new(n: usize) -> Self {
        Self { k: std::array::from_fn(|_| vec![0.0; n]), stage: vec![0.0; n], end: vec![0.0; n] }
    }

    /// The derivatives at the beginning of the step, to be set before [`step`](Self::step).
    pub fn first_stage(&mut self) -> &mut [f64] {
        &mut self.k[0]
    }

    /// Makes the end of the step last taken the beginning of the next.
    pub fn accept(&mut self) {
        let (first, rest) = self.k.split_at_mut(1);
        first[0].copy_from_slice(&rest[5]);
    }

    /// The states in the middle of the step last taken, by the cubic through its ends and their derivatives.
    pub fn middle(&mut self, x: &[f64], h: f64) -> &[f64] {
        for (i, place) in self.stage.iter_mut().enumerate() {
            *place = 0.5 * (x[i] + self.end[i]) + 0.125 * h * (self.k[0][i] - self.k[6][i]);
        }
        &self.stage
    }

    /// Takes a step of length `h` from `x` at `t` to [`end`](Self::end). Returns the estimate of its error, scaled so
    /// that at most 1 is within the tolerance: `|e_i| ≤ tolerance · max(nominal_i, |x_i|)` for every i. (A mean over
    /// states, most of which hardly move, would allow the others more.)
    pub fn step(
        &mut self,
        mut derivatives: impl FnMut(f64, &[f64], &mut [f64]),
        t: f64,
        x: &[f64],
        h: f64,
        tolerance: f64,
        nominal: &[f64],
    ) -> f64 {
        for s in 1..7 {
            let (done, rest) = self.k.split_at_mut(s);
            let into = if s == 6 { &mut self.end } else { &mut self.stage };
            for (i, place) in into.iter_mut().enumerate() {
                let sum: f64 = A[s].iter().zip(done.iter()).map(|(a, k)| a * k[i]).sum();
                *place = x[i] + h * sum;
            }
            derivatives(t + C[s] * h, into, &mut rest[0]);
        }
        let mut worst = 0.0;
        for i in 0..x.len() {
            // An infinite state would make any error look small beside it.
            if !self.end[i].is_finite() {
                return f64::NAN;
            }
            let error: f64 = E.iter().zip(&self.k).map(|(e, k)| e * k[i]).sum();
            let scale = tolerance * nominal[i].max(x[i].abs()).max(self.end[i].abs());
            let part = (h * error / scale).abs();
            // A part that is not a number stays.
            if part > worst || part.is_nan() {
                worst = part;
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Harmonic oscillator over one period with n steps: the error of the fifth-order solution.
    fn error(n: usize) -> f64 {
        let turn = std::f64::consts::TAU;
        let mut rk = DormandPrince::new(2);
        let mut x = vec![1.0, 0.0];
        let f = |_: f64, x: &[f64], dx: &mut [f64]| {
            dx[0] = x[1];
            dx[1] = -x[0];
        };
        let h = turn / n as f64;
        f(0.0, &x, rk.first_stage());
        for i in 0..n {
            rk.step(f, i as f64 * h, &x, h, 1e-6, &[1.0, 1.0]);
            x.copy_from_slice(&rk.end);
            rk.accept();
        }
        (x[0] - 1.0).hypot(x[1])
    }

    #[test]
    fn the_order_is_five() {
        let order = (error(50) / error(100)).log2();
        assert!((order - 5.0).abs() < 0.1, "{order}");
    }

    #[test]
    fn the_estimate_is_the_difference_of_the_two_orders() {
        // For x' = t^4 both formulae are exact in the fifth order only: the estimate is the fourth-order error.
        let mut rk = DormandPrince::new(1);
        rk.first_stage()[0] = 0.0;
        let estimate = rk.step(|t, _, dx| dx[0] = t.powi(4), 0.0, &[0.0], 1.0, 1.0, &[1.0]);
        assert!((rk.end[0] - 0.2).abs() < 1e-15, "{}", rk.end[0]);
        let fourth: f64 = A[6].iter().chain([&0.0]).zip(&E).zip(&C).map(|((b, e), c)| (b - e) * c.powi(4)).sum();
        assert!((estimate - (0.2 - fourth).abs()).abs() < 1e-15, "{estimate}");
    }
}
