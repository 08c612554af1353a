//! What zeros and humps ask of a train, regular where they all meet.
//!
//! With x = ω_d t, κ = r + j, r = ζω/ω_d, and w in units of ω₀, the train answers with F(w) = ΣAᵢ e^{κwxᵢ} and leaves
//! V(w) = e^{−rwxₙ} |F(w)|. A small limit moves the zeros together, to w = 1 + s dₖ with sⁿ = V_lim. The equations stay regular in
//! divided differences, in which F(1 + sη) = F[w₁ … wₙ, 1 + sη] sⁿ Π(η − dₖ):
//!
//! - zeros: F[w₁] = F[w₁, w₂] = … = F[w₁ … wₙ] = 0, complex;
//! - height of a hump at 1 + sη: ln|F[w₁ … wₙ, 1 + sη]| − r(1 + sη)xₙ + Σ ln|η − dₖ| = 0;
//! - its peak: the slope of that over η is 0.

use nalgebra::SVector;

use super::{Form, UNKNOWNS};
use crate::differences::Differences;

/// The equations; unknowns that a form does not have are 0 = 0.
pub(super) struct System<'a> {
    pub form: &'a Form,
    pub r: f64,
    /// s, s to the power of the number of zeros being the limit.
    pub spread: f64,
}

impl System<'_> {
    pub fn size(&self) -> usize {
        let (zeros, peaks) = self.form.free();
        let later = self.form.impulses - 1;
        later + if self.form.unity { 0 } else { later } + zeros + peaks
    }

    pub fn at(&self, unknowns: &SVector<f64, UNKNOWNS>) -> SVector<f64, UNKNOWNS> {
        let design = self.form.unpack(unknowns);
        let zeros = &design.zeros[..self.form.zeros];
        let loss = 0.5 * self.r * design.phases[self.form.impulses - 1];
        let mut residual = SVector::<f64, UNKNOWNS>::zeros();
        let mut rows = residual.iter_mut();
        // there are as many equations as unknowns, so no row is missing
        let mut put = |value: f64| rows.next().into_iter().for_each(|row| *row = value);
        let count = self.form.impulses;
        let mut differences = Differences::new(self.r, &design.phases[..count], &design.amplitudes[..count]);
        for zero in zeros {
            let difference = differences.over(self.spread * zero);
            put(difference.re);
            put(difference.im);
        }
        for peak in &design.peaks[..zeros.len() - 1] {
            let mut at_peak = differences.clone();
            let (value, slope) = (at_peak.over(self.spread * peak), at_peak.over(self.spread * peak));
            let distances = zeros.iter().map(|zero| peak - zero);
            let product: f64 = distances.clone().product();
            // the differences carry e^{−rxₙ} already, and e^{−rsηxₙ/2}
            put((value.norm() * product.abs()).ln() - self.spread * peak * loss);
            let steep = (slope / value).re - loss;
            put(self.spread * steep + distances.map(f64::recip).sum::<f64>());
        }
        residual
    }
}
