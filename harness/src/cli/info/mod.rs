//! `swayless info`.

mod fmu;
mod json;
mod system;

use std::path::PathBuf;

use swayless::{Fmu, System, terminals};
use swayless_modeldesc::terminals::TERMINALS_AND_ICONS;
use swayless_modeldesc::types::{Dimension, Interface, ModelDescription, Start, Variable};

use super::{Failure, Outcome, console};

/// Show what an FMU offers, or what a system consists of.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The .fmu, .ssd or .ssp to look into
    file: PathBuf,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let is_system =
        arguments.file.extension().is_some_and(|e| e.eq_ignore_ascii_case("ssd") || e.eq_ignore_ascii_case("ssp"));
    if is_system {
        let system = System::open(&arguments.file)?;
        if arguments.json {
            console::print(format_args!("{:#}", system::json(&system)))?;
        } else {
            system::print(&system)?;
        }
    } else {
        let fmu = Fmu::open(&arguments.file)?;
        let description = fmu.description();
        let terminals = match terminals::read(fmu.folder(), description)? {
            Some(Ok((content, _))) => content.terminals,
            Some(Err(error)) => {
                console::warn(format_args!("{TERMINALS_AND_ICONS}: {error}"));
                Vec::new()
            }
            None => Vec::new(),
        };
        if arguments.json {
            console::print(format_args!("{:#}", json::fmu(description, &terminals)))?;
        } else {
            fmu::print(description, &terminals)?;
        }
    }
    Ok(Outcome::Done)
}

/// The interfaces offered, by the standard's names.
fn interfaces(description: &ModelDescription) -> impl Iterator<Item = (&'static str, &Interface)> {
    [
        ("ModelExchange", &description.model_exchange),
        ("CoSimulation", &description.co_simulation),
        ("ScheduledExecution", &description.scheduled_execution),
    ]
    .into_iter()
    .filter_map(|(name, interface)| Some((name, interface.as_ref()?)))
}

/// What an interface can do beyond the minimum, and what it needs: FMI 3.0's names, in words, and whether it is so.
fn flags(interface: &Interface) -> [(&'static str, &'static str, bool); 16] {
    let i = interface;
    [
        ("needsExecutionTool", "needs execution tool", i.needs_execution_tool),
        ("canBeInstantiatedOnlyOncePerProcess", "once per process", i.can_be_instantiated_only_once_per_process),
        ("canGetAndSetFMUState", "get and set state", i.can_get_and_set_fmu_state),
        ("canSerializeFMUState", "serialize state", i.can_serialize_fmu_state),
        ("providesDirectionalDerivatives", "directional derivatives", i.provides_directional_derivatives),
        ("providesAdjointDerivatives", "adjoint derivatives", i.provides_adjoint_derivatives),
        ("providesPerElementDependencies", "per-element dependencies", i.provides_per_element_dependencies),
        ("needsCompletedIntegratorStep", "needs completed integrator step", i.needs_completed_integrator_step),
        ("providesEvaluateDiscreteStates", "evaluate discrete states", i.provides_evaluate_discrete_states),
        ("canHandleVariableCommunicationStepSize", "variable step size", i.can_handle_variable_communication_step_size),
        ("canInterpolateInputs", "input interpolation", i.can_interpolate_inputs),
        ("canRunAsynchronuously", "asynchronous", i.can_run_asynchronuously),
        ("providesIntermediateUpdate", "intermediate update", i.provides_intermediate_update),
        ("mightReturnEarlyFromDoStep", "might return early", i.might_return_early_from_do_step),
        (
            "canReturnEarlyAfterIntermediateUpdate",
            "early return after intermediate update",
            i.can_return_early_after_intermediate_update,
        ),
        ("hasEventMode", "event mode", i.has_event_mode),
    ]
}

fn causality(variable: &Variable) -> String {
    lower_first(format!("{:?}", variable.causality))
}

/// The type with the sizes of an array, those of structural parameters by name.
fn variable_type(variable: &Variable, description: &ModelDescription) -> String {
    let mut text = format!("{:?}", variable.data_type);
    for dimension in &variable.dimensions {
        match dimension {
            Dimension::Fixed(size) => text += &format!("[{size}]"),
            Dimension::Variable(reference) => match named(*reference, description) {
                Some(size) => text += &format!("[{}]", size.name),
                None => text += &format!("[#{reference}]"),
            },
        }
    }
    text
}

/// The first variable with this value reference.
fn named(reference: u32, description: &ModelDescription) -> Option<&Variable> {
    description.variables.iter().find(|variable| variable.value_reference == reference)
}

/// The start values as text.
fn start(variable: &Variable) -> Option<Vec<String>> {
    Some(match variable.start.as_ref()? {
        Start::Float(values) => values.iter().map(f64::to_string).collect(),
        Start::Integer(values) => values.iter().map(i128::to_string).collect(),
        Start::Boolean(values) => values.iter().map(bool::to_string).collect(),
        Start::String(values) => values.clone(),
        Start::Binary(values) => values.iter().map(|bytes| format!("{} bytes", bytes.len())).collect(),
    })
}

/// The standard's spelling of a name: `Float64` stays, `CalculatedParameter` becomes `calculatedParameter`.
fn lower_first(name: String) -> String {
    let mut letters = name.chars();
    letters.next().map(|first| first.to_ascii_lowercase().to_string() + letters.as_str()).unwrap_or_default()
}
