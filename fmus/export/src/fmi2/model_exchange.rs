//! Model exchange in FMI 2.0.

use swayless_abi::fmi2::*;

use crate::instance::Refusal;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put, slice, slice_mut};

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2EnterEventMode<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(c, Call::EnterEventMode, "fmi2EnterEventMode", |instance| instance.enter_event()) }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2NewDiscreteStates<M: Model>(c: Component, fmi2event_info: *mut EventInfo) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(c, Call::NewDiscreteStates, "fmi2NewDiscreteStates", |instance| {
            if fmi2event_info.is_null() {
                return Err(Refusal::error("fmi2eventInfo is NULL"));
            }
            let outcome = instance.update_discrete_states()?;
            fmi2event_info.write(EventInfo {
                values_of_continuous_states_changed: outcome.states_changed.into(),
                next_event_time_defined: outcome.next_event.is_some().into(),
                next_event_time: outcome.next_event.unwrap_or_default(),
                ..EventInfo::default()
            });
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2EnterContinuousTimeMode<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::EnterContinuousTimeMode, "fmi2EnterContinuousTimeMode", |instance| {
            instance.enter_continuous_time();
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2CompletedIntegratorStep<M: Model>(
    c: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    // SAFETY: the instance and the places for the answers are the importer's.
    unsafe {
        call::<M>(c, Call::CompletedIntegratorStep, "fmi2CompletedIntegratorStep", |_| {
            put(enter_event_mode, 0);
            put(terminate_simulation, 0);
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SetTime<M: Model>(c: Component, time: Real) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(c, Call::SetTime, "fmi2SetTime", |instance| instance.set_time(time)) }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SetContinuousStates<M: Model>(c: Component, x: *const Real, nx: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(c, Call::SetContinuousStates, "fmi2SetContinuousStates", |instance| {
            instance.set_states(slice(x, nx, "x")?)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetDerivatives<M: Model>(c: Component, derivatives: *mut Real, nx: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(c, Call::GetDerivatives, "fmi2GetDerivatives", |instance| {
            instance.derivatives(slice_mut(derivatives, nx, "derivatives")?)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetEventIndicators<M: Model>(c: Component, event_indicators: *mut Real, ni: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(c, Call::GetEventIndicators, "fmi2GetEventIndicators", |instance| {
            instance.event_indicators(slice_mut(event_indicators, ni, "eventIndicators")?)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetContinuousStates<M: Model>(c: Component, x: *mut Real, nx: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(c, Call::GetContinuousStates, "fmi2GetContinuousStates", |instance| {
            instance.states(slice_mut(x, nx, "x")?)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetNominalsOfContinuousStates<M: Model>(c: Component, x_nominal: *mut Real, nx: usize) -> Status {
    // SAFETY: the instance and the array are the importer's.
    unsafe {
        call::<M>(c, Call::GetNominals, "fmi2GetNominalsOfContinuousStates", |instance| {
            instance.nominals(slice_mut(x_nominal, nx, "x_nominal")?)
        })
    }
}
