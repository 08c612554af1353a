//! What FMI 3.0 writes its own way.

use super::common::{attributes, default_experiment, items, log_categories, start, units};
use super::structure::{References, unknown};
use super::{read_initial, root, variable_head};
use crate::problem::Report;
use crate::types::*;
use crate::xml_in::{Child, Fields, Node, check_children, hex_bytes};

const VERSION: FmiVersion = FmiVersion::V3;

pub(super) fn read(node: &Node, report: &mut Report) -> ModelDescription {
    let mut fields = Fields::of(node);
    let mut description = root(&mut fields, VERSION, "instantiationToken", report);
    fields.finish(report);
    check_children(
        node,
        &[
            Child::Maybe("ModelExchange"),
            Child::Maybe("CoSimulation"),
            Child::Maybe("ScheduledExecution"),
            Child::Maybe("UnitDefinitions"),
            Child::Maybe("TypeDefinitions"),
            Child::Maybe("LogCategories"),
            Child::Maybe("DefaultExperiment"),
            Child::Once("ModelVariables"),
            Child::Once("ModelStructure"),
        ],
        report,
    );
    let mut references = Vec::new();
    for child in &node.children {
        match child.name.as_str() {
            "ModelExchange" => description.model_exchange = Some(interface(child, report)),
            "CoSimulation" => description.co_simulation = Some(interface(child, report)),
            "ScheduledExecution" => description.scheduled_execution = Some(interface(child, report)),
            "UnitDefinitions" => description.units = units(child, VERSION, report),
            "TypeDefinitions" => description.type_definitions = types(child, report),
            "LogCategories" => description.log_categories = log_categories(child, report),
            "DefaultExperiment" => description.default_experiment = Some(default_experiment(child, report)),
            "ModelVariables" => (description.variables, references) = variables(child, report),
            _ => {}
        }
    }
    let by_reference = References::by_value_reference(&description.variables);
    for (index, to) in references {
        let variable = &mut description.variables[index];
        let line = variable.line;
        variable.derivative = to.derivative.and_then(|r| by_reference.resolve(r, "derivative", line, report));
        variable.previous = to.previous.and_then(|r| by_reference.resolve(r, "previous", line, report));
    }
    for child in node.children.iter().filter(|child| child.name == "ModelStructure") {
        description.structure = structure(child, &by_reference, report);
        description.number_of_event_indicators = description.structure.event_indicators.len();
    }
    description
}

fn interface(node: &Node, report: &mut Report) -> Interface {
    check_children(node, &[], report);
    let mut fields = Fields::of(node);
    let mut interface = Interface {
        model_identifier: fields.required("modelIdentifier", report),
        needs_execution_tool: fields.flag("needsExecutionTool", report),
        can_be_instantiated_only_once_per_process: fields.flag("canBeInstantiatedOnlyOncePerProcess", report),
        can_get_and_set_fmu_state: fields.flag("canGetAndSetFMUState", report),
        can_serialize_fmu_state: fields.flag("canSerializeFMUState", report),
        provides_directional_derivatives: fields.flag("providesDirectionalDerivatives", report),
        provides_adjoint_derivatives: fields.flag("providesAdjointDerivatives", report),
        provides_per_element_dependencies: fields.flag("providesPerElementDependencies", report),
        ..Interface::default()
    };
    match node.name.as_str() {
        "ModelExchange" => {
            interface.needs_completed_integrator_step = fields.flag("needsCompletedIntegratorStep", report);
            interface.provides_evaluate_discrete_states = fields.flag("providesEvaluateDiscreteStates", report);
        }
        "CoSimulation" => {
            interface.can_handle_variable_communication_step_size =
                fields.flag("canHandleVariableCommunicationStepSize", report);
            interface.fixed_internal_step_size = fields.value("fixedInternalStepSize", report);
            interface.max_output_derivative_order = fields.value("maxOutputDerivativeOrder", report).unwrap_or(0);
            interface.recommended_intermediate_input_smoothness =
                fields.value("recommendedIntermediateInputSmoothness", report).unwrap_or(0);
            interface.provides_intermediate_update = fields.flag("providesIntermediateUpdate", report);
            interface.might_return_early_from_do_step = fields.flag("mightReturnEarlyFromDoStep", report);
            interface.can_return_early_after_intermediate_update =
                fields.flag("canReturnEarlyAfterIntermediateUpdate", report);
            interface.has_event_mode = fields.flag("hasEventMode", report);
            interface.provides_evaluate_discrete_states = fields.flag("providesEvaluateDiscreteStates", report);
        }
        _ => {}
    }
    // The schema lets layered standards add attributes here; most often, though, it is a flag of FMI 2.0.
    for key in fields.others() {
        report.warning(node.line, format!("`{}` has no attribute `{key}`; nobody will heed it", node.name));
    }
    interface
}

