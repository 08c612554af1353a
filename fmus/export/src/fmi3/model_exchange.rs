//! Model exchange in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::layout::Layout;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put, slice, slice_mut};

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3EnterEventMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(instance, Call::EnterEventMode, "fmi3EnterEventMode", |instance| instance.enter_event()) }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3EvaluateDiscreteStates<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::NewDiscreteStates, "fmi3EvaluateDiscreteStates", |instance| {
            instance.pending = true;
            instance.evaluate()
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3UpdateDiscreteStates<M: Model>(
    instance: Instance,
    discrete_states_need_update: *mut Boolean,
    terminate_simulation: *mut Boolean,
    nominals_of_continuous_states_changed: *mut Boolean,
    values_of_continuous_states_changed: *mut Boolean,
    next_event_time_defined: *mut Boolean,
    next_event_time: *mut Float64,
) -> Status {
    // SAFETY: the instance and the places for the answers are the importer's.
    unsafe {
        call::<M>(instance, Call::NewDiscreteStates, "fmi3UpdateDiscreteStates", |instance| {
            let outcome = instance.update_discrete_states()?;
            put(discrete_states_need_update, 0);
            put(terminate_simulation, 0);
            put(nominals_of_continuous_states_changed, 0);
            put(values_of_continuous_states_changed, outcome.states_changed.into());
            put(next_event_time_defined, outcome.next_event.is_some().into());
            put(next_event_time, outcome.next_event.unwrap_or_default());
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3EnterContinuousTimeMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::EnterContinuousTimeMode, "fmi3EnterContinuousTimeMode", |instance| {
            instance.enter_continuous_time();
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3CompletedIntegratorStep<M: Model>(
    instance: Instance,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    // SAFETY: the instance and the places for the answers are the importer's.
    unsafe {
        call::<M>(instance, Call::CompletedIntegratorStep, "fmi3CompletedIntegratorStep", |_| {
            put(enter_event_mode, 0);
            put(terminate_simulation, 0);
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SetTime<M: Model>(instance: Instance, time: Float64) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(instance, Call::SetTime, "fmi3SetTime", |instance| instance.set_time(time)) }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SetContinuousStates<M: Model>(instance: Instance, states: *const Float64, n: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(instance, Call::SetContinuousStates, "fmi3SetContinuousStates", |instance| {
            instance.set_states(slice(states, n, "continuousStates")?)
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetContinuousStateDerivatives<M: Model>(
    instance: Instance,
    derivatives: *mut Float64,
    n: usize,
) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(instance, Call::GetDerivatives, "fmi3GetContinuousStateDerivatives", |instance| {
            instance.derivatives(slice_mut(derivatives, n, "derivatives")?)
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetEventIndicators<M: Model>(instance: Instance, indicators: *mut Float64, n: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(instance, Call::GetEventIndicators, "fmi3GetEventIndicators", |instance| {
            instance.event_indicators(slice_mut(indicators, n, "eventIndicators")?)
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetContinuousStates<M: Model>(instance: Instance, states: *mut Float64, n: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(instance, Call::GetContinuousStates, "fmi3GetContinuousStates", |instance| {
            instance.states(slice_mut(states, n, "continuousStates")?)
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetNominalsOfContinuousStates<M: Model>(
    instance: Instance,
    nominals: *mut Float64,
    n: usize,
) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(instance, Call::GetNominals, "fmi3GetNominalsOfContinuousStates", |instance| {
            instance.nominals(slice_mut(nominals, n, "nominals")?)
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetNumberOfEventIndicators<M: Model>(instance: Instance, n: *mut usize) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(instance, Call::GetCounts, "fmi3GetNumberOfEventIndicators", |_| {
            put(n, Layout::<M>::INDICATOR_COUNT);
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetNumberOfContinuousStates<M: Model>(instance: Instance, n: *mut usize) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(instance, Call::GetCounts, "fmi3GetNumberOfContinuousStates", |instance| {
            put(n, instance.state_count());
            Ok(())
        })
    }
}
