//! What FMI 3.0 writes its own way: an element per type, references by value reference.

use super::*;
use crate::xml_out::hex;

const VERSION: FmiVersion = FmiVersion::V3;

pub(super) fn write(document: &mut Document, description: &ModelDescription) -> Result<(), WriteError> {
    document.open(root(description, "3.0", "instantiationToken"));
    interfaces(document, description);
    units(document, &description.units);
    types(document, &description.type_definitions)?;
    log_categories(document, &description.log_categories);
    default_experiment(document, description.default_experiment.as_ref());
    document.open(Element::new("ModelVariables"));
    for variable in &description.variables {
        write_variable(document, variable, description)?;
    }
    document.close();
    structure(document, description)?;
    document.close();
    Ok(())
}

fn interfaces(document: &mut Document, description: &ModelDescription) {
    if let Some(interface) = &description.model_exchange {
        document.empty(
            shared_flags("ModelExchange", interface)
                .flag("needsCompletedIntegratorStep", interface.needs_completed_integrator_step)
                .flag("providesEvaluateDiscreteStates", interface.provides_evaluate_discrete_states),
        );
    }
    if let Some(interface) = &description.co_simulation {
        document.empty(
            shared_flags("CoSimulation", interface)
                .flag("canHandleVariableCommunicationStepSize", interface.can_handle_variable_communication_step_size)
                .maybe_float("fixedInternalStepSize", interface.fixed_internal_step_size)
                .unless_default("maxOutputDerivativeOrder", interface.max_output_derivative_order, 0)
                .unless_default(
                    "recommendedIntermediateInputSmoothness",
                    interface.recommended_intermediate_input_smoothness,
                    0,
                )
                .flag("providesIntermediateUpdate", interface.provides_intermediate_update)
                .flag("mightReturnEarlyFromDoStep", interface.might_return_early_from_do_step)
                .flag("canReturnEarlyAfterIntermediateUpdate", interface.can_return_early_after_intermediate_update)
                .flag("hasEventMode", interface.has_event_mode)
                .flag("providesEvaluateDiscreteStates", interface.provides_evaluate_discrete_states),
        );
    }
    if let Some(interface) = &description.scheduled_execution {
        document.empty(shared_flags("ScheduledExecution", interface));
    }
}

fn shared_flags(name: &'static str, interface: &Interface) -> Element {
    Element::new(name)
        .text("modelIdentifier", &interface.model_identifier)
        .flag("needsExecutionTool", interface.needs_execution_tool)
        .flag("canBeInstantiatedOnlyOncePerProcess", interface.can_be_instantiated_only_once_per_process)
        .flag("canGetAndSetFMUState", interface.can_get_and_set_fmu_state)
        .flag("canSerializeFMUState", interface.can_serialize_fmu_state)
        .flag("providesDirectionalDerivatives", interface.provides_directional_derivatives)
        .flag("providesAdjointDerivatives", interface.provides_adjoint_derivatives)
        .flag("providesPerElementDependencies", interface.provides_per_element_dependencies)
}

/// The element of a type definition.
fn type_element(data_type: DataType) -> &'static str {
    match data_type {
        DataType::Float32 => "Float32Type",
        DataType::Float64 => "Float64Type",
        DataType::Int8 => "Int8Type",
        DataType::UInt8 => "UInt8Type",
        DataType::Int16 => "Int16Type",
        DataType::UInt16 => "UInt16Type",
        DataType::Int32 => "Int32Type",
        DataType::UInt32 => "UInt32Type",
        DataType::Int64 => "Int64Type",
        DataType::UInt64 => "UInt64Type",
        DataType::Boolean => "BooleanType",
        DataType::String => "StringType",
        DataType::Binary => "BinaryType",
        DataType::Enumeration => "EnumerationType",
        DataType::Clock => "ClockType",
    }
}

/// What a clock says of its ticks, which nothing else may and a clock must say.
fn ticks(element: Element, data_type: DataType, clock: Option<&Clock>, place: &str) -> Result<Element, WriteError> {
    let clock = match (data_type, clock) {
        (DataType::Clock, Some(clock)) => clock,
        (DataType::Clock, None) => {
            return Err(WriteError::not_in("FMI 3.0", format!("the clock `{place}`, without its interval,")));
        }
        (_, None) => return Ok(element),
        (_, Some(_)) => return Err(WriteError::Attributes { place: place.to_owned(), data_type }),
    };
    let counter = |value: Option<u64>| value.map(|value| value.to_string());
    Ok(element
        .text("intervalVariability", clock.interval_variability.as_str())
        .flag("canBeDeactivated", clock.can_be_deactivated)
        .maybe("priority", clock.priority.map(|value| value.to_string()).as_deref())
        .maybe_float("intervalDecimal", clock.interval_decimal)
        .maybe_float("shiftDecimal", clock.shift_decimal)
        .flag("supportsFraction", clock.supports_fraction)
        .maybe("resolution", counter(clock.resolution).as_deref())
        .maybe("intervalCounter", counter(clock.interval_counter).as_deref())
        .maybe("shiftCounter", counter(clock.shift_counter).as_deref()))
}

