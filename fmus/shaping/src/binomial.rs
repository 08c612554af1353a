//! ZV, ZVD, ZVDD and ZVDDD: impulses every half damped period, with binomial amplitudes.

use crate::{Mode, Shaper};

/// N impulses at k·T_d/2 with amplitudes C(N−1, k) Kᵏ/(1 + K)ᴺ⁻¹: the ZV shaper (1.1) convolved N − 1 times with itself,
/// so that V has a zero of order N − 1 at the mode; N = 3 is (1.2).
pub(crate) fn design<const N: usize>(mode: Mode) -> Shaper {
    let half_period = 0.5 * mode.damped_period();
    let amplitudes = amplitudes::<N>(mode);
    Shaper::of::<N>(std::array::from_fn(|k| (k as f64 * half_period, amplitudes[k])))
}

pub(crate) fn amplitudes<const N: usize>(mode: Mode) -> [f64; N] {
    let decay = mode.half_period_decay();
    let (first, second) = (1.0 / (1.0 + decay), decay / (1.0 + decay));
    let mut amplitudes = [0.0; N];
    amplitudes[0] = 1.0;
    for convolved in 1..N {
        for k in (1..=convolved).rev() {
            amplitudes[k] = first * amplitudes[k] + second * amplitudes[k - 1];
        }
        amplitudes[0] *= first;
    }
    amplitudes
}
