//! C types and functions of FMI 2.0.5 (headers `fmi2TypesPlatform.h`, `fmi2FunctionTypes.h`, `fmi2Functions.h`).

use core::ffi::{c_char, c_int, c_uint, c_void};

/// An FMU instance (`fmi2Component`).
pub type Component = *mut c_void;
/// What the importer wants back in its callbacks (`fmi2ComponentEnvironment`).
pub type ComponentEnvironment = *mut c_void;
/// A saved state of an FMU (`fmi2FMUstate`).
pub type FMUstate = *mut c_void;
/// Handle of a variable (`fmi2ValueReference`).
pub type ValueReference = c_uint;
/// `fmi2Real`.
pub type Real = f64;
/// `fmi2Integer`.
pub type Integer = c_int;
/// `fmi2Boolean`: 0 is false, 1 is true.
pub type Boolean = c_int;
/// `fmi2String`: UTF-8, ends with a NUL.
pub type String = *const c_char;
/// `fmi2Byte`.
pub type Byte = c_char;

/// `fmi2Status`. A plain number, since a foreign FMU may return any.
pub type Status = c_int;
/// All well.
pub const OK: Status = 0;
/// Not quite right, but the computation goes on.
pub const WARNING: Status = 1;
/// The call was refused; the instance is as it was.
pub const DISCARD: Status = 2;
/// The instance cannot go on; others can.
pub const ERROR: Status = 3;
/// All instances of this FMU are broken.
pub const FATAL: Status = 4;
/// An asynchronous step is under way.
pub const PENDING: Status = 5;

/// `fmi2Type`: 0 is model exchange, 1 is co-simulation.
pub type Type = c_int;
/// Instantiate for model exchange.
pub const MODEL_EXCHANGE: Type = 0;
/// Instantiate for co-simulation.
pub const CO_SIMULATION: Type = 1;

/// `fmi2StatusKind`: what `fmi2Get…Status` is asked for.
pub type StatusKind = c_int;
/// The status of an asynchronous step.
pub const DO_STEP_STATUS: StatusKind = 0;
/// A text on a pending step.
pub const PENDING_STATUS: StatusKind = 1;
/// The end of the last successful step.
pub const LAST_SUCCESSFUL_TIME: StatusKind = 2;
/// Whether the FMU wants to terminate.
pub const TERMINATED: StatusKind = 3;

/// `fmi2CallbackLogger`: printf-like, so texts are passed through `"%s"`.
pub type CallbackLogger = Option<unsafe extern "C" fn(ComponentEnvironment, String, Status, String, String, ...)>;
/// `fmi2CallbackAllocateMemory`.
pub type CallbackAllocateMemory = Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>;
/// `fmi2CallbackFreeMemory`.
pub type CallbackFreeMemory = Option<unsafe extern "C" fn(*mut c_void)>;
/// `fmi2StepFinished`.
pub type StepFinished = Option<unsafe extern "C" fn(ComponentEnvironment, Status)>;

/// `fmi2CallbackFunctions`.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct CallbackFunctions {
    /// Takes log messages; may be NULL.
    pub logger: CallbackLogger,
    /// `calloc` of the importer; may be NULL.
    pub allocate_memory: CallbackAllocateMemory,
    /// `free` of the importer; may be NULL.
    pub free_memory: CallbackFreeMemory,
    /// Called when an asynchronous step ends; may be NULL.
    pub step_finished: StepFinished,
    /// Passed back in every callback; may be NULL.
    pub component_environment: ComponentEnvironment,
}

/// `fmi2EventInfo`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EventInfo {
    /// Call `fmi2NewDiscreteStates` again.
    pub new_discrete_states_needed: Boolean,
    /// Stop the simulation.
    pub terminate_simulation: Boolean,
    /// Ask for the nominal values again.
    pub nominals_of_continuous_states_changed: Boolean,
    /// Ask for the states again.
    pub values_of_continuous_states_changed: Boolean,
    /// `next_event_time` holds.
    pub next_event_time_defined: Boolean,
    /// When the next time event is due (s).
    pub next_event_time: Real,
}

