//! What a model description says, the same for FMI 2.0 and FMI 3.0.

mod clock;
mod definitions;
mod interface;
mod structure;
mod variability;
mod variable;

pub use clock::{Clock, IntervalVariability};
pub use definitions::{Attributes, BaseUnit, DataType, DisplayUnit, Item, TypeDefinition, Unit};
pub use interface::Interface;
pub use structure::{DependencyKind, ModelStructure, Unknown};
pub use variability::{Causality, Initial, Variability};
pub use variable::{Alias, Dimension, Start, Variable};

use std::fmt;

/// A version of the FMI standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FmiVersion {
    /// FMI 2.0.
    V2,
    /// FMI 3.0.
    V3,
}

impl fmt::Display for FmiVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::V2 => "2.0",
            Self::V3 => "3.0",
        })
    }
}

/// The content of a `modelDescription.xml`.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelDescription {
    /// The version of the standard it is written for.
    pub fmi_version: FmiVersion,
    /// `modelName`.
    pub model_name: String,
    /// `guid` in FMI 2.0, `instantiationToken` in FMI 3.0.
    pub instantiation_token: String,
    /// `description`.
    pub description: Option<String>,
    /// `author`.
    pub author: Option<String>,
    /// `version` of the model.
    pub version: Option<String>,
    /// `copyright`.
    pub copyright: Option<String>,
    /// `license`.
    pub license: Option<String>,
    /// `generationTool`.
    pub generation_tool: Option<String>,
    /// `generationDateAndTime`, as written.
    pub generation_date_and_time: Option<String>,
    /// `variableNamingConvention`.
    pub variable_naming_convention: NamingConvention,
    /// The model-exchange interface, if offered.
    pub model_exchange: Option<Interface>,
    /// The co-simulation interface, if offered.
    pub co_simulation: Option<Interface>,
    /// The scheduled-execution interface, if offered (FMI 3.0).
    pub scheduled_execution: Option<Interface>,
    /// `UnitDefinitions`.
    pub units: Vec<Unit>,
    /// `TypeDefinitions`.
    pub type_definitions: Vec<TypeDefinition>,
    /// `LogCategories`.
    pub log_categories: Vec<LogCategory>,
    /// `DefaultExperiment`.
    pub default_experiment: Option<DefaultExperiment>,
    /// How many event indicators there are: an attribute in FMI 2.0, the number of `EventIndicator`s in FMI 3.0.
    pub number_of_event_indicators: usize,
    /// `ModelVariables`, in order.
    pub variables: Vec<Variable>,
    /// `ModelStructure`.
    pub structure: ModelStructure,
}

impl ModelDescription {
    /// A description with a name and a token and nothing else in it.
    pub fn new(fmi_version: FmiVersion, model_name: impl Into<String>, instantiation_token: impl Into<String>) -> Self {
        Self {
            fmi_version,
            model_name: model_name.into(),
            instantiation_token: instantiation_token.into(),
            description: None,
            author: None,
            version: None,
            copyright: None,
            license: None,
            generation_tool: None,
            generation_date_and_time: None,
            variable_naming_convention: NamingConvention::default(),
            model_exchange: None,
            co_simulation: None,
            scheduled_execution: None,
            units: Vec::new(),
            type_definitions: Vec::new(),
            log_categories: Vec::new(),
            default_experiment: None,
            number_of_event_indicators: 0,
            variables: Vec::new(),
            structure: ModelStructure::default(),
        }
    }
}

/// `variableNamingConvention`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NamingConvention {
    /// Names are plain strings.
    #[default]
    Flat,
    /// Names follow the grammar of the standard: `a.b[1].c`, `der(x)`.
    Structured,
}

/// A `Category` of `LogCategories`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogCategory {
    /// Its name.
    pub name: String,
    /// Its description.
    pub description: Option<String>,
}

/// `DefaultExperiment`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DefaultExperiment {
    /// `startTime` (s).
    pub start_time: Option<f64>,
    /// `stopTime` (s).
    pub stop_time: Option<f64>,
    /// `tolerance`, relative.
    pub tolerance: Option<f64>,
    /// `stepSize` (s).
    pub step_size: Option<f64>,
}

/// The name of a value; the tables above are complete, each next to its enumeration.
fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], value: T) -> &'static str {
    names.iter().find(|(_, v)| *v == value).map_or("", |(name, _)| name)
}
