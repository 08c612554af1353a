//! What an acceleration limit makes of a shaper (thesis 5.1): (5.13), (5.15), (5.21) and the conditions of Theorem 1.

use std::error::Error;
use std::fmt;

use nalgebra::Complex;

use crate::prediction::mean_of_ramp;
use crate::{Mode, Ramp, Shaper};

/// Residual vibration after a shaped step behind an acceleration limit, as a share of what one ideal step leaves, (5.15): each
/// impulse Aᵢ becomes a ramp |Aᵢ|v_f/a long, and the ramps are added,
///
/// Θ/β = (2/α) |Σ sin(Aᵢα/2) sin(ω_n t − ω_n tᵢ − Aᵢα/2)|, α = ωv_f/a,
///
/// here with damping, too, and seen from the end of the last ramp. For α → 0 it is
/// [`residual_vibration`](crate::residual_vibration). It is what a limiter does where no ramps meet
/// ([`longest_ramp`]); where they do, a limiter lags behind their sum, and [`predict`](crate::predict) says by how much.
#[must_use]
pub fn ramped_vibration(shaper: &Shaper, mode: Mode, ramp: Ramp) -> f64 {
    let sigma = Complex::new(mode.damping_ratio() * mode.frequency(), mode.damped_frequency());
    let end = command_duration(shaper, ramp);
    let answers = shaper.impulses().iter().map(|impulse| {
        let angle = sigma * (impulse.amplitude.abs() * ramp.time());
        (sigma * (impulse.time - end)).exp() * mean_of_ramp(angle) * impulse.amplitude
    });
    answers.sum::<Complex<f64>>().norm()
}

/// The longest bare ramp v_f/a, in seconds, at which no ramp of a shaped step meets the next (5.13): the least of
/// (tᵢ₊₁ − tᵢ)/|Aᵢ|; infinite for a single impulse. Times ω it is the α up to which (5.15) holds.
#[must_use]
pub fn longest_ramp(shaper: &Shaper) -> f64 {
    let spaces = shaper.impulses().windows(2).map(|pair| (pair[1].time - pair[0].time) / pair[0].amplitude.abs());
    spaces.fold(f64::INFINITY, f64::min)
}

/// When the command of a shaped step behind an acceleration limit is complete, tₙ + |Aₙ|v_f/a in seconds; a next step that
/// comes no sooner finds the drive idle (5.21).
#[must_use]
pub fn command_duration(shaper: &Shaper, ramp: Ramp) -> f64 {
    let last = shaper.impulses().last().map_or(0.0, |impulse| impulse.amplitude.abs());
    shaper.duration() + last * ramp.time()
}

/// Why an acceleration limit and a shaper may not be exchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotInterchangeable {
    /// An amplitude has another size than the first.
    Amplitude {
        /// Which impulse, from 0.
        index: usize,
        /// Its amplitude.
        value: f64,
        /// The first one's.
        first: f64,
    },
    /// A ramp has not ended when the next impulse comes.
    Overlap {
        /// Which impulse, from 0, is ramped too long.
        index: usize,
        /// The time to the next one, in seconds.
        space: f64,
        /// How long its ramp takes, in seconds.
        ramp_time: f64,
        /// The longest bare ramp v_f/a at which no ramps meet, in seconds.
        longest_ramp: f64,
    },
}

impl fmt::Display for NotInterchangeable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Amplitude { index, value, first } => {
                write!(f, "the amplitude of impulse {index} is {value}, not of the size of the first, {first}")
            }
            Self::Overlap { index, space, ramp_time, longest_ramp } => write!(
                f,
                "the ramp of impulse {index} takes {ramp_time} s, and the next comes after {space} s; the bare ramp may take \
                 {longest_ramp} s"
            ),
        }
    }
}

impl Error for NotInterchangeable {}

/// Theorem 1: whether the limited shaped step is the shaped limited step, so that the shaper cancels behind the limit what it
/// cancels without.
///
/// # Errors
/// [`NotInterchangeable`] unless (a) all amplitudes have the same size, to 1e-9, and (b) tᵢ₊₁ − tᵢ ≥ |Aᵢ|v_f/a.
pub fn interchangeable(shaper: &Shaper, ramp: Ramp) -> Result<(), NotInterchangeable> {
    let impulses = shaper.impulses();
    let first = impulses[0].amplitude;
    for (index, impulse) in impulses.iter().enumerate() {
        let value = impulse.amplitude;
        if (value.abs() - first.abs()).abs() > 1e-9 * first.abs() {
            return Err(NotInterchangeable::Amplitude { index, value, first });
        }
    }
    for (index, pair) in impulses.windows(2).enumerate() {
        let (space, ramp_time) = (pair[1].time - pair[0].time, pair[0].amplitude.abs() * ramp.time());
        if space < ramp_time {
            return Err(NotInterchangeable::Overlap { index, space, ramp_time, longest_ramp: longest_ramp(shaper) });
        }
    }
    Ok(())
}
