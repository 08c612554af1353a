//! Inputs beyond what any crane does are cut, so that a step of any finite input ends in useful time.

use swayless_export::Scalar;

/// No joint and no base is faster (rad/s, m/s).
pub const FASTEST: f64 = 100.0;
/// Nothing accelerates a joint or a payload more (rad/s², m/s²).
pub const STRONGEST: f64 = 1e6;

/// A rate as far as it is physical.
pub fn cut<R: Scalar>(rate: R) -> R {
    rate.clamp(-FASTEST, FASTEST)
}

/// An acceleration as far as it is physical.
pub fn cut_acceleration<R: Scalar>(acceleration: R) -> R {
    acceleration.clamp(-STRONGEST, STRONGEST)
}

/// Whether none of the rates is cut.
pub fn are_physical(rates: &[f64]) -> bool {
    rates.iter().all(|rate| rate.abs() <= FASTEST)
}
