//! The closed form of UMZVc, (5.29): each ramp is over before the next begins.

use super::error::{CompensatedError, TimeConstant};
use crate::{Mode, Shaper};

/// Whether (5.32) holds, so that [`CompensatedForm::ClosedForm`](crate::CompensatedForm::ClosedForm) has a solution for both
/// directions: ωτ_b ≥ ½√((ωτ_a)² − 3) and the same with τ_a and τ_b exchanged. It always does up to ωτ = √3.
#[must_use]
pub fn compensation_exists(mode: Mode, acceleration_time_constant: f64, braking_time_constant: f64) -> bool {
    let ends = [acceleration_time_constant, braking_time_constant].map(|time| time * mode.frequency());
    ends[0] <= longest(ends[1]) && ends[1] <= longest(ends[0])
}

/// (5.32) solved for the other time constant, both times ω.
fn longest(other: f64) -> f64 {
    (4.0 * other * other + 3.0).sqrt()
}

/// The train for a growing speed:
///
/// β = ½√((ωτ_a)² + 1)/√((ωτ_b)² + 1), t₂ = (1/ω)(atan(1/ωτ_b) − atan(1/ωτ_a) + acos β) + nT, t₃ = (1/ω) acos(2β² − 1) + mT,
///
/// with the least n that puts t₂ behind 0 and the least m ≥ n that puts t₃ behind t₂.
pub(super) fn train(mode: Mode, growing: f64, falling: f64) -> Result<Shaper, CompensatedError> {
    let omega = mode.frequency();
    let (up, down) = (growing * omega, falling * omega);
    let beta = 0.5 * up.hypot(1.0) / down.hypot(1.0);
    if beta > 1.0 {
        let (which, value) = (TimeConstant::Acceleration, growing);
        // not so long that rounding puts β above 1
        let longest = longest(down) * (1.0 - 4.0 * f64::EPSILON) / omega;
        return Err(CompensatedError::Unequal { which, value, longest });
    }
    // atan(1/y) = π/2 − atan y, and acos(2β² − 1) = 2 acos β as β ≥ 0
    let (lead, angle) = (up.atan() - down.atan(), beta.acos());
    let behind = |angle: f64, before: f64| {
        let mut time = angle / omega;
        while time <= before {
            time += mode.period();
        }
        time
    };
    let second = behind(lead + angle, 0.0);
    let third = behind(2.0 * angle, second);
    Ok(Shaper::of([(0.0, 1.0), (second, -1.0), (third, 1.0)]))
}
