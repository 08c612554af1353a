//! What a model description says, the same for FMI 2.0 and FMI 3.0.

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

/// A `Unit` with its display units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Unit {
    /// The name by which variables refer to it.
    pub name: String,
    /// Its dimensions and conversion to SI, if given.
    pub base: Option<BaseUnit>,
    /// The units a user may want to see instead.
    pub display_units: Vec<DisplayUnit>,
}

/// `BaseUnit`: value in SI = factor · value + offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseUnit {
    /// Exponents of kg, m, s, A, K, mol, cd, rad, in this order.
    pub exponents: [i32; 8],
    /// The factor.
    pub factor: f64,
    /// The offset.
    pub offset: f64,
}

impl BaseUnit {
    /// The names of the exponents, as the standard's attributes have them.
    pub const SYMBOLS: [&'static str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "rad"];
}

/// `DisplayUnit`: display value = factor · value + offset; with `inverse` (FMI 3.0), factor / value.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplayUnit {
    /// Its name.
    pub name: String,
    /// The factor.
    pub factor: f64,
    /// The offset.
    pub offset: f64,
    /// Whether the value stands below the factor.
    pub inverse: bool,
}

/// A `SimpleType` (FMI 2.0) or a type of `TypeDefinitions` (FMI 3.0).
#[derive(Debug, Clone, PartialEq)]
pub struct TypeDefinition {
    /// The name by which variables refer to it.
    pub name: String,
    /// Its description.
    pub description: Option<String>,
    /// The base type.
    pub data_type: DataType,
    /// What numbers of this type are.
    pub attributes: Attributes,
    /// The items, when [`DataType::Enumeration`].
    pub items: Vec<Item>,
}

/// An `Item` of an enumeration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: i64,
    /// Its description.
    pub description: Option<String>,
}

/// The type of a variable. FMI 2.0's `Real` is `Float64`, its `Integer` is `Int32`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum DataType {
    Float32,
    Float64,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Boolean,
    String,
    Binary,
    Enumeration,
    Clock,
}

impl DataType {
    /// Every type with the name of its element in FMI 3.0.
    pub(crate) const NAMES: [(&'static str, Self); 15] = [
        ("Float32", Self::Float32),
        ("Float64", Self::Float64),
        ("Int8", Self::Int8),
        ("UInt8", Self::UInt8),
        ("Int16", Self::Int16),
        ("UInt16", Self::UInt16),
        ("Int32", Self::Int32),
        ("UInt32", Self::UInt32),
        ("Int64", Self::Int64),
        ("UInt64", Self::UInt64),
        ("Boolean", Self::Boolean),
        ("String", Self::String),
        ("Binary", Self::Binary),
        ("Enumeration", Self::Enumeration),
        ("Clock", Self::Clock),
    ];

    /// The name of its element in FMI 3.0.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }

    /// The least and the greatest value of an integer type or an enumeration (whose values are 32 bits wide in FMI 2.0);
    /// `None` for the other types.
    pub fn integer_range(self, version: FmiVersion) -> Option<(i128, i128)> {
        Some(match self {
            Self::Int8 => (i8::MIN.into(), i8::MAX.into()),
            Self::UInt8 => (0, u8::MAX.into()),
            Self::Int16 => (i16::MIN.into(), i16::MAX.into()),
            Self::UInt16 => (0, u16::MAX.into()),
            Self::Int32 => (i32::MIN.into(), i32::MAX.into()),
            Self::UInt32 => (0, u32::MAX.into()),
            Self::Enumeration if version == FmiVersion::V2 => (i32::MIN.into(), i32::MAX.into()),
            Self::Int64 | Self::Enumeration => (i64::MIN.into(), i64::MAX.into()),
            Self::UInt64 => (0, u64::MAX.into()),
            _ => return None,
        })
    }

    /// Whether variables of this type can be continuous.
    pub fn is_float(self) -> bool {
        matches!(self, Self::Float32 | Self::Float64)
    }
}

/// Attributes that a type definition and a variable share; on a variable, what is absent holds from its declared type.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Attributes {
    /// `quantity`.
    pub quantity: Option<String>,
    /// `unit`.
    pub unit: Option<String>,
    /// `displayUnit`.
    pub display_unit: Option<String>,
    /// `relativeQuantity`.
    pub relative_quantity: bool,
    /// `unbounded`.
    pub unbounded: bool,
    /// `min`.
    pub min: Option<f64>,
    /// `max`.
    pub max: Option<f64>,
    /// `nominal`.
    pub nominal: Option<f64>,
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

/// A variable of `ModelVariables`.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// `name`.
    pub name: String,
    /// `valueReference`.
    pub value_reference: u32,
    /// `description`.
    pub description: Option<String>,
    /// `causality`.
    pub causality: Causality,
    /// `variability`.
    pub variability: Variability,
    /// `initial`: as written, or what the standard's table says when it is not.
    pub initial: Option<Initial>,
    /// The type.
    pub data_type: DataType,
    /// `declaredType`.
    pub declared_type: Option<String>,
    /// Unit, bounds and the like.
    pub attributes: Attributes,
    /// `start`: one value, or one for each element in row-major order, or one for all elements.
    pub start: Option<Start>,
    /// `Dimension`s (FMI 3.0); none for a scalar.
    pub dimensions: Vec<Dimension>,
    /// The state that this variable is the derivative of, as an index into [`ModelDescription::variables`].
    pub derivative: Option<usize>,
    /// `reinit`.
    pub reinit: bool,
    /// `canHandleMultipleSetPerTimeInstant`; true unless said otherwise.
    pub can_handle_multiple_set_per_time_instant: bool,
    /// `intermediateUpdate` (FMI 3.0).
    pub intermediate_update: bool,
    /// `clocks`: the value references of the clocks it belongs to (FMI 3.0).
    pub clocks: Vec<u32>,
    /// `previous`: the variable that holds its value before the clock tick, as an index into
    /// [`ModelDescription::variables`] (FMI 3.0).
    pub previous: Option<usize>,
    /// `Alias` elements (FMI 3.0).
    pub aliases: Vec<Alias>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

impl Variable {
    /// A scalar with nothing said about it but what every variable must say; `initial` is the standard's default for
    /// this causality and variability.
    pub fn new(
        name: impl Into<String>,
        value_reference: u32,
        data_type: DataType,
        causality: Causality,
        variability: Variability,
    ) -> Self {
        Self {
            name: name.into(),
            value_reference,
            description: None,
            causality,
            variability,
            initial: Initial::default_for(causality, variability),
            data_type,
            declared_type: None,
            attributes: Attributes::default(),
            start: None,
            dimensions: Vec::new(),
            derivative: None,
            reinit: false,
            can_handle_multiple_set_per_time_instant: true,
            intermediate_update: false,
            clocks: Vec::new(),
            previous: None,
            aliases: Vec::new(),
            line: 0,
        }
    }
}

/// `Alias`: another name of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Alias {
    /// The name.
    pub name: String,
    /// Its description.
    pub description: Option<String>,
    /// `displayUnit`.
    pub display_unit: Option<String>,
}

