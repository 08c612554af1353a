//! An FMU as JSON.

use serde_json::{Value as Json, json};
use swayless_modeldesc::terminals::Terminal;
use swayless_modeldesc::types::{Clock, DataType, Interface, ModelDescription, TypeDefinition};

use super::{causality, flags, interfaces, lower_first, named, start, variable_type};

/// All that is known of an FMU. Names and spellings are those of FMI 3.0, for FMI 2.0 as well.
pub fn fmu(description: &ModelDescription, terminals: &[Terminal]) -> Json {
    let interfaces: serde_json::Map<String, Json> =
        interfaces(description).map(|(name, i)| (name.to_owned(), interface(i))).collect();
    let variables: Vec<Json> = description
        .variables
        .iter()
        .map(|v| {
            let clocks: Vec<&str> =
                v.clocks.iter().filter_map(|&clock| Some(named(clock, description)?.name.as_str())).collect();
            json!({
                "name": v.name, "valueReference": v.value_reference, "description": v.description,
                "causality": causality(v), "variability": lower_first(format!("{:?}", v.variability)),
                "initial": v.initial.map(|i| lower_first(format!("{i:?}"))), "type": variable_type(v, description),
                "declaredType": v.declared_type, "unit": v.attributes.unit, "displayUnit": v.attributes.display_unit,
                "min": v.attributes.min, "max": v.attributes.max, "nominal": v.attributes.nominal, "start": start(v),
                "clock": v.clock.as_ref().map(clock), "clocks": clocks,
            })
        })
        .collect();
    let enumerations: Vec<Json> = description
        .type_definitions
        .iter()
        .filter(|definition| definition.data_type == DataType::Enumeration)
        .map(|definition| json!({ "name": definition.name, "items": items(definition) }))
        .collect();
    let experiment = description.default_experiment.unwrap_or_default();
    json!({
        "fmiVersion": description.fmi_version.to_string(),
        "modelName": description.model_name,
        "description": description.description,
        "version": description.version,
        "author": description.author,
        "copyright": description.copyright,
        "license": description.license,
        "generationTool": description.generation_tool,
        "generationDateAndTime": description.generation_date_and_time,
        "instantiationToken": description.instantiation_token,
        "interfaces": interfaces,
        "continuousStates": description.structure.derivatives.len(),
        "eventIndicators": description.number_of_event_indicators,
        "defaultExperiment": {
            "startTime": experiment.start_time, "stopTime": experiment.stop_time,
            "stepSize": experiment.step_size, "tolerance": experiment.tolerance,
        },
        "enumerations": enumerations,
        "variables": variables,
        "terminals": terminals.iter().map(terminal).collect::<Vec<_>>(),
    })
}

fn interface(interface: &Interface) -> Json {
    let mut known = json!({
        "modelIdentifier": interface.model_identifier,
        "maxOutputDerivativeOrder": interface.max_output_derivative_order,
        "recommendedIntermediateInputSmoothness": interface.recommended_intermediate_input_smoothness,
        "fixedInternalStepSize": interface.fixed_internal_step_size,
    });
    for (name, _, on) in flags(interface) {
        known[name] = on.into();
    }
    known
}

fn items(definition: &TypeDefinition) -> Vec<Json> {
    let item = |item: &swayless_modeldesc::types::Item| json!({ "name": item.name, "value": item.value, "description": item.description });
    definition.items.iter().map(item).collect()
}

fn clock(clock: &Clock) -> Json {
    json!({
        "intervalVariability": clock.interval_variability.as_str(), "canBeDeactivated": clock.can_be_deactivated,
        "priority": clock.priority, "intervalDecimal": clock.interval_decimal, "shiftDecimal": clock.shift_decimal,
        "supportsFraction": clock.supports_fraction, "resolution": clock.resolution,
        "intervalCounter": clock.interval_counter, "shiftCounter": clock.shift_counter,
    })
}

fn terminal(terminal: &Terminal) -> Json {
    let members: Vec<Json> = terminal
        .members
        .iter()
        .map(|m| json!({ "memberName": m.name, "variableName": m.variable, "variableKind": m.kind }))
        .collect();
    json!({
        "name": terminal.name, "matchingRule": terminal.matching_rule, "terminalKind": terminal.terminal_kind,
        "description": terminal.description, "members": members,
        "terminals": terminal.terminals.iter().map(self::terminal).collect::<Vec<_>>(),
    })
}
