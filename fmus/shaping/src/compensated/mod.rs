//! UMZVc (thesis 5.2): UMZV for a drive whose speed follows the command with one time constant while it grows and another while
//! it falls.
//!
//! A command that grows takes one train, a command that shrinks another: impulses 1, −1, 1 at 0, t₂, t₃ and at 0, t₂′, t₃′. The
//! braking train is the accelerating one with the time constants exchanged.

mod closed_form;
mod conditions;
mod error;
mod ramp;

pub use closed_form::compensation_exists;
pub use conditions::{PulseLength, RampsComplete, pulse_length};
pub use error::{CompensatedError, TimeConstant};

use crate::{Mode, Shaper, umzv};

/// How the times of [`compensated`] are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CompensatedForm {
    /// Nothing remains of the vibration, however little of a ramp is over when the next one begins, and with damping.
    #[default]
    ExactRamp,
    /// (5.29), for a mode without damping and ramps that are over when the next one begins, which takes three time constants.
    ClosedForm,
}

/// The two trains of UMZVc.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated {
    /// For a change away from standstill.
    pub accelerating: Shaper,
    /// For a change towards standstill.
    pub braking: Shaper,
}

/// Designs UMZVc: no vibration of `mode` behind a drive v̇ = (u − v)/τ, with τ = `acceleration_time_constant` while |v| grows and
/// `braking_time_constant` while it falls, both in seconds (5.25).
///
/// With equal time constants it is UMZV. Does not allocate.
///
/// # Errors
/// [`CompensatedError`] for a time constant that is none, for a mode that has no UMZV, where (5.32) is not fulfilled (closed form)
/// or no times are found (exact ramps; that happens where one time constant is next to nothing, the other above about 1.6/ω without
/// damping and 1/ω at ζ = 0.2). It names time constants next to those given that have a solution.
pub fn compensated(
    mode: Mode,
    acceleration_time_constant: f64,
    braking_time_constant: f64,
    form: CompensatedForm,
) -> Result<Compensated, CompensatedError> {
    use CompensatedError::NotFound;
    use TimeConstant::{Acceleration, Braking};
    for (which, value) in [(Acceleration, acceleration_time_constant), (Braking, braking_time_constant)] {
        let shares = value * mode.frequency();
        if !(value >= 0.0 && shares.is_finite()) {
            return Err(CompensatedError::TimeConstant { which, value });
        }
    }
    let unity = match form {
        CompensatedForm::ExactRamp => umzv::design(mode),
        CompensatedForm::ClosedForm => umzv::design(mode.undamped()),
    };
    let unity = unity.map_err(CompensatedError::Unity)?;
    if acceleration_time_constant == braking_time_constant {
        return Ok(Compensated { accelerating: unity.clone(), braking: unity });
    }
    let train = |growing, falling| match form {
        CompensatedForm::ExactRamp => ramp::train(mode, &unity, growing, falling),
        CompensatedForm::ClosedForm => closed_form::train(mode, growing, falling),
    };
    let accelerating = train(acceleration_time_constant, braking_time_constant);
    // seen from the speed before, a falling speed is a growing one
    let braking = train(braking_time_constant, acceleration_time_constant).map_err(CompensatedError::exchanged);
    match (accelerating, braking) {
        (Ok(accelerating), Ok(braking)) => Ok(Compensated { accelerating, braking }),
        // what is feasible is so for both
        (Err(NotFound { feasible_share: one, .. }), Err(error @ NotFound { feasible_share: other, .. }))
            if other < one =>
        {
            Err(error)
        }
        (Err(error), _) | (_, Err(error)) => Err(error),
    }
}
