//! Version, life cycle and logging of FMI 3.0.

use std::ffi::c_char;

use swayless_abi::fmi3::*;

use super::callbacks::log;
use crate::fmi2::unknown_category;
use crate::instance::{EventMode, Instance as Runtime};
use crate::model::Model;
use crate::phase::{Call, Interface, Phase};
use crate::raw::{call, free, instantiate, no_such_interface, slice, text};
use crate::uri;

/// The pointers of all functions here are the importer's, as FMI 3.0.2 specifies them.
pub unsafe fn fmi3GetVersion<M: Model>() -> *const c_char {
    c"3.0".as_ptr()
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3SetDebugLogging<M: Model>(
    instance: Instance,
    logging_on: Boolean,
    n_categories: usize,
    categories: *const String,
) -> Status {
    // SAFETY: the instance and the array are the importer's, as the standard specifies.
    unsafe {
        call::<M>(instance, Call::SetDebugLogging, "fmi3SetDebugLogging", |instance| {
            let categories = slice(categories, n_categories, "categories")?;
            let names: Vec<_> = categories.iter().map(|name| text(*name).unwrap_or_default()).collect();
            instance.log.set(logging_on != 0, names.iter().map(AsRef::as_ref)).map_err(unknown_category)
        })
    }
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3InstantiateModelExchange<M: Model>(
    instance_name: String,
    instantiation_token: String,
    resource_path: String,
    _visible: Boolean,
    logging_on: Boolean,
    instance_environment: InstanceEnvironment,
    log_message: LogMessageCallback,
) -> Instance {
    let log = log(log_message, instance_environment, logging_on != 0);
    // SAFETY: texts are the importer's, as the standard specifies; they are copied.
    let (name, token, path) = unsafe { (text(instance_name), text(instantiation_token), text(resource_path)) };
    let resources = path.and_then(|path| uri::folder(&path));
    instantiate::<M>(Interface::ModelExchange, name.as_deref(), token.as_deref(), log, resources)
}

/// See [`fmi3GetVersion`].
#[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
pub unsafe fn fmi3InstantiateCoSimulation<M: Model>(
    instance_name: String,
    instantiation_token: String,
    resource_path: String,
    _visible: Boolean,
    logging_on: Boolean,
    event_mode_used: Boolean,
    early_return_allowed: Boolean,
    _required_intermediate_variables: *const ValueReference,
    _n_required_intermediate_variables: usize,
    instance_environment: InstanceEnvironment,
    log_message: LogMessageCallback,
    _intermediate_update: IntermediateUpdateCallback,
) -> Instance {
    let log = log(log_message, instance_environment, logging_on != 0);
    // SAFETY: texts are the importer's, as the standard specifies; they are copied.
    let (name, token, path) = unsafe { (text(instance_name), text(instantiation_token), text(resource_path)) };
    let resources = path.and_then(|path| uri::folder(&path));
    let made = instantiate::<M>(Interface::CoSimulation, name.as_deref(), token.as_deref(), log, resources);
    if !made.is_null() {
        // SAFETY: not NULL, so the instance that has just been made, which nobody else knows yet.
        let instance = unsafe { &mut *made.cast::<Runtime<M>>() };
        instance.event_mode = EventMode { used: event_mode_used != 0, early_return: early_return_allowed != 0 };
    }
    made
}

/// See [`fmi3GetVersion`].
#[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
pub unsafe fn fmi3InstantiateScheduledExecution<M: Model>(
    instance_name: String,
    _instantiation_token: String,
    _resource_path: String,
    _visible: Boolean,
    logging_on: Boolean,
    instance_environment: InstanceEnvironment,
    log_message: LogMessageCallback,
    _clock_update: ClockUpdateCallback,
    _lock_preemption: LockPreemptionCallback,
    _unlock_preemption: UnlockPreemptionCallback,
) -> Instance {
    let log = log(log_message, instance_environment, logging_on != 0);
    // SAFETY: the text is the importer's, as the standard specifies.
    let name = unsafe { text(instance_name) };
    no_such_interface(name.as_deref(), &log, "scheduled execution")
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3FreeInstance<M: Model>(instance: Instance) {
    // SAFETY: the importer's instance, which it does not use again.
    unsafe { free::<M>(instance) }
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3EnterInitializationMode<M: Model>(
    instance: Instance,
    tolerance_defined: Boolean,
    tolerance: Float64,
    start_time: Float64,
    stop_time_defined: Boolean,
    stop_time: Float64,
) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::EnterInitializationMode, "fmi3EnterInitializationMode", |instance| {
            let tolerance = (tolerance_defined != 0).then_some(tolerance);
            instance.setup_experiment(tolerance, start_time, (stop_time_defined != 0).then_some(stop_time))?;
            instance.enter_initialization();
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3ExitInitializationMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::ExitInitializationMode, "fmi3ExitInitializationMode", |instance| {
            instance.exit_initialization()
        })
    }
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3Terminate<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::Terminate, "fmi3Terminate", |instance| {
            instance.phase = Phase::Terminated;
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`].
pub unsafe fn fmi3Reset<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::Reset, "fmi3Reset", |instance| {
            instance.reset();
            Ok(())
        })
    }
}
