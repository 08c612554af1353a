//! C types and functions of FMI 3.0.2 (headers `fmi3PlatformTypes.h`, `fmi3FunctionTypes.h`, `fmi3Functions.h`).

use core::ffi::{c_char, c_int, c_void};

/// An FMU instance (`fmi3Instance`).
pub type Instance = *mut c_void;
/// What the importer wants back in its callbacks (`fmi3InstanceEnvironment`).
pub type InstanceEnvironment = *mut c_void;
/// A saved state of an FMU (`fmi3FMUState`).
pub type FMUState = *mut c_void;
/// Handle of a variable (`fmi3ValueReference`).
pub type ValueReference = u32;
/// `fmi3Float32`.
pub type Float32 = f32;
/// `fmi3Float64`.
pub type Float64 = f64;
/// `fmi3Int8`.
pub type Int8 = i8;
/// `fmi3UInt8`.
pub type UInt8 = u8;
/// `fmi3Int16`.
pub type Int16 = i16;
/// `fmi3UInt16`.
pub type UInt16 = u16;
/// `fmi3Int32`.
pub type Int32 = i32;
/// `fmi3UInt32`.
pub type UInt32 = u32;
/// `fmi3Int64`.
pub type Int64 = i64;
/// `fmi3UInt64`.
pub type UInt64 = u64;
/// `fmi3Boolean`, a C `bool`. A byte here, since a careless caller may pass something other than 0 and 1.
pub type Boolean = u8;
/// `fmi3String`: UTF-8, ends with a NUL.
pub type String = *const c_char;
/// `fmi3Byte`.
pub type Byte = u8;
/// `fmi3Binary`.
pub type Binary = *const u8;
/// `fmi3Clock`, a C `bool` like [`Boolean`].
pub type Clock = u8;

/// `fmi3Status`. A plain number, since a foreign FMU may return any.
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

/// `fmi3DependencyKind`.
pub type DependencyKind = c_int;
/// `fmi3IntervalQualifier`.
pub type IntervalQualifier = c_int;

/// `fmi3LogMessageCallback`.
pub type LogMessageCallback = Option<unsafe extern "C" fn(InstanceEnvironment, Status, String, String)>;
/// `fmi3ClockUpdateCallback`.
pub type ClockUpdateCallback = Option<unsafe extern "C" fn(InstanceEnvironment)>;
/// `fmi3IntermediateUpdateCallback`.
pub type IntermediateUpdateCallback = Option<
    unsafe extern "C" fn(InstanceEnvironment, Float64, Boolean, Boolean, Boolean, Boolean, *mut Boolean, *mut Float64),
>;
/// `fmi3LockPreemptionCallback`.
pub type LockPreemptionCallback = Option<unsafe extern "C" fn()>;
/// `fmi3UnlockPreemptionCallback`.
pub type UnlockPreemptionCallback = Option<unsafe extern "C" fn()>;

