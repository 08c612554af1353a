//! The model description, from the declarations and the traced structure.

mod clocks;
mod definitions;
pub mod names;
mod structure;
pub mod terminals;
mod variables;

use swayless_modeldesc::types::{
    DefaultExperiment, FmiVersion, Interface, LogCategory, ModelDescription, NamingConvention,
};

use crate::instance::TOLERANCE;
use crate::layout::Layout;
use crate::log::Category;
use crate::model::Model;
use crate::token::{self, Variant};

/// The description of a model for a version of the standard.
pub fn of<M: Model>(version: FmiVersion, variant: Variant) -> ModelDescription {
    let entries = variables::entries::<M>(version, variant);
    let name = variant.name::<M>();
    let is_fmi3 = version == FmiVersion::V3;
    let scheduled = variant == Variant::Clocked && Variant::has_scheduled_execution::<M>();
    let structure = structure::of::<M>(&entries);
    let units = definitions::units(&entries);
    let interface = Interface {
        model_identifier: name.clone(),
        can_not_use_memory_management_functions: true,
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        provides_directional_derivatives: true,
        provides_adjoint_derivatives: true,
        provides_per_element_dependencies: is_fmi3,
        provides_evaluate_discrete_states: is_fmi3,
        ..Interface::default()
    };
    ModelDescription {
        fmi_version: version,
        model_name: name,
        instantiation_token: token::of::<M>(variant),
        description: Some(M::INFO.description.to_string()),
        author: Some(env!("CARGO_PKG_AUTHORS").to_string()),
        version: Some(env!("CARGO_PKG_VERSION").to_string()),
        copyright: None,
        license: Some(env!("CARGO_PKG_LICENSE").to_string()),
        generation_tool: Some(format!("Swayless {}", env!("CARGO_PKG_VERSION"))),
        // Left out, so that equal sources give equal bytes.
        generation_date_and_time: None,
        variable_naming_convention: NamingConvention::Structured,
        co_simulation: Some(Interface {
            can_handle_variable_communication_step_size: true,
            can_interpolate_inputs: !is_fmi3,
            max_output_derivative_order: 1,
            has_event_mode: is_fmi3,
            might_return_early_from_do_step: is_fmi3,
            provides_intermediate_update: is_fmi3,
            can_return_early_after_intermediate_update: is_fmi3,
            ..interface.clone()
        }),
        scheduled_execution: scheduled
            .then(|| Interface { provides_evaluate_discrete_states: false, ..interface.clone() }),
        model_exchange: Some(interface),
        type_definitions: definitions::types::<M>(&units),
        units: units.into_iter().map(definitions::unit).collect(),
        log_categories: Category::ALL
            .iter()
            .map(|(name, description)| LogCategory {
                name: (*name).to_string(),
                description: Some((*description).to_string()),
            })
            .collect(),
        default_experiment: Some(DefaultExperiment {
            start_time: Some(0.0),
            stop_time: Some(M::INFO.stop_time),
            tolerance: Some(TOLERANCE),
            step_size: Some(M::INFO.step_size),
        }),
        number_of_event_indicators: Layout::<M>::INDICATOR_COUNT,
        variables: entries.into_iter().map(|entry| entry.variable).collect(),
        structure,
    }
}