fn types(node: &Node, report: &mut Report) -> Vec<TypeDefinition> {
    Fields::of(node).finish(report);
    if node.children.is_empty() {
        report.error(node.line, "`TypeDefinitions` must not be empty; remove it");
    }
    let mut types = Vec::new();
    for node in &node.children {
        let name = node.name.strip_suffix("Type");
        let Some((_, data_type)) = DataType::NAMES.into_iter().find(|(known, _)| Some(*known) == name) else {
            report.error(node.line, format!("`{}` is not a type; remove it", node.name));
            continue;
        };
        let mut fields = Fields::of(node);
        let definition = TypeDefinition {
            name: fields.required("name", report),
            description: fields.text("description"),
            data_type,
            attributes: attributes(node, &mut fields, data_type, VERSION, report),
            items: if data_type == DataType::Enumeration {
                items(node, VERSION, report)
            } else {
                check_children(node, &[], report);
                Vec::new()
            },
            clock: clock(data_type, &mut fields, report),
        };
        binary(data_type, &mut fields, report);
        fields.finish(report);
        types.push(definition);
    }
    types
}

/// What a clock or its type says; `None` for everything else, and when it does not say when it ticks.
fn clock(data_type: DataType, fields: &mut Fields<'_>, report: &mut Report) -> Option<Clock> {
    if data_type != DataType::Clock {
        return None;
    }
    let variability = fields.required_one_of("intervalVariability", &IntervalVariability::NAMES, report);
    // Without it, the others are still asked for, so that nobody calls them unknown.
    let clock = Clock {
        interval_variability: variability.unwrap_or(IntervalVariability::Triggered),
        can_be_deactivated: fields.flag("canBeDeactivated", report),
        priority: fields.value("priority", report),
        interval_decimal: fields.value("intervalDecimal", report),
        shift_decimal: fields.value("shiftDecimal", report),
        supports_fraction: fields.flag("supportsFraction", report),
        resolution: fields.value("resolution", report),
        interval_counter: fields.value("intervalCounter", report),
        shift_counter: fields.value("shiftCounter", report),
    };
    variability.map(|_| clock)
}

/// Attributes of a binary, which we check and then do without.
fn binary(data_type: DataType, fields: &mut Fields<'_>, report: &mut Report) {
    if data_type == DataType::Binary {
        fields.get("mimeType");
        fields.value::<u64>("maxSize", report);
    }
}

/// What a variable refers to by value reference.
#[derive(Default)]
struct ReferencesOf {
    derivative: Option<u32>,
    previous: Option<u32>,
}

fn variables(node: &Node, report: &mut Report) -> (Vec<Variable>, Vec<(usize, ReferencesOf)>) {
    Fields::of(node).finish(report);
    if node.children.is_empty() {
        report.error(node.line, "`ModelVariables` must not be empty");
    }
    let mut variables = Vec::new();
    let mut references = Vec::new();
    for node in &node.children {
        let Some((_, data_type)) = DataType::NAMES.into_iter().find(|(name, _)| *name == node.name) else {
            report.error(node.line, format!("`{}` is not a type of variable; remove it", node.name));
            continue;
        };
        let (variable, to) = variable(node, data_type, report);
        if to.derivative.is_some() || to.previous.is_some() {
            references.push((variables.len(), to));
        }
        variables.push(variable);
    }
    (variables, references)
}