/// Hands the table of all functions of FMI 3.0.2 to the macro named in the brackets, followed by what else stands there.
///
/// The callback is expanded where the types of [`fmi3`](crate::fmi3) are in scope. The exporter makes the C symbols
/// from the table, the importer the struct of function pointers.
#[macro_export]
macro_rules! fmi3_functions {
    ([$($callback:tt)*] $($extra:tt)*) => {
        $($callback)*! {
            [$($extra)*]
            fn fmi3GetVersion() -> String;
            fn fmi3SetDebugLogging(
                instance: Instance, logging_on: Boolean, n_categories: usize, categories: *const String
            ) -> Status;
            fn fmi3InstantiateModelExchange(
                instance_name: String, instantiation_token: String, resource_path: String, visible: Boolean,
                logging_on: Boolean, instance_environment: InstanceEnvironment, log_message: LogMessageCallback
            ) -> Instance;
            fn fmi3InstantiateCoSimulation(
                instance_name: String, instantiation_token: String, resource_path: String, visible: Boolean,
                logging_on: Boolean, event_mode_used: Boolean, early_return_allowed: Boolean,
                required_intermediate_variables: *const ValueReference, n_required_intermediate_variables: usize,
                instance_environment: InstanceEnvironment, log_message: LogMessageCallback,
                intermediate_update: IntermediateUpdateCallback
            ) -> Instance;
            fn fmi3InstantiateScheduledExecution(
                instance_name: String, instantiation_token: String, resource_path: String, visible: Boolean,
                logging_on: Boolean, instance_environment: InstanceEnvironment, log_message: LogMessageCallback,
                clock_update: ClockUpdateCallback, lock_preemption: LockPreemptionCallback,
                unlock_preemption: UnlockPreemptionCallback
            ) -> Instance;
            fn fmi3FreeInstance(instance: Instance);
            fn fmi3EnterInitializationMode(
                instance: Instance, tolerance_defined: Boolean, tolerance: Float64, start_time: Float64,
                stop_time_defined: Boolean, stop_time: Float64
            ) -> Status;
            fn fmi3ExitInitializationMode(instance: Instance) -> Status;
            fn fmi3EnterEventMode(instance: Instance) -> Status;
            fn fmi3Terminate(instance: Instance) -> Status;
            fn fmi3Reset(instance: Instance) -> Status;
            fn fmi3GetFloat32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Float32, n_values: usize
            ) -> Status;
            fn fmi3GetFloat64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Float64, n_values: usize
            ) -> Status;
            fn fmi3GetInt8(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Int8, n_values: usize
            ) -> Status;
            fn fmi3GetUInt8(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut UInt8, n_values: usize
            ) -> Status;
            fn fmi3GetInt16(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Int16, n_values: usize
            ) -> Status;
            fn fmi3GetUInt16(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut UInt16, n_values: usize
            ) -> Status;
            fn fmi3GetInt32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Int32, n_values: usize
            ) -> Status;
            fn fmi3GetUInt32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut UInt32, n_values: usize
            ) -> Status;
            fn fmi3GetInt64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Int64, n_values: usize
            ) -> Status;
            fn fmi3GetUInt64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut UInt64, n_values: usize
            ) -> Status;
            fn fmi3GetBoolean(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Boolean, n_values: usize
            ) -> Status;
            fn fmi3GetString(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut String, n_values: usize
            ) -> Status;
            fn fmi3GetBinary(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                value_sizes: *mut usize, values: *mut Binary, n_values: usize
            ) -> Status;
            fn fmi3GetClock(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *mut Clock
            ) -> Status;
            fn fmi3SetFloat32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Float32, n_values: usize
            ) -> Status;
            fn fmi3SetFloat64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Float64, n_values: usize
            ) -> Status;
            fn fmi3SetInt8(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Int8, n_values: usize
            ) -> Status;
            fn fmi3SetUInt8(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const UInt8, n_values: usize
            ) -> Status;
            fn fmi3SetInt16(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Int16, n_values: usize
            ) -> Status;
            fn fmi3SetUInt16(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const UInt16, n_values: usize
            ) -> Status;
            fn fmi3SetInt32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Int32, n_values: usize
            ) -> Status;
            fn fmi3SetUInt32(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const UInt32, n_values: usize
            ) -> Status;
            fn fmi3SetInt64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Int64, n_values: usize
            ) -> Status;
            fn fmi3SetUInt64(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const UInt64, n_values: usize
            ) -> Status;
            fn fmi3SetBoolean(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Boolean, n_values: usize
            ) -> Status;
            fn fmi3SetString(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const String, n_values: usize
            ) -> Status;
            fn fmi3SetBinary(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                value_sizes: *const usize, values: *const Binary, n_values: usize
            ) -> Status;
            fn fmi3SetClock(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                values: *const Clock
            ) -> Status;
            fn fmi3GetNumberOfVariableDependencies(
                instance: Instance, value_reference: ValueReference, n_dependencies: *mut usize
            ) -> Status;
            fn fmi3GetVariableDependencies(
                instance: Instance, dependent: ValueReference, element_indices_of_dependent: *mut usize,
                independents: *mut ValueReference, element_indices_of_independents: *mut usize,
                dependency_kinds: *mut DependencyKind, n_dependencies: usize
            ) -> Status;
            fn fmi3GetFMUState(instance: Instance, fmu_state: *mut FMUState) -> Status;
            fn fmi3SetFMUState(instance: Instance, fmu_state: FMUState) -> Status;
            fn fmi3FreeFMUState(instance: Instance, fmu_state: *mut FMUState) -> Status;
            fn fmi3SerializedFMUStateSize(instance: Instance, fmu_state: FMUState, size: *mut usize) -> Status;
            fn fmi3SerializeFMUState(
                instance: Instance, fmu_state: FMUState, serialized_state: *mut Byte, size: usize
            ) -> Status;
            fn fmi3DeserializeFMUState(
                instance: Instance, serialized_state: *const Byte, size: usize, fmu_state: *mut FMUState
            ) -> Status;
            fn fmi3GetDirectionalDerivative(
                instance: Instance, unknowns: *const ValueReference, n_unknowns: usize,
                knowns: *const ValueReference, n_knowns: usize, seed: *const Float64, n_seed: usize,
                sensitivity: *mut Float64, n_sensitivity: usize
            ) -> Status;
            fn fmi3GetAdjointDerivative(
                instance: Instance, unknowns: *const ValueReference, n_unknowns: usize,
                knowns: *const ValueReference, n_knowns: usize, seed: *const Float64, n_seed: usize,
                sensitivity: *mut Float64, n_sensitivity: usize
            ) -> Status;
            fn fmi3EnterConfigurationMode(instance: Instance) -> Status;
            fn fmi3ExitConfigurationMode(instance: Instance) -> Status;
            fn fmi3GetIntervalDecimal(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                intervals: *mut Float64, qualifiers: *mut IntervalQualifier
            ) -> Status;
            fn fmi3GetIntervalFraction(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                counters: *mut UInt64, resolutions: *mut UInt64, qualifiers: *mut IntervalQualifier
            ) -> Status;
            fn fmi3GetShiftDecimal(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                shifts: *mut Float64
            ) -> Status;
            fn fmi3GetShiftFraction(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                counters: *mut UInt64, resolutions: *mut UInt64
            ) -> Status;
            fn fmi3SetIntervalDecimal(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                intervals: *const Float64
            ) -> Status;
            fn fmi3SetIntervalFraction(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                counters: *const UInt64, resolutions: *const UInt64
            ) -> Status;
            fn fmi3SetShiftDecimal(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                shifts: *const Float64
            ) -> Status;
            fn fmi3SetShiftFraction(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                counters: *const UInt64, resolutions: *const UInt64
            ) -> Status;
            fn fmi3EvaluateDiscreteStates(instance: Instance) -> Status;
            fn fmi3UpdateDiscreteStates(
                instance: Instance, discrete_states_need_update: *mut Boolean, terminate_simulation: *mut Boolean,
                nominals_of_continuous_states_changed: *mut Boolean,
                values_of_continuous_states_changed: *mut Boolean, next_event_time_defined: *mut Boolean,
                next_event_time: *mut Float64
            ) -> Status;
            fn fmi3EnterContinuousTimeMode(instance: Instance) -> Status;
            fn fmi3CompletedIntegratorStep(
                instance: Instance, no_set_fmu_state_prior_to_current_point: Boolean, enter_event_mode: *mut Boolean,
                terminate_simulation: *mut Boolean
            ) -> Status;
            fn fmi3SetTime(instance: Instance, time: Float64) -> Status;
            fn fmi3SetContinuousStates(
                instance: Instance, continuous_states: *const Float64, n_continuous_states: usize
            ) -> Status;
            fn fmi3GetContinuousStateDerivatives(
                instance: Instance, derivatives: *mut Float64, n_continuous_states: usize
            ) -> Status;
            fn fmi3GetEventIndicators(
                instance: Instance, event_indicators: *mut Float64, n_event_indicators: usize
            ) -> Status;
            fn fmi3GetContinuousStates(
                instance: Instance, continuous_states: *mut Float64, n_continuous_states: usize
            ) -> Status;
            fn fmi3GetNominalsOfContinuousStates(
                instance: Instance, nominals: *mut Float64, n_continuous_states: usize
            ) -> Status;
            fn fmi3GetNumberOfEventIndicators(instance: Instance, n_event_indicators: *mut usize) -> Status;
            fn fmi3GetNumberOfContinuousStates(instance: Instance, n_continuous_states: *mut usize) -> Status;
            fn fmi3EnterStepMode(instance: Instance) -> Status;
            fn fmi3GetOutputDerivatives(
                instance: Instance, value_references: *const ValueReference, n_value_references: usize,
                orders: *const Int32, values: *mut Float64, n_values: usize
            ) -> Status;
            fn fmi3DoStep(
                instance: Instance, current_communication_point: Float64, communication_step_size: Float64,
                no_set_fmu_state_prior_to_current_point: Boolean, event_handling_needed: *mut Boolean,
                terminate_simulation: *mut Boolean, early_return: *mut Boolean, last_successful_time: *mut Float64
            ) -> Status;
            fn fmi3ActivateModelPartition(
                instance: Instance, clock_reference: ValueReference, activation_time: Float64
            ) -> Status;
        }
    };
}

crate::function_pointers! { fmi3_functions }
