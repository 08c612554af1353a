//! Co-simulation in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put};

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
        call::<M>(instance, Call::DoStep, "fmi3DoStep", |instance| {
            let done = instance.do_step(current_communication_point, communication_step_size);
            let end = done.as_ref().ok();
            put(event_handling_needed, end.is_some_and(|end| end.event).into());
            put(terminate_simulation, 0);
            put(early_return, end.is_some_and(|end| end.early).into());
            put(last_successful_time, instance.t);
            done.map(|_| ())
        })
    }
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
