//! Version, life cycle and logging of FMI 2.0.

use std::ffi::c_char;

use swayless_abi::fmi2::*;

use super::callbacks::log;
use crate::instance::Refusal;
use crate::model::Model;
use crate::phase::{Call, Interface, Phase};
use crate::raw::{Order, Surroundings, call, free, instantiate, slice, text};
use crate::uri;

/// The pointers of all functions here are the importer's, as FMI 2.0.5 specifies them.
pub unsafe fn fmi2GetTypesPlatform<M: Model>() -> *const c_char {
    c"default".as_ptr()
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2GetVersion<M: Model>() -> *const c_char {
    c"2.0".as_ptr()
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2SetDebugLogging<M: Model>(
    c: Component,
    logging_on: Boolean,
    n_categories: usize,
    categories: *const String,
) -> Status {
    // SAFETY: the instance and the array are the importer's, as the standard specifies.
    unsafe {
        call::<M>(c, Call::SetDebugLogging, "fmi2SetDebugLogging", |instance| {
            let categories = slice(categories, n_categories, "categories")?;
            let names: Vec<_> = categories.iter().map(|name| text(*name).unwrap_or_default()).collect();
            instance.log.set(logging_on != 0, names.iter().map(AsRef::as_ref)).map_err(unknown_category)
        })
    }
}

pub(crate) fn unknown_category(name: std::string::String) -> Refusal {
    Refusal::error(format!("there is no log category {name}; the model description lists them"))
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2Instantiate<M: Model>(
    instance_name: String,
    fmu_type: Type,
    fmu_guid: String,
    fmu_resource_location: String,
    functions: *const CallbackFunctions,
    _visible: Boolean,
    logging_on: Boolean,
) -> Component {
    // SAFETY: texts and callbacks are the importer's, as the standard specifies; texts are copied.
    let (name, guid, location, log) =
        unsafe { (text(instance_name), text(fmu_guid), text(fmu_resource_location), log(functions, logging_on != 0)) };
    let interface = if fmu_type == MODEL_EXCHANGE { Interface::ModelExchange } else { Interface::CoSimulation };
    let resources = location.and_then(|location| uri::folder(&location));
    let order = Order {
        interface,
        may_have_clocks: false,
        name: name.as_deref(),
        token: guid.as_deref(),
        resources,
        surroundings: Surroundings::default(),
    };
    instantiate::<M>(order, log, |_| Ok(()))
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2FreeInstance<M: Model>(c: Component) {
    // SAFETY: the importer's instance, which it does not use again.
    unsafe { free::<M>(c) }
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2SetupExperiment<M: Model>(
    c: Component,
    tolerance_defined: Boolean,
    tolerance: Real,
    start_time: Real,
    stop_time_defined: Boolean,
    stop_time: Real,
) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::SetupExperiment, "fmi2SetupExperiment", |instance| {
            let tolerance = (tolerance_defined != 0).then_some(tolerance);
            instance.setup_experiment(tolerance, start_time, (stop_time_defined != 0).then_some(stop_time))
        })
    }
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2EnterInitializationMode<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::EnterInitializationMode, "fmi2EnterInitializationMode", |instance| {
            instance.enter_initialization();
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2ExitInitializationMode<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::ExitInitializationMode, "fmi2ExitInitializationMode", |instance| {
            instance.exit_initialization()
        })
    }
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2Terminate<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::Terminate, "fmi2Terminate", |instance| {
            instance.phase = Phase::Terminated;
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`].
pub unsafe fn fmi2Reset<M: Model>(c: Component) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(c, Call::Reset, "fmi2Reset", |instance| {
            instance.reset();
            Ok(())
        })
    }
}
