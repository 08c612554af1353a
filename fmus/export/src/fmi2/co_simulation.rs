//! Co-simulation in FMI 2.0.

use swayless_abi::fmi2::*;

use crate::instance::Refusal;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put};

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2DoStep<M: Model>(
    c: Component,
    current_communication_point: Real,
    communication_step_size: Real,
    _no_set_fmu_state_prior_to_current_point: Boolean,
) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::DoStep, "fmi2DoStep", |instance| {
            instance.do_step(current_communication_point, communication_step_size).map(|_| ())
        })
    }
}

/// No step is ever pending, so that there is nothing to report of one.
fn nothing_pending() -> Result<(), Refusal> {
    Err(Refusal::discard("no step is pending: every step ends before fmi2DoStep returns"))
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetStatus<M: Model>(c: Component, _s: StatusKind, _value: *mut Status) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(c, Call::GetStatus, "fmi2GetStatus", |_| nothing_pending()) }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetRealStatus<M: Model>(c: Component, s: StatusKind, value: *mut Real) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(c, Call::GetStatus, "fmi2GetRealStatus", |instance| {
            if s != LAST_SUCCESSFUL_TIME {
                return nothing_pending();
            }
            put(value, instance.t);
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetIntegerStatus<M: Model>(c: Component, _s: StatusKind, _value: *mut Integer) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(c, Call::GetStatus, "fmi2GetIntegerStatus", |_| nothing_pending()) }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetBooleanStatus<M: Model>(c: Component, s: StatusKind, value: *mut Boolean) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(c, Call::GetStatus, "fmi2GetBooleanStatus", |_| {
            if s != TERMINATED {
                return nothing_pending();
            }
            put(value, 0);
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetStringStatus<M: Model>(c: Component, _s: StatusKind, _value: *mut String) -> Status {
    // SAFETY: the importer's instance.
    unsafe { call::<M>(c, Call::GetStatus, "fmi2GetStringStatus", |_| nothing_pending()) }
}
