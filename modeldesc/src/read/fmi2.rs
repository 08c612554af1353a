//! What FMI 2.0 writes its own way.

use super::common::{attributes, default_experiment, items, log_categories, start, units};
use super::structure::{References, unknown};
use super::{read_initial, root, variable_head};
use crate::problem::Report;
use crate::types::*;
use crate::xml_in::{Child, Fields, Node, check_children};

const VERSION: FmiVersion = FmiVersion::V2;

/// The types by the names of their elements.
const TYPES: [(&str, DataType); 5] = [
    ("Real", DataType::Float64),
    ("Integer", DataType::Int32),
    ("Boolean", DataType::Boolean),
    ("String", DataType::String),
    ("Enumeration", DataType::Enumeration),
];

pub(super) fn read(node: &Node, report: &mut Report) -> ModelDescription {
    let mut fields = Fields::of(node);
    let mut description = root(&mut fields, VERSION, "guid", report);
    let indicators: u32 = fields.value("numberOfEventIndicators", report).unwrap_or(0);
    description.number_of_event_indicators = usize::try_from(indicators).unwrap_or(usize::MAX);
    fields.finish(report);

    // The schema lets the two interfaces stand in either order.
    let interfaces = ["ModelExchange", "CoSimulation"];
    let first = node.children.iter().find(|child| interfaces.contains(&child.name.as_str()));
    let [first, second] = if first.is_some_and(|child| child.name == interfaces[1]) {
        [interfaces[1], interfaces[0]]
    } else {
        interfaces
    };
    check_children(
        node,
        &[
            Child::Maybe(first),
            Child::Maybe(second),
            Child::Maybe("UnitDefinitions"),
            Child::Maybe("TypeDefinitions"),
            Child::Maybe("LogCategories"),
            Child::Maybe("DefaultExperiment"),
            Child::Once("ModelVariables"),
            Child::Once("ModelStructure"),
        ],
        report,
    );
    let mut derivatives = Vec::new();
    for child in &node.children {
        match child.name.as_str() {
            "ModelExchange" => description.model_exchange = Some(interface(child, report)),
            "CoSimulation" => description.co_simulation = Some(interface(child, report)),
            "UnitDefinitions" => description.units = units(child, VERSION, report),
            "TypeDefinitions" => description.type_definitions = types(child, report),
            "LogCategories" => description.log_categories = log_categories(child, report),
            "DefaultExperiment" => description.default_experiment = Some(default_experiment(child, report)),
            "ModelVariables" => (description.variables, derivatives) = variables(child, report),
            _ => {}
        }
    }
    let references = References::by_position(&description.variables);
    for Derivative { variable, state, line } in derivatives {
        description.variables[variable].derivative = references.resolve(state, "derivative", line, report);
    }
    for child in node.children.iter().filter(|child| child.name == "ModelStructure") {
        description.structure = structure(child, &references, report);
    }
    description
}

fn interface(node: &Node, report: &mut Report) -> Interface {
    check_children(node, &[Child::Maybe("SourceFiles")], report);
    let mut fields = Fields::of(node);
    let mut interface = Interface {
        model_identifier: fields.required("modelIdentifier", report),
        needs_execution_tool: fields.flag("needsExecutionTool", report),
        can_be_instantiated_only_once_per_process: fields.flag("canBeInstantiatedOnlyOncePerProcess", report),
        can_not_use_memory_management_functions: fields.flag("canNotUseMemoryManagementFunctions", report),
        can_get_and_set_fmu_state: fields.flag("canGetAndSetFMUstate", report),
        can_serialize_fmu_state: fields.flag("canSerializeFMUstate", report),
        provides_directional_derivatives: fields.flag("providesDirectionalDerivative", report),
        ..Interface::default()
    };
    if node.name == "ModelExchange" {
        interface.needs_completed_integrator_step = !fields.flag("completedIntegratorStepNotNeeded", report);
    } else {
        interface.can_handle_variable_communication_step_size =
            fields.flag("canHandleVariableCommunicationStepSize", report);
        interface.can_interpolate_inputs = fields.flag("canInterpolateInputs", report);
        interface.max_output_derivative_order = fields.value("maxOutputDerivativeOrder", report).unwrap_or(0);
        interface.can_run_asynchronuously = fields.flag("canRunAsynchronuously", report);
    }
    fields.finish(report);
    interface
}

/// The one child that says the type.
fn typed_child<'a>(node: &'a Node, report: &mut Report) -> Option<(&'a Node, DataType)> {
    let mut found = None;
    for child in &node.children {
        match TYPES.iter().find(|(name, _)| *name == child.name) {
            Some((_, data_type)) if found.is_none() => found = Some((child, *data_type)),
            Some(_) => report.error(child.line, format!("`{}` has more than one type", node.name)),
            None => {
                report.error(child.line, format!("`{}` does not belong into `{}`; remove it", child.name, node.name))
            }
        }
    }
    if found.is_none() {
        report.error(
            node.line,
            format!("`{}` needs one of the elements Real, Integer, Boolean, String, Enumeration", node.name),
        );
    }
    found
}

