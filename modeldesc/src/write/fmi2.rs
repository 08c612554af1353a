//! What FMI 2.0 writes its own way: typed children of `ScalarVariable`, references by 1-based index.

use super::*;

const VERSION: FmiVersion = FmiVersion::V2;

pub(super) fn write(document: &mut Document, description: &ModelDescription) -> Result<(), WriteError> {
    refuse_what_is_new(description)?;
    let mut root = root(description, "2.0", "guid");
    if description.model_exchange.is_some() || description.number_of_event_indicators > 0 {
        root = root.text("numberOfEventIndicators", &description.number_of_event_indicators.to_string());
    }
    document.open(root);
    interfaces(document, description);
    units(document, &description.units);
    types(document, &description.type_definitions)?;
    log_categories(document, &description.log_categories);
    default_experiment(document, description.default_experiment.as_ref());
    document.open(Element::new("ModelVariables"));
    for variable in &description.variables {
        scalar_variable(document, variable, description.variables.len())?;
    }
    document.close();
    structure(document, description)?;
    document.close();
    Ok(())
}

fn refuse_what_is_new(description: &ModelDescription) -> Result<(), WriteError> {
    let refuse = |what: String| Err(WriteError::not_in("FMI 2.0", what));
    if description.scheduled_execution.is_some() {
        return refuse("scheduled execution".to_owned());
    }
    if !description.structure.clocked_states.is_empty() {
        return refuse("a clocked state".to_owned());
    }
    for unit in &description.units {
        if let Some(display) = unit.display_units.iter().find(|d| d.inverse) {
            return refuse(format!("the inverse display unit `{}`", display.name));
        }
    }
    for variable in &description.variables {
        let name = &variable.name;
        if variable.clock.is_some() {
            return Err(WriteError::Attributes { place: name.clone(), data_type: variable.data_type });
        }
        let what = if !variable.dimensions.is_empty() {
            "dimensions"
        } else if !variable.aliases.is_empty() {
            "aliases"
        } else if variable.intermediate_update {
            "intermediateUpdate"
        } else if !variable.clocks.is_empty() {
            "clocks"
        } else if variable.previous.is_some() {
            "previous"
        } else if variable.causality == Causality::StructuralParameter {
            "the causality structuralParameter"
        } else {
            continue;
        };
        return refuse(format!("{what} of `{name}`"));
    }
    Ok(())
}

fn interfaces(document: &mut Document, description: &ModelDescription) {
    if let Some(interface) = &description.model_exchange {
        let element = Element::new("ModelExchange")
            .text("modelIdentifier", &interface.model_identifier)
            .flag("needsExecutionTool", interface.needs_execution_tool)
            .flag("completedIntegratorStepNotNeeded", !interface.needs_completed_integrator_step);
        document.empty(shared_flags(element, interface));
    }
    if let Some(interface) = &description.co_simulation {
        let element = Element::new("CoSimulation")
            .text("modelIdentifier", &interface.model_identifier)
            .flag("needsExecutionTool", interface.needs_execution_tool)
            .flag("canHandleVariableCommunicationStepSize", interface.can_handle_variable_communication_step_size)
            .flag("canInterpolateInputs", interface.can_interpolate_inputs)
            .unless_default("maxOutputDerivativeOrder", interface.max_output_derivative_order, 0)
            .flag("canRunAsynchronuously", interface.can_run_asynchronuously);
        document.empty(shared_flags(element, interface));
    }
}

fn shared_flags(element: Element, interface: &Interface) -> Element {
    element
        .flag("canBeInstantiatedOnlyOncePerProcess", interface.can_be_instantiated_only_once_per_process)
        .flag("canNotUseMemoryManagementFunctions", interface.can_not_use_memory_management_functions)
        .flag("canGetAndSetFMUstate", interface.can_get_and_set_fmu_state)
        .flag("canSerializeFMUstate", interface.can_serialize_fmu_state)
        .flag("providesDirectionalDerivative", interface.provides_directional_derivatives)
}