fn variable(node: &Node, data_type: DataType, report: &mut Report) -> (Variable, ReferencesOf) {
    let mut fields = Fields::of(node);
    let mut variable = variable_head(node, &mut fields, data_type, VERSION, report);
    let mut references = ReferencesOf::default();
    variable.clocks = fields.list("clocks", report).unwrap_or_default();
    variable.declared_type = fields.text("declaredType");
    if data_type == DataType::Enumeration && variable.declared_type.is_none() {
        fields.required("declaredType", report);
    }
    if data_type != DataType::Clock {
        read_initial(node, &mut fields, &mut variable, VERSION, report);
        variable.intermediate_update = fields.flag("intermediateUpdate", report);
        references.previous = fields.value("previous", report);
    }
    variable.attributes = attributes(node, &mut fields, data_type, VERSION, report);
    variable.start = start(node, &mut fields, data_type, VERSION, report);
    if data_type.is_float() {
        references.derivative = fields.value("derivative", report);
        variable.reinit = fields.flag("reinit", report);
    }
    variable.clock = clock(data_type, &mut fields, report);
    binary(data_type, &mut fields, report);
    fields.finish(report);
    children(node, &mut variable, report);
    (variable, references)
}

/// Dimensions, starts of strings and binaries, aliases.
fn children(node: &Node, variable: &mut Variable, report: &mut Report) {
    let allowed: &[Child] = match variable.data_type {
        DataType::Clock => &[Child::Many("Alias")],
        DataType::String | DataType::Binary => &[Child::Many("Dimension"), Child::Many("Start"), Child::Many("Alias")],
        _ => &[Child::Many("Dimension"), Child::Many("Alias")],
    };
    check_children(node, allowed, report);
    let mut texts = Vec::new();
    for child in &node.children {
        let mut fields = Fields::of(child);
        match child.name.as_str() {
            "Dimension" => variable.dimensions.extend(dimension(child, &mut fields, report)),
            // The schema forgot to require it.
            "Start" => texts.push((child.line, fields.required("value", report))),
            "Alias" => variable.aliases.push(Alias {
                name: fields.required("name", report),
                description: fields.text("description"),
                display_unit: if variable.data_type.is_float() { fields.text("displayUnit") } else { None },
            }),
            _ => continue,
        }
        fields.finish(report);
    }
    if texts.is_empty() {
        return;
    }
    variable.start = match variable.data_type {
        DataType::String => Some(Start::String(texts.into_iter().map(|(_, text)| text).collect())),
        DataType::Binary => {
            let values = texts.into_iter().map(|(line, text)| {
                let bytes = hex_bytes(&text);
                if bytes.is_none() {
                    report.error(line, format!("`Start` of `{}` must be pairs of hexadecimal digits", variable.name));
                }
                bytes
            });
            let values: Vec<Option<Vec<u8>>> = values.collect();
            values.into_iter().collect::<Option<_>>().map(Start::Binary)
        }
        _ => variable.start.take(),
    };
}

fn dimension(node: &Node, fields: &mut Fields<'_>, report: &mut Report) -> Option<Dimension> {
    let start = fields.value("start", report);
    let reference = fields.value("valueReference", report);
    match (start, reference) {
        (Some(size), None) => Some(Dimension::Fixed(size)),
        (None, Some(reference)) => Some(Dimension::Variable(reference)),
        _ => {
            report.error(node.line, "`Dimension` needs either `start` or `valueReference`");
            None
        }
    }
}

fn structure(node: &Node, references: &References, report: &mut Report) -> ModelStructure {
    let lists =
        ["Output", "ContinuousStateDerivative", "ClockedState", "InitialUnknown", "EventIndicator"].map(Child::Many);
    check_children(node, &lists, report);
    Fields::of(node).finish(report);
    let mut structure = ModelStructure::default();
    for entry in &node.children {
        let unknowns = match entry.name.as_str() {
            "Output" => &mut structure.outputs,
            "ContinuousStateDerivative" => &mut structure.derivatives,
            "ClockedState" => &mut structure.clocked_states,
            "InitialUnknown" => &mut structure.initial_unknowns,
            "EventIndicator" => &mut structure.event_indicators,
            _ => continue,
        };
        unknowns.extend(unknown(entry, "valueReference", references, report));
    }
    structure
}