fn types(node: &Node, report: &mut Report) -> Vec<TypeDefinition> {
    check_children(node, &[Child::Some("SimpleType")], report);
    Fields::of(node).finish(report);
    let mut types = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "SimpleType") {
        let mut fields = Fields::of(node);
        let name = fields.required("name", report);
        let description = fields.text("description");
        fields.finish(report);
        let Some((child, data_type)) = typed_child(node, report) else { continue };
        let mut fields = Fields::of(child);
        let (attributes, items) = if data_type == DataType::Enumeration {
            let attributes = Attributes { quantity: fields.text("quantity"), ..Attributes::default() };
            (attributes, items(child, VERSION, report))
        } else {
            check_children(child, &[], report);
            (attributes(child, &mut fields, data_type, VERSION, report), Vec::new())
        };
        fields.finish(report);
        types.push(TypeDefinition { name, description, data_type, attributes, items, clock: None });
    }
    types
}

/// The attribute `derivative`, which can only be resolved when all variables are known.
struct Derivative {
    variable: usize,
    state: u32,
    line: usize,
}

fn variables(node: &Node, report: &mut Report) -> (Vec<Variable>, Vec<Derivative>) {
    check_children(node, &[Child::Some("ScalarVariable")], report);
    Fields::of(node).finish(report);
    let mut variables = Vec::new();
    let mut derivatives = Vec::new();
    for node in node.children.iter().filter(|child| child.name == "ScalarVariable") {
        // A variable of unknown type still counts, or else all later indices would be wrong.
        let typed = typed_child(node, report);
        let data_type = typed.map_or(DataType::Float64, |(_, data_type)| data_type);
        let mut fields = Fields::of(node);
        let mut variable = variable_head(node, &mut fields, data_type, VERSION, report);
        if variable.causality == Causality::StructuralParameter {
            report.error(node.line, "`causality` is `structuralParameter`, which FMI 2.0 does not know");
        }
        read_initial(node, &mut fields, &mut variable, VERSION, report);
        fields.finish(report);
        if let Some((child, _)) = typed {
            check_children(child, &[], report);
            if let Some(state) = typed_attributes(child, &mut variable, report) {
                derivatives.push(Derivative { variable: variables.len(), state, line: child.line });
            }
        }
        variables.push(variable);
    }
    (variables, derivatives)
}

/// What stands in the element of the type; returns the reference of `derivative`.
fn typed_attributes(node: &Node, variable: &mut Variable, report: &mut Report) -> Option<u32> {
    let mut fields = Fields::of(node);
    let data_type = variable.data_type;
    variable.declared_type = fields.text("declaredType");
    if data_type == DataType::Enumeration && variable.declared_type.is_none() {
        fields.required("declaredType", report);
    }
    variable.attributes = attributes(node, &mut fields, data_type, VERSION, report);
    variable.start = match data_type {
        DataType::String => fields.text("start").map(|text| Start::String(vec![text])),
        _ => start(node, &mut fields, data_type, VERSION, report).filter(|start| {
            let one = match start {
                Start::Float(values) => values.len() == 1,
                Start::Integer(values) => values.len() == 1,
                Start::Boolean(values) => values.len() == 1,
                Start::String(_) | Start::Binary(_) => true,
            };
            if !one {
                report.error(node.line, format!("`start` of `{}` must be one value", variable.name));
            }
            one
        }),
    };
    let mut derivative = None;
    if data_type.is_float() {
        derivative = fields.value("derivative", report);
        variable.reinit = fields.flag("reinit", report);
    }
    fields.finish(report);
    derivative
}

fn structure(node: &Node, references: &References, report: &mut Report) -> ModelStructure {
    check_children(
        node,
        &[Child::Maybe("Outputs"), Child::Maybe("Derivatives"), Child::Maybe("InitialUnknowns")],
        report,
    );
    Fields::of(node).finish(report);
    let mut structure = ModelStructure::default();
    for list in &node.children {
        let unknowns = match list.name.as_str() {
            "Outputs" => &mut structure.outputs,
            "Derivatives" => &mut structure.derivatives,
            "InitialUnknowns" => &mut structure.initial_unknowns,
            _ => continue,
        };
        check_children(list, &[Child::Some("Unknown")], report);
        Fields::of(list).finish(report);
        let entries = list.children.iter().filter(|child| child.name == "Unknown");
        unknowns.extend(entries.filter_map(|entry| unknown(entry, "index", references, report)));
    }
    structure
}