/// A clock is a scalar without a value of its own.
fn refuse_what_clocks_have_not(variable: &Variable) -> Result<(), WriteError> {
    let what = if !variable.dimensions.is_empty() {
        "dimensions"
    } else if variable.previous.is_some() {
        "previous"
    } else if variable.derivative.is_some() {
        "derivative"
    } else if variable.initial.is_some() {
        "initial"
    } else if variable.intermediate_update {
        "intermediateUpdate"
    } else if variable.reinit {
        "reinit"
    } else {
        return Ok(());
    };
    Err(WriteError::not_in("FMI 3.0", format!("{what} of the clock `{}`", variable.name)))
}

fn types(document: &mut Document, types: &[TypeDefinition]) -> Result<(), WriteError> {
    if types.is_empty() {
        return Ok(());
    }
    document.open(Element::new("TypeDefinitions"));
    for definition in types {
        let element = Element::new(type_element(definition.data_type))
            .text("name", &definition.name)
            .maybe("description", definition.description.as_deref());
        let element = attributes(element, definition.data_type, &definition.attributes, VERSION, &definition.name)?;
        let element = ticks(element, definition.data_type, definition.clock.as_ref(), &definition.name)?;
        if definition.items.is_empty() {
            document.empty(element);
        } else {
            document.open(element);
            items(document, &definition.items);
            document.close();
        }
    }
    document.close();
    Ok(())
}

fn write_variable(
    document: &mut Document,
    variable: &Variable,
    description: &ModelDescription,
) -> Result<(), WriteError> {
    if variable.data_type == DataType::Clock {
        refuse_what_clocks_have_not(variable)?;
    }
    let place = format!("`{}`", variable.name);
    let element = variable_head(Element::new(variable.data_type.as_str()), variable);
    let mut element = element
        .flag("intermediateUpdate", variable.intermediate_update)
        .maybe("declaredType", variable.declared_type.as_deref());
    if !variable.clocks.is_empty() {
        element = element.text("clocks", &join(&variable.clocks, u32::to_string));
    }
    if let Some(index) = variable.previous {
        element = element.text("previous", &reference(index, description, &place)?);
    }
    let element = attributes(element, variable.data_type, &variable.attributes, VERSION, &variable.name)?;
    let mut element = ticks(element, variable.data_type, variable.clock.as_ref(), &variable.name)?;
    let starts = start_elements(variable);
    if starts.is_none() {
        element = element.maybe("start", start(variable, VERSION)?.as_deref());
    }
    if let Some(state) = variable.derivative {
        element = element.text("derivative", &reference(state, description, &place)?);
    }
    let element = element.flag("reinit", variable.reinit);
    let starts = starts.unwrap_or_default();
    if variable.dimensions.is_empty() && starts.is_empty() && variable.aliases.is_empty() {
        document.empty(element);
        return Ok(());
    }
    document.open(element);
    for dimension in &variable.dimensions {
        let element = Element::new("Dimension");
        document.empty(match dimension {
            Dimension::Fixed(size) => element.text("start", &size.to_string()),
            Dimension::Variable(reference) => element.text("valueReference", &reference.to_string()),
        });
    }
    starts.into_iter().for_each(|e| document.empty(e));
    for alias in &variable.aliases {
        if alias.display_unit.is_some() && !variable.data_type.is_float() {
            return Err(WriteError::Attributes { place: alias.name.clone(), data_type: variable.data_type });
        }
        document.empty(
            Element::new("Alias")
                .text("name", &alias.name)
                .maybe("description", alias.description.as_deref())
                .maybe("displayUnit", alias.display_unit.as_deref()),
        );
    }
    document.close();
    Ok(())
}

/// `Start` elements, which strings and binaries have in place of the attribute.
fn start_elements(variable: &Variable) -> Option<Vec<Element>> {
    let element = |value: &str| Element::new("Start").text("value", value);
    match (&variable.start, variable.data_type) {
        (Some(Start::String(values)), DataType::String) => Some(values.iter().map(|v| element(v)).collect()),
        (Some(Start::Binary(values)), DataType::Binary) => {
            Some(values.iter().map(|bytes| element(&hex(bytes))).collect())
        }
        _ => None,
    }
}

/// References are value references.
fn reference(index: usize, description: &ModelDescription, place: &str) -> Result<String, WriteError> {
    match description.variables.get(index) {
        Some(variable) => Ok(variable.value_reference.to_string()),
        None => Err(WriteError::NoSuchVariable { place: place.to_owned(), index }),
    }
}

fn structure(document: &mut Document, description: &ModelDescription) -> Result<(), WriteError> {
    let structure = &description.structure;
    document.open(Element::new("ModelStructure"));
    for (name, unknowns) in [
        ("Output", &structure.outputs),
        ("ContinuousStateDerivative", &structure.derivatives),
        ("ClockedState", &structure.clocked_states),
        ("InitialUnknown", &structure.initial_unknowns),
        ("EventIndicator", &structure.event_indicators),
    ] {
        for entry in unknowns {
            document.empty(unknown(name, "valueReference", entry, |i| reference(i, description, name))?);
        }
    }
    document.close();
    Ok(())
}