/// What FMI 2.0 calls a type.
fn element_of(data_type: DataType, of: &str) -> Result<&'static str, WriteError> {
    Ok(match data_type {
        DataType::Float64 => "Real",
        DataType::Int32 => "Integer",
        DataType::Boolean => "Boolean",
        DataType::String => "String",
        DataType::Enumeration => "Enumeration",
        _ => {
            let what = format!("the type {} of `{of}`", data_type.as_str());
            return Err(WriteError::not_in("FMI 2.0", what));
        }
    })
}

fn types(document: &mut Document, types: &[TypeDefinition]) -> Result<(), WriteError> {
    if types.is_empty() {
        return Ok(());
    }
    document.open(Element::new("TypeDefinitions"));
    for definition in types {
        let kind = Element::new(element_of(definition.data_type, &definition.name)?);
        if definition.data_type == DataType::Enumeration
            && (definition.attributes.min.is_some() || definition.attributes.max.is_some())
        {
            let what = format!("bounds of the enumeration type `{}`", definition.name);
            return Err(WriteError::not_in("FMI 2.0", what));
        }
        let kind = attributes(kind, definition.data_type, &definition.attributes, VERSION, &definition.name)?;
        document.open(
            Element::new("SimpleType")
                .text("name", &definition.name)
                .maybe("description", definition.description.as_deref()),
        );
        if definition.items.is_empty() {
            document.empty(kind);
        } else {
            document.open(kind);
            items(document, &definition.items);
            document.close();
        }
        document.close();
    }
    document.close();
    Ok(())
}

fn scalar_variable(document: &mut Document, variable: &Variable, variables: usize) -> Result<(), WriteError> {
    let kind = Element::new(element_of(variable.data_type, &variable.name)?)
        .maybe("declaredType", variable.declared_type.as_deref());
    let mut kind = attributes(kind, variable.data_type, &variable.attributes, VERSION, &variable.name)?;
    let wrong_start = || WriteError::StartType { variable: variable.name.clone(), data_type: variable.data_type };
    match &variable.start {
        Some(Start::String(values)) if variable.data_type == DataType::String => {
            let [value] = values.as_slice() else {
                return Err(wrong_start());
            };
            kind = kind.text("start", value);
        }
        _ => {
            let one = match &variable.start {
                Some(Start::Float(values)) => values.len() == 1,
                Some(Start::Integer(values)) => values.len() == 1,
                Some(Start::Boolean(values)) => values.len() == 1,
                Some(_) => false,
                None => true,
            };
            if !one {
                return Err(wrong_start());
            }
            kind = kind.maybe("start", start(variable, VERSION)?.as_deref());
        }
    }
    if let Some(state) = variable.derivative {
        let place = format!("`derivative` of `{}`", variable.name);
        kind = kind.text("derivative", &reference(state, variables, &place)?);
    }
    document.open(variable_head(Element::new("ScalarVariable"), variable));
    document.empty(kind.flag("reinit", variable.reinit));
    document.close();
    Ok(())
}

/// The standard counts from 1.
fn reference(index: usize, variables: usize, place: &str) -> Result<String, WriteError> {
    if index < variables {
        Ok((index + 1).to_string())
    } else {
        Err(WriteError::NoSuchVariable { place: place.to_owned(), index })
    }
}

fn structure(document: &mut Document, description: &ModelDescription) -> Result<(), WriteError> {
    let structure = &description.structure;
    let variables = description.variables.len();
    document.open(Element::new("ModelStructure"));
    for (list, unknowns) in [
        ("Outputs", &structure.outputs),
        ("Derivatives", &structure.derivatives),
        ("InitialUnknowns", &structure.initial_unknowns),
    ] {
        let elements: Vec<Element> = unknowns
            .iter()
            .map(|u| unknown("Unknown", "index", u, |i| reference(i, variables, list)))
            .collect::<Result<_, _>>()?;
        if !elements.is_empty() {
            document.open(Element::new(list));
            elements.into_iter().for_each(|e| document.empty(e));
            document.close();
        }
    }
    document.close();
    Ok(())
}
