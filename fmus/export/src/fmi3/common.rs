//! Version, life cycle and logging of FMI 3.0.

use std::ffi::c_char;

use swayless_abi::fmi3::*;

use super::callbacks::log;
use crate::fmi2::unknown_category;
use crate::instance::{EventMode, Instance as Runtime, Refusal};
use crate::model::Model;
use crate::phase::{Call, Interface, Phase};
use crate::raw::{Order, Surroundings, call, free, instantiate, slice, text};
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

/// What an importer says of an instance that it wants.
struct Wanted {
    interface: Interface,
    name: String,
    token: String,
    resource_path: String,
    logging_on: Boolean,
    log_message: LogMessageCallback,
    surroundings: Surroundings,
}

/// Makes an instance and prepares it.
///
/// # Safety
/// Texts and callbacks are the importer's, as FMI 3.0.2 specifies them; texts are copied.
unsafe fn make<M: Model>(wanted: Wanted, prepare: impl FnOnce(&mut Runtime<M>) -> Result<(), Refusal>) -> Instance {
    let log = log(wanted.log_message, wanted.surroundings.environment, wanted.logging_on != 0);
    // SAFETY: the caller's promise.
    let (name, token, path) = unsafe { (text(wanted.name), text(wanted.token), text(wanted.resource_path)) };
    let order = Order {
        interface: wanted.interface,
        may_have_clocks: true,
        name: name.as_deref(),
        token: token.as_deref(),
        resources: path.and_then(|path| uri::folder(&path)),
        surroundings: wanted.surroundings,
    };
    instantiate::<M>(order, log, prepare)
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
    let wanted = Wanted {
        interface: Interface::ModelExchange,
        name: instance_name,
        token: instantiation_token,
        resource_path,
        logging_on,
        log_message,
        surroundings: Surroundings { environment: instance_environment, ..Surroundings::default() },
    };
    // SAFETY: what is given is the importer's, as the standard specifies.
    unsafe { make::<M>(wanted, |_| Ok(())) }
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
    required_intermediate_variables: *const ValueReference,
    n_required_intermediate_variables: usize,
    instance_environment: InstanceEnvironment,
    log_message: LogMessageCallback,
    intermediate_update: IntermediateUpdateCallback,
) -> Instance {
    let wanted = Wanted {
        interface: Interface::CoSimulation,
        name: instance_name,
        token: instantiation_token,
        resource_path,
        logging_on,
        log_message,
        surroundings: Surroundings {
            environment: instance_environment,
            intermediate_update,
            ..Surroundings::default()
        },
    };
    // SAFETY: what is given is the importer's, as the standard specifies.
    unsafe {
        make::<M>(wanted, |instance| {
            instance.event_mode = EventMode { used: event_mode_used != 0, early_return: early_return_allowed != 0 };
            let required = (required_intermediate_variables, n_required_intermediate_variables);
            instance.require_intermediate(slice(required.0, required.1, "requiredIntermediateVariables")?)
        })
    }
}

/// See [`fmi3GetVersion`].
#[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
pub unsafe fn fmi3InstantiateScheduledExecution<M: Model>(
    instance_name: String,
    instantiation_token: String,
    resource_path: String,
    _visible: Boolean,
    logging_on: Boolean,
    instance_environment: InstanceEnvironment,
    log_message: LogMessageCallback,
    clock_update: ClockUpdateCallback,
    lock_preemption: LockPreemptionCallback,
    unlock_preemption: UnlockPreemptionCallback,
) -> Instance {
    let wanted = Wanted {
        interface: Interface::ScheduledExecution,
        name: instance_name,
        token: instantiation_token,
        resource_path,
        logging_on,
        log_message,
        surroundings: Surroundings {
            environment: instance_environment,
            clock_update,
            lock_preemption,
            unlock_preemption,
            ..Surroundings::default()
        },
    };
    // SAFETY: what is given is the importer's, as the standard specifies.
    unsafe { make::<M>(wanted, |_| Ok(())) }
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