/// `causality`. Its names are [`Causality::as_str`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Causality {
    StructuralParameter,
    Parameter,
    CalculatedParameter,
    Input,
    Output,
    Local,
    Independent,
}

impl Causality {
    /// Every causality with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 7] = [
        ("structuralParameter", Self::StructuralParameter),
        ("parameter", Self::Parameter),
        ("calculatedParameter", Self::CalculatedParameter),
        ("input", Self::Input),
        ("output", Self::Output),
        ("local", Self::Local),
        ("independent", Self::Independent),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}

/// `variability`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Variability {
    Constant,
    Fixed,
    Tunable,
    Discrete,
    Continuous,
}

impl Variability {
    /// Every variability with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 5] = [
        ("constant", Self::Constant),
        ("fixed", Self::Fixed),
        ("tunable", Self::Tunable),
        ("discrete", Self::Discrete),
        ("continuous", Self::Continuous),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}

/// `initial`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Initial {
    Exact,
    Approx,
    Calculated,
}

impl Initial {
    /// Every initial with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 3] =
        [("exact", Self::Exact), ("approx", Self::Approx), ("calculated", Self::Calculated)];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }

    /// What `initial` may be, its default first (FMI 2.0.5 section 2.2.7, FMI 3.0.2 section 2.4.7.4): nothing for the
    /// independent variable; exact for inputs, which FMI 2.0 leaves unsaid. Empty for combinations that may not be.
    pub fn allowed_for(causality: Causality, variability: Variability) -> &'static [Self] {
        use Causality as C;
        use Variability as V;
        match (causality, variability) {
            (C::StructuralParameter | C::Parameter, V::Fixed | V::Tunable)
            | (C::Input, V::Discrete | V::Continuous)
            | (C::Output | C::Local, V::Constant) => &[Self::Exact],
            (C::CalculatedParameter | C::Local, V::Fixed | V::Tunable) => &[Self::Calculated, Self::Approx],
            (C::Output | C::Local, V::Discrete | V::Continuous) => &[Self::Calculated, Self::Exact, Self::Approx],
            _ => &[],
        }
    }

    /// What `initial` is when it is not written.
    pub fn default_for(causality: Causality, variability: Variability) -> Option<Self> {
        Self::allowed_for(causality, variability).first().copied()
    }
}

/// Start values, by type.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// Of a float of either width.
    Float(Vec<f64>),
    /// Of an integer of any width or an enumeration. Wide enough for every one of them.
    Integer(Vec<i128>),
    /// Of a Boolean.
    Boolean(Vec<bool>),
    /// Of a string.
    String(Vec<String>),
    /// Of a binary.
    Binary(Vec<Vec<u8>>),
}

/// The size of an array in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Known.
    Fixed(u64),
    /// The value of a structural parameter, by its value reference.
    Variable(u32),
}

/// `ModelStructure`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelStructure {
    /// The outputs.
    pub outputs: Vec<Unknown>,
    /// The derivatives of the continuous states.
    pub derivatives: Vec<Unknown>,
    /// The clocked states (FMI 3.0).
    pub clocked_states: Vec<Unknown>,
    /// What must be solved for in initialization.
    pub initial_unknowns: Vec<Unknown>,
    /// The event indicators (FMI 3.0).
    pub event_indicators: Vec<Unknown>,
}

/// An entry of `ModelStructure`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Unknown {
    /// The variable, as an index into [`ModelDescription::variables`].
    pub variable: usize,
    /// What it depends on, as indices into [`ModelDescription::variables`]; `None` means on everything it could.
    pub dependencies: Option<Vec<usize>>,
    /// How, one for each dependency.
    pub dependencies_kind: Option<Vec<DependencyKind>>,
    /// The line it stands in, 0 when it was not read from a file.
    pub line: usize,
}

/// `dependenciesKind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum DependencyKind {
    Dependent,
    Constant,
    Fixed,
    Tunable,
    Discrete,
}

impl DependencyKind {
    /// Every kind with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 5] = [
        ("dependent", Self::Dependent),
        ("constant", Self::Constant),
        ("fixed", Self::Fixed),
        ("tunable", Self::Tunable),
        ("discrete", Self::Discrete),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }
}

/// The name of a value; the tables above are complete, each next to its enumeration.
fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], value: T) -> &'static str {
    names.iter().find(|(_, v)| *v == value).map_or("", |(name, _)| name)
}
