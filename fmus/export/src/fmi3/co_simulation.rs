//! Co-simulation in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::co_simulation::{Progress, StepEnd};
use crate::model::Model;
use crate::phase::{Call, Phase};
use crate::raw::{Surroundings, call, callback, put, surroundings};

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
#[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
pub unsafe fn fmi3DoStep<M: Model>(
    instance: Instance,
    current_communication_point: Float64,
    communication_step_size: Float64,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    event_handling_needed: *mut Boolean,
    terminate_simulation: *mut Boolean,
    early_return: *mut Boolean,
    last_successful_time: *mut Float64,
) -> Status {
    // SAFETY: the instance and the places for the answers are the importer's.
    unsafe {
        let surroundings = surroundings::<M>(instance);
        let pauses = surroundings.intermediate_update.is_some();
        let (mut stride, mut now) = (None, Call::DoStep);
        loop {
            let mut paused = None;
            let status = call::<M>(instance, now, "fmi3DoStep", |instance| {
                instance.phase = Phase::Step;
                let begun = match stride.take() {
                    Some(stride) => Ok(stride),
                    None => instance.begin_step(current_communication_point, communication_step_size, pauses),
                };
                let done = begun.and_then(|begun| instance.continue_step(stride.insert(begun)));
                let end = match done {
                    Ok(Progress::Ended(end)) => end,
                    _ => StepEnd::default(),
                };
                put(event_handling_needed, end.event.into());
                put(terminate_simulation, 0);
                put(early_return, end.early.into());
                put(last_successful_time, instance.t);
                if done? == Progress::Paused {
                    instance.phase = Phase::Intermediate;
                    paused = Some((instance.t, instance.event_mode.early_return));
                }
                Ok(())
            });
            let (Some((t, early)), Some(stride)) = (paused, &mut stride) else { return status };
            let can_return_early = early && t < stride.end();
            let update = || intermediate_update(surroundings, t, can_return_early);
            if let Some(wanted) = callback::<M, _>(instance, update) {
                stride.return_at(wanted);
            }
            now = Call::ContinueStep;
        }
    }
}

/// Calls the importer within a step. Returns when it wants the step to end, if it does.
///
/// # Safety
/// No reference to the instance is held: the importer may get and set variables of it.
unsafe fn intermediate_update(surroundings: Surroundings, t: f64, can_return_early: bool) -> Option<f64> {
    let callback = surroundings.intermediate_update?;
    let (mut requested, mut time) = (0, t);
    // SAFETY: the importer's callback with its own environment, and places that live during the call.
    unsafe {
        let (set_requested, get_allowed, step_finished) = (1, 1, 1);
        let can = can_return_early.into();
        callback(
            surroundings.environment,
            t,
            set_requested,
            get_allowed,
            step_finished,
            can,
            &raw mut requested,
            &raw mut time,
        );
    }
    (can_return_early && requested != 0).then_some(time)
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3EnterStepMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::EnterStepMode, "fmi3EnterStepMode", |instance| {
            instance.enter_step();
            Ok(())
        })
    }
}
