//! The model description, from the declarations and the traced structure.

mod definitions;
mod structure;
mod variables;

use swayless_modeldesc::types::{
    DefaultExperiment, FmiVersion, Interface, LogCategory, ModelDescription, NamingConvention,
};

use crate::instance::TOLERANCE;
use crate::layout::Layout;
use crate::log::Category;
use crate::model::Model;
use crate::token;

/// The description of a model for a version of the standard.
pub fn of<M: Model>(version: FmiVersion) -> ModelDescription {
    let entries = variables::entries::<M>(version);
    let structure = structure::of::<M>(&entries);
    let units = definitions::units(&entries);
    let interface = Interface {
        model_identifier: M::INFO.name.to_string(),
        can_not_use_memory_management_functions: true,
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        provides_directional_derivatives: true,
        provides_adjoint_derivatives: true,
        ..Interface::default()
    };
    ModelDescription {
        fmi_version: version,
        model_name: M::INFO.name.to_string(),
        instantiation_token: token::of::<M>(),
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
            can_interpolate_inputs: version == FmiVersion::V2,
            max_output_derivative_order: 1,
            has_event_mode: version == FmiVersion::V3,
            might_return_early_from_do_step: version == FmiVersion::V3,
            ..interface.clone()
        }),
        model_exchange: Some(interface),
        scheduled_execution: None,
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
