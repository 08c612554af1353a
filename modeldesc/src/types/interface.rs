//! The interfaces of an FMU.

/// One of the interfaces of an FMU with its capability flags. A flag that a version does not know is false.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Interface {
    /// `modelIdentifier`: the file name of the binary.
    pub model_identifier: String,
    /// `needsExecutionTool`.
    pub needs_execution_tool: bool,
    /// `canBeInstantiatedOnlyOncePerProcess`.
    pub can_be_instantiated_only_once_per_process: bool,
    /// `canNotUseMemoryManagementFunctions` (FMI 2.0).
    pub can_not_use_memory_management_functions: bool,
    /// `canGetAndSetFMUState`.
    pub can_get_and_set_fmu_state: bool,
    /// `canSerializeFMUState`.
    pub can_serialize_fmu_state: bool,
    /// `providesDirectionalDerivatives`.
    pub provides_directional_derivatives: bool,
    /// `providesAdjointDerivatives` (FMI 3.0).
    pub provides_adjoint_derivatives: bool,
    /// `providesPerElementDependencies` (FMI 3.0).
    pub provides_per_element_dependencies: bool,
    /// Model exchange: whether `CompletedIntegratorStep` must be called. FMI 2.0 says it the other way round, with
    /// `completedIntegratorStepNotNeeded`.
    pub needs_completed_integrator_step: bool,
    /// `providesEvaluateDiscreteStates` (FMI 3.0).
    pub provides_evaluate_discrete_states: bool,
    /// Co-simulation: `canHandleVariableCommunicationStepSize`.
    pub can_handle_variable_communication_step_size: bool,
    /// Co-simulation: `fixedInternalStepSize` (s, FMI 3.0).
    pub fixed_internal_step_size: Option<f64>,
    /// Co-simulation: `canInterpolateInputs` (FMI 2.0).
    pub can_interpolate_inputs: bool,
    /// Co-simulation: `maxOutputDerivativeOrder`.
    pub max_output_derivative_order: u32,
    /// Co-simulation: `recommendedIntermediateInputSmoothness` (FMI 3.0).
    pub recommended_intermediate_input_smoothness: i32,
    /// Co-simulation: `canRunAsynchronuously` (FMI 2.0, spelt as in the standard).
    pub can_run_asynchronuously: bool,
    /// Co-simulation: `providesIntermediateUpdate` (FMI 3.0).
    pub provides_intermediate_update: bool,
    /// Co-simulation: `mightReturnEarlyFromDoStep` (FMI 3.0).
    pub might_return_early_from_do_step: bool,
    /// Co-simulation: `canReturnEarlyAfterIntermediateUpdate` (FMI 3.0).
    pub can_return_early_after_intermediate_update: bool,
    /// Co-simulation: `hasEventMode` (FMI 3.0).
    pub has_event_mode: bool,
}