/// Hands the table of all functions of FMI 2.0.5 to the macro named in the brackets, followed by what else stands there.
///
/// The callback is expanded where the types of [`fmi2`](crate::fmi2) are in scope. The exporter makes the C symbols
/// from the table, the importer the struct of function pointers.
#[macro_export]
macro_rules! fmi2_functions {
    ([$($callback:tt)*] $($extra:tt)*) => {
        $($callback)*! {
            [$($extra)*]
            fn fmi2GetTypesPlatform() -> String;
            fn fmi2GetVersion() -> String;
            fn fmi2SetDebugLogging(
                c: Component, logging_on: Boolean, n_categories: usize, categories: *const String
            ) -> Status;
            fn fmi2Instantiate(
                instance_name: String, fmu_type: Type, fmu_guid: String, fmu_resource_location: String,
                functions: *const CallbackFunctions, visible: Boolean, logging_on: Boolean
            ) -> Component;
            fn fmi2FreeInstance(c: Component);
            fn fmi2SetupExperiment(
                c: Component, tolerance_defined: Boolean, tolerance: Real, start_time: Real,
                stop_time_defined: Boolean, stop_time: Real
            ) -> Status;
            fn fmi2EnterInitializationMode(c: Component) -> Status;
            fn fmi2ExitInitializationMode(c: Component) -> Status;
            fn fmi2Terminate(c: Component) -> Status;
            fn fmi2Reset(c: Component) -> Status;
            fn fmi2GetReal(c: Component, vr: *const ValueReference, nvr: usize, value: *mut Real) -> Status;
            fn fmi2GetInteger(c: Component, vr: *const ValueReference, nvr: usize, value: *mut Integer) -> Status;
            fn fmi2GetBoolean(c: Component, vr: *const ValueReference, nvr: usize, value: *mut Boolean) -> Status;
            fn fmi2GetString(c: Component, vr: *const ValueReference, nvr: usize, value: *mut String) -> Status;
            fn fmi2SetReal(c: Component, vr: *const ValueReference, nvr: usize, value: *const Real) -> Status;
            fn fmi2SetInteger(c: Component, vr: *const ValueReference, nvr: usize, value: *const Integer) -> Status;
            fn fmi2SetBoolean(c: Component, vr: *const ValueReference, nvr: usize, value: *const Boolean) -> Status;
            fn fmi2SetString(c: Component, vr: *const ValueReference, nvr: usize, value: *const String) -> Status;
            fn fmi2GetFMUstate(c: Component, fmu_state: *mut FMUstate) -> Status;
            fn fmi2SetFMUstate(c: Component, fmu_state: FMUstate) -> Status;
            fn fmi2FreeFMUstate(c: Component, fmu_state: *mut FMUstate) -> Status;
            fn fmi2SerializedFMUstateSize(c: Component, fmu_state: FMUstate, size: *mut usize) -> Status;
            fn fmi2SerializeFMUstate(c: Component, fmu_state: FMUstate, serialized_state: *mut Byte, size: usize) -> Status;
            fn fmi2DeSerializeFMUstate(
                c: Component, serialized_state: *const Byte, size: usize, fmu_state: *mut FMUstate
            ) -> Status;
            fn fmi2GetDirectionalDerivative(
                c: Component, v_unknown_ref: *const ValueReference, n_unknown: usize,
                v_known_ref: *const ValueReference, n_known: usize, dv_known: *const Real, dv_unknown: *mut Real
            ) -> Status;
            fn fmi2EnterEventMode(c: Component) -> Status;
            fn fmi2NewDiscreteStates(c: Component, fmi2event_info: *mut EventInfo) -> Status;
            fn fmi2EnterContinuousTimeMode(c: Component) -> Status;
            fn fmi2CompletedIntegratorStep(
                c: Component, no_set_fmu_state_prior_to_current_point: Boolean, enter_event_mode: *mut Boolean,
                terminate_simulation: *mut Boolean
            ) -> Status;
            fn fmi2SetTime(c: Component, time: Real) -> Status;
            fn fmi2SetContinuousStates(c: Component, x: *const Real, nx: usize) -> Status;
            fn fmi2GetDerivatives(c: Component, derivatives: *mut Real, nx: usize) -> Status;
            fn fmi2GetEventIndicators(c: Component, event_indicators: *mut Real, ni: usize) -> Status;
            fn fmi2GetContinuousStates(c: Component, x: *mut Real, nx: usize) -> Status;
            fn fmi2GetNominalsOfContinuousStates(c: Component, x_nominal: *mut Real, nx: usize) -> Status;
            fn fmi2SetRealInputDerivatives(
                c: Component, vr: *const ValueReference, nvr: usize, order: *const Integer, value: *const Real
            ) -> Status;
            fn fmi2GetRealOutputDerivatives(
                c: Component, vr: *const ValueReference, nvr: usize, order: *const Integer, value: *mut Real
            ) -> Status;
            fn fmi2DoStep(
                c: Component, current_communication_point: Real, communication_step_size: Real,
                no_set_fmu_state_prior_to_current_point: Boolean
            ) -> Status;
            fn fmi2CancelStep(c: Component) -> Status;
            fn fmi2GetStatus(c: Component, s: StatusKind, value: *mut Status) -> Status;
            fn fmi2GetRealStatus(c: Component, s: StatusKind, value: *mut Real) -> Status;
            fn fmi2GetIntegerStatus(c: Component, s: StatusKind, value: *mut Integer) -> Status;
            fn fmi2GetBooleanStatus(c: Component, s: StatusKind, value: *mut Boolean) -> Status;
            fn fmi2GetStringStatus(c: Component, s: StatusKind, value: *mut String) -> Status;
        }
    };
}

crate::function_pointers! { fmi2_functions }
